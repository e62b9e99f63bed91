"""Shares of connections: whoever holds many makes room, and this computer is never locked out by others."""

from __future__ import annotations

import resource
from dataclasses import replace

import pytest

from epf_gcs.shares.holder import Standing, is_this_computer
from epf_gcs.shares.known_hosts import FORGOTTEN_S
from epf_gcs.shares.table import SHARES, by_host, fitting
from epf_gcs.system.limits import raise_open_files
from epf_gcs.web.serving.visitors import Visitors

PER_HOST_HERE = 3
FEW = replace(
    SHARES,
    connections=by_host(each=PER_HOST_HERE, strangers=6, others=8, own=2),
    sockets=by_host(each=2, strangers=3, others=3, own=2),
)


class Visitor:
    """One that is busy for so long, or idle; it has shown a key, or not."""

    def __init__(
        self, host: str, idle_since_s: float | None = None, *, since_s: float = 0.0, has_shown_key: bool = True
    ) -> None:
        self.host = host
        self.idle_since_s = idle_since_s
        self.since_s = since_s if idle_since_s is None else idle_since_s
        self.has_shown_key = has_shown_key
        self.ended = False

    def make_room(self) -> None:
        self.ended = True


@pytest.fixture
def now_s() -> list[float]:
    return [0.0]


@pytest.fixture
def visitors(now_s: list[float]) -> Visitors:
    return Visitors(shares=FEW, now_s=lambda: now_s[0])


def test_a_host_that_holds_many_gives_up_the_one_that_was_idle_longest(visitors: Visitors) -> None:
    own = [Visitor("10.0.0.1", since_s) for since_s in (5.0, 3.0, 4.0)]
    assert all(visitors.come_in(one) for one in own)
    assert visitors.come_in(Visitor("10.0.0.1", 9.0))
    assert [one.ended for one in own] == [False, True, False]
    assert len(visitors) == PER_HOST_HERE


@pytest.mark.parametrize("address", ["2001:db8::{:x}", "fe80::{:x}%eth0"])
def test_a_network_of_addresses_is_one_host(visitors: Visitors, address: str) -> None:
    assert all(visitors.come_in(Visitor(address.format(number))) for number in range(3))
    assert not visitors.come_in(Visitor(address.format(9)))
    assert visitors.come_in(Visitor("2001:db8:0:1::1")), "another network has its own share"
    assert all(visitors.become_socket(Visitor(address.format(number))) for number in range(2))
    assert not visitors.become_socket(Visitor(address.format(9)))


def test_who_has_shown_a_key_and_is_at_work_is_not_sent_away(visitors: Visitors) -> None:
    busy = [Visitor("10.0.0.1") for _ in range(3)]
    assert all(visitors.come_in(one) for one in busy)
    assert not visitors.come_in(Visitor("10.0.0.1"))
    assert not any(one.ended for one in busy)
    assert visitors.refused == {"connection": 1}
    assert visitors.come_in(Visitor("10.0.0.2")), "another host has its own share"
    visitors.leave(busy[0])
    assert visitors.come_in(Visitor("10.0.0.1"))


def test_when_all_is_full_the_host_with_most_makes_room(visitors: Visitors) -> None:
    many = [Visitor("10.0.0.1", 9.0) for _ in range(3)]
    few = [Visitor("10.0.0.2", 1.0), Visitor("10.0.0.3", 1.0), Visitor("10.0.0.4", 1.0)]
    assert all(visitors.come_in(one) for one in (*many, *few))
    assert visitors.come_in(Visitor("10.0.0.5"))
    assert [one.ended for one in many].count(True) == 1
    assert not any(one.ended for one in few)


def test_a_connection_that_has_shown_no_key_makes_room_whatever_it_is_doing(visitors: Visitors) -> None:
    slow = [Visitor(f"10.0.0.{number // 3}", since_s=5.0 - number, has_shown_key=False) for number in range(6)]
    assert all(visitors.come_in(one) for one in slow)
    assert visitors.come_in(Visitor("10.0.0.9", has_shown_key=False))
    assert [one.ended for one in slow] == [False, False, True, False, False, False]


def test_who_waits_goes_before_who_is_busy_and_a_stranger_before_both_with_a_key(visitors: Visitors) -> None:
    keyed = Visitor("10.0.0.1", 1.0)
    busy = Visitor("10.0.0.1", since_s=1.0, has_shown_key=False)
    idle = Visitor("10.0.0.1", 9.0, has_shown_key=False)
    assert all(visitors.come_in(one) for one in (keyed, busy, idle))
    for goes in (idle, busy, keyed):
        assert not goes.ended
        assert visitors.come_in(Visitor("10.0.0.1"))
        assert goes.ended


def test_hosts_where_a_key_was_shown_have_places_that_strangers_cannot_take(
    visitors: Visitors, now_s: list[float]
) -> None:
    visitors.know("10.0.0.9", Standing.viewer)
    strangers = [Visitor(f"10.0.0.{number}") for number in range(6)]
    assert all(visitors.come_in(one) for one in strangers)
    assert not visitors.come_in(Visitor("10.0.0.8")), "the strangers' share is full"
    now_s[0] = FORGOTTEN_S
    assert visitors.come_in(Visitor("10.0.0.9"))
    assert not any(one.ended for one in strangers)
    now_s[0] = FORGOTTEN_S + 1
    assert not visitors.come_in(Visitor("10.0.0.9")), "it was long ago"


def test_a_host_where_a_key_was_shown_makes_no_room_for_strangers(visitors: Visitors) -> None:
    visitors.know("10.0.0.9", Standing.owner)
    known = [Visitor("10.0.0.9", 1.0, has_shown_key=False) for _ in range(3)]
    strangers = [Visitor(f"10.0.0.{number}", 5.0, has_shown_key=False) for number in range(6)]
    assert all(visitors.come_in(one) for one in (*known, *strangers[:5]))
    for _ in range(4):
        assert visitors.come_in(Visitor("10.0.0.7", 5.0, has_shown_key=False))
    assert not any(one.ended for one in known)


def test_this_computer_comes_in_however_many_others_there_are(visitors: Visitors) -> None:
    for number in range(6):
        assert visitors.come_in(Visitor(f"10.0.0.{number}"))
    assert not visitors.come_in(Visitor("10.0.0.9"))
    for host in ("127.0.0.1", "::1"):
        assert visitors.come_in(Visitor(host))
    assert not visitors.come_in(Visitor("127.0.0.1"))


def test_streams_have_shares_too(visitors: Visitors) -> None:
    first = Visitor("10.0.0.1")
    assert visitors.become_socket(first)
    assert visitors.become_socket(Visitor("10.0.0.1"))
    assert not visitors.become_socket(Visitor("10.0.0.1"))
    assert visitors.become_socket(Visitor("10.0.0.2"))
    assert not visitors.become_socket(Visitor("10.0.0.3"))
    assert visitors.become_socket(Visitor("127.0.0.1"))
    visitors.leave(first)
    assert visitors.become_socket(Visitor("10.0.0.3"))


@pytest.mark.parametrize("descriptors", [256, 1024, 1500, 20000])
def test_there_are_never_more_connections_than_descriptors(descriptors: int) -> None:
    """Each may need two: its socket, and the file that is sent over it."""
    found = fitting(SHARES, descriptors).connections
    assert 2 * found.all <= max(100, descriptors - 200)
    assert all(min(part) > 10 for part in found.parts.values())


def test_what_the_system_allows_is_taken() -> None:
    soft, hard = resource.getrlimit(resource.RLIMIT_NOFILE)
    try:
        resource.setrlimit(resource.RLIMIT_NOFILE, (min(soft, 1000), hard))
        assert raise_open_files() == hard
        assert resource.getrlimit(resource.RLIMIT_NOFILE) == (hard, hard)
    finally:
        resource.setrlimit(resource.RLIMIT_NOFILE, (soft, hard))


@pytest.mark.parametrize(
    ("host", "own"), [("127.0.0.1", True), ("127.1.2.3", True), ("::1", True), ("10.0.0.1", False)]
)
def test_this_computer_is_known(host: str, own: bool) -> None:
    assert is_this_computer(host) is own


def begun(visitors: Visitors, hosts: list[str], each: int = 1) -> int:
    """How many TLS handshakes these hosts begin, who try so many times each, in turns."""
    return sum(visitors.begin_handshake(host) for _ in range(each) for host in hosts)


ROW = SHARES.handshakes
A_PAGE = 6
"""Connections that a browser opens."""


def test_a_host_that_shakes_hands_on_and_on_is_slowed_down_and_a_class_is_not(
    visitors: Visitors, now_s: list[float]
) -> None:
    assert begun(visitors, ["10.0.0.1"], 120) == 120
    per_s, at_once = ROW.each[Standing.stranger]
    assert begun(visitors, ["10.0.0.2"], 2000) == at_once
    now_s[0] = 1.0
    assert begun(visitors, ["10.0.0.2"], 2000) == per_s
    assert begun(visitors, ["10.0.0.3"], A_PAGE) == A_PAGE


def test_a_network_of_addresses_shakes_hands_as_one_host(visitors: Visitors) -> None:
    hosts = [f"2001:db8::{number:x}" for number in range(1000)]
    assert begun(visitors, hosts) == ROW.each[Standing.stranger].at_once


def test_strangers_together_have_a_limit(visitors: Visitors) -> None:
    hosts = [f"10.{number >> 8}.{number & 255}.1" for number in range(2000)]
    assert ROW.newcomers is not None
    most = ROW.together[Standing.stranger].at_once + ROW.newcomers.together.at_once
    assert begun(visitors, hosts, 3) == most


def test_this_computer_shakes_hands_as_often_as_it_likes(visitors: Visitors) -> None:
    assert begun(visitors, ["127.0.0.1"], 5000) == 5000


STRANGERS = [f"10.0.1.{number}" for number in range(60)]


def beset(visitors: Visitors, now_s: list[float], seconds: int) -> None:
    """Sixty hosts shake hands ten times a second each."""
    for _ in range(10 * seconds):
        now_s[0] += 0.1
        begun(visitors, STRANGERS)


def test_a_host_where_a_key_was_shown_shakes_hands_whatever_strangers_do(
    visitors: Visitors, now_s: list[float]
) -> None:
    visitors.know("10.0.0.9", Standing.viewer)
    beset(visitors, now_s, 60)
    assert begun(visitors, ["10.0.0.9"], A_PAGE) == A_PAGE
    assert visitors.refused["handshake"] > 20_000


def test_a_newcomer_shakes_hands_before_strangers_who_did_so_often(visitors: Visitors, now_s: list[float]) -> None:
    beset(visitors, now_s, 5)
    for number in range(100, 120):
        beset(visitors, now_s, 1)
        assert begun(visitors, [f"10.0.0.{number}"], A_PAGE) == A_PAGE
