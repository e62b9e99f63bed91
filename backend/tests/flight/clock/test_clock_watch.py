"""A clock that is set in flight, or that nobody vouches for, is noted; one that is steered is not."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import structlog

from epf_gcs.flight.clock.clock_watch import ClockWatch
from epf_gcs.recordings.notes import CLOCK

START_NS = 946_684_800_000_000_000


class Computer:
    """Its two clocks, the stamps that a flight makes with them, and what was noted."""

    def __init__(self) -> None:
        self.steady_ns = 7_000_000_000
        self.unix_ns = START_NS
        self.synchronised: bool | None = False
        self.noted: list[Mapping[str, Any]] = []
        self.offset_ns = self.unix_ns - self.steady_ns
        self.watch = ClockWatch(
            self._Stamps(self.offset_ns),
            self._know,
            unix_ns=lambda: self.unix_ns,
            steady_ns=lambda: self.steady_ns,
            synchronised=lambda: self.synchronised,
        )

    def _know(self, name: str, content: Mapping[str, Any]) -> None:
        assert name == CLOCK
        self.noted.append(content)

    class _Stamps:
        def __init__(self, offset_ns: int) -> None:
            self._offset_ns = offset_ns

        def unix_ns(self, steady_ns: int) -> int:
            return steady_ns + self._offset_ns

    def run(self, seconds: float, drift_s: float = 0.0) -> None:
        self.steady_ns += round(seconds * 1e9)
        self.unix_ns += round((seconds + drift_s) * 1e9)
        self.watch.look()


def test_a_clock_without_anybody_who_vouches_for_it_is_noted_once() -> None:
    computer = Computer()
    for _ in range(3):
        computer.run(0.5)
    assert computer.noted == [{"ahead_s": 0.0, "synchronised": False}]


def test_a_clock_that_is_set_in_flight_is_noted_with_how_far_off_it_was() -> None:
    computer = Computer()
    computer.run(10)
    computer.synchronised = True
    computer.run(0.5, drift_s=840_000_000.25)
    computer.run(0.5)
    assert computer.noted[1:] == [{"ahead_s": 840_000_000.25, "synchronised": True}]


def test_a_clock_that_is_steered_is_not_noted() -> None:
    computer = Computer()
    computer.run(1)
    for _ in range(100):
        computer.run(1, drift_s=0.019)
    assert len(computer.noted) == 1


def test_a_clock_that_is_set_back_is_noted_too() -> None:
    computer = Computer()
    computer.run(1)
    computer.run(1, drift_s=-3600)
    assert computer.noted[-1]["ahead_s"] == -3600.0


def test_a_clock_that_is_set_nearly_right_again_is_noted_with_what_is_left() -> None:
    computer = Computer()
    computer.run(1)
    computer.run(1, drift_s=100)
    computer.run(1, drift_s=-99)
    assert [note["ahead_s"] for note in computer.noted] == [0.0, 100.0, 1.0]


def test_a_clock_that_was_wrong_from_the_start_is_noted_once_with_how_far() -> None:
    computer = Computer()
    computer.run(1, drift_s=3)
    computer.run(1)
    assert [note["ahead_s"] for note in computer.noted] == [3.0]


def test_the_moment_between_two_readings_is_no_error_of_the_clock() -> None:
    computer = Computer()
    computer.run(1, drift_s=0.004)
    assert computer.noted == [{"ahead_s": 0.0, "synchronised": False}]


def test_the_log_says_that_a_clock_was_set_and_not_that_somebody_vouches_for_it() -> None:
    computer = Computer()
    with structlog.testing.capture_logs() as logged:
        computer.run(1)
        computer.synchronised = True
        computer.run(1)
        assert logged == []
        computer.run(1, drift_s=-7.12345)
    assert [(line["event"], line["log_level"], line["ahead_s"]) for line in logged] == [
        ("the system's clock was set", "warning", -7.123)
    ]
    assert computer.noted[-1]["ahead_s"] == -7.123
