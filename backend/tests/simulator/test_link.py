"""The simulated network."""

import pytest

from epf_gcs.simulator.link import Link, LinkQuality


def delivered(link: Link[int], count: int, period_s: float = 0.02) -> dict[int, float]:
    """Send 0, 1, 2 ... a period apart; returns what arrived, and when."""
    arrivals: dict[int, float] = {}
    for number in range(count):
        now_s = number * period_s
        link.send(number, now_s)
        arrivals |= dict.fromkeys(link.due(now_s), now_s)
    return arrivals | dict.fromkeys(link.due(float("inf")), float("inf"))


def test_a_perfect_link_delivers_at_once() -> None:
    arrivals = delivered(Link(LinkQuality(), "1"), 10)
    assert list(arrivals) == list(range(10))
    assert all(at_s == number * 0.02 for number, at_s in arrivals.items())


def test_delay_holds_every_datagram_back_by_as_much() -> None:
    link: Link[int] = Link(LinkQuality(delay_ms=100.0), "1")
    link.send(1, 5.0)
    assert link.due(5.099) == []
    assert link.next_due_s == pytest.approx(5.1)
    assert link.due(5.1) == [1]
    assert link.next_due_s is None


def test_jitter_never_reorders() -> None:
    arrivals = delivered(Link(LinkQuality(delay_ms=10.0, jitter_ms=200.0), "7"), 500)
    assert list(arrivals) == list(range(500))


def test_loss_takes_its_share_and_counts_it() -> None:
    link: Link[int] = Link(LinkQuality(loss=0.05), "3")
    arrivals = delivered(link, 10_000)
    assert len(arrivals) + link.lost == 10_000
    assert 400 <= link.lost <= 600


def test_the_same_seed_loses_the_same_datagrams_and_another_seed_others() -> None:
    quality = LinkQuality(jitter_ms=30.0, loss=0.2)
    first = delivered(Link(quality, "3"), 1000)
    assert delivered(Link(quality, "3"), 1000) == first
    assert delivered(Link(quality, "4"), 1000) != first
