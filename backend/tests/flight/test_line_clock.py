"""Reads that come together share a time, and what they bring is decoded at just that time."""

from __future__ import annotations

import time

import pytest

from epf_gcs.flight.line_clock import LineClock
from epf_gcs.recordings.topics import BOARD_RECEIVED, BOARD_SENT, SIMULATOR_RECEIVED, SIMULATOR_SENT


class SteadyClock:
    """The system's steady clock in the test's hand."""

    def __init__(self) -> None:
        self.ns = 5_000_000_000

    def __call__(self) -> int:
        return self.ns

    def wait_us(self, microseconds: int) -> None:
        self.ns += 1000 * microseconds


@pytest.fixture
def steady(monkeypatch: pytest.MonkeyPatch) -> SteadyClock:
    clock = SteadyClock()
    monkeypatch.setattr(time, "monotonic_ns", clock)
    return clock


def test_reads_within_a_millisecond_of_the_first_have_its_time(steady: SteadyClock) -> None:
    clock = LineClock()
    first = clock.received(BOARD_RECEIVED)
    steady.wait_us(600)
    assert clock.received(BOARD_RECEIVED) == first
    steady.wait_us(399)
    assert clock.received(BOARD_RECEIVED) == first
    steady.wait_us(1)
    assert clock.received(BOARD_RECEIVED) == first + 1_000_000, "counted from the first, not from the one before"


@pytest.mark.parametrize("between", [BOARD_SENT, SIMULATOR_RECEIVED, SIMULATOR_SENT])
def test_another_topic_in_between_parts_them(steady: SteadyClock, between: int) -> None:
    clock = LineClock()
    stamps = [clock.received(BOARD_RECEIVED)]
    for topic in (between, BOARD_RECEIVED):
        steady.wait_us(10)
        stamps.append(clock.sent(topic))
    assert stamps == [stamps[0], stamps[0] + 10_000, stamps[0] + 20_000]


def test_each_datagram_has_its_own_time(steady: SteadyClock) -> None:
    clock = LineClock()
    first = clock.received(SIMULATOR_RECEIVED)
    steady.wait_us(1)
    assert clock.received(SIMULATOR_RECEIVED) == first + 1000


def test_while_a_read_is_decoded_the_time_is_its_and_afterwards_the_present(steady: SteadyClock) -> None:
    clock = LineClock()
    seen: list[tuple[bytes, int, float]] = []

    def take(data: bytes) -> None:
        steady.wait_us(100)
        clock.sent(SIMULATOR_SENT)
        seen.append((data, clock.now_ns(), clock.now_s()))

    decode = clock.decoding(take)
    stamp = clock.received(BOARD_RECEIVED)
    steady.wait_us(200)
    decode(b"one")
    assert seen == [(b"one", stamp, stamp * 1e-9)]
    assert clock.now_ns() == stamp + 300_000


def test_a_decoder_that_fails_does_not_stop_the_time(steady: SteadyClock) -> None:
    clock = LineClock()

    def fail(_: bytes) -> None:
        raise ValueError("damaged")

    stamp = clock.received(BOARD_RECEIVED)
    with pytest.raises(ValueError, match="damaged"):
        clock.decoding(fail)(b"")
    steady.wait_us(50)
    assert clock.now_ns() == stamp + 50_000
