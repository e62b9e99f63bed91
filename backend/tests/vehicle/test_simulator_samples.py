"""How often a simulator's datagrams become samples."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

import pytest

from epf_gcs.vehicle.simulator_samples import SimulatorSamples
from epf_gcs.xplane.datagram import Eight, Record, build
from tests.support.simulator import NO, ROWS, WHOLE

ONE_ROW = build([Record(3, ROWS[3])])
START_S = 1.7e9


class Taken:
    """The samples that were made: topic and time, and of each topic the newest values and what was not plausible."""

    def __init__(self) -> None:
        self.samples: list[tuple[str, float]] = []
        self.newest: dict[str, Mapping[str, Any]] = {}
        self.implausible: dict[str, list[str]] = {}

    def take(self, topic: str, t_s: float, values: Mapping[str, Any], implausible: Iterable[str] = ()) -> None:
        self.samples.append((topic, round(t_s - START_S, 3)))
        self.newest[topic] = values
        self.implausible[topic] = list(implausible)

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


def one_row(row: int, values: Eight | None = None) -> bytes:
    return build([Record(row, ROWS[row] if values is None else values)])


def test_a_row_that_came_within_the_last_second_arrives_and_what_the_board_needs_beside_it_is_missing() -> None:
    samples = SimulatorSamples(Taken())
    show(samples, one_row(20), 0.0)
    show(samples, one_row(3), 0.5)
    show(samples, one_row(6), 0.5)
    assert samples.rows(START_S + 1.0) == [3, 6, 20]
    assert samples.missing_rows(START_S + 1.0) == [4, 8, 16, 17, 25]
    assert samples.rows(START_S + 1.25) == [3, 6]
    assert samples.missing_rows(START_S + 1.25) == [4, 8, 16, 17, 20, 25]


def test_a_value_whose_row_stopped_is_shown_as_none_and_does_not_stand_still() -> None:
    taken = Taken()
    samples = SimulatorSamples(taken)
    show(samples, one_row(3), 0.0)
    assert taken.newest["simulator"]["indicated_airspeed_kt"] == 95.5
    assert taken.newest["simulator"]["pitch_deg"] is None
    show(samples, one_row(17), 1.5)
    assert taken.newest["simulator"]["indicated_airspeed_kt"] is None
    assert taken.newest["simulator"]["pitch_deg"] == 2.5


def test_a_value_that_cannot_be_is_named_beside_those_that_can() -> None:
    taken = Taken()
    samples = SimulatorSamples(taken)
    show(samples, one_row(3), 0.0)
    assert taken.implausible["simulator"] == []
    show(samples, one_row(20, (*ROWS[20][:1], float("inf"), *ROWS[20][2:])), 0.1)
    assert taken.implausible["simulator"] == ["longitude_deg"]
    assert taken.newest["simulator"]["longitude_deg"] is None
    assert taken.newest["simulator"]["latitude_deg"] == pytest.approx(ROWS[20][0])


def test_all_rows_are_shown_as_they_came_five_times_a_second() -> None:
    taken = Taken()
    samples = SimulatorSamples(taken)
    show(samples, one_row(20), 0.0)
    for index in range(1, 18):
        show(samples, one_row(3), 0.025 * index)
    assert taken.times_s("xplane_rows") == [0.0, 0.2, 0.4]
    assert list(taken.newest["xplane_rows"]["rows"]) == ["3", "20"]
    assert taken.newest["xplane_rows"]["rows"]["3"] == list(ROWS[3])
    assert taken.newest["xplane_rows"]["rows"]["20"] == pytest.approx(list(ROWS[20]))


def test_rows_that_come_one_by_one_are_a_frame_for_the_board_with_the_last_of_them() -> None:
    taken = Taken()
    samples = SimulatorSamples(taken)
    for index, row in enumerate((3, 4, 8, 16, 17, 20, 25)):
        show(samples, one_row(row), 0.001 * index)
    assert taken.times_s("xplane_info") == [0.006]
    assert taken.newest["xplane_info"]["speed_kt"] == 95.5


def test_another_simulator_begins_without_the_rows_of_the_one_before() -> None:
    taken = Taken()
    samples = SimulatorSamples(taken)
    for row in (3, 4, 8, 16):
        show(samples, one_row(row), 0.0)
    samples.begin("xp12")
    assert samples.profile == "xp12"
    assert samples.rows(START_S) == []
    for row in (17, 20, 25):
        show(samples, one_row(row), 0.1)
    assert taken.times_s("xplane_info") == [], "half of the frame was another simulator's"
    assert samples.datagrams == 7, "what came over the line is counted on"


def test_angular_rates_are_read_as_the_simulator_of_this_generation_sends_them() -> None:
    shown = {}
    for profile in ("xp10", "xp12"):
        samples = SimulatorSamples(taken := Taken())
        samples.begin(profile)
        show(samples, one_row(16, (1.0, 2.0, 3.0) + (NO,) * 5), 0.0)
        shown[profile] = taken.newest["simulator"]["q_rad_s"]
    assert shown["xp10"] != shown["xp12"]


def test_rows_beyond_what_a_simulator_has_are_left_out_and_the_others_are_counted_on() -> None:
    samples = SimulatorSamples(Taken())
    show(samples, one_row(3), 0.0)
    for row in range(1000, 1255):
        show(samples, build([Record(row, (7.5,) * 8)]), 0.1)
    show(samples, build([Record(1999, (7.5,) * 8), Record(3, ROWS[3])]), 0.2)
    assert len(samples.arrivals) == 256
    assert 1999 not in samples.arrivals
    assert samples.arrivals[3].count == 2


def test_samples_that_go_on_from_a_kept_state_are_those_that_would_have_come() -> None:
    taken, again = Taken(), Taken()
    samples, later = SimulatorSamples(taken), SimulatorSamples(again)
    samples.begin("xp12")
    for index, row in enumerate((3, 4, 8, 16)):
        show(samples, one_row(row), 0.01 * index)
    later.restore(samples.kept())
    assert again.samples == []
    assert later.profile == "xp12"
    assert (later.datagrams, later.bytes_in) == (4, samples.bytes_in)
    taken.samples.clear()
    for one in (samples, later):
        for index, row in enumerate((17, 20, 25, 3, 4)):
            show(one, one_row(row), 0.035 + 0.001 * index)
        show(one, one_row(8), 0.21)
    assert again.samples == taken.samples
    assert taken.times_s("xplane_info") == [0.037]
    assert taken.times_s("xplane_rows") == [0.21]
    assert again.newest == taken.newest
    assert {row: one.count for row, one in later.arrivals.items()} == {
        row: one.count for row, one in samples.arrivals.items()
    }
