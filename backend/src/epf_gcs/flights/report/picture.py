"""The small picture of a manoeuvre as SVG: signal, target, and the marks of rise, peak, settling and final value."""

from __future__ import annotations

from html import escape
from typing import Final

from epf_gcs.contract.report import ReportManoeuvre

_WIDTH: Final = 300.0
_HEIGHT: Final = 130.0
_LEFT: Final = 40.0
_RIGHT: Final = 6.0
_TOP: Final = 6.0
_BOTTOM: Final = 18.0
_TARGET: Final = 'stroke="#666" stroke-dasharray="4 3"'
_VALUE: Final = 'stroke="#000" stroke-width="1.6"'


def picture(one: ReportManoeuvre, label: str) -> str:
    """The picture; empty where there is nothing to draw."""
    trace = one.trace
    known = [] if trace is None else [v for v in (*trace.value, *trace.target) if v is not None]
    if trace is None or len(known) < 2:
        return ""
    low, high = float(min(known)), float(max(known))
    room = max((high - low) * 0.08, 1e-6)
    first, last = float(trace.at_s[0]), float(trace.at_s[-1])

    def x(at_s: float) -> float:
        return _LEFT + (at_s - first) / ((last - first) or 1.0) * (_WIDTH - _LEFT - _RIGHT)

    def y(value: float) -> float:
        return _TOP + (high + room - value) / (high - low + 2 * room) * (_HEIGHT - _TOP - _BOTTOM)

    until_s, floor, digits = one.until_s - one.at_s, _HEIGHT - _BOTTOM, 1 if high - low < 5 else 0
    drawn = [
        f'<path d="M{_LEFT} {_TOP}V{floor}H{_WIDTH - _RIGHT}" fill="none" stroke="#999"/>',
        _text(_LEFT - 4, y(high) + 3, "end", f"{high:.{digits}f}"),
        _text(_LEFT - 4, y(low) + 3, "end", f"{low:.{digits}f}"),
        _text(x(max(0.0, first)), _HEIGHT - 5, "middle", "0"),
        _text(_WIDTH - _RIGHT, _HEIGHT - 5, "end", f"{last:.0f} s"),
    ]
    if one.rise_from_s is not None and one.rise_to_s is not None:
        begin, end = x(one.rise_from_s), x(min(one.rise_to_s, until_s))
        size = f'width="{max(1.0, end - begin):.1f}" height="{floor - _TOP}"'
        drawn.append(f'<rect x="{begin:.1f}" y="{_TOP}" {size} fill="#ddd"/>')
    if one.settling_s is not None and one.settling_s <= until_s:
        drawn.append(_dotted(f"M{x(one.settling_s):.1f} {_TOP}V{floor}"))
    if one.final is not None:
        drawn.append(_dotted(f"M{x(0):.1f} {y(one.final):.1f}H{x(until_s):.1f}"))
    for values, style in ((trace.target, _TARGET), (trace.value, _VALUE)):
        pairs = zip(trace.at_s, values, strict=True)
        path = _path([(x(at_s), None if value is None else y(value)) for at_s, value in pairs])
        drawn.append(f'<path d="{path}" fill="none" {style}/>')
    if one.peak is not None and one.peak_s is not None and one.peak_s <= until_s:
        drawn.append(f'<circle cx="{x(one.peak_s):.1f}" cy="{y(one.peak):.1f}" r="3" fill="none" stroke="#000"/>')
    title = escape(label)
    return f'<svg viewBox="0 0 {_WIDTH} {_HEIGHT}" role="img" aria-label="{title}">{"".join(drawn)}</svg>'


def _path(points: list[tuple[float, float | None]]) -> str:
    """A line that is broken where a value is missing."""
    path, is_down = "", False
    for x, y in points:
        if y is not None:
            path += f"{'L' if is_down else 'M'}{x:.1f} {y:.1f}"
        is_down = y is not None
    return path


def _text(x: float, y: float, anchor: str, text: str) -> str:
    return f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}" font-size="10" fill="#444">{text}</text>'


def _dotted(path: str) -> str:
    return f'<path d="{path}" fill="none" stroke="#666" stroke-dasharray="1 3"/>'
