"""Reads that come together share a time, and what they bring is decoded at just that time."""

from __future__ import annotations

import time

import pytest

from epf_gcs.flight.clock.line_clock import LineClock
from epf_gcs.recordings.topics import BOARD_RECEIVED, BOARD_SENT, SIMULATOR_RECEIVED, SIMULATOR_SENT

TICK_NS = 1024


class SteadyClock:
    """The system's steady clock in the test's hand; it and the system's time begin at a tick."""

    def __init__(self) -> None:
        self.ns = 5_000_000 * TICK_NS

    def __call__(self) -> int:
        return self.ns

    def wait(self, ticks: int) -> None:
        self.ns += TICK_NS * ticks


@pytest.fixture
def steady(monkeypatch: pytest.MonkeyPatch) -> SteadyClock:
    clock = SteadyClock()
    monkeypatch.setattr(time, "monotonic_ns", clock)
    monkeypatch.setattr(time, "time_ns", lambda: 1_700_000_000_000_000 * TICK_NS)
    return clock


def test_reads_within_a_millisecond_of_the_first_have_its_time(steady: SteadyClock) -> None:
    clock = LineClock()
    first = clock.received(BOARD_RECEIVED)
    steady.wait(600)
    assert clock.received(BOARD_RECEIVED) == first
    steady.wait(376)
    assert clock.received(BOARD_RECEIVED) == first
    steady.wait(1)
    assert clock.received(BOARD_RECEIVED) == first + 977 * TICK_NS, "counted from the first, not from the one before"


def test_bytes_that_were_read_late_have_the_time_at_which_they_came(steady: SteadyClock) -> None:
    clock = LineClock()
    first = clock.received(BOARD_RECEIVED)
    steady.wait(20_000)
    late = [clock.received(BOARD_RECEIVED, ticks * TICK_NS * 1e-9) for ticks in (8000, 4000, 0)]
    assert late == [first + ticks * TICK_NS for ticks in (12_000, 16_000, 20_000)]


def test_no_time_is_before_an_earlier_one_however_late_bytes_were_read(steady: SteadyClock) -> None:
    clock = LineClock()
    sent = clock.sent(BOARD_SENT)
    steady.wait(1000)
    assert clock.received(BOARD_RECEIVED, 1.0) == sent


@pytest.mark.parametrize("between", [BOARD_SENT, SIMULATOR_RECEIVED, SIMULATOR_SENT])
def test_another_topic_in_between_parts_them(steady: SteadyClock, between: int) -> None:
    clock = LineClock()
    stamps = [clock.received(BOARD_RECEIVED)]
    for topic in (between, BOARD_RECEIVED):
        steady.wait(10)
        stamps.append(clock.sent(topic))
    assert stamps == [stamps[0], stamps[0] + 10 * TICK_NS, stamps[0] + 20 * TICK_NS]


def test_each_datagram_has_its_own_time(steady: SteadyClock) -> None:
    clock = LineClock()
    first = clock.received(SIMULATOR_RECEIVED)
    steady.wait(1)
    assert clock.received(SIMULATOR_RECEIVED) == first + TICK_NS


def test_while_a_read_is_decoded_the_time_is_its_and_afterwards_the_present(steady: SteadyClock) -> None:
    clock = LineClock()
    seen: list[tuple[bytes, int, float]] = []

    def take(data: bytes) -> None:
        steady.wait(100)
        clock.sent(SIMULATOR_SENT)
        seen.append((data, clock.now_ns(), clock.now_s()))

    decode = clock.decoding(take)
    stamp = clock.received(BOARD_RECEIVED)
    steady.wait(200)
    decode(b"one")
    assert seen == [(b"one", stamp, stamp * 1e-9)]
    assert clock.now_ns() == stamp + 300 * TICK_NS
    assert clock.now_s() == pytest.approx((stamp + 300 * TICK_NS) * 1e-9, abs=1e-6)


def test_a_decoder_that_fails_does_not_stop_the_time(steady: SteadyClock) -> None:
    clock = LineClock()

    def fail(_: bytes) -> None:
        raise ValueError("damaged")

    stamp = clock.received(BOARD_RECEIVED)
    with pytest.raises(ValueError, match="damaged"):
        clock.decoding(fail)(b"")
    steady.wait(50)
    assert clock.now_ns() == stamp + 50 * TICK_NS


def test_no_time_has_noise_in_its_last_bits_and_none_is_earlier_than_one_before(steady: SteadyClock) -> None:
    clock = LineClock()
    times: list[int] = []
    for _ in range(20):
        steady.ns += 300
        times += [clock.received(SIMULATOR_RECEIVED, 1e-7), clock.received(SIMULATOR_RECEIVED), clock.now_ns()]
    assert times == sorted(times)
    assert {time_ns % TICK_NS for time_ns in times} == {0}
    assert times[-1] + TICK_NS > clock.offset_ns + steady.ns


@pytest.mark.parametrize("ticks_before", [0, 1, 500, 975, 976])
def test_reads_together_share_their_time_wherever_the_clock_stood(steady: SteadyClock, ticks_before: int) -> None:
    clock = LineClock()
    steady.wait(ticks_before)
    first = clock.received(BOARD_RECEIVED)
    steady.wait(976)
    assert clock.received(BOARD_RECEIVED) == first
    steady.wait(1)
    assert clock.received(BOARD_RECEIVED) > first
