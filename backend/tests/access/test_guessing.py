"""Guessing is slow for who guesses, and costs others nothing."""

from __future__ import annotations

from epf_gcs.access.guessing import (
    FORGOTTEN_S,
    FREE_FAILURES,
    LONGEST_S,
    MOST_ADDRESSES,
    TRIES_AT_ONCE,
    TRIES_PER_S,
    GuessLimiter,
)
from epf_gcs.shares.holder import group_of


def patient(guessing: GuessLimiter, address: str, tries: int, start_s: float = 0.0) -> float:
    """Try as soon as allowed; when the last try was made."""
    now_s = start_s
    for _ in range(tries):
        while (wait_s := guessing.failed(address, now_s)) > 0:
            now_s += wait_s
    return now_s


def test_a_few_slips_cost_nothing_and_then_each_try_waits_twice_as_long() -> None:
    guessing = GuessLimiter()
    assert patient(guessing, "10.0.0.1", FREE_FAILURES) == 0.0
    waits = [guessing.failed("10.0.0.1", 0.0)]
    for _ in range(4):
        now_s = sum(waits)
        assert guessing.failed("10.0.0.1", now_s) == 0
        waits.append(guessing.failed("10.0.0.1", now_s))
    assert waits == [1, 2, 4, 8, 16]


def test_a_day_is_enough_for_three_hundred_tries() -> None:
    guessing = GuessLimiter()
    assert patient(guessing, "10.0.0.1", 300) > 300 * LONGEST_S * 0.95


def test_another_address_pays_nothing() -> None:
    guessing = GuessLimiter()
    patient(guessing, "10.0.0.1", 20)
    assert guessing.failed("10.0.0.2", 1e6) == 0


def test_many_at_the_same_moment_are_no_way_round() -> None:
    guessing = GuessLimiter()
    assert [guessing.failed("10.0.0.1", 0.0) for _ in range(10)].count(0) == FREE_FAILURES


def test_a_network_of_addresses_is_one() -> None:
    guessing = GuessLimiter()
    tries = [guessing.failed(f"2001:db8::{number:x}", 0.0) for number in range(10)]
    assert tries.count(0) == FREE_FAILURES
    assert guessing.failed("2001:db8:0:1::1", 0.0) == 0


def test_ipv4_behind_a_socket_for_both_is_not_one_network() -> None:
    guessing = GuessLimiter()
    patient(guessing, "::ffff:10.0.0.1", 20)
    assert guessing.failed("::ffff:10.0.0.2", 1e6) == 0
    assert group_of("::ffff:10.0.0.1") == group_of("10.0.0.1")


def test_a_zone_and_a_name_are_no_way_round_either() -> None:
    assert group_of("fe80::1%eth0") == group_of("fe80::2%eth0")
    assert group_of("testclient") == "testclient"


def test_all_together_have_a_limit() -> None:
    guessing = GuessLimiter()
    tries = [guessing.failed(f"10.0.{number // 250}.{number % 250}", 0.0) for number in range(100)]
    assert tries.count(0) == TRIES_AT_ONCE
    assert guessing.failed("192.0.2.1", 0.0) <= 1 / TRIES_PER_S
    assert guessing.failed("192.0.2.1", 1 / TRIES_PER_S) == 0


def test_failures_are_forgotten_and_take_bounded_room() -> None:
    guessing = GuessLimiter()
    now_s = patient(guessing, "10.0.0.1", 10)
    assert guessing.failed("10.0.0.1", now_s + FORGOTTEN_S + LONGEST_S) == 0
    assert guessing.failed("10.0.0.1", now_s + FORGOTTEN_S + LONGEST_S) == 0
    for number in range(MOST_ADDRESSES + 50):
        guessing.failed(f"10.{number // 65025}.{number // 255 % 255}.{number % 255}", 1e6 + number)
    assert len(guessing._of) <= MOST_ADDRESSES
