"""The track that was flown, and the few places of it from which it differs least, of which a plan can be made."""

from __future__ import annotations

from typing import Any, Final

import numpy as np

from epf_gcs.contract.flights import FlownPath
from epf_gcs.flights.export.flown import LONGEST_GAP_S, jumps
from epf_gcs.flights.flight_data import FlightData
from epf_gcs.flights.signals import Array
from epf_gcs.formats.track_thinning import thinned_places
from epf_gcs.units import M_PER_FT

# Topic and altitude of the real flight and of the simulator's, with the factor to metres.
_SOURCES: Final = {"flight": ("gps", "altitude_m", 1.0), "hil": ("simulator", "altitude_msl_ft", M_PER_FT)}
_T: Final = 0


def track_rows(flight: FlightData, source: str) -> Array:
    """All samples with a position: seconds since the start, latitude and longitude in degrees, metres above the sea.

    Shape (n, 4); (0, 4) if there are none.
    """
    topic, altitude, to_m = _SOURCES[source]
    if topic not in {span.name for span in flight.topics()}:
        return np.empty((0, 4))
    found = [flight.samples(topic, name) for name in ("latitude_deg", "longitude_deg", altitude)]
    rows = np.column_stack((found[0].t_s, *(one.values for one in found)))
    rows[:, 3] *= to_m
    placed: Array = rows[np.isfinite(rows).all(axis=1) & _has_fix(flight, topic)]
    return placed


def moved_rows(rows: Array) -> Array:
    """Without the repeats of a place."""
    moved = np.ones(len(rows), dtype=bool)
    moved[1:] = (rows[1:, 1:] != rows[:-1, 1:]).any(axis=1)
    return rows[moved]


def flown_path(flight: FlightData, source: str, most: int) -> FlownPath:
    """The longest unbroken piece of the track as at most `most` places. A track is broken where nothing was heard, and
    where the aircraft was put elsewhere."""
    rows = track_rows(flight, source)
    silences = np.flatnonzero(np.diff(rows[:, _T]) > LONGEST_GAP_S) + 1
    heard = [moved_rows(piece) for piece in np.split(rows, silences)]
    pieces = [piece for one in heard for piece in np.split(one, np.flatnonzero(jumps(one)) + 1) if len(piece) > 1]
    if not pieces:
        return FlownPath(points=0, pieces=0, deviation_m=0.0, places=[])
    longest = max(pieces, key=lambda piece: float(piece[-1, _T] - piece[0, _T]))
    kept, deviation_m = thinned_places(longest[:, 1], longest[:, 2], longest[:, 3], most)
    return FlownPath(len(longest), len(pieces), deviation_m, longest[kept, 1:].tolist())


def _has_fix(flight: FlightData, topic: str) -> Any:
    """Without a fix a receiver sends its last position, or 0 deg N 0 deg E."""
    if topic != "gps":
        return True
    return (flight.samples("gps", "valid").values == 1.0) & (flight.samples("gps", "fix").values > 0.0)
