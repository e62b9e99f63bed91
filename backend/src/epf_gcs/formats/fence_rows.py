"""Fences as lines: the fence items of MAVLink (.waypoints), and rows of latitude and longitude (.fen, .txt)."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from itertools import takewhile
from typing import Final, Literal, NamedTuple

from epf_gcs.errors import ErrorCode

FenceKind = Literal["inclusion", "exclusion", "return"]

# MAV_CMD of fence items.
_RETURN_POINT: Final = 5000
_POLYGONS: Final[dict[int, FenceKind]] = {5001: "inclusion", 5002: "exclusion"}
_CIRCLES: Final[dict[int, FenceKind]] = {5003: "inclusion", 5004: "exclusion"}
# Columns of an item: its command, the first parameter (number of corners, or a radius), latitude and longitude.
_COMMAND, _FIRST, _LATITUDE, _LONGITUDE, _COLUMNS = 3, 4, 8, 9, 12
_NUMBER: Final = r"[+-]?[0-9]+(?:\.[0-9]*)?"
_ROW: Final = re.compile(rf"\s*({_NUMBER})[\s,;]+({_NUMBER})\s*")
# A return point, three corners, and the first of them again.
_LEAST_WITH_RETURN: Final = 5


class FenceShape(NamedTuple):
    """An area, or the place that an aircraft outside returns to. `corners`: latitude and longitude in degrees; of a
    circle, whose `radius_m` is not None, its centre."""

    kind: FenceKind
    corners: tuple[tuple[object, object], ...]
    radius_m: float | None


class _Item(NamedTuple):
    line: int
    command: int
    first: float
    place: tuple[object, object]


class FenceRowFault(Exception):  # noqa: N818 - a fault of the file, told to its owner as a GatewayError with the name
    """Why the lines are not a fence, and at which line."""

    def __init__(self, code: ErrorCode, why: str, line: int) -> None:
        super().__init__(why)
        self.code: ErrorCode = code
        self.line = line


def fence_items(data: bytes) -> list[FenceShape]:
    """The fence items of a list of waypoints; others are passed over. Raises FenceRowFault."""
    items = [_item(cells, line) for line, cells in _lines(data) if line > 1]
    shapes: list[FenceShape] = []
    at = 0
    while at < len(items):
        item = items[at]
        if item.command in _POLYGONS:
            corners = _polygon(items[at:])
            shapes.append(FenceShape(_POLYGONS[item.command], corners, None))
            at += len(corners)
            continue
        if item.command in _CIRCLES:
            shapes.append(FenceShape(_CIRCLES[item.command], (item.place,), item.first))
        elif item.command == _RETURN_POINT:
            shapes.append(FenceShape("return", (item.place,), None))
        at += 1
    return shapes


def _polygon(items: list[_Item]) -> tuple[tuple[object, object], ...]:
    """The corners of the polygon that begins here: each says how many there are."""
    command, wanted = items[0].command, int(items[0].first)
    found = list(takewhile(lambda one: (one.command, one.first) == (command, wanted), items[: max(1, wanted)]))
    if len(found) != wanted:
        line = found[-1].line
        raise FenceRowFault(
            "fence_file_rows", f"line {line} ends a polygon that has {len(found)} of its {wanted} corners", line
        )
    return tuple(one.place for one in found)


def are_rows(data: bytes) -> bool:
    """Whether the first line that is no remark is a latitude and a longitude."""
    first = next((text for _, text in _rows(data)), "")
    return _ROW.fullmatch(first) is not None


def fence_rows(data: bytes) -> list[FenceShape]:
    """A closed border, with the return point before it as autopilots number it, or without. Raises FenceRowFault.

    A border that does not come back to its beginning is refused: its first row may be a corner or the return point.
    """
    places: list[tuple[str, str]] = []
    line = 1
    for line, text in _rows(data):
        found = _ROW.fullmatch(text)
        if found is None:
            raise FenceRowFault("fence_file_rows", f"line {line} is no latitude and longitude", line)
        places.append((found[1], found[2]))
    if len(places) >= _LEAST_WITH_RETURN and places[1] == places[-1]:
        return [FenceShape("return", (places[0],), None), FenceShape("inclusion", tuple(places[1:]), None)]
    if places[0] == places[-1]:
        return [FenceShape("inclusion", tuple(places), None)]
    raise FenceRowFault("fence_file_open", "its last row is neither its first nor its second", line)


def _item(cells: list[str], line: int) -> _Item:
    try:
        first = float(cells[_FIRST])
        if len(cells) < _COLUMNS or not math.isfinite(first):
            raise ValueError
        return _Item(line, int(cells[_COMMAND]), first, (cells[_LATITUDE], cells[_LONGITUDE]))
    except (IndexError, ValueError) as error:
        raise FenceRowFault("fence_file_rows", f"line {line} is no item of {_COLUMNS} values", line) from error


def _lines(data: bytes) -> Iterator[tuple[int, list[str]]]:
    lines = data.decode("utf-8", "replace").splitlines()
    return ((nth, text.split()) for nth, text in enumerate(lines, 1) if text.strip())


def _rows(data: bytes) -> Iterator[tuple[int, str]]:
    lines = data.decode("utf-8", "replace").splitlines()
    return ((nth, text) for nth, text in enumerate(lines, 1) if text.strip() and not text.lstrip().startswith("#"))
