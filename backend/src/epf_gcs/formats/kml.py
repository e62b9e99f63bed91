"""KML 2.2 as we write it. The elements are in the schema's order, which readers other than Google Earth require."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from datetime import UTC, datetime
from typing import Final
from xml.etree.ElementTree import Element

from epf_gcs.codec.tables import Waypoint
from epf_gcs.formats.placed_event import PlacedEvent
from epf_gcs.formats.xml_tree import KML, add, decimal, plain, xml_bytes
from epf_gcs.units import m_from_ft

MEDIA_TYPE: Final = "application/vnd.google-earth.kml+xml"
SPEED_DATA: Final = "speed_kt"
"""Name of the ExtendedData entry that holds a waypoint's speed, for which KML has no element."""

EVENT_DATA: Final = "epf_event"
"""Name of the entry that says that a placemark is something that happened in a flight, and no waypoint."""

# Colours are aabbggrr.
TRACK_COLOUR: Final = "ff00ffff"
_CURTAIN_COLOUR: Final = "4d00ffff"
_PLAN_COLOUR: Final = "ffff00ff"

Position = tuple[float, float, float]
"""Latitude and longitude in degrees, altitude in metres above mean sea level."""


def document(name: str) -> tuple[Element, Element]:
    """A new document: its root, and the element that takes the content."""
    root = Element("kml", {"xmlns": KML})
    content = add(root, "Document")
    add(content, "name", plain(name))
    return root, content


def kml_bytes(root: Element) -> bytes:
    """The document as a file."""
    return xml_bytes(root)


def coordinates(positions: Iterable[Position]) -> str:
    """The positions as KML's text, longitude first."""
    return " ".join(f"{longitude:.9f},{latitude:.9f},{altitude:.6f}" for latitude, longitude, altitude in positions)


def add_styles(content: Element) -> None:
    """The styles of a track, with its curtain to the ground, and of a plan. Add them before any feature."""
    track = add(content, "Style", id="track")
    _line_style(track, TRACK_COLOUR, 3)
    add(add(track, "PolyStyle"), "color", _CURTAIN_COLOUR)
    _line_style(add(content, "Style", id="plan"), _PLAN_COLOUR, 2)


def add_plan(parent: Element, name: str, waypoints: Sequence[Waypoint]) -> None:
    """A folder with a placemark for each waypoint, which keeps its speed, and the line that joins them."""
    folder = add(parent, "Folder")
    add(folder, "name", plain(name))
    positions = [(at.latitude_deg, at.longitude_deg, m_from_ft(at.altitude_ft)) for at in waypoints]
    if len(positions) > 1:
        route = add(folder, "Placemark")
        add(route, "name", plain(name))
        add(route, "styleUrl", "#plan")
        line = add(route, "LineString")
        add(line, "altitudeMode", "absolute")
        add(line, "coordinates", coordinates(positions))
    for index, (waypoint, position) in enumerate(zip(waypoints, positions, strict=True)):
        placemark = add(folder, "Placemark")
        add(placemark, "name", str(index))
        data = add(add(placemark, "ExtendedData"), "Data", name=SPEED_DATA)
        add(data, "value", decimal(waypoint.speed_kt))
        point = add(placemark, "Point")
        add(point, "extrude", "1")
        add(point, "altitudeMode", "absolute")
        add(point, "coordinates", coordinates([position]))


def add_events(parent: Element, name: str, events: Sequence[PlacedEvent]) -> None:
    """A folder with a placemark for each event, at its time and place."""
    folder = add(parent, "Folder")
    add(folder, "name", plain(name))
    for event in events:
        placemark = add(folder, "Placemark")
        add(placemark, "name", plain(event.name))
        when = datetime.fromtimestamp(round(event.t_s, 3), UTC).isoformat(timespec="milliseconds")
        add(add(placemark, "TimeStamp"), "when", when.replace("+00:00", "Z"))
        add(add(add(placemark, "ExtendedData"), "Data", name=EVENT_DATA), "value", event.kind)
        point = add(placemark, "Point")
        add(point, "altitudeMode", "absolute")
        add(point, "coordinates", coordinates([(event.latitude_deg, event.longitude_deg, event.altitude_m)]))


def _line_style(style: Element, colour: str, width: int) -> None:
    line = add(style, "LineStyle")
    add(line, "color", colour)
    add(line, "width", str(width))
