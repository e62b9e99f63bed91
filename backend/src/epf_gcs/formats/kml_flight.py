"""A whole flight as KML: the lines with their curtains, the same with time, attitude, speed and course of every point,
what happened where, and the plans."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Iterator, Sequence
from typing import Final, NamedTuple
from xml.etree.ElementTree import Element

import numpy as np

from epf_gcs.codec.tables import Waypoint
from epf_gcs.formats.kml import add_events, add_plan, add_styles, coordinates, document, kml_bytes
from epf_gcs.formats.placed_event import PlacedEvent
from epf_gcs.formats.samples import Column, Samples
from epf_gcs.formats.xml_tree import add, plain

_SCHEMA: Final = "flown"
GX: Final = "http://www.google.com/kml/ext/2.2"
# Placeholder for the points of a line, replaced while writing; its letters cannot be in a name (see `plain`).
_MARK: Final = re.compile("\ue000([0-9]+)([lt])\ue001".encode())


class FlownTrack(NamedTuple):
    """The lines of one track, each in parts, with the Unix times of its first and last point."""

    name: str
    lines: Sequence[Iterable[Samples]]
    spans_s: Sequence[tuple[float, float]]


class NamedEvents(NamedTuple):
    """What happened on a flight, and the title of it all."""

    name: str
    events: Sequence[PlacedEvent]


class NamedPlan(NamedTuple):
    """A plan and its title."""

    name: str
    waypoints: Sequence[Waypoint]


def flight_document(
    name: str, tracks: Sequence[FlownTrack], plans: Sequence[NamedPlan], happened: NamedEvents, note: str | None = None
) -> Iterator[bytes]:
    """A document in pieces, described by `note`. Each line is there twice: as a line that any reader draws, and, for
    readers that know Google's extension, as a track that their clock moves along."""
    root, content = document(name)
    root.set("xmlns:gx", GX)
    if note is not None:
        add(content, "description", plain(note))
    add_styles(content)
    schema = add(content, "Schema", id=_SCHEMA)
    for field in ("speed_mps", "course_deg"):
        add(schema, "gx:SimpleArrayField", name=field, type="float")
    lines: list[Iterable[Samples]] = []
    for track in tracks:
        if track.lines:
            folder = add(content, "Folder")
            add(folder, "name", plain(track.name))
            for line, span_s in zip(track.lines, track.spans_s, strict=True):
                _add_line(folder, track.name, span_s, len(lines))
                lines.append(line)
    if happened.events:
        add_events(content, happened.name, happened.events)
    for plan in plans:
        add_plan(content, plan.name, plan.waypoints)
    texts = _MARK.split(kml_bytes(root))
    for index in range(0, len(texts), 3):
        yield texts[index]
        if index + 2 < len(texts):
            line = lines[int(texts[index + 1])]
            yield from _coordinates(line) if texts[index + 2] == b"l" else _track(line)


def _add_line(folder: Element, name: str, span_s: tuple[float, float], number: int) -> None:
    line = add(folder, "Placemark")
    add(line, "name", plain(name))
    span = add(line, "TimeSpan")
    add(span, "begin", iso_ms(np.array(span_s[:1]))[0])
    add(span, "end", iso_ms(np.array(span_s[1:]))[0])
    add(line, "styleUrl", "#track")
    geometry = add(line, "LineString")
    add(geometry, "extrude", "1")
    add(geometry, "altitudeMode", "absolute")
    add(geometry, "coordinates", f"\ue000{number}l\ue001")
    moving = add(folder, "Placemark")
    add(moving, "name", plain(name))
    add(moving, "styleUrl", "#track")
    track = add(moving, "gx:Track")
    add(track, "altitudeMode", "absolute").tail = f"\ue000{number}t\ue001"


def _coordinates(line: Iterable[Samples]) -> Iterator[bytes]:
    for samples in line:
        yield coordinates(zip(*(column.tolist() for column in samples[1:4]), strict=True)).encode("ascii") + b"\n"


def _track(line: Iterable[Samples]) -> Iterator[bytes]:
    """All times, then all places, attitudes, speeds and courses, as the extension's schema has them.

    An attitude that is not known is level on the course.
    """
    for samples in line:
        yield "".join(f"<when>{text}</when>\n" for text in iso_ms(samples.t_s)).encode("ascii")
    for samples in line:
        places = zip(*(column.tolist() for column in samples[1:4]), strict=True)
        yield "".join(
            f"<gx:coord>{longitude:.9f} {latitude:.9f} {altitude:.3f}</gx:coord>\n"
            for latitude, longitude, altitude in places
        ).encode("ascii")
    for samples in line:
        heading = np.where(np.isnan(samples.heading_deg), samples.course_deg, samples.heading_deg) % 360.0
        angles = np.nan_to_num(np.column_stack((heading, samples.pitch_deg, samples.roll_deg)))
        yield "".join(
            f"<gx:angles>{heading:.2f} {pitch:.2f} {roll:.2f}</gx:angles>\n" for heading, pitch, roll in angles.tolist()
        ).encode("ascii")
    yield f'<ExtendedData><SchemaData schemaUrl="#{_SCHEMA}">\n'.encode()
    for field in ("speed_mps", "course_deg"):
        yield f'<gx:SimpleArrayData name="{field}">\n'.encode()
        for samples in line:
            values = getattr(samples, field).tolist()
            yield "".join(
                f"<gx:value>{'' if math.isnan(value) else f'{value:.2f}'}</gx:value>\n" for value in values
            ).encode("ascii")
        yield b"</gx:SimpleArrayData>\n"
    yield b"</SchemaData></ExtendedData>\n"


def iso_ms(t_s: Column) -> list[str]:
    """Unix times as ISO 8601, to the millisecond."""
    texts = np.datetime_as_string(np.round(t_s * 1e3).astype("datetime64[ms]"), unit="ms", timezone="UTC")
    return [str(text) for text in texts]
