"""The flown tracks as GPX 1.1, which loggers, planners and photo programs read."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from datetime import UTC, datetime
from typing import Final, NamedTuple
from xml.sax.saxutils import escape

from epf_gcs.formats.samples import Samples
from epf_gcs.formats.xml_tree import GPX, plain

MEDIA_TYPE: Final = "application/gpx+xml"


class TimedTrack(NamedTuple):
    """The lines of one track (it is broken where data are missing), each line in parts."""

    name: str
    lines: Sequence[Iterable[Samples]]


def gpx_track_pieces(tracks: Sequence[TimedTrack], note: str | None = None) -> Iterator[bytes]:
    """A document with a `trk` for each track and a `trkseg` for each of its lines, in pieces. `note` describes it."""
    yield f'<?xml version="1.0" encoding="UTF-8"?>\n<gpx xmlns="{GPX}" version="1.1" creator="EPF GCS">\n'.encode()
    if note is not None:
        yield f"<metadata><desc>{escape(plain(note))}</desc></metadata>\n".encode()
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
        strict=True,
    )
    for t_s, latitude_deg, longitude_deg, altitude_m in rows:
        time = datetime.fromtimestamp(round(t_s, 3), UTC).isoformat(timespec="milliseconds").replace("+00:00", "Z")
        yield (
            f'<trkpt lat="{latitude_deg:.7f}" lon="{longitude_deg:.7f}">'
            f"<ele>{altitude_m:.3f}</ele><time>{time}</time></trkpt>\n"
        )
