"""Who waits to be let in: strangers with a few addresses do not keep a guest out, nor does a class its own."""

from __future__ import annotations

from dataclasses import replace

import pytest

from epf_gcs.access.roles import Role
from epf_gcs.access.sessions import WAITS_S, Sessions
from epf_gcs.access.store import Person
from epf_gcs.errors import ConflictError
from epf_gcs.shares.holder import Standing
from epf_gcs.shares.table import SHARES

PART = SHARES.waiting.parts[Standing.stranger]


@pytest.fixture
def sessions() -> Sessions:
    return Sessions([], [])


def ask(sessions: Sessions, address: str, name: str = "x", now_s: float = 0.0) -> Person:
    return sessions.come_in(name, "", "waiting", Role.viewer, address, now_s)[1]


def waiting(sessions: Sessions, address: str) -> list[str]:
    return [one.name for one in sessions.people.values() if one.address == address and one.state == "waiting"]


def test_a_guest_waits_however_many_ask_from_a_few_addresses(sessions: Sessions) -> None:
    for number in range(500):
        ask(sessions, f"10.0.0.{number % 5}", now_s=number)
    guest = ask(sessions, "10.0.0.99", "Ana", now_s=500.0)
    for number in range(500):
        ask(sessions, f"10.0.0.{number % 5}", now_s=501.0 + number)
    assert sessions.people[guest.id] == guest
    assert len(sessions.people) == PART.together


def test_a_class_behind_one_address_waits_and_the_longest_waiting_goes(sessions: Sessions) -> None:
    for number in range(PART.each + 1):
        ask(sessions, "10.0.0.1", f"{number}", now_s=number)
    assert waiting(sessions, "10.0.0.1") == [f"{number}" for number in range(1, PART.each + 1)]


def test_who_was_let_in_or_forgotten_frees_the_place_and_the_disk_hears_of_it(sessions: Sessions) -> None:
    people = [ask(sessions, f"10.0.{number}.1") for number in range(PART.together)]
    sessions.change(people[0].id, name=None, role=None, state="in")
    sessions.remove(people[1].id)
    ask(sessions, "10.1.0.1")
    ask(sessions, "10.1.0.2")
    assert sessions.take_gone() == [], "there was room"
    ask(sessions, "10.1.0.3", now_s=WAITS_S + 1)
    assert len(sessions.take_gone()) == PART.together
    assert sessions.take_gone() == []
    assert [one.state for one in sessions.people.values()] == ["in", "waiting"]


def test_who_waited_before_a_restart_has_a_place(sessions: Sessions) -> None:
    people = [ask(sessions, "10.0.0.1", now_s=float(number)) for number in range(PART.each)]
    again = Sessions(people, [])
    ask(again, "10.0.0.1", "new", now_s=100.0)
    assert len(again.people) == PART.each
    assert again.take_gone() == [people[0].id]


def test_nobody_waits_where_there_is_no_place_at_all() -> None:
    nothing = type(SHARES.waiting)({})
    sessions = Sessions([], [], shares=replace(SHARES, waiting=nothing))
    with pytest.raises(ConflictError):
        ask(sessions, "10.0.0.1")
    assert sessions.people == {}
