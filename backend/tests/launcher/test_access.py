"""One-time keys from the command line, and the launcher's own way into the gateway that it started."""

from __future__ import annotations

import contextlib
import re
import subprocess
import sys
from pathlib import Path

import pytest

from epf_gcs.access.roles import Role
from epf_gcs.access.store import AccessStore, Person
from epf_gcs.data_folder.lock import DataFolder
from epf_gcs.data_folder.whereabouts import FILE, Whereabouts, leave, of_running
from epf_gcs.launcher.access import access_arguments, invite_command, new_launcher_key
from epf_gcs.launcher.gateway_client import GatewayClient, RefusedError
from tests.support.callers import stranger, strict_gateway
from tests.support.gateway import running_gateway
from tests.support.programs import gateway_process
from tests.support.waiting import DEADLINE_S

KEY = r"[0-9A-Z]{4}(?:-[0-9A-Z]{4}){3}"


PATH = ":".join(sys.path)


def invite(*arguments: str | Path, **variables: str) -> subprocess.CompletedProcess[str]:
    """`epf-gcs invite` as a user runs it."""
    command = [sys.executable, "-m", "epf_gcs.launcher.gateway", "invite", *map(str, arguments)]
    return subprocess.run(command, capture_output=True, text=True, check=False, timeout=DEADLINE_S, env={**variables})


def test_an_invitation_of_the_command_line_lets_one_in_while_the_station_runs(tmp_path: Path) -> None:
    with strict_gateway(tmp_path / "data") as gateway, stranger(gateway) as ana:
        said = invite("--data-dir", tmp_path / "data", "--role", "viewer", "--port", "8123", PYTHONPATH=PATH)
        assert said.returncode == 0, said.stderr
        key = re.search(KEY, said.stdout)
        assert key is not None
        assert f":8123/#key={key[0]}" in said.stdout
        me = ana.post("/access/enter", json={"key": key[0], "name": "Ana"}).json()
        assert (me["state"], me["role"]) == ("in", "viewer")


def test_an_invitation_says_the_port_of_the_station_that_runs_unless_another_is_given(tmp_path: Path) -> None:
    data = tmp_path / "data"
    with gateway_process(data, "--no-recording") as program:
        port = program.wait_for_words(r"url=http://[^:]+:(\d+)")
        reached = ("--host", "0.0.0.0")  # noqa: S104 - nothing listens there
        assert f":{port}/#key=" in invite("--data-dir", data, *reached, PYTHONPATH=PATH, GCS_PORT="8001").stdout
        assert "this computer alone" in invite("--data-dir", data, PYTHONPATH=PATH).stdout
        assert ":8123/#key=" in invite("--data-dir", data, *reached, "--port", "8123", PYTHONPATH=PATH).stdout
    # What a killed station left says nothing of the next one.
    assert ":8000/#key=" in invite("--data-dir", data, PYTHONPATH=PATH).stdout


@pytest.mark.parametrize("left", [b"", b"[]", b"{", b'{"host": 1, "port": 2, "tls": true}', b"\xff" * 20_000])
def test_what_a_stranger_wrote_in_its_place_is_no_station(tmp_path: Path, left: bytes) -> None:
    with DataFolder(tmp_path):
        leave(tmp_path, Whereabouts("127.0.0.1", 4711, tls=True))
        assert of_running(tmp_path) == Whereabouts("127.0.0.1", 4711, tls=True)
        (tmp_path / FILE).write_bytes(left)
        assert of_running(tmp_path) is None


@pytest.mark.parametrize("wrong", [["--role", "boss"], ["--minutes", "0"], ["--minutes", "nan"]])
def test_what_cannot_be_is_refused(tmp_path: Path, wrong: list[str]) -> None:
    said = invite("--data-dir", tmp_path / "data", *wrong, PYTHONPATH=PATH)
    assert said.returncode != 0
    assert re.search(KEY, said.stdout) is None


def test_the_first_one_in_where_nobody_is_trusted_is_an_owner(tmp_path: Path) -> None:
    variables = {"PYTHONPATH": PATH, "GCS_TRUST_THIS_COMPUTER": "false"}
    assert "for one owner" in invite("--data-dir", tmp_path, **variables).stdout
    with contextlib.closing(AccessStore(tmp_path)) as store:
        store.put(Person("a", "Ana", "", Role.owner, "in", 0.0, 0.0, ""))
    assert "for one operator" in invite("--data-dir", tmp_path, **variables).stdout
    assert (
        "for one operator" in invite("--data-dir", tmp_path, **variables | {"GCS_TRUST_THIS_COMPUTER": "true"}).stdout
    )


def test_the_launcher_is_known_by_the_key_that_it_gave(tmp_path: Path) -> None:
    key = new_launcher_key()
    with strict_gateway(tmp_path / "data", launcher_key=key) as gateway:
        assert GatewayClient(gateway.base, key).status()["version"]
        for other in (None, new_launcher_key()):
            with pytest.raises(RefusedError):
                GatewayClient(gateway.base, other).status()


def test_only_the_long_option_lets_anybody_fly(tmp_path: Path) -> None:
    with strict_gateway(tmp_path / "data", allow_anyone_to_fly=True) as gateway, stranger(gateway) as eve:
        me = eve.get("/access/me").json()
        assert (me["state"], me["kind"], me["role"], me["anyone_may_fly"]) == ("in", "anyone", "operator", True)
        assert eve.post("/commands/start", json={}).json()["code"] == "board_not_open"
        assert eve.get("/access/people").status_code == 403
    with running_gateway(tmp_path / "data") as gateway, stranger(gateway) as ana:
        assert ana.get("/access/me").json()["anyone_may_fly"] is False


def test_the_options_go_on_to_the_programs(tmp_path: Path) -> None:
    assert access_arguments(trust_this_computer=None, allow_anyone_to_fly=False) == []
    assert access_arguments(trust_this_computer=False, allow_anyone_to_fly=True) == [
        "--no-trust-this-computer",
        "--allow-anyone-to-fly",
    ]
    assert invite_command(tmp_path, "0.0.0.0", 8000, tls=True)[-1] == "--tls"  # noqa: S104
