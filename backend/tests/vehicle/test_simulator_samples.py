"""How often a simulator's datagrams become samples."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

from epf_gcs.vehicle.simulator_samples import SimulatorSamples
from epf_gcs.xplane.datagram import Record, build
from tests.support.simulator import ROWS, WHOLE

ONE_ROW = build([Record(3, ROWS[3])])
START_S = 1.7e9


class Taken:
    """The samples that were made: topic and time."""

    def __init__(self) -> None:
        self.samples: list[tuple[str, float]] = []

    def take(self, topic: str, t_s: float, values: Mapping[str, Any], implausible: Iterable[str] = ()) -> None:
        self.samples.append((topic, round(t_s - START_S, 3)))

    def times_s(self, topic: str) -> list[float]:
        return [t_s for name, t_s in self.samples if name == topic]


def show(samples: SimulatorSamples, datagram: bytes, after_s: float) -> None:
    reading = samples.read(datagram, START_S + after_s)
    assert reading is not None
    samples.show(reading)


def test_rows_that_come_one_by_one_are_shown_fifty_times_a_second_at_the_most() -> None:
    taken = Taken()
    samples = SimulatorSamples(taken)
    for index in range(12):
        show(samples, ONE_ROW, 0.007 * index)
    assert taken.times_s("simulator") == [0.0, 0.021, 0.042, 0.063]
    assert samples.datagrams == 12
    assert samples.bytes_in == 12 * len(ONE_ROW)


def test_a_complete_frame_is_shown_at_once() -> None:
    taken = Taken()
    samples = SimulatorSamples(taken)
    for index in range(4):
        show(samples, WHOLE, 0.001 * index)
    assert taken.times_s("simulator") == taken.times_s("xplane_info") == [0.0, 0.001, 0.002, 0.003]


def test_the_rows_of_a_complete_frame_are_there_too() -> None:
    samples = SimulatorSamples(Taken())
    show(samples, WHOLE, 0.0)
    assert samples.rows(START_S) == sorted(ROWS)


def test_what_is_no_datagram_of_a_simulator_is_none() -> None:
    assert SimulatorSamples(Taken()).read(b"rubbish", START_S) is None
