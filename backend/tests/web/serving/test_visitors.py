"""Shares of connections: whoever holds many makes room, and this computer is never locked out by others."""

from __future__ import annotations

import resource

import pytest

from epf_gcs.errors import ConflictError
from epf_gcs.system.limits import raise_open_files
from epf_gcs.web.serving.uploads import FROM_ELSEWHERE, PER_HOST, Uploads
from epf_gcs.web.serving.visitors import Limits, Visitors, fitting, is_this_computer

LIMITS = Limits(
    connections=6,
    connections_per_host=3,
    for_this_computer=2,
    sockets=3,
    sockets_per_host=2,
    sockets_for_this_computer=2,
)


class Visitor:
    def __init__(self, host: str, idle_since_s: float | None = None) -> None:
        self.host = host
        self.idle_since_s = idle_since_s
        self.ended = False

    def make_room(self) -> None:
        self.ended = True


@pytest.fixture
def visitors() -> Visitors:
    return Visitors(LIMITS)


def test_a_host_that_holds_many_gives_up_the_one_that_was_idle_longest(visitors: Visitors) -> None:
    own = [Visitor("10.0.0.1", since_s) for since_s in (5.0, 3.0, 4.0)]
    assert all(visitors.come_in(one) for one in own)
    assert visitors.come_in(Visitor("10.0.0.1", 9.0))
    assert [one.ended for one in own] == [False, True, False]
    assert len(visitors) == LIMITS.connections_per_host


@pytest.mark.parametrize("address", ["2001:db8::{:x}", "fe80::{:x}%eth0"])
def test_a_network_of_addresses_is_one_host(visitors: Visitors, address: str) -> None:
    assert all(visitors.come_in(Visitor(address.format(number))) for number in range(3))
    assert not visitors.come_in(Visitor(address.format(9)))
    assert visitors.come_in(Visitor("2001:db8:0:1::1")), "another network has its own share"
    assert all(visitors.become_socket(Visitor(address.format(number))) for number in range(2))
    assert not visitors.become_socket(Visitor(address.format(9)))
    uploads = Uploads()
    with uploads.one_more(address.format(1)), uploads.one_more(address.format(2)), uploads.one_more(address.format(3)):
        with pytest.raises(ConflictError), uploads.one_more(address.format(4)):
            pass
        with uploads.one_more("10.0.0.1"):
            pass


def test_who_is_at_work_is_not_sent_away(visitors: Visitors) -> None:
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
    found = fitting(Limits(), descriptors)
    assert found.connections + found.for_this_computer < descriptors - 100
    assert min(found.connections, found.for_this_computer, found.connections_per_host) > 10


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


def test_uploads_from_elsewhere_leave_places_for_this_computer() -> None:
    uploads = Uploads()
    open_now = [uploads.one_more(host) for host in ["10.0.0.1"] * PER_HOST + ["10.0.0.2"] * (FROM_ELSEWHERE - PER_HOST)]
    for one in open_now:
        one.__enter__()
    for host in ("10.0.0.1", "10.0.0.3"):
        with pytest.raises(ConflictError), uploads.one_more(host):
            pass
    with uploads.one_more("127.0.0.1"), uploads.one_more("127.0.0.1"):
        pass
    open_now[0].__exit__(None, None, None)
    with uploads.one_more("10.0.0.3"):
        pass
