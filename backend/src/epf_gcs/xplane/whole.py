"""The fast path from a datagram that holds a whole frame to the values of command 50.

Nearly every datagram of a simulator is of this kind, and the HIL loop waits for it. Anything unusual,
however slightly (a row missing or repeated, a value absent or out of its range, a stick beyond its end),
goes to `parse` and `Gatherer`, which handle it. If the fast path returns values, they are the same as theirs.
"""

from __future__ import annotations

from collections.abc import Callable
from operator import itemgetter
from struct import Struct
from typing import Any, Final, NamedTuple

from epf_gcs.codec.messages_gen import DATAGRAM_MAGIC, NO_VALUE, VALUES_PER_ROW, XPLANE_ROWS
from epf_gcs.xplane.mapping import INFO_SOURCES, NEEDED_ROWS, TRACK_NAME, TRACK_ROW, XplaneInfo, in_our_unit

_PREFIX_SIZE: Final = len(DATAGRAM_MAGIC) + 1
_RECORD_FIELDS: Final = 1 + VALUES_PER_ROW
_RECORD_SIZE: Final = 4 * _RECORD_FIELDS
_MOST_ROWS: Final = 64
_MOST_PLANS: Final = 8  # a simulator sends one sequence of rows, or a few while somebody selects rows in it


class _Plan(NamedTuple):
    """Where the 15 values are in a datagram with these rows, their limits, and the factors from their units to ours.

    `scales` is None if all factors are 1.
    """

    pick: Callable[[tuple[Any, ...]], tuple[float, ...]]
    limits: tuple[tuple[float, float], ...]
    scales: tuple[float, ...] | None


class WholeFrames:
    """Reads datagrams of one profile."""

    def __init__(self, profile: str) -> None:
        self._profile = profile
        self._layouts: dict[int, Struct] = {}
        self._plans: dict[tuple[int, ...], _Plan | None] = {}

    def read(self, datagram: bytes) -> XplaneInfo | None:
        """The values of a whole frame; None if the datagram holds no whole frame or anything unusual."""
        count, rest = divmod(len(datagram) - _PREFIX_SIZE, _RECORD_SIZE)
        if rest or not len(NEEDED_ROWS) < count <= _MOST_ROWS or not datagram.startswith(DATAGRAM_MAGIC):
            return None
        fields = self._layout(count).unpack_from(datagram, _PREFIX_SIZE)
        plan = self._plan(fields[::_RECORD_FIELDS])
        if plan is None:
            return None
        values = plan.pick(fields)
        if NO_VALUE in values:
            return None
        for value, (minimum, maximum) in zip(values, plan.limits, strict=True):
            if not minimum <= value <= maximum:
                return None
        if plan.scales is not None:
            values = tuple(value * scale for value, scale in zip(values, plan.scales, strict=True))
        return XplaneInfo._make(values)

    def _layout(self, count: int) -> Struct:
        layout = self._layouts.get(count)
        if layout is None:
            layout = self._layouts[count] = Struct("<" + f"i{VALUES_PER_ROW}f" * count)
        return layout

    def _plan(self, rows: tuple[int, ...]) -> _Plan | None:
        if rows not in self._plans:
            if len(self._plans) >= _MOST_PLANS:
                self._plans.clear()
            self._plans[rows] = _make_plan(rows, self._profile)
        return self._plans[rows]


def _make_plan(rows: tuple[int, ...], profile: str) -> _Plan | None:
    """None if a needed row or the track is missing, or a row is repeated."""
    if not NEEDED_ROWS | {TRACK_ROW} <= set(rows) or len(set(rows)) < len(rows):
        return None
    places: list[int] = []
    limits: list[tuple[float, float]] = []
    scales: list[float] = []
    for field, source in INFO_SOURCES.items():
        row, name = (TRACK_ROW, TRACK_NAME) if field == "yaw_deg" else source
        for wanted in XPLANE_ROWS[profile][row].values:
            our_name, scale = in_our_unit(wanted)
            if our_name == name:
                places.append(rows.index(row) * _RECORD_FIELDS + 1 + wanted.index)
                limits.append((wanted.minimum, wanted.maximum))
                scales.append(scale)
    return _Plan(itemgetter(*places), tuple(limits), None if set(scales) == {1.0} else tuple(scales))
