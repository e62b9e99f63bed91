"""What has ended is over at once, also where an answer is still on its way."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path

import httpx
import pytest

from epf_gcs.access.roles import Role
from tests.support.callers import Browser, person, program, strict_gateway
from tests.support.gateway import Gateway

RECORDING = "20260131T120000Z"
BYTES = 64_000_000


@pytest.fixture(scope="module")
def station(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Gateway]:
    folder: Path = tmp_path_factory.mktemp("ended") / "data"
    (folder / "recordings").mkdir(parents=True)
    with (folder / "recordings" / f"{RECORDING}.mcap").open("wb") as file:
        file.truncate(BYTES)
    with strict_gateway(folder) as gateway:
        yield gateway


@pytest.fixture(scope="module")
def owner(station: Gateway) -> Iterator[Browser]:
    with person(station, Role.owner, "Owner") as client:
        yield client


def a_person(station: Gateway, owner: Browser) -> tuple[Browser, Callable[[], object]]:
    client = person(station, Role.viewer, "Leaving")
    people = owner.get("/access/people").json()["people"]
    found = next(one["id"] for one in people if one["name"] == "Leaving")
    return client, lambda: owner.delete(f"/access/people/{found}").raise_for_status()


def a_session(station: Gateway, owner: Browser) -> tuple[Browser, Callable[[], object]]:
    client = person(station, Role.viewer, "Lost tablet")
    sessions = owner.get("/access/sessions").json()["sessions"]
    found = next(one["id"] for one in sessions if one["name"] == "Lost tablet")
    return client, lambda: owner.delete(f"/access/sessions/{found}").raise_for_status()


def a_program(station: Gateway, owner: Browser) -> tuple[Browser, Callable[[], object]]:
    client, _, found = program(station, Role.viewer, owner)
    return client, lambda: owner.delete(f"/access/programs/{found}").raise_for_status()


@pytest.mark.parametrize("make", [a_person, a_session, a_program])
def test_an_answer_that_is_being_sent_ends_in_the_middle(
    station: Gateway, owner: Browser, make: Callable[[Gateway, Browser], tuple[Browser, Callable[[], object]]]
) -> None:
    client, end = make(station, owner)
    with client, client.stream("GET", f"/recordings/{RECORDING}/export") as answer:
        assert answer.headers["content-length"] == str(BYTES)
        parts = answer.iter_raw()
        received = len(next(parts))
        end()
        with pytest.raises(httpx.RemoteProtocolError):
            received += sum(map(len, parts))
    assert received < BYTES
    assert owner.get("/status").status_code == 200


def test_one_who_is_in_gets_all_of_it(owner: Browser) -> None:
    assert len(owner.get(f"/recordings/{RECORDING}/export").content) == BYTES
