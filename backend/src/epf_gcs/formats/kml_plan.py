"""Flight plans as KML: our own files are read back exactly, Google Earth's as far as they hold what a plan needs."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from typing import Final, NamedTuple
from xml.etree.ElementTree import Element

from epf_gcs.codec.tables import Waypoint
from epf_gcs.formats.kml import EVENT_DATA, SPEED_DATA, add_plan, add_styles, document, kml_bytes
from epf_gcs.formats.mission_file import (
    MAX_WAYPOINTS,
    FileFault,
    FilePlan,
    Frame,
    Note,
    Place,
    Point,
    frame_fault,
    not_a_number,
    number,
    place_params,
)
from epf_gcs.formats.xml_tree import child, child_text, every, local
from epf_gcs.units import ft_from_m

_COMMA: Final = re.compile(r"\s*,\s*")  # "lon, lat, alt" is wrong, and common

# KML's altitude modes, those of its extension too. Without one, an altitude is clamped: it is ignored.
_FRAME: Final[dict[str, Frame | None]] = {
    "absolute": "sea",
    "relativeToGround": "ground",
    "clampToGround": None,
    "clampToSeaFloor": None,
    "": None,
}


class _Shape(NamedTuple):
    """The positions of one geometry; clamped: on the ground, whatever their altitudes."""

    is_clamped: bool
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


def read_kml(root: Element) -> FilePlan:
    """The waypoints of a KML file: our own placemarks if there are any, else the first line, else the first track that
    was flown, else other placemarks.

    Altitudes are metres. A line with more points than a plan takes is one that was flown, too. Raises FileFault.
    """
    pins = list(_pins(root))
    lines = list(every(root, "LineString"))
    tracks = [track for track in every(root, "Track") if child(track, "coord") is not None]
    is_ours = any(pin.speed is not None for pin in pins)
    if not is_ours and (lines or tracks):
        chosen = [_shape(lines[0], Place("LineString", 1)) if lines else _track_shape(tracks[0])]
        skipped = len(lines) + len(tracks) - 1 + len(pins)
    else:
        # Reading one more than a plan can hold is enough for `settle` to refuse the file.
        chosen = [_pin_shape(pin) for pin in pins[: MAX_WAYPOINTS + 1]]
        # Our own file has its marks twice: as such, and joined by a line.
        joined = [word for pin in pins for word in _words(pin.point)]
        skipped = sum(_words(line) != joined for line in lines) + len(tracks)
    notes = [Note("shapes_skipped", {"count": skipped})] if skipped else []
    points, notes = _as_flown(chosen, notes)
    is_track = not is_ours and (len(points) > MAX_WAYPOINTS if lines else bool(tracks))
    return FilePlan("kml", points, notes, is_track=is_track)


def _as_flown(shapes: list[_Shape], notes: list[Note]) -> tuple[list[Point], list[Note]]:
    """The points in order, and the notes with those on their altitudes added."""
    points: list[Point] = []
    clamped = 0
    for shape in shapes:
        for point in shape.points:
            # "Clamped to ground" ignores the altitude in the file. Use it all the same if it is not 0; 0 means none.
            if shape.is_clamped and point.altitude_ft:
                clamped += 1
            points.append(point if not shape.is_clamped or point.altitude_ft else point._replace(altitude_ft=None))
    if clamped:
        notes.append(Note("altitude_clamped", {"count": clamped}))
    return points, notes


def _pins(root: Element) -> Iterator[_Pin]:
    for nth, placemark in enumerate(every(root, "Placemark"), 1):
        point = child(placemark, "Point")
        if point is not None and _data(placemark, EVENT_DATA) is None:
            yield _Pin(Place("Placemark", nth), point, _data(placemark, SPEED_DATA))


def _pin_shape(pin: _Pin) -> _Shape:
    shape = _shape(pin.point, pin.place)
    speed_kt = None if pin.speed is None else number(pin.speed, SPEED_DATA, pin.place)
    if len(shape.points) > 1:
        raise not_a_number("coordinates", " ".join(_words(pin.point)), pin.place)
    return shape._replace(points=[found._replace(place=pin.place, speed_kt=speed_kt) for found in shape.points])


def _data(placemark: Element, name: str) -> str | None:
    """The entry of the placemark's own data; None if it has none of this name."""
    extended = child(placemark, "ExtendedData")
    for data in () if extended is None else every(extended, "Data"):
        if data.get("name") == name:
            return child_text(data, "value") or ""
    return None


def _shape(geometry: Element, place: Place) -> _Shape:
    points = [
        _position(position, place if place.kind == "Placemark" else Place("coordinates", index))
        for index, position in enumerate(_words(geometry), 1)
    ]
    return _framed(geometry, place, points)


def _track_shape(track: Element) -> _Shape:
    """A track of Google's extension: an element for each position, its numbers apart by spaces."""
    coords = (element for element in track if local(element) == "coord")
    points = [
        _position(",".join((element.text or "").split()), Place("coordinates", index))
        for index, element in enumerate(coords, 1)
    ]
    return _framed(track, Place("Track", 1), points)


def _framed(geometry: Element, place: Place, points: list[Point]) -> _Shape:
    """The points with what their altitudes count from. Raises FileFault if that is unknown."""
    mode = (child_text(geometry, "altitudeMode") or "").strip()
    if child_text(geometry, "altitudeOffset"):
        mode = "gx:altitudeOffset"
    if mode not in _FRAME:
        raise frame_fault(mode, place)
    counts_from = _FRAME[mode]
    return _Shape(counts_from is None, [point._replace(frame=counts_from or "sea") for point in points])


def _words(geometry: Element) -> list[str]:
    return _COMMA.sub(",", child_text(geometry, "coordinates") or "").split()


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
