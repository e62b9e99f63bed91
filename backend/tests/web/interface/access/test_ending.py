"""What an owner ends or changes in Setup › Acceso, and what becomes of the streams that are open."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import httpx
import pytest

from epf_gcs.access.roles import Role
from tests.support.callers import person, strict_gateway
from tests.support.gateway import Gateway
from tests.support.page import page
from tests.support.waiting import eventually

STREAM = "/api/v1/stream"


@pytest.fixture
def station(tmp_path: Path) -> Iterator[Gateway]:
    with strict_gateway(tmp_path / "data") as gateway:
        yield gateway


def cookie_of(client: httpx.Client) -> str:
    return "; ".join(f"{name}={value}" for name, value in client.cookies.items())


def id_of(owner: httpx.Client, name: str) -> str:
    people = owner.get("/access/people").json()["people"]
    return str(next(one["id"] for one in people if one["name"] == name))


def test_an_ended_person_loses_control_and_all_streams_and_others_keep_theirs(station: Gateway) -> None:
    with person(station, Role.owner, "Olga") as olga, person(station, Role.operator, "Ana") as client:
        hers, others = cookie_of(client), cookie_of(olga)
        with (
            page(station.base, cookie=hers) as ana,
            page(station.base, cookie=hers) as twin,
            page(station.base, cookie=others) as watching,
        ):
            olga.patch(f"/access/people/{id_of(olga, 'Ana')}", json={"state": "ended"}).raise_for_status()
            change = watching.event("control")
            assert (change["client"], change["reason"]) == (None, "ended")
            assert change["before"]["client"] == ana.client
            assert [one.wait_closed() for one in (ana, twin)] == [(1008, "ended")] * 2
            eventually(lambda: olga.get("/status").json()["viewers"] == 1, "only they are gone")
            assert watching.closed is None
            assert watching.act("take").json()["client"] == watching.client
        assert client.get("/status").status_code == 401


def test_the_streams_of_a_key_that_is_ended_are_closed(station: Gateway) -> None:
    with person(station, Role.owner, "Olga") as olga:
        made = olga.post("/access/programs", json={"name": "logger", "role": "operator"}).json()
        with page(station.base, key=made["key"]) as logger:
            assert (logger.hello["name"], logger.hello["kind"]) == ("logger", "program")
            olga.delete(f"/access/programs/{made['program']['id']}").raise_for_status()
            assert logger.wait_closed() == (1008, "ended")


def test_a_role_that_is_lowered_ends_control_at_once_and_is_told_to_the_page(station: Gateway) -> None:
    with (
        person(station, Role.owner, "Olga") as olga,
        person(station, Role.operator, "Ana") as client,
        page(station.base, cookie=cookie_of(client)) as ana,
        page(station.base, cookie=cookie_of(olga)) as other,
    ):
        changed = {"role": "viewer", "name": "Ana María"}
        olga.patch(f"/access/people/{id_of(olga, 'Ana')}", json=changed).raise_for_status()
        told = ana.event("access")
        while told["role"] != "viewer":
            told = ana.event("access")
        assert told["name"].startswith("Ana María")
        assert other.event("control")["reason"] == "ended"
        ana.send({"type": "stick", "elevator": 1, "aileron": 0, "rudder": 0, "throttle": 1, "t_ms": 1})
        assert ana.event("error")["code"] == "role_too_low"
        assert ana.act("take").json()["code"] == "role_too_low"


def test_the_log_tells_who_had_control_and_why_it_went(station: Gateway) -> None:
    with person(station, Role.owner, "Olga") as olga, person(station, Role.operator, "Ana") as client:
        with page(station.base, cookie=cookie_of(client)) as ana:
            assert ana.hello["has_control"]

        def told() -> list[tuple[str, str]]:
            deeds = olga.get("/access/log", params={"text": "holder"}).json()["deeds"]
            return [(deed["what"], deed["result"]) for deed in deeds]

        name = ana.hello["name"]
        eventually(lambda: told() == [(f"{name} > -", "lost"), (f"- > {name}", "first")], "both are in the log")
