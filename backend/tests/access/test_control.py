"""Control through a running station: what pages, programs and viewers see of it, over real streams."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from contextlib import ExitStack
from typing import Any

import pytest

from epf_gcs.access.caller import Caller
from epf_gcs.access.roles import Role
from tests.support.gateway import Gateway
from tests.support.page import CutLine, Page, page
from tests.support.waiting import eventually

STREAM = "/api/v1/stream"
ADDRESS = re.compile(r"\d+\.\d+\.\d+\.\d+|:\d{4,5}\b|localhost")

Open = Callable[..., Page]


@pytest.fixture
def opened(gateway: Gateway) -> Iterator[Open]:
    """Opens pages: of this computer without a name, of `ana`, `bea` (operators), `olga` (owner) and `eve` (viewer)."""
    people = {"ana": Role.operator, "bea": Role.operator, "olga": Role.owner, "eve": Role.viewer}
    for name, role in people.items():
        caller = Caller("person", name, f"{name.title()} · tablet", role, f"session-{name}")
        gateway.web.admission.programs.add_caller(f"key-of-{name}", caller)
    with ExitStack() as stack:

        def open_page(name: str | None = None, query: str = "", line: int | None = None) -> Page:
            key = None if name is None else f"key-of-{name}"
            return stack.enter_context(page(gateway.base, STREAM + query, key, line))

        yield open_page


def test_pages_are_called_by_people_and_places_and_never_by_addresses(gateway: Gateway, opened: Open) -> None:
    pages = [opened(), opened(), opened("ana"), opened("ana"), opened(query="?name=Tower")]
    assert [(one.hello["name"], one.hello["kind"], one.hello["number"]) for one in pages] == [
        ("this computer", "local", 1),
        ("this computer 2", "local", 2),
        ("Ana · tablet", "person", 1),
        ("Ana · tablet 2", "person", 2),
        ("Tower", "program", 1),
    ]
    assert opened("ana", query="?name=Olga").hello["name"] == "Ana · tablet 3", "nobody passes for somebody else"
    listed = gateway.http.get("/control").json()
    assert [one["name"] for one in listed["pages"]][:5] == [one.hello["name"] for one in pages]
    assert ADDRESS.search(str([listed, gateway.status()["control"], pages[0].hello["name"]])) is None


def test_a_number_is_free_again_when_its_page_has_gone(opened: Open) -> None:
    first, second = opened(), opened()
    first.close()
    second.event("control")
    assert opened().hello["name"] == "this computer"


def test_the_hello_says_role_and_control_apart(opened: Open) -> None:
    hellos = [opened("eve").hello, opened("ana").hello, opened("olga").hello]
    assert [(one["role"], one["has_control"]) for one in hellos] == [
        ("viewer", False),
        ("operator", True),
        ("owner", False),
    ]


def test_asking_is_shown_to_all_and_granting_gives(gateway: Gateway, opened: Open) -> None:
    ana, bea, eve = opened("ana"), opened("bea"), opened("eve")
    assert bea.act("ask").json()["requests"][0]["name"] == "Bea · tablet"
    for one in (ana, eve):
        asked = one.event("control_request")
        assert (asked["client"], asked["role"]) == (bea.client, "operator")
        assert asked["given_at_s"] is None, "the holder decides"
    assert gateway.status()["control"]["requests"][0]["client"] == bea.client
    answer = ana.act("grant", to=bea.client).json()
    assert (answer["client"], answer["requests"]) == (bea.client, [])
    assert eve.event("control_request_closed")["result"] == "given"
    change = eve.event("control")
    assert (change["client"], change["reason"], change["before"]["client"]) == (bea.client, "granted", ana.client)
    assert ana.http.post("/commands/ahrs_on").json()["code"] == "control_held"


def test_a_refusal_closes_the_request_and_holds_for_a_while(opened: Open) -> None:
    ana, bea = opened("ana"), opened("bea")
    bea.act("ask")
    assert ana.act("refuse", to=bea.client).json()["client"] == ana.client
    assert bea.event("control_request_closed")["result"] == "refused"
    again = bea.act("ask")
    assert (again.status_code, again.json()["code"]) == (409, "control_refused")
    assert 0.0 < again.json()["params"]["wait_s"] <= 10.0


def test_a_request_is_withdrawn_and_control_handed_over_released_and_asked_for_while_it_is_free(opened: Open) -> None:
    ana, bea = opened("ana"), opened("bea")
    bea.act("ask")
    assert bea.act("withdraw").json()["requests"] == []
    assert ana.event("control_request_closed")["result"] == "withdrawn"
    assert ana.act("hand_over", to=bea.client).json()["client"] == bea.client
    assert bea.act("release").json()["client"] is None
    assert ana.act("ask").json()["client"] == ana.client


def test_an_owner_takes_control_on_purpose_and_an_operator_does_not(opened: Open) -> None:
    ana, bea, olga = opened("ana"), opened("bea"), opened("olga")
    assert bea.act("take", confirm=True).json()["code"] == "control_held"
    unconfirmed = olga.act("take")
    assert (unconfirmed.status_code, unconfirmed.json()["code"]) == (409, "control_unconfirmed")
    assert olga.act("take", confirm=True).json()["client"] == olga.client
    change = ana.event("control")
    while change["reason"] != "taken":
        change = ana.event("control")
    assert change["client"] == olga.client


def test_what_cannot_be_is_refused_with_a_reason(opened: Open) -> None:
    pages = {name: opened(name) for name in ("ana", "bea", "eve")}
    cases: tuple[tuple[str, str, dict[str, Any], int, str], ...] = (
        ("eve", "take", {}, 403, "role_too_low"),
        ("eve", "ask", {}, 403, "role_too_low"),
        ("ana", "grant", {}, 422, "invalid_request"),
        ("ana", "hand_over", {}, 422, "invalid_request"),
        ("ana", "grant", {"to": "somebody"}, 409, "control_not_asked"),
        ("ana", "hand_over", {"to": "somebody"}, 404, "client_unknown"),
        ("bea", "refuse", {"to": "somebody"}, 409, "control_held"),
        ("bea", "release", {}, 409, "control_held"),
        ("ana", "steal", {}, 422, "invalid_request"),
    )
    for who, action, others, status, code in cases:
        answer = pages[who].act(action, **others)
        assert (answer.status_code, answer.json()["code"]) == (status, code), (who, action)
        assert answer.json()["detail"].endswith(".")


def test_an_id_works_only_for_the_session_that_opened_it(gateway: Gateway, opened: Open) -> None:
    ana, bea = opened("ana"), opened("bea")
    stolen = {"X-Client": ana.client}
    answer = bea.http.post("/commands/ahrs_on", headers=stolen)
    assert (answer.status_code, answer.json()["code"]) == (403, "client_not_yours")
    for action in ("take", "release", "hand_over"):
        body = {"client": ana.client, "action": action, "to": bea.client}
        assert bea.http.post("/control", json=body).json()["code"] == "client_not_yours"
    assert gateway.status()["control"]["client"] == ana.client
    ana.close()
    assert bea.event("control")["reason"] == "lost"
    assert bea.http.post("/commands/ahrs_on", headers=stolen).json()["code"] == "client_not_yours", "nor a left one"
    thief = opened("bea", query=f"?client={ana.client}")
    assert thief.client != ana.client
    again = opened("ana", query=f"?client={ana.client}")
    assert (again.client, again.hello["has_control"]) == (ana.client, True)


def test_a_viewer_commands_nothing_even_while_nobody_has_control(gateway: Gateway, opened: Open) -> None:
    eve = opened("eve")
    assert gateway.status()["control"]["client"] is None
    assert eve.http.post("/commands/ahrs_on").json()["code"] == "role_too_low"
    eve.send({"type": "stick", "elevator": 1, "aileron": 0, "rudder": 0, "throttle": 1, "t_ms": 1})
    assert eve.event("error")["code"] == "role_too_low"
    assert gateway.status()["hil"]["stick"]["samples"] == {}


def test_a_page_whose_line_is_cut_loses_control_to_who_asked_and_is_told_when_the_line_is_back(
    gateway: Gateway, opened: Open
) -> None:
    line = CutLine(gateway.server.port)
    ana, bea, eve = opened("ana", line=line.port), opened("bea"), opened("eve")
    bea.act("ask")
    eve.event("control_request")
    line.cut()
    first, second = eve.event("control"), eve.event("control")
    assert (first["client"], first["reason"], first["before"]["client"]) == (None, "silent", ana.client)
    assert (second["client"], second["reason"]) == (bea.client, "asked")
    line.mend()
    while (change := ana.event("control"))["client"] != bea.client:
        assert change["reason"] in ("first", "silent")
    assert gateway.status()["control"]["client"] == bea.client, "it does not come back by itself"
    line.close()


def test_a_page_whose_line_is_cut_has_control_again_when_nobody_took_it(gateway: Gateway, opened: Open) -> None:
    line = CutLine(gateway.server.port)
    ana, eve = opened("ana", line=line.port), opened("eve")
    line.cut()
    assert eve.event("control")["reason"] == "silent"
    reserved = gateway.status()["control"]["reserved"]
    assert (reserved["client"], reserved["name"]) == (ana.client, "Ana · tablet")
    line.mend()
    assert eve.event("control")["reason"] == "back"
    assert gateway.status()["control"]["client"] == ana.client
    line.close()


def test_a_page_that_comes_back_on_another_line_takes_the_place_of_its_cut_one(gateway: Gateway, opened: Open) -> None:
    line = CutLine(gateway.server.port)
    ana, eve = opened("ana", line=line.port), opened("eve")
    line.cut()
    assert eve.event("control")["reason"] == "silent"
    again = opened("ana", query=f"?client={ana.client}")
    assert (again.client, again.hello["has_control"]) == (ana.client, True)
    assert [one["client"] for one in gateway.http.get("/control").json()["pages"]] == [eve.client, ana.client]
    line.close()


def test_a_page_that_is_busy_lets_the_stick_go_and_keeps_control_unless_somebody_asks(
    gateway: Gateway, opened: Open
) -> None:
    ana, bea, eve = opened("ana"), opened("bea"), opened("eve")
    sample = {"type": "stick", "elevator": 1, "aileron": 0, "rudder": 0, "throttle": 1}
    ana.send({**sample, "t_ms": 1})
    ana.hangs = True
    eventually(lambda: gateway.web.control.is_hung, "its page does nothing")
    assert gateway.status()["control"]["client"] == ana.client
    ana.wake()
    eventually(lambda: not gateway.web.control.is_hung, "it goes on")
    ana.send({**sample, "t_ms": 2})
    eventually(lambda: gateway.flight.stick.counts["taken"] == 2, "and flies on")
    assert not [kind for kind in eve.unread() if kind == "control"], "nobody heard of a change"

    ana.hangs = True
    bea.act("ask")
    assert [eve.event("control")["reason"], eve.event("control")["reason"]] == ["silent", "asked"]
    ana.wake()
    assert gateway.status()["control"]["client"] == bea.client


def test_samples_of_a_stick_without_control_do_not_reach_the_flight(gateway: Gateway, opened: Open) -> None:
    ana, bea = opened("ana"), opened("bea")
    sample = {"type": "stick", "elevator": 1, "aileron": 0, "rudder": 0, "throttle": 1, "t_ms": 1}
    for _ in range(5):
        bea.send(sample)
    ana.send(sample)
    eventually(
        lambda: gateway.status()["hil"]["stick"]["samples"] == {"taken": 1, "not_operator": 5}, "each is counted"
    )
    assert gateway.flight.stick.counts == {"taken": 1}
