"""The simulator's rows -> our names, units and axes; and the controls of the board or a pilot -> surfaces."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Final, NamedTuple

from epf_gcs.codec.messages_gen import NO_VALUE, XPLANE_ROWS
from epf_gcs.codec.tables import RowValue
from epf_gcs.xplane.datagram import Eight, Surfaces

_RAD_PER_DEG: Final = math.pi / 180.0
_CLAMPED_ROWS: Final = (8, 11, 25)
"""Sticks, surfaces and throttle: a value beyond its limit is clamped to the limit, not treated as missing."""


class XplaneInfo(NamedTuple):
    """The 15 values of command 50, in its order."""

    elevator: float
    aileron: float
    rudder: float
    throttle: float
    gx_rad_s: float
    gy_rad_s: float
    gz_rad_s: float
    yaw_deg: float
    pitch_deg: float
    roll_deg: float
    altitude_ft: float
    vvi_ft_min: float
    speed_kt: float
    latitude_deg: float
    longitude_deg: float

    @property
    def stick(self) -> Surfaces:
        """The pilot's controls, as they go straight to the surfaces on the manual path."""
        return Surfaces(self.elevator, self.aileron, self.rudder, self.throttle)


INFO_SOURCES: Final[Mapping[str, tuple[int, str]]] = {
    "elevator": (8, "stick_elevator"),
    "aileron": (8, "stick_aileron"),
    "rudder": (8, "stick_rudder"),
    "throttle": (25, "throttle_command"),
    "gx_rad_s": (16, "p_rad_s"),
    "gy_rad_s": (16, "q_rad_s"),
    "gz_rad_s": (16, "r_rad_s"),
    "yaw_deg": (17, "true_heading_deg"),
    "pitch_deg": (17, "pitch_deg"),
    "roll_deg": (17, "roll_deg"),
    "altitude_ft": (20, "altitude_indicated_ft"),
    "vvi_ft_min": (4, "vvi_ft_min"),
    "speed_kt": (3, "indicated_airspeed_kt"),
    "latitude_deg": (20, "latitude_deg"),
    "longitude_deg": (20, "longitude_deg"),
}
"""Where each value of command 50 comes from: row and name. The ground track, row 18, replaces the heading if sent."""

TRACK_ROW: Final = 18
TRACK_NAME: Final = "horizontal_path_deg"
NEEDED_ROWS: Final = frozenset(row for row, _ in INFO_SOURCES.values())


class RowMeaning(NamedTuple):
    """The used values of one row by name, None for "no data", and the names whose value was not plausible."""

    values: dict[str, float | None]
    implausible: tuple[str, ...]


def row_meaning(row: int, eight: Eight, profile: str) -> RowMeaning:
    """Names and units of a row's values; angular rates are rad/s in every profile. Unknown rows are empty.

    "No value" (-999) becomes None; a value that is not finite or outside its range becomes None and is listed as
    implausible.
    """
    values: dict[str, float | None] = {}
    implausible: list[str] = []
    for name, place, scale, minimum, maximum, is_clamped in _PLANS[profile].get(row, ()):
        raw = eight[place]
        if raw == NO_VALUE:
            values[name] = None
        elif minimum <= raw <= maximum:
            values[name] = raw * scale
        elif is_clamped and math.isfinite(raw):
            values[name] = (minimum if raw < minimum else maximum) * scale
        else:
            values[name] = None
            implausible.append(name)
    return RowMeaning(values, tuple(implausible))


def unusable_values(rows: Mapping[int, Eight], profile: str) -> list[tuple[int, str, float]]:
    """Row, name and raw value of all that command 50 needs, whose row is there, and that cannot be used."""
    meanings = {row: row_meaning(row, eight, profile).values for row, eight in rows.items()}
    has_track = meanings.get(TRACK_ROW, {}).get(TRACK_NAME) is not None
    return [
        (row, name, rows[row][_place(row, name, profile)])
        for field, (row, name) in INFO_SOURCES.items()
        if row in meanings and meanings[row][name] is None and not (field == "yaw_deg" and has_track)
    ]


def _place(row: int, name: str, profile: str) -> int:
    return next(step.place for step in _PLANS[profile][row] if step.name == name)


def info_from_rows(rows: Mapping[int, Mapping[str, float | None]]) -> XplaneInfo | None:
    """Command 50 from the decoded rows of one simulator frame; None if one of its values is missing."""
    values = {field: rows.get(row, {}).get(name) for field, (row, name) in INFO_SOURCES.items()}
    track = rows.get(TRACK_ROW, {}).get(TRACK_NAME)
    if track is not None:
        values["yaw_deg"] = track
    known = {field: value for field, value in values.items() if value is not None}
    return XplaneInfo(**known) if len(known) == len(values) else None


def surfaces_from_servos_in(channels: Sequence[float]) -> Surfaces:
    """The RC receiver's channels as surfaces: 0 aileron, 1 elevator, 2 throttle, 3 rudder."""
    aileron, elevator, throttle, rudder = channels[:4]
    return Surfaces(elevator, aileron, rudder, throttle)


def in_our_unit(wanted: RowValue) -> tuple[str, float]:
    """Our name for a row's value, and the factor from its unit to ours."""
    if wanted.unit == "deg/s":
        return wanted.name.removesuffix("_deg_s") + "_rad_s", _RAD_PER_DEG
    return wanted.name, 1.0


class _Step(NamedTuple):
    """How one value of a row is read: its place, the factor to our unit, and its range in the simulator's unit."""

    name: str
    place: int
    scale: float
    minimum: float
    maximum: float
    is_clamped: bool


def _step(wanted: RowValue, *, is_clamped: bool) -> _Step:
    name, scale = in_our_unit(wanted)
    return _Step(name, wanted.index, scale, wanted.minimum, wanted.maximum, is_clamped)


_PLANS: Final[Mapping[str, Mapping[int, tuple[_Step, ...]]]] = {
    profile: {
        number: tuple(_step(wanted, is_clamped=number in _CLAMPED_ROWS) for wanted in definition.values)
        for number, definition in rows.items()
    }
    for profile, rows in XPLANE_ROWS.items()
}
