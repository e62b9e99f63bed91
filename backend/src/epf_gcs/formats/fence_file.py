"""Fences as files of other programs: KML, .plan of QGroundControl, the lists of Mission Planner and MAVProxy."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Final, Literal, NamedTuple
from xml.etree.ElementTree import Element

import orjson

from epf_gcs.earth import RADIUS_M
from epf_gcs.errors import ErrorCode, InvalidInputError, Params
from epf_gcs.formats.fence_border import Corner, crossing_edges
from epf_gcs.formats.fence_rows import FenceKind, FenceRowFault, FenceShape, are_rows, fence_items, fence_rows
from epf_gcs.formats.kml import coordinates, document, kml_bytes
from epf_gcs.formats.mission_file import FileFault
from epf_gcs.formats.recognise import read_plan_file, unpacked_kml
from epf_gcs.formats.wpl_plan import SIGNATURE
from epf_gcs.formats.xml_tree import add, child_text, decimal, every, local, parse_xml, plain
from epf_gcs.units import m_from_ft

FenceFormat = Literal["kml", "plan"]
FenceFileFormat = Literal["kml", "plan", "waypoints", "rows"]
"""What a fence is read from: also a .waypoints with fence items, and rows of latitude and longitude."""
FenceNoteCode = Literal["circle_cornered", "crosses", "exclusions_skipped", "return_skipped", "shapes_skipped"]

LEAST_CORNERS: Final = 3
MOST_CORNERS: Final = 100
LOWEST_CEILING_FT: Final = -1500.0
HIGHEST_CEILING_FT: Final = 60_000.0
CEILING_DATA: Final = "ceiling_ft"
"""Name of the ExtendedData entry that holds the ceiling, so that it comes back exactly."""

_COMMA: Final = re.compile(r"\s*,\s*")  # "lon, lat, alt" is wrong, and common
_CIRCLE_CORNERS: Final = 36
_MOST_RADIUS_M: Final = 1_000_000.0


class FenceNote(NamedTuple):
    """Something about the file that a person should know before relying on the fence."""

    code: FenceNoteCode
    params: Params


@dataclass(frozen=True, slots=True)
class FenceFile:
    """A fence that was read: 3 to 100 corners, the first not repeated; `ceiling_ft` above the sea, or None.

    The border may cross itself, which a note says.
    """

    format: FenceFileFormat
    corners: tuple[Corner, ...]
    ceiling_ft: float | None
    notes: tuple[FenceNote, ...]


def write_fence_kml(name: str, corners: Sequence[Corner], ceiling_ft: float | None) -> bytes:
    """A polygon: a curtain to the ceiling where there is one, else on the ground."""
    root, content = document(name)
    placemark = add(content, "Placemark")
    add(placemark, "name", plain(name))
    if ceiling_ft is not None:
        add(add(add(placemark, "ExtendedData"), "Data", name=CEILING_DATA), "value", decimal(ceiling_ft))
    polygon = add(placemark, "Polygon")
    if ceiling_ft is None:
        add(polygon, "tessellate", "1")
    else:
        add(polygon, "extrude", "1")
        add(polygon, "altitudeMode", "absolute")
    height_m = 0.0 if ceiling_ft is None else m_from_ft(ceiling_ft)
    ring = [(*corner, height_m) for corner in (*corners, *corners[:1])]
    add(add(add(polygon, "outerBoundaryIs"), "LinearRing"), "coordinates", coordinates(ring))
    return kml_bytes(root)


def write_fence_plan(corners: Sequence[Corner]) -> bytes:
    """A .plan with a geofence and without waypoints. QGroundControl keeps no ceiling in it."""
    latitude_deg, longitude_deg = corners[0]
    polygon = {"inclusion": True, "polygon": [list(corner) for corner in corners], "version": 1}
    plan = {
        "fileType": "Plan",
        "geoFence": {"circles": [], "polygons": [polygon], "version": 2},
        "groundStation": "EPF GCS",
        "mission": {
            "cruiseSpeed": 15,
            "firmwareType": 0,
            "globalPlanAltitudeMode": 2,
            "hoverSpeed": 5,
            "items": [],
            "plannedHomePosition": [latitude_deg, longitude_deg, 0],
            "vehicleType": 1,
            "version": 2,
        },
        "rallyPoints": {"points": [], "version": 2},
        "version": 1,
    }
    return orjson.dumps(plan, option=orjson.OPT_INDENT_2)


def read_fence_file(name: str, data: bytes) -> FenceFile:
    """The fence in a file, which is recognised by its content. Raises InvalidInputError naming the file.

    The first border of the file is the fence; what else is in it is left out and noted.
    """
    try:
        return _read(name, data)
    except InvalidInputError as error:
        if error.code in ("fence_file_no_fence", "fence_file_unknown") and _is_plan(name, data):
            raise _refused(
                "fence_file_plan",
                f"'{name}' is a flight plan without a fence: read it as a plan, or draw a polygon in it.",
                name,
            ) from error
        raise


def _is_plan(name: str, data: bytes) -> bool:
    try:
        return bool(read_plan_file(name, data, thin=True).points)
    except InvalidInputError:
        return False


def _read(name: str, data: bytes) -> FenceFile:
    try:
        packed = unpacked_kml(data)
        text = packed.removeprefix(b"\xef\xbb\xbf").lstrip()
        if text.startswith(b"{"):
            return _of_plan(name, packed)
        if text.startswith(SIGNATURE):
            return _of_shapes(name, "waypoints", fence_items(text))
        if are_rows(text):
            return _of_shapes(name, "rows", fence_rows(text))
        root = parse_xml(packed)
    except FenceRowFault as fault:
        raise _refused(fault.code, f"The fence in '{name}' is not whole: {fault}.", name, nth=fault.line) from fault
    except FileFault as fault:
        raise _unknown(name) from fault
    if local(root) != "kml":
        raise _unknown(name)
    return _of_kml(name, root)


def _of_kml(name: str, root: Element) -> FenceFile:
    polygons = list(every(root, "Polygon"))
    holes = sum(1 for _ in every(root, "innerBoundaryIs"))
    if polygons:
        ring = next(every(polygons[0], "LinearRing"), None)
        others = len(polygons) - 1
    else:
        # A path that ends where it begins is a border, too: drawn by hand, it is one as often as a polygon is.
        lines = list(every(root, "LineString"))
        rings = [line for line in lines if len(found := _words(line)) > LEAST_CORNERS and found[0] == found[-1]]
        ring, others = (rings[0] if rings else None), len(lines) - 1
    if ring is None:
        raise _no_fence(name)
    corners = _checked(name, (_kml_corner(word) for word in _words(ring)))
    notes = _noted(("shapes_skipped", others), ("exclusions_skipped", holes))
    return FenceFile("kml", corners, _ceiling_ft(root), (*_crossed(corners), *notes))


def _words(ring: Element) -> list[str]:
    return _COMMA.sub(",", child_text(ring, "coordinates") or "").split()


def _kml_corner(word: str) -> tuple[object, object]:
    parts = word.split(",")
    return (parts[1], parts[0]) if len(parts) > 1 else (None, None)


def _ceiling_ft(root: Element) -> float | None:
    for data in every(root, "Data"):
        if data.get("name") == CEILING_DATA:
            value = _number(child_text(data, "value"))
            if value is not None and LOWEST_CEILING_FT <= value <= HIGHEST_CEILING_FT:
                return value
    return None


def _of_plan(name: str, data: bytes) -> FenceFile:
    try:
        plan = orjson.loads(data.removeprefix(b"\xef\xbb\xbf"))
    except orjson.JSONDecodeError as error:
        raise _unknown(name) from error
    if not isinstance(plan, dict) or plan.get("fileType") != "Plan":
        raise _unknown(name)
    fence = plan.get("geoFence")
    polygons = _dicts(fence, "polygons")
    circles = _dicts(fence, "circles")
    shapes = [*map(_polygon, polygons), *map(_circle, circles)]
    return _of_shapes(name, "plan", shapes)


def _polygon(one: Mapping[str, Any]) -> FenceShape:
    corners = tuple(map(_pair, _list(one.get("polygon"))))
    return FenceShape("exclusion" if one.get("inclusion") is False else "inclusion", corners, None)


def _circle(one: Mapping[str, Any]) -> FenceShape:
    circle = one.get("circle")
    values = circle if isinstance(circle, dict) else {}
    kind: FenceKind = "exclusion" if one.get("inclusion") is False else "inclusion"
    return FenceShape(kind, (_pair(values.get("center")),), _number(values.get("radius")) or 0.0)


def _of_shapes(name: str, file_format: FenceFileFormat, shapes: Sequence[FenceShape]) -> FenceFile:
    """The first of the areas to stay within."""
    kept = [shape for shape in shapes if shape.kind == "inclusion"]
    if not kept:
        raise _no_fence(name)
    first = kept[0]
    corners = _checked(name, first.corners if first.radius_m is None else _around(name, first))
    notes = _noted(
        ("circle_cornered", 0 if first.radius_m is None else _CIRCLE_CORNERS),
        ("shapes_skipped", len(kept) - 1),
        ("exclusions_skipped", sum(shape.kind == "exclusion" for shape in shapes)),
        ("return_skipped", sum(shape.kind == "return" for shape in shapes)),
    )
    return FenceFile(file_format, corners, None, (*_crossed(corners), *notes))


def _crossed(corners: Sequence[Corner]) -> tuple[FenceNote, ...]:
    sides = crossing_edges(corners)
    return () if sides is None else (FenceNote("crosses", {"first": sides[0], "second": sides[1]}),)


def _around(name: str, circle: FenceShape) -> list[tuple[object, object]]:
    """Corners on a circle, all of them within it: the fence is never larger than what was drawn."""
    latitude_deg, longitude_deg = map(_number, circle.corners[0])
    radius_m = circle.radius_m
    is_circle = radius_m is not None and 0 < radius_m <= _MOST_RADIUS_M
    if latitude_deg is None or longitude_deg is None or abs(latitude_deg) > 85 or radius_m is None or not is_circle:
        raise _no_place(name, 1)
    found: list[tuple[object, object]] = []
    for index in range(_CIRCLE_CORNERS):
        bearing = 2 * math.pi * index / _CIRCLE_CORNERS
        north_deg = math.degrees(radius_m / RADIUS_M) * math.cos(bearing)
        east_deg = math.degrees(radius_m / RADIUS_M) * math.sin(bearing) / math.cos(math.radians(latitude_deg))
        found.append((latitude_deg + north_deg, (longitude_deg + east_deg + 180) % 360 - 180))
    return found


def _checked(name: str, corners: Iterable[tuple[object, object]]) -> tuple[Corner, ...]:
    found: list[Corner] = []
    for nth, (latitude, longitude) in enumerate(corners, 1):
        latitude_deg, longitude_deg = _number(latitude), _number(longitude)
        if latitude_deg is None or longitude_deg is None or abs(latitude_deg) > 90 or abs(longitude_deg) > 180:
            raise _no_place(name, nth)
        if not found or found[-1] != (latitude_deg, longitude_deg):
            found.append((latitude_deg, longitude_deg))
    if len(found) > 1 and found[0] == found[-1]:
        found.pop()
    if not LEAST_CORNERS <= len(found) <= MOST_CORNERS:
        raise _refused(
            "fence_file_corners",
            f"The border in '{name}' has {len(found)} corners; a fence has {LEAST_CORNERS} to {MOST_CORNERS}.",
            name,
            count=len(found),
            least=LEAST_CORNERS,
            most=MOST_CORNERS,
        )
    return tuple(found)


def _noted(*counts: tuple[FenceNoteCode, int]) -> tuple[FenceNote, ...]:
    return tuple(FenceNote(code, {"count": count}) for code, count in counts if count > 0)


def _number(value: object) -> float | None:
    if isinstance(value, bool) or not isinstance(value, int | float | str):
        return None
    try:
        found = float(value)
    except (ValueError, OverflowError):
        return None
    return found if math.isfinite(found) else None


def _pair(value: object) -> tuple[object, object]:
    return (value[0], value[1]) if isinstance(value, list) and len(value) >= 2 else (None, None)


def _list(value: object) -> list[Any]:
    return value if isinstance(value, list) else []


def _dicts(fence: object, key: str) -> list[Mapping[str, Any]]:
    values = fence.get(key) if isinstance(fence, dict) else None
    return [one for one in _list(values) if isinstance(one, dict)]


def _unknown(name: str) -> InvalidInputError:
    return _refused(
        "fence_file_unknown",
        f"'{name}' is no fence that can be read: KML, KMZ, .plan, a .waypoints with fence items, or rows of latitude "
        "and longitude.",
        name,
    )


def _no_fence(name: str) -> InvalidInputError:
    return _refused(
        "fence_file_no_fence",
        f"There is no fence in '{name}': no area to stay within. Draw a polygon, or an inclusion fence.",
        name,
    )


def _no_place(name: str, nth: int) -> InvalidInputError:
    return _refused("fence_file_place", f"Corner {nth} in '{name}' is no place on the Earth.", name, nth=nth)


def _refused(code: ErrorCode, detail: str, name: str, **params: float) -> InvalidInputError:
    return InvalidInputError(code, detail, name=name, **params)
