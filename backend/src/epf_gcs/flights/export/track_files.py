"""KML, KMZ, GPX and CZML of an indexed flight, with the times of the flight (see `spread.py`) and its plans in KML."""

from __future__ import annotations

from collections.abc import Iterator
from datetime import UTC, datetime
from pathlib import Path
from typing import Final

from epf_gcs.flights.export.asked import ExportRequest, Progress, no_position
from epf_gcs.flights.export.flown import TOPICS, FlownLine, Source, flown_lines
from epf_gcs.flights.export.placed import placed_events
from epf_gcs.flights.export.plans import plans_at
from epf_gcs.flights.export.stretch import Stretch
from epf_gcs.flights.export.thinning import DEVIATION_M, thinned_lines
from epf_gcs.formats import kmz
from epf_gcs.formats.czml import MovingTrack, czml_pieces
from epf_gcs.formats.gpx_track import TimedTrack, gpx_track_pieces
from epf_gcs.formats.kml_flight import FlownTrack, NamedEvents, NamedPlan, flight_document
from epf_gcs.formats.kml_words import WORDS
from epf_gcs.recordings.reading import notes_of

# How much of the work is reading the columns; the rest is writing, whose progress is that of the points.
_READING: Final = 0.5
_SOURCES: Final[tuple[Source, ...]] = ("flight", "hil")
_COLOURS: Final = {"flight": (255, 255, 0, 255), "hil": (0, 229, 255, 255)}


def write(asked: ExportRequest, target: Path, aside: Path, progress: Progress) -> None:
    """Raises GatewayError, OSError."""
    stretch = Stretch(asked, progress)
    stretch.expect([topic for topic in TOPICS if topic in stretch.topics], share=_READING)
    tracks = {source: flown_lines(stretch, source, aside) for source in _SOURCES}
    if asked.is_thinned:
        tracks = {source: thinned_lines(lines, aside / f"{source}.thinned") for source, lines in tracks.items()}
    points = sum(line.end - line.first for lines in tracks.values() for line in lines)
    if not points:
        raise no_position()
    written = 0
    with target.open("wb") as file:
        for piece in _pieces(asked, stretch, tracks):
            file.write(piece)
            written += len(piece)
            # A point takes at least some 50 bytes in each of the formats: the share is never too large.
            progress.at(min(0.99, _READING + (1.0 - _READING) * written / (written + 50.0 * points)))


def _pieces(asked: ExportRequest, stretch: Stretch, tracks: dict[Source, list[FlownLine]]) -> Iterator[bytes]:
    words = WORDS[asked.language]
    names: dict[Source, str] = {"flight": words.track, "hil": words.hil_track}
    when = datetime.fromtimestamp(stretch.start_ns // 1_000_000_000, UTC).strftime("%Y-%m-%d %H:%M:%S UTC")
    title = f"{words.station}: {words.track}, {when}"
    happened = placed_events(stretch.events(), [*tracks["hil"], *tracks["flight"]], asked.language)
    note = words.thinned.format(deviation_m=DEVIATION_M) if asked.is_thinned else None
    match asked.format:
        case "gpx":
            named = [TimedTrack(names[source], lines) for source, lines in tracks.items()]
            return gpx_track_pieces(named, happened, note)
        case "czml":
            return czml_pieces(
                title,
                [
                    MovingTrack(source, names[source], _COLOURS[source], [line.span_s() for line in lines], lines)
                    for source, lines in tracks.items()
                ],
            )
    noted = plans_at(notes_of(asked.recording), stretch.last_ns)
    titles = {"flight": words.plan, "hil": words.hil_plan}
    document = flight_document(
        title,
        [FlownTrack(names[one], lines, [line.span_s() for line in lines]) for one, lines in tracks.items()],
        [NamedPlan(titles[name], waypoints) for name, waypoints in noted.items()],
        NamedEvents(words.events, happened),
        note,
    )
    return document if asked.format == "kml" else kmz.kmz_pieces([(kmz.DOCUMENT, document)])
