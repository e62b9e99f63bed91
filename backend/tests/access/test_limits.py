"""What a caller may ask has a limit by role; this computer has none."""

from __future__ import annotations

import contextlib
from collections.abc import Iterator
from pathlib import Path

import httpx
import pytest
from websockets.exceptions import InvalidStatus

from epf_gcs.access import limits as limits_module
from epf_gcs.access.caller import LOCAL, Caller
from epf_gcs.access.limits import OF_ROLE, STRANGERS, UPLOADS_OF_ALL_BYTES_PER_H, CallerLimits
from epf_gcs.access.roles import Role
from epf_gcs.errors import TooManyError
from tests.support.callers import one_time_key, person, stranger, strict_gateway
from tests.support.gateway import Gateway
from tests.support.page import Page, page
from tests.support.waiting import eventually


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
        for number in range(int(STRANGERS.requests_at_once) + 100):
            limits.request(None, f"2001:db8::{number:x}")
            asked += 1
    assert asked == STRANGERS.requests_at_once


def test_requests_are_counted_by_session_and_strangers_by_address() -> None:
    now_s = [0.0]
    limits = CallerLimits(lambda: now_s[0])
    assert granted(limits, None) == STRANGERS.requests_at_once
    assert granted(limits, None, "10.0.0.2") == STRANGERS.requests_at_once
    for role in Role:
        assert granted(limits, caller(role, role.name)) == OF_ROLE[role].requests_at_once
    assert granted(limits, caller(Role.viewer, "another")) == OF_ROLE[Role.viewer].requests_at_once
    now_s[0] = 2.0
    assert granted(limits, None) == 2 * STRANGERS.requests_per_s
    assert granted(limits, LOCAL) == 20000


def test_uploads_are_limited_by_role_and_in_total() -> None:
    limits = CallerLimits(lambda: 0.0)
    most = int(OF_ROLE[Role.operator].upload_bytes_per_h)
    limits.upload(caller(Role.operator), most)
    with pytest.raises(TooManyError):
        limits.upload(caller(Role.operator), 1)
    with pytest.raises(TooManyError):
        limits.upload(caller(Role.viewer, "v"), 1)
    left = int(UPLOADS_OF_ALL_BYTES_PER_H) - most
    for number in range(left // most):
        limits.upload(caller(Role.operator, f"o{number}"), most)
    with pytest.raises(TooManyError):
        limits.upload(caller(Role.operator, "last"), most)
    limits.upload(LOCAL, most)


def test_streams_are_counted_while_they_are_open() -> None:
    limits = CallerLimits(lambda: 0.0)
    for _ in range(OF_ROLE[Role.viewer].sockets):
        limits.socket_opened(caller(Role.viewer))
    with pytest.raises(TooManyError):
        limits.socket_opened(caller(Role.viewer))
    limits.socket_opened(caller(Role.viewer, "another"))
    limits.socket_closed(caller(Role.viewer))
    limits.socket_opened(caller(Role.viewer))
    for _ in range(100):
        limits.socket_opened(LOCAL)


@pytest.fixture
def station(tmp_path: Path) -> Iterator[Gateway]:
    with strict_gateway(tmp_path / "data") as gateway:
        yield gateway


def test_who_asks_too_much_hears_when_to_come_back(station: Gateway, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(limits_module, "STRANGERS", STRANGERS._replace(requests_per_s=0.5, requests_at_once=20.0))
    with stranger(station) as client:
        answers: list[httpx.Response] = []
        while not answers or answers[-1].status_code == 200:
            assert len(answers) < 100
            answers.append(client.get("/access/me"))
        assert answers[-1].json()["code"] == "access_too_many_requests"
        assert int(answers[-1].headers["retry-after"]) == 2
        # A session of its own has a limit of its own.
        body = {"key": one_time_key(station, Role.viewer), "name": "Ana"}
        station.web.limits._requests.clear()
        client.post("/access/enter", json=body).raise_for_status()
        assert client.get("/status").status_code == 200


def test_one_stream_too_many_hears_when_to_come_back_and_a_closed_one_makes_room(station: Gateway) -> None:
    with person(station, Role.viewer) as ana, contextlib.ExitStack() as open_ones:
        cookie = "; ".join(f"{name}={value}" for name, value in ana.cookies.items())

        def one_more() -> Page:
            return open_ones.enter_context(page(station.base, cookie=cookie))

        pages = [one_more() for _ in range(OF_ROLE[Role.viewer].sockets)]
        with pytest.raises(InvalidStatus) as refused:
            one_more()
        answer = refused.value.response
        assert (answer.status_code, answer.headers["Retry-After"]) == (429, "10")
        assert b"access_too_many_requests" in answer.body
        pages[0].connection.close()
        eventually(lambda: station.web.limits._sockets.total() < len(pages), "one is counted no more")
        assert one_more().hello["role"] == "viewer"
    eventually(lambda: not station.web.limits._sockets, "none is counted")
