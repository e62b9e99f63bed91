"""Positions, attitudes and events of a flight as messages of Foxglove's published schemas, in order of time."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import Any, Final

import numpy as np
import numpy.typing as npt
import orjson

from epf_gcs.flights.events import Event
from epf_gcs.flights.export.flown import Source
from epf_gcs.flights.export.foxglove_schemas import LEVELS
from epf_gcs.flights.export.spread import Rows, Times
from epf_gcs.flights.over_ground import offsets_m
from epf_gcs.flights.report.words import words
from epf_gcs.formats.kml_words import Language
from epf_gcs.formats.samples import Samples
from epf_gcs.recordings.scan import Places

Batches = Iterator[tuple[Places, list[bytes]]]
"""Times (n,) and the n messages, as JSON; in order of time."""

_UNKNOWN_COVARIANCE: Final = {"position_covariance": [0.0] * 9, "position_covariance_type": 0}
_WARNINGS: Final = ("alarm", "damage", "gap", "jump", "lost", "restart")
# Of an event's data, what its words or its time say already.
_SAID: Final = ("id", "text", "level", "active", "acknowledged", "event")
_ROWS: Final = 512


def locations(source: Source, lines: Iterable[Iterable[Samples]]) -> Batches:
    """`foxglove.LocationFix` of each point of the track."""
    for line in lines:
        for samples in line:
            t_ns = _in_ns(samples.t_s)
            places = zip(t_ns.tolist(), *(column.tolist() for column in samples[1:4]), strict=True)
            yield t_ns, [_location(source, *place) for place in places]


def poses(source: Source, lines: Iterable[Iterable[Samples]]) -> Batches:
    """`foxglove.PoseInFrame` of each point of the track whose attitude is known."""
    origin: list[npt.NDArray[np.float64]] = []
    for line in lines:
        for samples in line:
            latitude_deg, longitude_deg, altitude_m = samples[1:4]
            origin = origin or [column[:1] for column in samples[1:4]]
            north_m, east_m = offsets_m(latitude_deg, longitude_deg, *origin[:2])
            place_m = np.stack((east_m, north_m, altitude_m - origin[2]), axis=1)
            attitude = np.stack(samples[4:7], axis=1)
            known = np.isfinite(attitude).all(axis=1)
            if known.any():
                t_ns = _in_ns(samples.t_s)[known]
                yield t_ns, _poses(source, t_ns, place_m[known], attitude[known])


def poses_in_place(source: Source, attitudes: Iterator[tuple[Times, Rows]]) -> Batches:
    """The same of a flight without a position: the attitude alone."""
    for t_ns, rows in attitudes:
        if len(t_ns):
            yield t_ns, _poses(source, t_ns, np.zeros((len(t_ns), 3)), rows)


def logs(events: Sequence[Event], language: Language) -> Batches:
    """`foxglove.Log` of each event."""
    for first in range(0, len(events), _ROWS):
        part = events[first : first + _ROWS]
        t_ns = np.array([event.t_ns for event in part], dtype=np.int64)
        yield t_ns, [_log(event, language) for event in part]


def quaternions(heading_pitch_roll_deg: npt.NDArray[np.float64]) -> npt.NDArray[np.float64]:
    """Shape (n, 4), x, y, z, w: from the aircraft's forward, left and up to east, north and up."""
    heading, pitch, roll = np.radians(heading_pitch_roll_deg.T) / 2.0
    # About up, to the left positive; about left, nose down positive; about forward, to the right positive.
    yaw = np.pi / 4.0 - heading
    (cy, sy), (cp, sp), (cr, sr) = ((np.cos(angle), np.sin(angle)) for angle in (yaw, -pitch, roll))
    return np.stack(
        (
            cy * cp * sr - sy * sp * cr,
            cy * sp * cr + sy * cp * sr,
            sy * cp * cr - cy * sp * sr,
            cy * cp * cr + sy * sp * sr,
        ),
        axis=1,
    )


def _in_ns(t_s: npt.NDArray[np.float64]) -> Places:
    return np.round(t_s * 1e3).astype(np.int64) * 1_000_000


def _time(t_ns: int) -> dict[str, int]:
    seconds, rest_ns = divmod(t_ns, 1_000_000_000)
    return {"sec": seconds, "nsec": rest_ns}


def _location(source: Source, t_ns: int, latitude_deg: float, longitude_deg: float, altitude_m: float) -> bytes:
    return orjson.dumps(
        {
            "timestamp": _time(t_ns),
            "frame_id": source,
            "latitude": latitude_deg,
            "longitude": longitude_deg,
            "altitude": altitude_m,
            **_UNKNOWN_COVARIANCE,
        }
    )


def _poses(
    source: Source, t_ns: Places, place_m: npt.NDArray[np.float64], attitude_deg: npt.NDArray[np.float64]
) -> list[bytes]:
    rows = zip(t_ns.tolist(), place_m.round(3).tolist(), quaternions(attitude_deg).round(6).tolist(), strict=True)
    return [
        orjson.dumps(
            {
                "timestamp": _time(at_ns),
                "frame_id": f"{source}_start",
                "pose": {
                    "position": dict(zip("xyz", place, strict=True)),
                    "orientation": dict(zip("xyzw", orientation, strict=True)),
                },
            }
        )
        for at_ns, place, orientation in rows
    ]


def _log(event: Event, language: Language) -> bytes:
    level = "WARNING" if event.kind in _WARNINGS else "INFO"
    if event.kind == "alarm" and event.data.get("level") == "critical":
        level = "ERROR"
    return orjson.dumps(
        {
            "timestamp": _time(event.t_ns),
            "level": LEVELS[level],
            "message": _words(event, language),
            "name": event.kind,
            "file": "",
            "line": 0,
        }
    )


def _words(event: Event, language: Language) -> str:
    said: Any = event.data.get("text") or event.name
    if event.kind == "alarm":
        said = words(language)["alarmNames"].get(event.name) or said
    details = (f"{name} {value}" for name, value in event.data.items() if name not in _SAID and _is_plain(value))
    return ", ".join(part for part in (str(said), *details) if part) or event.kind


def _is_plain(value: object) -> bool:
    return isinstance(value, str | int | float) and value != ""
