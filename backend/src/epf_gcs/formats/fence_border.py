"""The border of a fence: where it crosses itself it is not clear what is inside."""

from __future__ import annotations

from collections.abc import Sequence

Corner = tuple[float, float]
"""Latitude and longitude in degrees."""

_Flat = tuple[float, float]
"""Longitude and latitude in degrees, counted from the first corner, so that no border has a seam in it."""


def crossing_edges(corners: Sequence[Corner]) -> tuple[int, int] | None:
    """Two sides of the border that cross or touch, by number from 1 (side n begins at corner n); None if none do.

    Of a border that crosses itself it is not clear what is inside: twice enclosed counts as outside.
    """
    first = corners[0][1] if corners else 0.0
    places = [((longitude - first + 180.0) % 360.0, latitude) for latitude, longitude in corners]
    edges = [(place, places[(nth + 1) % len(places)]) for nth, place in enumerate(places)]
    for nth, edge in enumerate(edges):
        for other in range(nth + 1, len(edges)):
            are_neighbours = other == nth + 1 or (nth == 0 and other == len(edges) - 1)
            if _meet(*edge, *edges[other], share_an_end=are_neighbours):
                return nth + 1, other + 1
    return None


def _meet(a: _Flat, b: _Flat, c: _Flat, d: _Flat, *, share_an_end: bool) -> bool:
    sides = (_side(a, b, c), _side(a, b, d), _side(c, d, a), _side(c, d, b))
    if share_an_end:
        # They cross only where one lies on the other, as the two sides of a spike do.
        return not any(sides) and (
            _is_between(a, b, c) + _is_between(a, b, d) + _is_between(c, d, a) + _is_between(c, d, b) > 2
        )
    if sides[0] * sides[1] < 0 and sides[2] * sides[3] < 0:
        return True
    touches = ((a, b, c), (a, b, d), (c, d, a), (c, d, b))
    return any(side == 0 and _is_between(*three) for side, three in zip(sides, touches, strict=True))


def _side(a: _Flat, b: _Flat, c: _Flat) -> float:
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def _is_between(a: _Flat, b: _Flat, c: _Flat) -> bool:
    return min(a[0], b[0]) <= c[0] <= max(a[0], b[0]) and min(a[1], b[1]) <= c[1] <= max(a[1], b[1])
