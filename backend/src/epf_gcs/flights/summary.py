"""The figures of a flight's row in the library, from its samples, events and notes."""

from __future__ import annotations

import math
from dataclasses import asdict
from typing import Final

import numpy as np

from epf_gcs.contract.flights import Thumbnail
from epf_gcs.flights.breaks import Span, motion_breaks, parts
from epf_gcs.flights.events import Event
from epf_gcs.flights.flight_data import FlightData, read_field
from epf_gcs.flights.over_ground import steps_m
from epf_gcs.flights.signals import Array
from epf_gcs.recordings import notes
from epf_gcs.recordings.flight_summary import FlightSummary
from epf_gcs.units import M_PER_FT, M_PER_NM
from epf_gcs.vehicle.noted import newest_identity

# Less is not worth another time in the list.
_CLOCK_OFF_S: Final = 2.0
_LONGEST_STEP_S: Final = 10.0
_FASTEST_M_S: Final = 350.0
_LEAST_JUMP_M: Final = 100.0
_TRACK_POINTS: Final = 120
_ALTITUDES: Final = 80
# Where an aircraft's place comes from: the simulator's in a HIL flight, else the receiver's.
_PLACES: Final = (("simulator", "altitude_msl_ft", 1.0), ("gps", "altitude_m", 1 / M_PER_FT))
_SPEEDS: Final = (("simulator", "indicated_airspeed_kt"), ("analog", "calibrated_airspeed_kt"), ("gps", "speed_kt"))


def summarise(flight: FlightData, events: list[Event]) -> FlightSummary:
    """Everything of the row that is made from samples, events and notes. Raises OSError, RecordingError."""
    place = _places(flight)
    kinds = [event.kind for event in events]
    identity = newest_identity(note.content for note in flight.notes() if note.name == notes.IDENTITY)
    clock_ahead_s, clock_unsure = _clock(flight)
    return FlightSummary(
        started_ns=flight.start_ns,
        ended_ns=flight.end_ns,
        clock_ahead_s=clock_ahead_s,
        clock_unsure=clock_unsure,
        **asdict(identity),
        highest_ft=None if place is None else _extreme(place[3]),
        fastest_kt=_fastest_kt(flight),
        distance_nm=None if place is None else _distance_nm(place, motion_breaks(events, flight.start_ns)),
        waypoints=kinds.count("waypoint"),
        alarms=kinds.count("alarm"),
        marks=kinds.count("mark"),
        thumbnail=None if place is None else _thumbnail(*place, flight.end_ns - flight.start_ns),
    )


def _clock(flight: FlightData) -> tuple[float, bool]:
    """How far the times of the recording turned out to be off (s), and whether nobody ever vouched for them."""
    found = [note.content for note in flight.notes() if note.name == notes.CLOCK and isinstance(note.content, dict)]
    ahead = found[-1].get("ahead_s") if found else 0.0
    is_far = isinstance(ahead, int | float) and math.isfinite(ahead) and abs(ahead) > _CLOCK_OFF_S
    ahead_s = float(ahead) if is_far and isinstance(ahead, int | float) else 0.0
    return ahead_s, bool(found) and all(one.get("synchronised") is False for one in found)


def _places(flight: FlightData) -> tuple[Array, Array, Array, Array] | None:
    """Times (s), latitudes and longitudes (deg) and altitudes (ft) of the first source that has any place."""
    there = {span.name for span in flight.topics()}
    for topic, altitude, factor in _PLACES:
        if topic not in there:
            continue
        t_s, latitude_deg = flight.samples(topic, "latitude_deg")
        longitude_deg = flight.samples(topic, "longitude_deg").values
        altitude_ft = flight.samples(topic, altitude).values * factor
        good = np.isfinite(latitude_deg) & np.isfinite(longitude_deg) & np.isfinite(altitude_ft)
        if topic == "gps":
            # Without a fix a receiver sends its last position, or 0 deg N 0 deg E.
            good &= (flight.samples(topic, "valid").values == 1.0) & (flight.samples(topic, "fix").values > 0.0)
        if good.any():
            return t_s[good], latitude_deg[good], longitude_deg[good], altitude_ft[good]
    return None


def _fastest_kt(flight: FlightData) -> float | None:
    for topic, field in _SPEEDS:
        fastest_kt = _extreme(read_field(flight, topic, field).values)
        if fastest_kt is not None:
            return fastest_kt
    return None


def _extreme(values: Array) -> float | None:
    known = values[np.isfinite(values)]
    return round(float(known.max()), 1) if len(known) else None


def _distance_nm(place: tuple[Array, Array, Array, Array], breaks: list[Span]) -> float:
    """The way over the ground; what lies in a break and jumps (another route was loaded, the fix was lost) are not
    flown."""
    total_m = sum(_way_m(*(column[chosen] for column in place[:3])) for chosen in parts(place[0], breaks))
    return round(total_m / M_PER_NM, 2)


def _way_m(t_s: Array, latitude_deg: Array, longitude_deg: Array) -> float:
    step_m = steps_m(latitude_deg, longitude_deg)
    elapsed_s = np.diff(t_s)
    flown = (elapsed_s <= _LONGEST_STEP_S) & (step_m <= np.maximum(_LEAST_JUMP_M, _FASTEST_M_S * elapsed_s))
    return float(step_m[flown].sum())


def _thumbnail(
    t_s: Array, latitude_deg: Array, longitude_deg: Array, altitude_ft: Array, duration_ns: int
) -> Thumbnail:
    chosen = np.linspace(0, len(t_s) - 1, min(_TRACK_POINTS, len(t_s))).astype(np.int64)
    north = latitude_deg[chosen]
    east = np.unwrap(longitude_deg[chosen], period=360.0) * np.cos(np.radians(float(np.mean(north))))
    # One scale for both, so that the picture has the track's shape.
    size = max(float(np.ptp(north)), float(np.ptp(east)), 1e-9)
    x = (east - east.min()) / size + (1.0 - np.ptp(east) / size) / 2
    y = (north - north.min()) / size + (1.0 - np.ptp(north) / size) / 2
    steps = np.clip((t_s / max(duration_ns * 1e-9, 1e-9) * _ALTITUDES).astype(np.int64), 0, _ALTITUDES - 1)
    counts = np.bincount(steps, minlength=_ALTITUDES)
    sums = np.bincount(steps, weights=altitude_ft, minlength=_ALTITUDES)
    low_ft, range_ft = float(altitude_ft.min()), max(float(np.ptp(altitude_ft)), 1e-9)
    return Thumbnail(
        track=[[round(float(a), 3), round(float(b), 3)] for a, b in zip(x, y, strict=True)],
        altitude=[
            round((total / count - low_ft) / range_ft, 3) if count else None
            for total, count in zip(sums.tolist(), counts.tolist(), strict=True)
        ],
    )
