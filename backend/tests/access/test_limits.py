"""What a caller may ask has a limit by role; this computer has none."""

from __future__ import annotations

import contextlib
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import httpx
import pytest
from websockets.exceptions import InvalidStatus

from epf_gcs.access.caller import LOCAL, Caller
from epf_gcs.access.limits import CallerLimits
from epf_gcs.access.roles import Role
from epf_gcs.errors import ConflictError, TooManyError
from epf_gcs.shares.holder import Standing
from epf_gcs.shares.rates import Flow, Rate
from epf_gcs.shares.table import SHARES, STREAM_COSTS_REQUESTS
from tests.support.callers import one_time_key, person, stranger, strict_gateway
from tests.support.gateway import Gateway
from tests.support.page import Page, page
from tests.support.waiting import eventually

REQUESTS = SHARES.requests.each
STRANGERS = REQUESTS[Standing.stranger]
STREAMS = SHARES.streams.parts


def caller(role: Role, session: str = "a") -> Caller:
    return Caller("person", "p", "Ana", role, session)


def granted(limits: CallerLimits, who: Caller | None, address: str = "10.0.0.1") -> int:
    count = 0
    with contextlib.suppress(TooManyError):
        while count < 20000:
            limits.request(who, address)
            count += 1
    return count


def test_a_stranger_with_a_whole_network_of_addresses_is_one() -> None:
    limits = CallerLimits(lambda: 0.0)
    asked = 0
    with contextlib.suppress(TooManyError):
        for number in range(int(STRANGERS.at_once) + 100):
            limits.request(None, f"2001:db8::{number:x}")
            asked += 1
    assert asked == STRANGERS.at_once


def test_requests_are_counted_by_session_and_strangers_by_address() -> None:
    now_s = [0.0]
    limits = CallerLimits(lambda: now_s[0])
    assert granted(limits, None) == STRANGERS.at_once
    assert granted(limits, None, "10.0.0.2") == STRANGERS.at_once
    for role in Role:
        assert granted(limits, caller(role, role.name)) == REQUESTS[Standing(role)].at_once
    assert granted(limits, caller(Role.viewer, "another")) == REQUESTS[Standing.viewer].at_once
    now_s[0] = 2.0
    assert granted(limits, None) == 2 * STRANGERS.per_s
    assert granted(limits, LOCAL) == 20000


def test_uploads_are_limited_by_role_and_operators_together_leave_room_to_owners() -> None:
    limits = CallerLimits(lambda: 0.0)
    row = SHARES.upload_bytes
    most = int(row.each[Standing.operator].at_once)
    limits.upload(caller(Role.operator), most)
    with pytest.raises(TooManyError):
        limits.upload(caller(Role.operator), 1)
    with pytest.raises(TooManyError):
        limits.upload(caller(Role.viewer, "v"), 1)
    for number in range(1, int(row.together[Standing.operator].at_once) // most):
        limits.upload(caller(Role.operator, f"o{number}"), most)
    with pytest.raises(TooManyError):
        limits.upload(caller(Role.operator, "last"), most)
    limits.upload(caller(Role.owner, "boss"), most)
    limits.upload(LOCAL, 100 * most)


def test_files_that_are_being_received_have_shares() -> None:
    limits = CallerLimits(lambda: 0.0)
    with contextlib.ExitStack() as open_now:
        first = open_now.enter_context(contextlib.ExitStack())
        first.enter_context(limits.one_upload(caller(Role.operator, "ana")))
        for who in ("ana", "ana", "eva"):
            open_now.enter_context(limits.one_upload(caller(Role.operator, who)))
        for who in ("ana", "leo"):
            with pytest.raises(ConflictError), limits.one_upload(caller(Role.operator, who)):
                pass
        with limits.one_upload(caller(Role.owner, "boss")), limits.one_upload(LOCAL), limits.one_upload(LOCAL):
            pass
        first.close()
        with limits.one_upload(caller(Role.operator, "leo")):
            pass


def test_streams_are_counted_while_they_are_open() -> None:
    limits = CallerLimits(lambda: 0.0)
    for number in range(STREAMS[Standing.viewer].each):
        limits.open_stream(number, caller(Role.viewer))
    with pytest.raises(TooManyError):
        limits.open_stream("more", caller(Role.viewer))
    limits.open_stream("other", caller(Role.viewer, "another"))
    limits.close_stream(0)
    limits.close_stream(0)
    limits.open_stream("more", caller(Role.viewer))
    for number in range(100):
        limits.open_stream(f"local {number}", LOCAL)


def test_opening_a_stream_counts_as_requests() -> None:
    limits = CallerLimits(lambda: 0.0)
    opened = 0
    with contextlib.suppress(TooManyError):
        while opened < 20000:
            limits.request(caller(Role.viewer), "10.0.0.1", STREAM_COSTS_REQUESTS)
            opened += 1
    assert opened == REQUESTS[Standing.viewer].at_once / STREAM_COSTS_REQUESTS


@pytest.fixture
def station(tmp_path: Path) -> Iterator[Gateway]:
    with strict_gateway(tmp_path / "data") as gateway:
        yield gateway


def test_who_asks_too_much_hears_when_to_come_back(tmp_path: Path) -> None:
    each = {**REQUESTS, Standing.stranger: Rate(0.5, 20)}
    with strict_gateway(tmp_path, shares=replace(SHARES, requests=Flow(each, {}))) as station:
        entering = stranger(station)
        with stranger(station) as client:
            body = {"key": one_time_key(station, Role.viewer), "name": "Ana"}
            entering.post("/access/enter", json=body).raise_for_status()
            answers: list[httpx.Response] = []
            while not answers or answers[-1].status_code == 200:
                assert len(answers) < 100
                answers.append(client.get("/access/me"))
            assert answers[-1].json()["code"] == "access_too_many_requests"
            assert int(answers[-1].headers["retry-after"]) == 2
            # A session of its own has a limit of its own.
            assert entering.get("/status").status_code == 200
        entering.close()


def test_one_stream_too_many_hears_when_to_come_back_and_a_closed_one_makes_room(station: Gateway) -> None:
    with person(station, Role.viewer) as ana, contextlib.ExitStack() as open_ones:
        cookie = "; ".join(f"{name}={value}" for name, value in ana.cookies.items())

        def one_more() -> Page:
            return open_ones.enter_context(page(station.base, cookie=cookie))

        pages = [one_more() for _ in range(STREAMS[Standing.viewer].each)]
        with pytest.raises(InvalidStatus) as refused:
            one_more()
        answer = refused.value.response
        assert (answer.status_code, answer.headers["Retry-After"]) == (429, "10")
        assert b"access_too_many_requests" in answer.body
        pages[0].connection.close()
        eventually(lambda: len(station.web.limits.streams) < len(pages), "one is counted no more")
        assert one_more().hello["role"] == "viewer"
    eventually(lambda: len(station.web.limits.streams) == 0, "none is counted")


def test_streams_that_are_opened_and_closed_on_and_on_are_slowed_down(tmp_path: Path) -> None:
    each = {**REQUESTS, Standing.viewer: Rate(0.001, 5 * STREAM_COSTS_REQUESTS)}
    with strict_gateway(tmp_path, shares=replace(SHARES, requests=Flow(each, {}))) as station:
        ana = person(station, Role.viewer)
        cookie = "; ".join(f"{name}={value}" for name, value in ana.cookies.items())
        ana.close()
        for _ in range(5):
            with page(station.base, cookie=cookie):
                pass
        with pytest.raises(InvalidStatus) as refused, page(station.base, cookie=cookie):
            pass
        assert refused.value.response.status_code == 429
