"""One flight on one page: an HTML file that needs nothing else. Track over the plan, altitude, airspeed and distance
from the leg over time, all from the simulator's truth; each figure beside its bound."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from html import escape
from pathlib import Path
from typing import Final

import numpy as np

from epf_gcs.disk import replace_file
from epf_gcs.lab.errors import LabError
from epf_gcs.lab.figures import Leg, columns_m, metres, split
from epf_gcs.lab.flight import FIGURES, Flight
from epf_gcs.lab.truth import Column
from epf_gcs.rehearsal.flown_plan import capture_m

_WIDTH, _HEIGHT, _TRACK_HEIGHT, _MARGIN = 960.0, 220.0, 620.0, 46.0
# More points than a screen has columns show nothing more.
_POINTS: Final = 1500
_STYLE: Final = """
body { font: 15px system-ui, sans-serif; max-width: 1000px; margin: 1.5rem auto; padding: 0 1rem; color: #1c2430; }
table { border-collapse: collapse; }
td, th { text-align: right; padding: .15rem .9rem; border-bottom: 1px solid #d5dbe3; }
td:first-child, th:first-child { text-align: left; } .bad { color: #b3261e; font-weight: 600; }
svg { width: 100%; height: auto; } svg text { font: 12px system-ui, sans-serif; fill: #46505e; }
.flown { fill: none; stroke: #1659b7; stroke-width: 1.6; }
.asked { fill: none; stroke: #9a5b00; stroke-dasharray: 6 4; }
.moment { stroke: #b3261e; fill: #b3261e; } .frame { fill: none; stroke: #d5dbe3; }
"""

Line = tuple[str, Column, Column]
"""Class of the line, and its points."""


def write_page(flight: Flight, path: Path, link: str = "") -> None:
    """Write the page; `link` opens the station at the flight's moment. Raises LabError if the disk does not take it."""
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        replace_file(path, page(flight, link).encode())
    except OSError as error:
        raise LabError(f"{path} cannot be written: {error.strerror or error}") from error


def page(flight: Flight, link: str = "") -> str:
    """The page as text."""
    moment = flight.moment
    where = f'<a href="{escape(link)}">{escape(moment.why)}</a>' if link else escape(moment.why)
    title = escape(str(flight))
    return "\n".join(
        (
            '<!doctype html><html lang="en"><head><meta charset="utf-8">',
            f"<title>{title}</title><style>{_STYLE}</style></head><body>",
            f"<h1>{title}</h1><p>After {moment.at_s:.1f} s: {where}. All of it is the simulator's truth.</p>",
            *_figures(flight),
            *_plots(flight),
            "</body></html>",
        )
    )


def _figures(flight: Flight) -> Iterator[str]:
    yield "<table><tr><th>figure</th><th>flown</th><th>bound</th></tr>"
    for name, figure in FIGURES.items():
        bound, kind = flight.bounds.get(name), ""
        if bound is not None and not flight.is_within(name):
            kind = ' class="bad"'
        told = "" if bound is None else f"{bound:g}"
        yield f"<tr{kind}><td>{name}</td><td>{figure(flight):.4g}</td><td>{told}</td></tr>"
    yield "</table>"


def _plots(flight: Flight) -> Iterator[str]:
    legs = split(flight.truth, flight.route.waypoints)
    if not legs:
        return
    at_s = flight.moment.at_s
    truth = flight.truth
    yield _track(legs)
    altitude = [_asked(leg, leg.waypoint.altitude_ft) for leg in legs]
    yield _plot("Altitude, ft", [("flown", truth.time_s, truth.altitude_ft), *altitude], at_s)
    speed = [_asked(leg, leg.waypoint.speed_kt) for leg in legs]
    yield _plot("Indicated airspeed, kt", [("flown", truth.time_s, truth.airspeed_kt), *speed], at_s)
    off = [("flown", leg.truth.time_s, leg.cross_track_m()) for leg in legs]
    yield _plot("Distance from the leg, m, right of it is positive", off, at_s)


def _asked(leg: Leg, value: float) -> Line:
    ends = leg.truth.time_s[[0, -1]]
    return "asked", ends, np.full(2, value)


def _track(legs: Sequence[Leg]) -> str:
    """North up, one scale for both axes; the circles are where a waypoint may count as captured."""
    origin = legs[0].begin
    places = [metres(origin, (one.waypoint.latitude_deg, one.waypoint.longitude_deg)) for one in legs]
    north, east = (np.array([0.0, *(place[axis] for place in places)]) for axis in (0, 1))
    flown = [columns_m(origin, leg.truth) for leg in legs]
    all_north = np.concatenate([north, *(one[0] for one in flown)])
    all_east = np.concatenate([east, *(one[1] for one in flown)])
    width, height = _WIDTH - 2.0 * _MARGIN, _TRACK_HEIGHT - 2.0 * _MARGIN
    size = max(float(np.ptp(all_east)) / width, float(np.ptp(all_north)) / height, 1e-9)

    west_m, south_m = float(all_east.min()), float(all_north.min())

    def x(value: Column) -> Column:
        return (value - west_m) / size + _MARGIN

    def y(value: Column) -> Column:
        return (south_m - value) / size + (_TRACK_HEIGHT - _MARGIN)

    parts = [_polyline("asked", x(east), y(north))]
    for number, leg in enumerate(legs):
        at_x, at_y = float(x(east[number + 1])), float(y(north[number + 1]))
        radius = capture_m(leg.waypoint.speed_kt) / size
        parts.append(f'<circle class="asked" cx="{at_x:.1f}" cy="{at_y:.1f}" r="{radius:.1f}"/>')
        parts.append(f'<text x="{at_x + 5:.1f}" y="{at_y - 5:.1f}">{number + 1}</text>')
    parts += [_polyline("flown", x(one[1]), y(one[0])) for one in flown]
    return _svg("Track over the plan", _TRACK_HEIGHT, parts)


def _plot(title: str, lines: Sequence[Line], at_s: float) -> str:
    times = np.concatenate([line[1] for line in lines])
    values = np.concatenate([line[2] for line in lines])
    first, last = float(times.min()), max(float(times.max()), float(times.min()) + 1e-9)
    low, high = float(values.min()), max(float(values.max()), float(values.min()) + 1.0)

    def x(value: Column) -> Column:
        return _MARGIN + (value - first) / (last - first) * (_WIDTH - 2 * _MARGIN)

    def y(value: Column) -> Column:
        return _HEIGHT - _MARGIN / 2 - (value - low) / (high - low) * (_HEIGHT - _MARGIN)

    moment = float(x(np.array([min(max(at_s, first), last)]))[0])
    parts = [
        f'<line class="moment" x1="{moment:.1f}" x2="{moment:.1f}" y1="0" y2="{_HEIGHT:.0f}"/>',
        f'<text x="2" y="{_MARGIN / 2:.0f}">{high:.0f}</text>',
        f'<text x="2" y="{_HEIGHT - _MARGIN / 2:.0f}">{low:.0f}</text>',
        f'<text x="{_MARGIN:.0f}" y="{_HEIGHT - 6:.0f}">{first:.0f} s</text>',
        f'<text x="{_WIDTH - _MARGIN:.0f}" y="{_HEIGHT - 6:.0f}">{last:.0f} s</text>',
        *(_polyline(kind, x(at), y(value)) for kind, at, value in lines),
    ]
    return _svg(title, _HEIGHT, parts)


def _svg(title: str, height: float, parts: Sequence[str]) -> str:
    frame = f'<rect class="frame" x="0" y="0" width="{_WIDTH:.0f}" height="{height:.0f}"/>'
    drawn = "".join((frame, *parts))
    return (
        f"<h2>{escape(title)}</h2>"
        f'<svg role="img" aria-label="{escape(title)}" viewBox="0 0 {_WIDTH:.0f} {height:.0f}">{drawn}</svg>'
    )


def _polyline(kind: str, x: Column, y: Column) -> str:
    every = max(1, len(x) // _POINTS)
    points = " ".join(f"{one:.1f},{other:.1f}" for one, other in zip(x[::every], y[::every], strict=True))
    return f'<polyline class="{kind}" points="{points}"/>'
