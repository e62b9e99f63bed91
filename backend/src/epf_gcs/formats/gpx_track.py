"""The flown tracks as GPX 1.1, which loggers, planners and photo programs read."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from datetime import UTC, datetime
from typing import Final, NamedTuple
from xml.sax.saxutils import escape

from epf_gcs.formats.gpx_plan import EVENT_TYPE
from epf_gcs.formats.placed_event import PlacedEvent
from epf_gcs.formats.samples import Samples
from epf_gcs.formats.xml_tree import GPX, plain

MEDIA_TYPE: Final = "application/gpx+xml"
POINT_EXTENSION: Final = "http://www.garmin.com/xmlschemas/TrackPointExtension/v2"


class TimedTrack(NamedTuple):
    """The lines of one track (it is broken where data are missing), each line in parts."""

    name: str
    lines: Sequence[Iterable[Samples]]


def gpx_track_pieces(
    tracks: Sequence[TimedTrack], events: Iterable[PlacedEvent] = (), note: str | None = None
) -> Iterator[bytes]:
    """A document with a `wpt` for each event, a `trk` for each track and a `trkseg` for each of its lines, in pieces.

    `note` describes it. Speed and course stand in Garmin's extension of a point, which most readers know.
    """
    yield (
        f'<?xml version="1.0" encoding="UTF-8"?>\n<gpx xmlns="{GPX}" xmlns:gpxtpx="{POINT_EXTENSION}" version="1.1" '
        'creator="EPF GCS">\n'
    ).encode()
    if note is not None:
        yield f"<metadata><desc>{escape(plain(note))}</desc></metadata>\n".encode()
    for event in events:
        yield (
            f'<wpt lat="{event.latitude_deg:.7f}" lon="{event.longitude_deg:.7f}"><ele>{event.altitude_m:.3f}</ele>'
            f"<time>{_time(event.t_s)}</time><name>{escape(plain(event.name))}</name>"
            f"<type>{EVENT_TYPE}{event.kind}</type></wpt>\n"
        ).encode()
    for track in tracks:
        if track.lines:
            yield f"<trk><name>{escape(plain(track.name))}</name>\n".encode()
            for line in track.lines:
                yield b"<trkseg>\n"
                for samples in line:
                    yield "".join(_points(samples)).encode("ascii")
                yield b"</trkseg>\n"
            yield b"</trk>\n"
    yield b"</gpx>\n"


def _points(samples: Samples) -> Iterator[str]:
    rows = zip(
        samples.t_s.tolist(),
        samples.latitude_deg.tolist(),
        samples.longitude_deg.tolist(),
        samples.altitude_m.tolist(),
        samples.speed_mps.tolist(),
        samples.course_deg.tolist(),
        strict=True,
    )
    for t_s, latitude_deg, longitude_deg, altitude_m, speed_mps, course_deg in rows:
        yield (
            f'<trkpt lat="{latitude_deg:.7f}" lon="{longitude_deg:.7f}">'
            f"<ele>{altitude_m:.3f}</ele><time>{_time(t_s)}</time>{_motion(speed_mps, course_deg)}</trkpt>\n"
        )


def _motion(speed_mps: float, course_deg: float) -> str:
    """What is known of both, in the order of the extension's schema."""
    speed = "" if math.isnan(speed_mps) else f"<gpxtpx:speed>{speed_mps:.2f}</gpxtpx:speed>"
    course = "" if math.isnan(course_deg) else f"<gpxtpx:course>{course_deg % 360.0:.1f}</gpxtpx:course>"
    if not speed and not course:
        return ""
    inside = f"<gpxtpx:TrackPointExtension>{speed}{course}</gpxtpx:TrackPointExtension>"
    return f"<extensions>{inside}</extensions>"


def _time(t_s: float) -> str:
    return datetime.fromtimestamp(round(t_s, 3), UTC).isoformat(timespec="milliseconds").replace("+00:00", "Z")
