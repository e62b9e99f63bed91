"""Flight plans as KML: ours come back exactly, those of Google Earth as far as they say what a plan needs."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from typing import Final, Literal, NamedTuple
from xml.etree.ElementTree import Element

from gateway.codec.tables import Waypoint
from gateway.formats.kml import SPEED_DATA, add_plan, add_styles, document, kml_bytes
from gateway.formats.mission_file import FileFault, MissionFile, Note, Place, Point, number, place_params, settle
from gateway.formats.units import ft_from_m
from gateway.formats.xml_tree import child, child_text, every, local

_COMMA: Final = re.compile(r"\s*,\s*")  # "lon, lat, alt" is wrong, and common

_Mode = Literal["absolute", "relative", "clamped"]


class _Shape(NamedTuple):
    """The positions of one geometry, and how its altitudes are meant."""

    mode: _Mode
    points: list[Point]


def write_kml(name: str, waypoints: Sequence[Waypoint]) -> bytes:
    """A KML 2.2 document: a placemark for each waypoint, and the line that joins them."""
    root, content = document(name)
    add_styles(content)
    add_plan(content, name, waypoints)
    return kml_bytes(root)


def read_kml(root: Element) -> MissionFile:
    """The waypoints of a KML file. Our own placemarks before lines, the first line before other placemarks.

    Altitudes are metres. Raises FileFault.
    """
    if local(root) != "kml":
        raise FileFault("mission_file_unknown", f"its first element is <{local(root)[:30]}> and not <kml> or <gpx>")
    points = list(_point_shapes(root))
    lines = [_shape(line, Place("LineString", index)) for index, line in enumerate(every(root, "LineString"), 1)]
    ours = any(point.speed_kt is not None for shape in points for point in shape.points)
    if ours or not lines:
        chosen, skipped = points, 0 if ours else len(lines)
    else:
        chosen, skipped = lines[:1], len(lines) - 1 + len(points)
    notes = [Note("shapes_skipped", {"count": skipped})] if skipped else []
    return settle("kml", *_as_flown(chosen, notes))


def _as_flown(shapes: list[_Shape], notes: list[Note]) -> tuple[list[Point], list[Note]]:
    """The points in order, and what is to be said of their altitudes."""
    above_ground = sum(len(shape.points) for shape in shapes if shape.mode == "relative")
    if above_ground:
        notes.append(Note("altitude_above_ground", {"count": above_ground}))
    points: list[Point] = []
    clamped = 0
    for shape in shapes:
        for point in shape.points:
            # On the ground whatever it says; a number there is more than nothing, a zero is not.
            if shape.mode == "clamped" and point.altitude_ft:
                clamped += 1
            points.append(point if shape.mode != "clamped" or point.altitude_ft else point._replace(altitude_ft=None))
    if clamped:
        notes.append(Note("altitude_clamped", {"count": clamped}))
    return points, notes


def _point_shapes(root: Element) -> Iterator[_Shape]:
    for index, placemark in enumerate(every(root, "Placemark"), 1):
        point = child(placemark, "Point")
        if point is None:
            continue
        place = Place("Placemark", index)
        shape = _shape(point, place)
        speed = _speed_kt(placemark, place)
        yield shape._replace(points=[found._replace(place=place, speed_kt=speed) for found in shape.points[:1]])


def _speed_kt(placemark: Element, place: Place) -> float | None:
    extended = child(placemark, "ExtendedData")
    for data in () if extended is None else every(extended, "Data"):
        if data.get("name") == SPEED_DATA:
            return number(child_text(data, "value"), SPEED_DATA, place)
    return None


def _shape(geometry: Element, place: Place) -> _Shape:
    text = _COMMA.sub(",", child_text(geometry, "coordinates") or "")
    points = [
        _position(position, place if place.kind == "Placemark" else Place("coordinates", index))
        for index, position in enumerate(text.split(), 1)
    ]
    return _Shape(_mode(child_text(geometry, "altitudeMode")), points)


def _mode(text: str | None) -> _Mode:
    words = (text or "").strip()
    return "absolute" if words == "absolute" else "relative" if words.startswith("relative") else "clamped"


def _position(text: str, place: Place) -> Point:
    parts = text.split(",")
    if len(parts) < 2:
        raise FileFault(
            "mission_file_unreadable",
            f"{place} is not longitude,latitude,altitude ({text[:30]!r})",
            field="coordinates",
            value=text[:30],
            **place_params(place),
        )
    altitude_m = number(parts[2], "altitude", place) if len(parts) > 2 and parts[2] else None
    return Point(
        place,
        number(parts[1], "latitude_deg", place),
        number(parts[0], "longitude_deg", place),
        None if altitude_m is None else ft_from_m(altitude_m),
        None,
    )
