"""The report's figures of a flight whose every figure is known: times, distances, battery, link, legs and gains."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from epf_gcs.contract.flights import EventKind
from epf_gcs.contract.report import FlightReport, ReportAlarm, ReportDistances, ReportEvent, ReportMark
from epf_gcs.flights.events import Event
from epf_gcs.flights.report.figures import alarms, distances, pauses, round_trip, times
from epf_gcs.flights.report.making import report
from epf_gcs.flights.report.told import told
from epf_gcs.recordings import notes
from epf_gcs.recordings.flight_summary import FlightSummary
from epf_gcs.recordings.notes import Note
from tests.flights.report.made import SIMULATOR_HZ, make, near
from tests.flights.test_events import START_NS, MadeFlight

M_PER_DEG = 111_195.0
SPEED_M_S = 25.0
SUMMARY = FlightSummary(
    START_NS,
    START_NS + 300 * 10**9,
    distance_nm=3.5,
    highest_ft=900.0,
    fastest_kt=61.0,
    frames=990,
    frames_damaged=10,
    gaps=[(START_NS, START_NS + 2 * 10**9), (START_NS + 5 * 10**9, START_NS + 6 * 10**9)],
    damage="It was cut off.",
    is_whole=False,
)
NOTHING = FlightSummary(START_NS, START_NS)


def note(at_s: float, name: str, content: Any) -> Note:
    return Note(START_NS + round(at_s * 1e9), name, content)


def gains(at_s: float, **values: Any) -> Note:
    return note(at_s, notes.PARAMETERS, {name: {"value": value} for name, value in values.items()})


def circuit(noted: list[Note]) -> MadeFlight:
    """Legs of 60 s to the north, 5 m to the right of the line, at 25 m/s; the autopilot is on from 10 s to 250 s.

    It climbs at 600 ft/min for the second leg, and nothing is measured from 100 s to 104 s.
    """
    t_s = np.arange(0.0, 300.0, 1 / SIMULATOR_HZ)
    plan_s, beats_s, slow_s = np.arange(0.0, 300.0, 0.1), np.arange(0.0, 300.0, 0.2), np.arange(0.0, 300.0, 0.5)
    kept = (t_s < 100.0) | (t_s > 104.0)
    t_s = t_s[kept]
    north_m = SPEED_M_S * t_s
    leg_m = np.minimum(30.0, np.maximum(0.0, t_s % 60.0 - 20.0)) / 6.0
    airborne = np.where((t_s > 5.0) & (t_s < 270.0), 50.0, 3.0)
    airborne[(t_s > 280.0) & (t_s < 281.0)] = 50.0
    return MadeFlight(
        {
            "heartbeat": (
                beats_s,
                {
                    "autopilot_hil": (beats_s >= 10.0) & (beats_s < 250.0),
                    "autopilot": (beats_s >= 200.0) & (beats_s < 260.0),
                },
            ),
            "fms_hil_plan": (
                plan_s,
                {
                    "altitude_ft": np.where(plan_s < 120.0, 500.0, 800.0),
                    "bearing_deg": np.zeros(len(plan_s)),
                    "speed_kt": np.full(len(plan_s), 50.0),
                    "waypoint": np.floor(plan_s / 60.0),
                    "distance_m": 1500.0 - SPEED_M_S * (plan_s % 60.0),
                },
            ),
            "simulator": (
                t_s,
                {
                    "altitude_indicated_ft": np.interp(t_s, [0.0, 120.0, 150.0, 300.0], [500.0, 500.0, 800.0, 800.0]),
                    "altitude_msl_ft": np.interp(t_s, [0.0, 120.0, 150.0, 300.0], [500.0, 500.0, 800.0, 800.0]),
                    "horizontal_path_deg": np.zeros(len(t_s)),
                    "indicated_airspeed_kt": airborne,
                    "latitude_deg": 28.0 + north_m / M_PER_DEG,
                    "longitude_deg": -15.0 + leg_m / M_PER_DEG / np.cos(np.radians(28.0)),
                },
            ),
            "analog": (slow_s, {"battery_v": 12.6 - slow_s / 300.0}),
        },
        noted,
    )


@pytest.fixture(scope="module")
def found() -> FlightReport:
    begun_ns = START_NS + np.arange(0.0, 100.0) * 2e7
    noted = [
        note(0.0, notes.IDENTITY, {"station": "1.0.0", "aircraft": "ala fija", "board": {"firmware_version": "2.1"}}),
        gains(1.0, k_altura=1.0, k_heading=2.0, k_rudder=0.5, unknown_gain=3.0, k_pitch="much"),
        gains(140.0, k_altura=1.5, k_rudder=0.6),
        note(150.0, notes.LOST, {"bytes": 12}),
    ]
    events = [
        Event(START_NS + 4 * 10**9, "alarm", "gps_lost", {"level": "critical"}, START_NS + 9 * 10**9),
        Event(START_NS + 8 * 10**9, "alarm", "card", {"level": 7}),
        Event(START_NS + 6 * 10**9, "mark", "mark", {"text": "first turn"}, id="1"),
    ]
    return report("20260101T120000Z", circuit(noted), SUMMARY, events, begun_ns, begun_ns + 4e6)


def test_times_count_what_was_flown_and_by_whom(found: FlightReport) -> None:
    # Neither the four seconds without samples nor a peak of a second is flight.
    assert found.times.airborne_s == near(261.0, abs=0.2)
    assert found.times.autopilot_s == near(250.0, abs=0.5)
    assert found.times.duration_s == near(300.0, abs=0.2)


def test_distances_and_climb(found: FlightReport) -> None:
    assert found.distances == ReportDistances(
        distance_nm=3.5,
        highest_ft=900.0,
        fastest_kt=61.0,
        lowest_ft=500.0,
        climb_most_ft_min=near(600.0, rel=0.01),
        sink_most_ft_min=near(0.0, abs=0.01),
    )


def test_the_battery_at_both_ends_and_what_it_lost_each_hour(found: FlightReport) -> None:
    assert found.battery is not None
    assert found.battery.begin_v == near(12.6 - 5.0 / 300.0, abs=0.01)
    assert found.battery.end_v == near(11.6 + 5.0 / 300.0, abs=0.01)
    assert found.battery.lowest_v == near(11.6, abs=0.01)
    assert found.battery.drop_v_per_hour == near(12.0, rel=0.05)


def test_the_link_with_its_silences_and_round_trip(found: FlightReport) -> None:
    link = found.link
    assert (link.damaged_percent, link.gaps, link.gaps_s, link.longest_gap_s) == (
        near(1.0),
        2,
        near(3.0),
        near(2.0),
    )
    trip = link.round_trip_ms
    assert trip is not None
    assert trip.count == 100
    assert (trip.median, trip.p99, trip.longest) == (near(4.0, abs=0.01),) * 3


def test_alarms_and_marks_in_words_that_are_known(found: FlightReport) -> None:
    assert found.alarms == [
        ReportAlarm("gps_lost", "critical", near(4.0), near(5.0), 1),
        ReportAlarm("card", None, near(8.0), None, 1),
    ]
    assert found.marks == [ReportMark(near(6.0), "first turn")]


def test_an_alarm_that_came_again_and_again_is_one_with_its_count() -> None:
    def came(at_s: float, until_s: float | None, level: str) -> Event:
        until_ns = None if until_s is None else round(until_s * 1e9)
        return Event(round(at_s * 1e9), "alarm", "hil_lost", {"level": level}, until_ns)

    twice = [came(1.0, 2.0, "warning"), came(5.0, 5.5, "critical")]
    (one,) = alarms(twice, 0)
    assert one == ReportAlarm("hil_lost", "critical", at_s=1.0, lasted_s=1.5, count=2)
    (open_end,) = alarms([*twice, came(9.0, None, "warning")], 0)
    assert (open_end.count, open_end.lasted_s) == (3, None)


def test_an_alarm_whose_brief_soundings_are_one_event_is_counted_with_each() -> None:
    data = {"level": "warning", "times": 3, "lasted_s": 0.3}
    again = Event(20 * 10**9, "alarm", "hil_lost", {}, 21 * 10**9)
    (one,) = alarms([Event(10**9, "alarm", "hil_lost", data, 9 * 10**9), again], 0)
    assert (one.count, one.lasted_s) == (4, near(1.3))


def test_what_changed_or_broke_the_flight_is_told_in_order() -> None:
    def event(at_s: float, kind: EventKind, name: str = "", until_s: float | None = None, **data: Any) -> Event:
        return Event(round(at_s * 1e9), kind, name, data, None if until_s is None else round(until_s * 1e9))

    events = [
        event(1, "mode", "assisted", on=False),
        event(2, "mode", "autopilot", on=True),
        event(3, "stick", "gamepad", gamepad="Xbox", state="lost"),
        event(4, "limits", "battery_low_v", before=10.5, after=11.0),
        event(5, "restart"),
        event(6, "jump", until_s=6.5, distance_m=280),
        event(7, "gap", "silence", until_s=11),
        event(8, "gap", "simulator", until_s=11),
        event(9, "alarm", "simulator_paused"),
        event(10, "alarm", "gps_lost"),
    ]
    assert told(events, 0) == [
        ReportEvent("manual", 1.0, None, ""),
        ReportEvent("stick", 3.0, None, "gamepad Xbox lost"),
        ReportEvent("limits", 4.0, None, "battery_low_v 10.5 → 11"),
        ReportEvent("restart", 5.0, None, ""),
        ReportEvent("jump", 6.0, 6.5, "280 m"),
        ReportEvent("silence", 7.0, 11.0, ""),
        ReportEvent("simulator_silence", 8.0, 11.0, ""),
        ReportEvent("pause", 9.0, None, ""),
    ]


def test_legs_say_how_far_beside_the_line_and_how_well_the_targets_were_held(found: FlightReport) -> None:
    legs = [one for one in found.manoeuvres if one.kind == "leg"]
    assert [one.waypoint for one in legs] == [1, 2, 3]
    for one in legs:
        leg = one.leg
        assert leg is not None
        assert leg.across_rms_m is not None
        assert one.trace is not None
        assert leg.duration_s == near(60.0, abs=0.2)
        assert leg.across_most_m == near(5.0, abs=0.1)
        assert 2.0 < leg.across_rms_m < 4.5
        assert leg.speed_error_kt == near(0.0, abs=0.01)
        assert len(one.trace.at_s) == len(one.trace.value) == len(one.trace.target)
    last = legs[2].leg
    assert last is not None
    assert last.distance_m == near(1500.0, rel=0.01)
    assert last.altitude_error_ft == near(0.0, abs=0.01)


def test_a_gain_that_was_changed_stands_between_the_loop_before_and_after(found: FlightReport) -> None:
    change, rudder = found.gains
    assert (change.name, change.loop, change.before, change.after) == ("k_altura", "altitude", 1.0, 1.5)
    assert change.at_s == near(140.0)
    assert change.earlier is not None
    assert change.later is not None
    assert (change.earlier.from_s, change.later.to_s) == (0.0, near(300.0, abs=0.2))
    assert (change.earlier.error_rms or 0.0) > (change.later.error_rms or 0.0) > 0.0
    assert found.gains_known == {"k_altura": 1.5, "k_heading": 2.0, "k_rudder": 0.6}
    assert (rudder.loop, rudder.earlier, rudder.later) == (None, None, None), "no loop answers for the rudder"


def test_gains_that_a_restart_made_unknown_are_given_no_time_until_they_were_read_again() -> None:
    unknown = note(100.0, notes.PARAMETERS, {"k_altura": {"value": None}, "k_pitch": {"value": None}})
    made = circuit([gains(1.0, k_altura=0.08, k_pitch=2.4), unknown, gains(130.0, k_altura=0.06, k_pitch=2.4)])
    found = report("a", made, NOTHING, [], np.empty(0), np.empty(0))
    (change,) = found.gains
    assert (change.name, change.at_s, change.before, change.after) == ("k_altura", near(130.0), 0.08, 0.06)
    assert change.earlier is not None
    assert change.later is not None
    assert (change.earlier.to_s, change.later.from_s) == (near(100.0), near(130.0))
    never = report("a", circuit([gains(1.0, k_altura=0.08), unknown]), NOTHING, [], np.empty(0), np.empty(0))
    assert (never.gains, never.gains_known) == ([], {})


def test_what_the_recording_cannot_tell_is_said(found: FlightReport) -> None:
    assert found.unknown == ["wind", "gaps", "file", "lost"]
    empty = report("20260101T120000Z", MadeFlight({}), NOTHING, [], np.empty(0), np.empty(0))
    assert empty.unknown == ["wind", "battery", "round_trip", "position", "speed", "gains"]
    assert empty.distances.climb_most_ft_min is None
    assert (empty.link.damaged_percent, empty.link.longest_gap_s) == (None, None)


def test_a_battery_that_is_not_connected_is_none() -> None:
    t_s = np.arange(0.0, 30.0)
    flight = MadeFlight({"analog": (t_s, {"battery_v": np.full(len(t_s), 0.1)})})
    assert report("20260101T120000Z", flight, NOTHING, [], np.empty(0), np.empty(0)).battery is None


def test_no_rate_of_climb_is_told_over_a_gap() -> None:
    t_s = np.array([0.0, 0.1, 50.0, 50.1])
    flight = MadeFlight({"gps": (t_s, {"altitude_m": np.array([0.0, 0.0, 500.0, 500.0])})})
    assert distances(flight, NOTHING, []).climb_most_ft_min is None
    assert times(flight, [], []).airborne_s is None


def test_answers_without_a_question_are_no_round_trip() -> None:
    assert round_trip(np.empty(0), np.array([float(START_NS)]), []) is None


def test_a_leg_without_places_still_has_its_time() -> None:
    legs = [one for one in report("a", make(1).flight, NOTHING, [], np.empty(0), np.empty(0)).manoeuvres
            if one.kind == "leg"]  # fmt: skip
    assert legs
    assert all(one.leg and one.leg.across_rms_m is None and one.leg.distance_m is None for one in legs)
    assert all(one.trace is None for one in legs)


def test_a_pause_of_the_simulator_is_left_out_of_the_round_trip() -> None:
    asked = START_NS + np.arange(400.0) * 20_000_000
    answered = asked + 30_000_000
    alarm = Event(START_NS + 2_000_000_000, "alarm", "simulator_paused", {}, START_NS + 5_000_000_000)
    paused = pauses([alarm])
    with_pause, without = round_trip(asked, answered, []), round_trip(asked, answered, paused)
    assert with_pause is not None
    assert without is not None
    assert (with_pause.count, without.count) == (400, 250)
    assert without.longest == near(30.0, abs=0.01), "the pairs after it are not shifted"
    assert pauses([replace(alarm, until_ns=None)])[0][1] > START_NS + 10**15
    assert pauses([replace(alarm, name="hil_lost")]) == []
