"""A flight for Google Earth: the aircraft with their attitude, the view, the tracks, and links to reload them."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from itertools import islice
from typing import Final, NamedTuple
from xml.etree.ElementTree import Element

from epf_gcs.formats.kml import Position, add_styles, coordinates, document, kml_bytes
from epf_gcs.formats.xml_tree import add, decimal, plain

# One piece takes a few tenths of a millisecond, so that writing a long track does not hold up the event loop.
_POINTS_PER_PIECE: Final = 200
_VIEW_RANGE_M: Final = 250.0
_VIEW_TILT_DEG: Final = 70.0
# Placeholder for the coordinates of a line, replaced while writing; its letters cannot be in a name (see `plain`).
_MARK: Final = re.compile("\ue000([0-9]+)\ue001".encode())


@dataclass(frozen=True, slots=True)
class Aircraft:
    """One aircraft. The angles are None if they are not live: then only its last position is shown."""

    name: str
    position: Position
    heading_deg: float | None = None
    pitch_deg: float | None = None
    roll_deg: float | None = None
    description: str = ""


class NamedTrack(NamedTuple):
    """The lines of one track, which is broken where data are missing."""

    name: str
    lines: Sequence[Iterable[Position]]


class Link(NamedTuple):
    """An address that Google Earth reloads every `refresh_s` seconds; None: loaded once."""

    name: str
    url: str
    refresh_s: int | None
    moves_view: bool = False


def track_document(
    name: str, tracks: Sequence[NamedTrack], aircraft: Sequence[Aircraft] = (), model_url: str = ""
) -> Iterator[bytes]:
    """A KML with the tracks and the aircraft at their present positions, in pieces that each take little time."""
    root, content = document(name)
    add_styles(content)
    for one in aircraft:
        _add_aircraft(content, one, model_url)
    return _pieces(root, content, tracks)


def live_document(
    name: str, aircraft: Sequence[Aircraft], followed: Aircraft | None, tracks: Sequence[NamedTrack], model_url: str
) -> Iterator[bytes]:
    """A KML with the aircraft and their recent tracks, viewed from behind the followed aircraft."""
    root, content = document(name)
    if followed is not None:
        _add_view(content, followed)
    add_styles(content)
    for one in aircraft:
        _add_aircraft(content, one, model_url)
    return _pieces(root, content, tracks)


def link_document(name: str, links: Sequence[Link]) -> bytes:
    """The KML that a user opens once: it names the addresses to load, and how often."""
    root, content = document(name)
    add(content, "open", "1")
    for link in links:
        element = add(content, "NetworkLink")
        add(element, "name", plain(link.name))
        add(element, "flyToView", "1" if link.moves_view else "0")
        where = add(element, "Link")
        add(where, "href", link.url)
        if link.refresh_s is not None:
            add(where, "refreshMode", "onInterval")
            add(where, "refreshInterval", str(link.refresh_s))
    return kml_bytes(root)


def _pieces(root: Element, content: Element, tracks: Sequence[NamedTrack]) -> Iterator[bytes]:
    lines: list[Iterable[Position]] = []
    for track in tracks:
        if track.lines:
            placemark = add(content, "Placemark")
            add(placemark, "name", plain(track.name))
            add(placemark, "styleUrl", "#track")
            geometry = add(placemark, "MultiGeometry")
            for line in track.lines:
                _add_line(geometry, len(lines))
                lines.append(line)
    for index, text in enumerate(_MARK.split(kml_bytes(root))):
        if index % 2:
            yield from _coordinate_pieces(lines[int(text)])
        else:
            yield text


def _add_line(geometry: Element, number: int) -> None:
    """A line with a curtain to the ground."""
    line = add(geometry, "LineString")
    add(line, "extrude", "1")
    add(line, "altitudeMode", "absolute")
    add(line, "coordinates", f"\ue000{number}\ue001")


def _coordinate_pieces(line: Iterable[Position]) -> Iterator[bytes]:
    positions = iter(line)
    while some := list(islice(positions, _POINTS_PER_PIECE)):
        yield coordinates(some).encode("ascii") + b"\n"


def _add_view(content: Element, aircraft: Aircraft) -> None:
    latitude_deg, longitude_deg, altitude_m = aircraft.position
    view = add(content, "LookAt")
    add(view, "longitude", decimal(longitude_deg))
    add(view, "latitude", decimal(latitude_deg))
    add(view, "altitude", decimal(altitude_m))
    add(view, "heading", decimal(aircraft.heading_deg or 0.0))
    add(view, "tilt", decimal(_VIEW_TILT_DEG))
    add(view, "range", decimal(_VIEW_RANGE_M))
    add(view, "altitudeMode", "absolute")


def _add_aircraft(content: Element, aircraft: Aircraft, model_url: str) -> None:
    placemark = add(content, "Placemark")
    add(placemark, "name", plain(aircraft.name))
    if aircraft.description:
        add(placemark, "description", aircraft.description)
    heading_deg, pitch_deg, roll_deg = aircraft.heading_deg, aircraft.pitch_deg, aircraft.roll_deg
    if heading_deg is None or pitch_deg is None or roll_deg is None:
        _add_point(placemark, aircraft.position)
        return
    # Add a point to the model, because a model has no label and some readers do not draw it.
    geometry = add(placemark, "MultiGeometry")
    _add_point(geometry, aircraft.position)
    latitude_deg, longitude_deg, altitude_m = aircraft.position
    model = add(geometry, "Model")
    add(model, "altitudeMode", "absolute")
    location = add(model, "Location")
    add(location, "longitude", decimal(longitude_deg))
    add(location, "latitude", decimal(latitude_deg))
    add(location, "altitude", decimal(altitude_m))
    orientation = add(model, "Orientation")
    add(orientation, "heading", decimal(heading_deg))
    # Clockwise about x and y, seen from the tip of the axis: nose up and right wing down are negative.
    add(orientation, "tilt", decimal(-pitch_deg))
    add(orientation, "roll", decimal(-roll_deg))
    add(add(model, "Link"), "href", model_url)


def _add_point(parent: Element, position: Position) -> None:
    point = add(parent, "Point")
    add(point, "extrude", "1")
    add(point, "altitudeMode", "absolute")
    add(point, "coordinates", coordinates([position]))
