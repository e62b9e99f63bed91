"""Counts, rates and ages as somebody reads them."""

from __future__ import annotations

from dataclasses import asdict

import pytest

from epf_gcs.clock import Clock
from epf_gcs.error_log import ErrorLog
from epf_gcs.vehicle.arrivals import Arrivals
from epf_gcs.vehicle.frame_statistics import FrameStatistics
from epf_gcs.vehicle.inspection import CountedFrame, copy_frames, inspect_frames, inspect_rows, share_percent
from epf_gcs.vehicle.vehicle import Vehicle
from tests.support.outlet import KeptOutlet


def heard(*times_s: float) -> Arrivals:
    arrivals = Arrivals()
    for t_s in times_s:
        arrivals.heard(t_s, (float("nan"), float("inf"), -float("inf"), t_s))
    return arrivals


def test_a_frame_has_its_rate_to_the_hundredth_and_its_times_to_the_thousandth() -> None:
    (frame,) = inspect_frames([CountedFrame(1, "ahrs", 3, 0.2, heard(100.0, 100.3, 100.7, 101.3))], 101.53456)
    shown = asdict(frame)
    assert shown.pop("values")[3] == 101.3
    assert shown == {
        "id": 1,
        "name": "ahrs",
        "damaged": 3,
        "stale_after_s": 0.2,
        "count": 4,
        "rate_hz": 2.31,
        "jitter_ms": 124.722,
        "age_s": 0.235,
        "units": {},
    }


@pytest.mark.parametrize("name", ["autopilot_parameters", "capabilities", "acknowledgement"])
def test_what_is_sent_when_asked_for_has_no_jitter(name: str) -> None:
    (frame,) = inspect_frames([CountedFrame(1, name, 0, None, heard(1.0, 3.0, 90.0))], 91.0)
    assert (frame.count, frame.jitter_ms) == (3, None)


def test_a_frame_that_never_came_has_neither_rate_nor_age() -> None:
    (frame,) = inspect_frames([CountedFrame(1, "ahrs", 0, None, Arrivals())], 5.0)
    assert (frame.count, frame.rate_hz, frame.jitter_ms, frame.age_s) == (0, 0.0, None, None)


def test_rows_are_those_of_the_profile_and_those_that_came_in_their_order() -> None:
    rows = inspect_rows({77: heard(1.0), 3: heard(2.0)}, "xp10", 3.0)
    assert [row.row for row in rows] == sorted(row.row for row in rows)
    by_number = {row.row: row for row in rows}
    assert (by_number[77].name, by_number[77].expected, by_number[77].age_s) == ("row_77", False, 2.0)
    assert by_number[77].values == [None, None, None, 1.0]
    assert (by_number[3].count, by_number[3].expected, by_number[4].count) == (1, True, 0)
    assert by_number[4].values is None


@pytest.mark.parametrize(
    ("bytes_per_s", "capacity", "percent"),
    [(123.4, 1000.0, 12.3), (0.0, 5.0, 0.0), (5.0, None, None), (5.0, 0.0, None)],
)
def test_a_share_of_a_line_has_one_decimal_and_needs_its_capacity(
    bytes_per_s: float, capacity: float | None, percent: float | None
) -> None:
    assert share_percent(bytes_per_s, capacity) == percent


def test_what_is_in_no_definition_is_listed_by_its_number_after_what_is() -> None:
    statistics = FrameStatistics()
    statistics.unknown = {0x77: heard(1.0), 0x42: heard(2.0)}
    statistics.unknown_damaged.update({0x42: 3})
    telemetry = Vehicle(Clock(), KeptOutlet(), ErrorLog(), lambda _: 0.1).telemetry
    copied = copy_frames(statistics, telemetry)
    assert [one.name for one in copied[-2:]] == ["unknown_0x42", "unknown_0x77"]
    assert [(one.damaged, one.arrivals.last_s) for one in copied[-2:]] == [(3, 2.0), (0, 1.0)]
    statistics.unknown[0x42].heard(9.0, None)
    assert copied[-2].arrivals.last_s == 2.0, "a copy does not change"
