"""Flight plans as KML: our own files are read back exactly, Google Earth's as far as they hold what a plan needs."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from typing import Final, Literal, NamedTuple
from xml.etree.ElementTree import Element

from epf_gcs.codec.tables import Waypoint
from epf_gcs.formats.kml import SPEED_DATA, add_plan, add_styles, document, kml_bytes
from epf_gcs.formats.mission_file import (
    MAX_WAYPOINTS,
    FileFault,
    MissionFile,
    Note,
    Place,
    Point,
    above_ground,
    number,
    place_params,
    settle,
)
from epf_gcs.formats.units import ft_from_m
from epf_gcs.formats.xml_tree import child, child_text, every

_COMMA: Final = re.compile(r"\s*,\s*")  # "lon, lat, alt" is wrong, and common

_Mode = Literal["absolute", "relative", "clamped"]


class _Shape(NamedTuple):
    """The positions of one geometry, and what its altitudes refer to."""

    mode: _Mode
    points: list[Point]


class _Pin(NamedTuple):
    """A placemark with a point. `speed` is the text of our speed entry; None if it has none, so is not our own."""

    place: Place
    point: Element
    speed: str | None


def write_kml(name: str, waypoints: Sequence[Waypoint]) -> bytes:
    """A KML 2.2 document: a placemark for each waypoint, and the line that joins them."""
    root, content = document(name)
    add_styles(content)
    add_plan(content, name, waypoints)
    return kml_bytes(root)


def read_kml(root: Element) -> MissionFile:
    """The waypoints of a KML file: our own placemarks if there are any, else the first line, else other placemarks.

    Altitudes are metres. Raises FileFault.
    """
    pins = list(_pins(root))
    lines = list(every(root, "LineString"))
    if lines and all(pin.speed is None for pin in pins):
        chosen, skipped = [_shape(lines[0], Place("LineString", 1))], len(lines) - 1 + len(pins)
    else:
        # Reading one more than a plan can hold is enough for `settle` to refuse the file.
        chosen, skipped = [_pin_shape(pin) for pin in pins[: MAX_WAYPOINTS + 1]], 0
    notes = [Note("shapes_skipped", {"count": skipped})] if skipped else []
    return settle("kml", *_as_flown(chosen, notes))


def _as_flown(shapes: list[_Shape], notes: list[Note]) -> tuple[list[Point], list[Note]]:
    """The points in order, and the notes with those on their altitudes added."""
    for shape in shapes:
        if shape.mode == "relative" and shape.points:
            raise above_ground(shape.points[0].place)
    points: list[Point] = []
    clamped = 0
    for shape in shapes:
        for point in shape.points:
            # "Clamped to ground" ignores the altitude in the file. Use it all the same if it is not 0; 0 means none.
            if shape.mode == "clamped" and point.altitude_ft:
                clamped += 1
            points.append(point if shape.mode != "clamped" or point.altitude_ft else point._replace(altitude_ft=None))
    if clamped:
        notes.append(Note("altitude_clamped", {"count": clamped}))
    return points, notes


def _pins(root: Element) -> Iterator[_Pin]:
    for nth, placemark in enumerate(every(root, "Placemark"), 1):
        point = child(placemark, "Point")
        if point is not None:
            yield _Pin(Place("Placemark", nth), point, _speed_text(placemark))


def _pin_shape(pin: _Pin) -> _Shape:
    shape = _shape(pin.point, pin.place)
    speed_kt = None if pin.speed is None else number(pin.speed, SPEED_DATA, pin.place)
    return shape._replace(points=[found._replace(place=pin.place, speed_kt=speed_kt) for found in shape.points[:1]])


def _speed_text(placemark: Element) -> str | None:
    extended = child(placemark, "ExtendedData")
    for data in () if extended is None else every(extended, "Data"):
        if data.get("name") == SPEED_DATA:
            return child_text(data, "value") or ""
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
