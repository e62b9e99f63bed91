"""A backup is made and fetched by owners alone, and its password is written nowhere."""

from __future__ import annotations

import io
import tarfile
from collections.abc import Iterator
from pathlib import Path
from typing import Any, Final

import httpx
import pytest

from epf_gcs.access.roles import Role
from epf_gcs.backup.age_archive import EncryptedReader
from tests.support.callers import person, strict_gateway
from tests.support.gateway import Gateway
from tests.support.waiting import eventually

PASSWORD: Final = "correct horse battery"  # noqa: S105


@pytest.fixture
def station(tmp_path: Path) -> Iterator[Gateway]:
    with strict_gateway(tmp_path / "data") as gateway:
        yield gateway


@pytest.fixture
def owner(station: Gateway) -> Iterator[httpx.Client]:
    with person(station, Role.owner, "Olga") as client:
        yield client


def finished(owner: httpx.Client, job: str) -> dict[str, Any]:
    eventually(lambda: owner.get(f"/jobs/{job}").json()["state"] in ("done", "failed"), "the job is over")
    told: dict[str, Any] = owner.get(f"/jobs/{job}").json()
    return told


def test_an_owner_makes_a_backup_and_its_password_stands_nowhere(
    station: Gateway, owner: httpx.Client, capfd: pytest.CaptureFixture[str]
) -> None:
    folder = station.flight_thread.data_dir
    (folder / "state.json").write_text("{}")
    answer = owner.post("/backups", json={"password": PASSWORD})
    assert answer.status_code == 202, answer.text
    job = finished(owner, answer.json()["job"])
    assert (job["kind"], job["state"], job["flight"], job["fault"]) == ("backup", "done", None, None)
    assert job["result"]["name"].endswith(".tar.age")
    (made,) = (folder / "exports").iterdir()
    assert made.stat().st_mode & 0o777 == 0o600
    sealed = owner.get(f"/jobs/{job['id']}/result").raise_for_status().content
    plain = EncryptedReader(io.BytesIO(sealed), PASSWORD, "the backup").read()
    with tarfile.open(fileobj=io.BytesIO(plain)) as archive:
        assert {"state.json", "access.sqlite"} <= set(archive.getnames())
    deed = next(one for one in owner.get("/access/log").json()["deeds"] if one["deed"] == "backup")
    assert (deed["what"], deed["result"]) == ("POST /backups", "202")
    said = "".join(capfd.readouterr()) + owner.get("/jobs").text
    assert PASSWORD not in said
    written = b"".join(path.read_bytes() for path in folder.rglob("*") if path.is_file())
    assert PASSWORD.encode() not in written


@pytest.mark.parametrize("password", ["short", "x" * 201, "two lines\nof a password"])
def test_a_password_that_cannot_be_used_is_refused_without_repeating_it(owner: httpx.Client, password: str) -> None:
    answer = owner.post("/backups", json={"password": password})
    assert (answer.status_code, password in answer.text) == (422, False)
    assert owner.get("/jobs").json()["jobs"] == []


def test_nobody_but_an_owner_makes_or_fetches_one(station: Gateway, owner: httpx.Client) -> None:
    job = owner.post("/backups", json={"password": PASSWORD}).json()["job"]
    finished(owner, job)
    with person(station, Role.operator, "Bo") as operator:
        assert operator.post("/backups", json={"password": PASSWORD}).json()["code"] == "role_too_low"
        assert operator.get(f"/jobs/{job}/result").json()["code"] == "role_too_low"
