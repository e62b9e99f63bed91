"""The flown tracks as CZML, for playback in Cesium: position, attitude and time of every point."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from datetime import UTC, datetime
from typing import Any, Final, NamedTuple

import numpy as np
import orjson

from epf_gcs.formats.samples import Column, Samples

MEDIA_TYPE: Final = "application/json"
_WIDTH_PX: Final = 2
# A box about as large as the aircraft, which shows its attitude without a model file: nose, left, up in metres.
_BOX_M: Final = (8.0, 12.0, 1.0)


class MovingTrack(NamedTuple):
    """One track: its lines in parts, each with the Unix times of its first and last point. `colour`: red, green, blue,
    opacity, 0..255."""

    id: str
    name: str
    colour: tuple[int, int, int, int]
    spans_s: Sequence[tuple[float, float]]
    lines: Sequence[Iterable[Samples]]


def czml_pieces(name: str, tracks: Sequence[MovingTrack]) -> Iterator[bytes]:
    """A document, in pieces: a clock over the whole flight, and a packet for each track that has a line."""
    shown = [track for track in tracks if track.spans_s]
    document: dict[str, Any] = {"id": "document", "name": name, "version": "1.0"}
    if shown:
        first_s = min(track.spans_s[0][0] for track in shown)
        last_s = max(track.spans_s[-1][1] for track in shown)
        interval = f"{_time(first_s)}/{_time(last_s)}"
        document["clock"] = {"interval": interval, "currentTime": _time(first_s), "multiplier": 1}
    yield b"[" + orjson.dumps(document)
    for track in shown:
        yield from _packet(track)
    yield b"]\n"


def _packet(track: MovingTrack) -> Iterator[bytes]:
    epoch_s = track.spans_s[0][0]
    colour = {"solidColor": {"color": {"rgba": list(track.colour)}}}
    spans = [f"{_time(begin_s)}/{_time(end_s)}" for begin_s, end_s in track.spans_s]
    packet: dict[str, Any] = {
        "id": track.id,
        "name": track.name,
        "availability": spans if len(spans) > 1 else spans[0],
        "point": {"pixelSize": 6, "color": {"rgba": list(track.colour)}},
        "label": {"text": track.name, "font": "14px sans-serif", "pixelOffset": {"cartesian2": [0, -20]}},
        "path": {"width": _WIDTH_PX, "resolution": 1, "material": colour},
        "box": {"dimensions": {"cartesian": list(_BOX_M)}, "material": colour},
    }
    # Without the packet's closing brace: the long lists are streamed after it, then the brace is written.
    yield b",\n" + orjson.dumps(packet)[:-1]
    head = {"epoch": _time(epoch_s), "interpolationAlgorithm": "LINEAR", "interpolationDegree": 1}
    yield b',"position":' + orjson.dumps(head)[:-1] + b',"cartographicDegrees":['
    yield from _joined(_place_rows(part, epoch_s) for line in track.lines for part in line)
    yield b"]}"
    rows = _joined(_attitude_rows(part, epoch_s) for line in track.lines for part in line)
    first = next(rows, None)
    if first is not None:
        yield b',"orientation":' + orjson.dumps(head)[:-1] + b',"unitQuaternion":[' + first
        yield from rows
        yield b"]}"
    yield b"}"


def _joined(parts: Iterable[Column]) -> Iterator[bytes]:
    """The numbers of all parts as one JSON list without its brackets."""
    separator = b""
    for part in parts:
        if part.size:
            yield separator + orjson.dumps(part.ravel(), option=orjson.OPT_SERIALIZE_NUMPY)[1:-1]
            separator = b","


def _place_rows(samples: Samples, epoch_s: float) -> Column:
    return np.stack(
        [
            np.round(samples.t_s - epoch_s, 3),
            np.round(samples.longitude_deg, 7),
            np.round(samples.latitude_deg, 7),
            np.round(samples.altitude_m, 3),
        ],
        axis=1,
    )


def _attitude_rows(samples: Samples, epoch_s: float) -> Column:
    known = ~np.isnan(samples.heading_deg)
    chosen = Samples(*(column[known] for column in samples))
    return np.concatenate([np.round(chosen.t_s - epoch_s, 3)[:, None], np.round(earth_quaternions(chosen), 7)], axis=1)


def earth_quaternions(samples: Samples) -> Column:
    """Rows of x, y, z, w: the rotation from body axes (nose, left wing, up) to Earth-fixed axes (x through Greenwich on
    the equator, z through the north pole)."""
    # The Earth-fixed axes become local east, north, up by rotating longitude + 90 about z, then 90 - latitude about x.
    to_place = _product(
        _about(2, np.radians(samples.longitude_deg + 90.0)), _about(0, np.radians(90.0 - samples.latitude_deg))
    )
    # Body axes with the nose to the east equal east, north, up. Heading is clockwise seen from above, so its sign
    # changes; nose up is a negative rotation about the left wing's axis; right wing down is positive about the nose.
    to_nose = _product(
        _about(2, np.radians(90.0 - samples.heading_deg)),
        _product(_about(1, np.radians(-samples.pitch_deg)), _about(0, np.radians(samples.roll_deg))),
    )
    return _product(to_place, to_nose)


def _about(axis: int, angle_rad: Column) -> Column:
    """Quaternions of rotations about an axis, anticlockwise seen from its tip."""
    turned = np.zeros((angle_rad.size, 4))
    turned[:, axis] = np.sin(angle_rad / 2.0)
    turned[:, 3] = np.cos(angle_rad / 2.0)
    return turned


def _product(first: Column, second: Column) -> Column:
    """Quaternion product: the rotation `second`, followed by `first`."""
    x1, y1, z1, w1 = first.T
    x2, y2, z2, w2 = second.T
    return np.stack(
        [
            w1 * x2 + x1 * w2 + y1 * z2 - z1 * y2,
            w1 * y2 - x1 * z2 + y1 * w2 + z1 * x2,
            w1 * z2 + x1 * y2 - y1 * x2 + z1 * w2,
            w1 * w2 - x1 * x2 - y1 * y2 - z1 * z2,
        ],
        axis=1,
    )


def _time(t_s: float) -> str:
    return datetime.fromtimestamp(round(t_s, 3), UTC).isoformat(timespec="milliseconds").replace("+00:00", "Z")
