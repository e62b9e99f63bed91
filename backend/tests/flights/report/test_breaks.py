"""Nothing is computed across a reset, a pause, a restart or a silence: neither in the report nor in the library."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from epf_gcs.contract.report import FlightReport
from epf_gcs.earth import M_PER_DEG
from epf_gcs.flights.breaks import breaks_of, parts
from epf_gcs.flights.events import Event, find_events
from epf_gcs.flights.report.making import report
from epf_gcs.flights.summary import summarise
from epf_gcs.recordings.flight_summary import FlightSummary
from epf_gcs.units import M_PER_NM
from tests.flights.report.made import near
from tests.flights.test_events import START_NS, MadeFlight, noted

SPEED_M_S = 25.0


def flight(
    *,
    away_s: tuple[float, float] = (-1.0, -1.0),
    reset: bool = False,
    silent_s: tuple[float, float] = (-1.0, -1.0),
    notes: Any = (),
) -> MadeFlight:
    """Two minutes to the north, climbing at 300 ft/min; the autopilot is on from 10 s to 110 s.

    The simulator sends nothing in `away_s`; with `reset` it begins anew at its end, 900 ft higher. The board is silent
    in `silent_s`, after which its target is 200 ft higher.
    """
    t_s, plan_s = np.arange(0.0, 120.0, 0.02), np.arange(0.0, 120.0, 0.1)
    again_s = away_s[1] if reset else 1e9
    kept = (t_s <= away_s[0]) | (t_s >= away_s[1])
    heard = (plan_s < silent_s[0]) | (plan_s > silent_s[1])
    t_s, plan_s = t_s[kept], plan_s[heard]
    flown_s = np.where(t_s < again_s, t_s, t_s - again_s)
    altitude_ft = 500.0 + 5.0 * t_s + 900.0 * (t_s >= again_s)
    return MadeFlight(
        {
            "heartbeat": (plan_s, {"autopilot_hil": (plan_s >= 10.0) & (plan_s < 110.0)}),
            "fms_hil_plan": (
                plan_s,
                {
                    "altitude_ft": 500.0 + 200.0 * (plan_s > silent_s[1]) * (silent_s[1] > 0.0),
                    "bearing_deg": 0.0 * plan_s,
                    "speed_kt": 0.0 * plan_s + 50.0,
                    "waypoint": np.floor(plan_s / 30.0),
                    "distance_m": 0.0 * plan_s + 900.0,
                },
            ),
            "simulator": (
                t_s,
                {
                    "altitude_indicated_ft": altitude_ft,
                    "altitude_msl_ft": altitude_ft,
                    "horizontal_path_deg": 0.0 * t_s,
                    "indicated_airspeed_kt": 0.0 * t_s + 50.0,
                    "latitude_deg": 28.0 + SPEED_M_S * flown_s / M_PER_DEG,
                    "longitude_deg": 0.0 * t_s - 15.0,
                },
            ),
        },
        list(notes),
    )


def reported(made: MadeFlight, gaps: Any = ()) -> tuple[FlightReport, FlightSummary]:
    """The report and the library's row, from the events that are found."""
    events = find_events(made, list(gaps), [])
    summary = summarise(made, events)
    return report("a", made, summary, events, np.empty(0), np.empty(0)), summary


def begun_s(found: FlightReport) -> list[int]:
    """When the answers to a step begin; this autopilot is switched on 50 ft too high."""
    assert {(one.kind, one.cause) for one in found.manoeuvres if one.kind != "leg"} == {("descent", "engaged")}
    return [round(one.at_s) for one in found.manoeuvres if one.kind != "leg"]


@pytest.mark.parametrize(("away_s", "kind"), [(0.02, "jump"), (0.5, "jump"), (30.0, "gap")])
def test_a_simulator_that_began_anew_neither_climbed_nor_flew_there(away_s: float, kind: str) -> None:
    """After half a minute of silence it may have flown there; nothing is computed across that either."""
    made = flight(away_s=(40.0, 40.0 + away_s), reset=True)
    found, row = reported(made)
    (broken,) = (event for event in find_events(made, [], []) if event.kind in ("jump", "gap"))
    assert broken.kind == kind
    assert (broken.t_ns - START_NS) * 1e-9 == near(40.0, abs=1e-6)
    assert broken.until_ns is not None
    assert (broken.until_ns - START_NS) * 1e-9 == near(40.0 + away_s, abs=1e-6)
    assert broken.data.get("distance_m", 300) > 250
    assert found.distances.climb_most_ft_min == near(300.0, rel=0.01)
    assert found.distances.sink_most_ft_min == 0.0
    assert begun_s(found) == [10]
    assert row.distance_nm == near((120.0 - away_s) * SPEED_M_S / M_PER_NM, abs=0.02)
    assert found.times.autopilot_s == near(100.0 - away_s, abs=0.2)
    assert [one.waypoint for one in found.manoeuvres if one.kind == "leg"] == ([2] if kind == "jump" else []), (
        "no leg across it"
    )


def test_a_reset_that_was_noted_live_is_one_event_at_the_time_of_its_samples() -> None:
    live = noted(40.4, "simulator_jumped", distance_m=275, latitude_deg=28.0, longitude_deg=-15.0, altitude_ft=1400.0)
    other = noted(90.0, "simulator_jumped", distance_m=600, latitude_deg=28.0, longitude_deg=-15.0, altitude_ft=1.0)
    events = find_events(flight(away_s=(40.0, 40.1), reset=True, notes=[live, other]), [], [])
    assert [(event.t_ns - START_NS) * 1e-9 for event in events if event.kind == "jump"] == [
        near(40.0, abs=1e-6),
        near(90.0, abs=1e-6),
    ]


def test_after_a_silence_the_autopilot_was_on_already() -> None:
    """The target changed while nobody heard it: nothing is known of that step."""
    made = flight(silent_s=(50.0, 54.0))
    found, _ = reported(made, [(START_NS + 50 * 10**9, START_NS + 54 * 10**9)])
    assert begun_s(found) == [10]
    assert found.times.autopilot_s == near(96.0, abs=0.3)
    assert [one.waypoint for one in found.manoeuvres if one.kind == "leg"] == [2]


def test_a_pause_is_no_time_in_the_air_nor_on_the_autopilot() -> None:
    alarm = {"id": "simulator_paused", "acknowledged": False}
    made = flight(notes=[noted(70.0, "alarm", active=True, **alarm), noted(80.0, "alarm", active=False, **alarm)])
    found, _ = reported(made)
    assert found.times.airborne_s == near(110.0, abs=0.2)
    assert found.times.autopilot_s == near(90.0, abs=0.2)


def test_what_a_hand_flew_is_not_the_autopilot_s_and_its_end_is_where_that_began() -> None:
    by_hand = [
        noted(0.0, "hil", path="assisted"),
        noted(40.0, "hil", path="manual"),
        noted(50.0, "hil", path="assisted"),
    ]
    made = flight(notes=by_hand)
    t_s, values = made.samples("simulator", "altitude_indicated_ft")
    values[t_s > 45.0] += 100.0
    found, _ = reported(made)
    assert found.times.autopilot_s == near(90.0, abs=0.2)
    assert begun_s(found) == [10, 50]
    modes = [(event.name, event.data["on"]) for event in find_events(made, [], []) if event.name == "assisted"]
    assert modes == [("assisted", False), ("assisted", True)]


def test_while_the_board_is_silent_the_simulators_aircraft_flies_on() -> None:
    found, row = reported(flight(silent_s=(50.0, 54.0)), [(START_NS + 50 * 10**9, START_NS + 54 * 10**9)])
    assert found.times.airborne_s == near(120.0, abs=0.1)
    assert row.distance_nm == near(120.0 * SPEED_M_S / M_PER_NM, abs=0.02)


def test_a_slow_heartbeat_is_no_silence() -> None:
    made = flight()
    beats_s = np.arange(0.0, 120.0, 2.5)
    made.replace("heartbeat", beats_s, {"autopilot_hil": (beats_s >= 10.0) & (beats_s < 110.0)})
    found, _ = reported(made)
    assert found.times.autopilot_s == near(100.0, abs=0.1)
    assert begun_s(found) == [10]


def test_breaks_that_overlap_are_one_and_samples_inside_are_of_no_part() -> None:
    def event(kind: Any, from_s: int, until_s: int | None, name: str = "") -> Event:
        return Event(from_s * 10**9, kind, name, {}, None if until_s is None else until_s * 10**9)

    breaks = breaks_of(
        [
            event("alarm", 1, 3, "gps_lost"),
            event("gap", 4, 6, "silence"),
            event("gap", 5, 8, "simulator"),
            event("restart", 8, None),
            event("alarm", 12, None, "simulator_paused"),
        ],
        0,
    )
    assert breaks == [(near(4.0), near(8.0)), (near(12.0), np.inf)]
    assert [part.tolist() for part in parts(np.arange(15.0), breaks)] == [[0, 1, 2, 3, 4], [8, 9, 10, 11, 12]]
    assert parts(np.empty(0), breaks) == []
