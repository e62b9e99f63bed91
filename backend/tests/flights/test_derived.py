"""Computed signals are what numpy computes from the recorded ones, and are drawn without losing an extreme."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from epf_gcs.errors import InvalidInputError, NotFoundError
from epf_gcs.flights.answers import signals
from epf_gcs.flights.derived import find, split_names
from epf_gcs.flights.fields import FieldMeaning, fields_of
from epf_gcs.flights.flight_data import FlightData, PeriodCache, Samples, TopicSpan
from epf_gcs.flights.signals import Array
from epf_gcs.recordings.notes import Note

START_NS = 1_769_860_800_000_000_000


class Given:
    """A flight with these samples; every topic has times of its own."""

    def __init__(self, **fields: tuple[Any, Any]) -> None:
        self._fields = {name.replace("__", "."): Samples(*one) for name, one in fields.items()}
        self.start_ns = START_NS
        self.end_ns = START_NS + int(max(one.t_s[-1] for one in self._fields.values()) * 1e9)

    def topics(self) -> list[TopicSpan]:
        return [
            TopicSpan(name.split(".")[0], len(one.t_s), self.start_ns, self.end_ns)
            for name, one in self._fields.items()
        ]

    def fields(self, topic: str) -> Mapping[str, FieldMeaning]:
        return fields_of(topic)

    def samples(self, topic: str, field: str) -> Samples:
        return self._fields[f"{topic}.{field}"]

    def notes(self) -> list[Note]:
        return []


T = np.arange(500) * 0.02
ROLL = 20 * np.sin(T)


def ask(flight: FlightData, name: str) -> tuple[str, Array, Array]:
    found = find(flight, PeriodCache(), name)
    return found.unit, found.t_s, found.values


def test_a_rate_is_the_change_from_sample_to_sample() -> None:
    unit, t_s, values = ask(Given(ahrs__roll_deg=(T, ROLL)), "rate(ahrs.roll_deg)")
    assert unit == "deg/s"
    np.testing.assert_array_equal(t_s, T)
    assert np.isnan(values[0])
    np.testing.assert_array_equal(values[1:], np.diff(ROLL) / np.diff(T))


def test_a_rate_goes_the_short_way_over_north_and_not_over_a_gap() -> None:
    t_s = np.concatenate((T, T + 60.0))
    yaw = np.concatenate(((T * 10 + 355) % 360, np.full(500, 90.0)))
    _, _, values = ask(Given(ahrs__yaw_deg=(t_s, yaw)), "rate(ahrs.yaw_deg)")
    np.testing.assert_allclose(values[1:500], 10.0, atol=1e-9)
    assert np.isnan(values[500])
    np.testing.assert_array_equal(values[501:], 0.0)


def test_of_samples_with_one_time_the_last_counts() -> None:
    t_s, values = np.array([0.0, 1.0, 1.0, 2.0]), np.array([0.0, 5.0, 10.0, 10.0])
    _, at_s, rates = ask(Given(gps__speed_kt=(t_s, values)), "rate(gps.speed_kt)")
    assert at_s.tolist() == [0.0, 1.0, 2.0]
    assert rates[1:].tolist() == [10.0, 0.0]


def test_a_difference_is_taken_at_each_sample_of_the_first_from_the_newest_of_the_second() -> None:
    other_s = np.arange(100) * 0.1 + 0.05
    other = np.arange(100.0)
    unit, t_s, values = ask(
        Given(simulator__indicated_airspeed_kt=(T, ROLL), fms_hil_plan__speed_kt=(other_s, other)),
        "diff(simulator.indicated_airspeed_kt,fms_hil_plan.speed_kt)",
    )
    assert unit == "kt"
    np.testing.assert_array_equal(t_s, T)
    for place, at_s in enumerate(T):
        before = np.flatnonzero(other_s <= at_s)
        expected = ROLL[place] - other[before[-1]] if len(before) else np.nan
        np.testing.assert_equal(values[place], expected)


def test_a_difference_compares_headings_the_short_way_and_like_quantities_in_one_unit() -> None:
    flight = Given(
        gps__heading_deg=(T, np.full(500, 350.0)),
        fms_plan__bearing_deg=(T, np.full(500, 10.0)),
        analog__altitude_m=(T, np.full(500, 304.8)),
        fms_plan__altitude_ft=(T, np.full(500, 900.0)),
    )
    np.testing.assert_array_equal(ask(flight, "diff(gps.heading_deg,fms_plan.bearing_deg)")[2], -20.0)
    unit, _, values = ask(flight, "diff(fms_plan.altitude_ft,analog.altitude_m)")
    assert unit == "ft"
    np.testing.assert_allclose(values, -100.0, atol=1e-9)
    with pytest.raises(InvalidInputError, match="like quantities"):
        find(flight, PeriodCache(), "diff(gps.heading_deg,analog.altitude_m)")


def test_an_error_is_the_target_less_the_value_at_each_sample_of_the_value() -> None:
    flight = Given(
        simulator__roll_deg=(T, ROLL), ahrs__roll_deg=(np.array([0.0, 2.0, 4.0]), np.array([5.0, 10.0, 15.0]))
    )
    _, t_s, values = ask(flight, "error(simulator.roll_deg,ahrs.roll_deg)")
    target = np.where(T < 2.0, 5.0, np.where(T < 4.0, 10.0, 15.0))
    np.testing.assert_array_equal(t_s, T)
    np.testing.assert_array_equal(values, target - ROLL)


def test_a_difference_has_no_value_while_the_second_is_silent() -> None:
    other_s = np.concatenate((np.arange(50) * 0.02, 8 + np.arange(50) * 0.02))
    flight = Given(ahrs__roll_deg=(T, ROLL), simulator__roll_deg=(other_s, np.zeros(100)))
    _, t_s, values = ask(flight, "diff(ahrs.roll_deg,simulator.roll_deg)")
    assert np.isnan(values[(t_s > 1.6) & (t_s < 8)]).all()
    assert np.isfinite(values[t_s < 1.4]).all()


def test_what_is_computed_with_a_signal_that_the_flight_has_not_has_no_value() -> None:
    found = find(Given(ahrs__roll_deg=(T, ROLL)), PeriodCache(), "diff(ahrs.roll_deg,simulator.roll_deg)")
    assert len(found.values) == len(T)
    assert np.isnan(found.values).all()


def test_a_name_that_the_definition_has_not_is_refused_within_a_computed_signal_too() -> None:
    with pytest.raises(NotFoundError):
        find(Given(ahrs__roll_deg=(T, ROLL)), PeriodCache(), "diff(ahrs.roll_deg,ahrs.nothing_deg)")


@pytest.mark.uncounted
@given(spike=st.integers(1, 359_999), points=st.integers(10, 2000), zoom=st.floats(0, 1))
def test_a_spike_of_one_sample_is_seen_in_a_computed_signal_at_every_zoom(spike: int, points: int, zoom: float) -> None:
    t_s = np.arange(360_000) * 0.02
    values = np.zeros(360_000)
    values[spike] = 30.0
    flight = Given(ahrs__roll_deg=(t_s, values), simulator__roll_deg=(t_s, np.zeros(360_000)))
    from_s, to_s = t_s[spike] * zoom, t_s[spike] + (t_s[-1] - t_s[spike]) * zoom
    names = split_names("diff(ahrs.roll_deg,simulator.roll_deg),rate(ahrs.roll_deg)")
    found = signals(flight, PeriodCache(), names, from_s, to_s, points)
    difference, rate = found.signals
    assert np.nanmax(np.array(difference.max, dtype=float)) == 30.0
    np.testing.assert_allclose(np.nanmax(np.array(rate.max, dtype=float)), 1500.0)
    assert found.starts_s == START_NS * 1e-9


def test_names_are_split_at_the_commas_between_them() -> None:
    assert split_names("a.b,rate(c.d),diff(e.f,g.h_I),error(j.k,l.m)")[1:] == [
        "rate(c.d)",
        "diff(e.f,g.h_I)",
        "error(j.k,l.m)",
    ]


def test_a_computed_signal_is_kept_for_the_next_zoom_until_the_flight_has_grown() -> None:
    flight, periods = Given(ahrs__roll_deg=(T, ROLL)), PeriodCache()
    first = find(flight, periods, "rate(ahrs.roll_deg)")
    assert find(flight, periods, "rate(ahrs.roll_deg)") is first
    grown = Given(ahrs__roll_deg=(np.append(T, 10.5), np.append(ROLL, 3.0)))
    assert len(find(grown, periods, "rate(ahrs.roll_deg)").t_s) == len(T) + 1


def test_only_so_many_computed_signals_are_kept() -> None:
    periods = PeriodCache()
    made = [periods.computed(str(number), 1, object) for number in range(20)]
    assert periods.computed("19", 1, object) is made[19]
    assert periods.computed("0", 1, object) is not made[0]
