"""Which signals of a flight hold the targets of each plan, what answers them, and whether the autopilot flew."""

from __future__ import annotations

from typing import Final, Literal, NamedTuple

import numpy as np

from epf_gcs.errors import NotFoundError
from epf_gcs.flights.breaks import Span
from epf_gcs.flights.flight_data import FlightData, read_field
from epf_gcs.flights.known_changes import surface_paths
from epf_gcs.flights.report.manoeuvres import Loop, Series, Stretch, stretches, without
from epf_gcs.units import M_PER_FT

Plan = Literal["flight", "hil"]

Signal = tuple[str, str, float]
"""Topic, field and factor."""

# What answers each loop, the one that the board flies by first. The HIL aircraft is what the board was told.
_ACTUAL: Final[dict[Plan, dict[Loop, tuple[Signal, ...]]]] = {
    "hil": {
        "altitude": (("simulator", "altitude_indicated_ft", 1.0), ("simulator", "altitude_msl_ft", 1.0)),
        "heading": (("simulator", "horizontal_path_deg", 1.0), ("simulator", "true_heading_deg", 1.0)),
        "speed": (("simulator", "indicated_airspeed_kt", 1.0),),
    },
    "flight": {
        "altitude": (("analog", "altitude_m", 1 / M_PER_FT), ("gps", "altitude_m", 1 / M_PER_FT)),
        "heading": (("gps", "heading_deg", 1.0), ("ahrs", "yaw_deg", 1.0)),
        "speed": (("analog", "calibrated_airspeed_kt", 1.0), ("gps", "speed_kt", 1.0)),
    },
}
_TARGETS: Final[dict[Loop, str]] = {"altitude": "altitude_ft", "heading": "bearing_deg", "speed": "speed_kt"}
_TOPICS: Final[dict[Plan, str]] = {"flight": "fms_plan", "hil": "fms_hil_plan"}
_FLAGS: Final[dict[Plan, str]] = {"flight": "autopilot", "hil": "autopilot_hil"}
PLANS: Final[tuple[Plan, ...]] = ("hil", "flight")
LOOPS: Final[tuple[Loop, ...]] = ("altitude", "heading", "speed")
_NOTHING: Final = Series(np.empty(0), np.empty(0))


class Place(NamedTuple):
    """Where the aircraft was: times (s), degrees and feet, all (n,)."""

    t_s: np.ndarray[tuple[int], np.dtype[np.float64]]
    latitude_deg: np.ndarray[tuple[int], np.dtype[np.float64]]
    longitude_deg: np.ndarray[tuple[int], np.dtype[np.float64]]


class PlanSignals(NamedTuple):
    """One plan's targets, answers and autopilot. A series is empty where the flight does not have it."""

    plan: Plan
    targets: dict[Loop, Series]
    actual: dict[Loop, Series]
    waypoint: Series
    distance_m: Series
    flown: list[Stretch]


def plan_signals(flight: FlightData, plan: Plan, breaks: list[Span]) -> PlanSignals:
    """Read them. What the autopilot flew is cut at the breaks, and is not what a hand flew. Raises OSError."""
    topic = _TOPICS[plan]
    flown = stretches(read(flight, "heartbeat", _FLAGS[plan]))
    if plan == "hil":
        flown = without(flown, _by_hand(flight), is_engaged=True)
    return PlanSignals(
        plan,
        {loop: read(flight, topic, field) for loop, field in _TARGETS.items()},
        {loop: first_of(flight, _ACTUAL[plan][loop]) for loop in LOOPS},
        read(flight, topic, "waypoint"),
        read(flight, topic, "distance_m"),
        without(flown, breaks, is_engaged=False),
    )


def _by_hand(flight: FlightData) -> list[Span]:
    """The stretches in which the stick moved the simulator's surfaces, and not the board."""
    paths = [((t_ns - flight.start_ns) * 1e-9, path) for t_ns, path in surface_paths(flight.notes())]
    ends = [*(at_s for at_s, _ in paths), np.inf][1:]
    return [(at_s, end_s) for (at_s, path), end_s in zip(paths, ends, strict=True) if path == "manual"]


def read(flight: FlightData, topic: str, field: str, factor: float = 1.0) -> Series:
    """The samples of a field that have a value; empty where the flight does not have the topic."""
    t_s, values = read_field(flight, topic, field)
    known = np.isfinite(values)
    return Series(t_s[known], values[known] * factor)


def first_of(flight: FlightData, signals: tuple[Signal, ...]) -> Series:
    """The first of these signals that has values."""
    for topic, field, factor in signals:
        found = read(flight, topic, field, factor)
        if len(found.t_s):
            return found
    return _NOTHING


def places(flight: FlightData, plan: Plan) -> Place | None:
    """The aircraft's places; None where it is missing. Raises OSError."""
    topic = "simulator" if plan == "hil" else "gps"
    try:
        t_s, latitude = flight.samples(topic, "latitude_deg")
        longitude = flight.samples(topic, "longitude_deg").values
        good = np.isfinite(latitude) & np.isfinite(longitude)
        if topic == "gps":
            # Without a fix a receiver sends its last position, or 0 deg N 0 deg E.
            good &= (flight.samples(topic, "valid").values == 1.0) & (flight.samples(topic, "fix").values > 0.0)
    except NotFoundError:
        return None
    return Place(t_s[good], latitude[good], longitude[good]) if good.any() else None
