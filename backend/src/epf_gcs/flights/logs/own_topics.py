"""Position and attitude of a log by the station's own names too: track, map, time bar and report know them by those."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from typing import Final, NamedTuple

import numpy as np

from epf_gcs.flights.fields import fields_of
from epf_gcs.recordings.log_table import LogTable

_DEG: Final = 180.0 / math.pi


class _Source(NamedTuple):
    """Our topic from one of theirs: by our field theirs, and the factor to our unit. `fixed`: what the log implies."""

    ours: str
    fields: Mapping[str, tuple[str, float]]
    fixed: Mapping[str, float]


_FIX: Final = {"valid": 1.0, "fix": 3.0}
_DEGREES: Final = {"latitude_deg": ("Lat", 1.0), "longitude_deg": ("Lng", 1.0), "altitude_m": ("Alt", 1.0)}
# One of each kind of log: the filter's position, which is there in all of them.
_SOURCES: Final = {
    "vehicle_global_position": _Source(
        "gps", {"latitude_deg": ("lat", 1.0), "longitude_deg": ("lon", 1.0), "altitude_m": ("alt", 1.0)}, _FIX
    ),
    "POS": _Source("gps", _DEGREES, _FIX),
    "GLOBAL_POSITION_INT": _Source(
        "gps", {"latitude_deg": ("lat", 1e-7), "longitude_deg": ("lon", 1e-7), "altitude_m": ("alt", 1e-3)}, _FIX
    ),
    "ATT": _Source("ahrs", {"roll_deg": ("Roll", 1.0), "pitch_deg": ("Pitch", 1.0), "yaw_deg": ("Yaw", 1.0)}, {}),
    "ATTITUDE": _Source(
        "ahrs", {"roll_deg": ("roll", _DEG), "pitch_deg": ("pitch", _DEG), "yaw_deg": ("yaw", _DEG)}, {}
    ),
}


def own_topics(table: LogTable) -> Iterator[LogTable]:
    """The same rows as ours, where the topic is known and has all that is needed; rows without a place are left out."""
    source = _SOURCES.get(table.topic)
    theirs = dict(zip(table.units, table.columns, strict=True))
    if source is None or not all(name in theirs for name, _ in source.fields.values()):
        return
    ours = {name: theirs[field] * factor for name, (field, factor) in source.fields.items()}
    rows = np.ones(len(table.t_ns), dtype=bool)
    if "latitude_deg" in ours:
        rows = (np.abs(ours["latitude_deg"]) <= 90.0) & ((ours["latitude_deg"] != 0.0) | (ours["longitude_deg"] != 0.0))
    if not rows.any():
        return
    units = {name: meaning.unit for name, meaning in fields_of(source.ours).items()}
    rest = {name: np.full(len(rows), source.fixed.get(name, np.nan)) for name in units if name not in ours}
    columns = [(ours | rest)[name][rows] for name in units]
    yield LogTable(source.ours, units, table.t_ns[rows], columns)
