"""The figures of the report's page, each with its name in the words and how it is written."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Final, NamedTuple

_UNITS: Final = {"ft": "ft", "deg": "°", "kt": "kt", "m": "m"}
_LOOP_UNITS: Final = {"altitude": "ft", "heading": "deg", "speed": "kt"}
NOTHING: Final = "—"


class Row(NamedTuple):
    """`read` is given a report, a manoeuvre or a gain's effect."""

    name: str
    read: Callable[[dict[str, Any]], str]


def shown(value: float | None, digits: int, unit: str = "") -> str:
    """What is not known is a dash; nothing is minus nought."""
    if value is None:
        return NOTHING
    text = f"{value:.{digits}f}"
    text = text.replace("-", "") if float(text) == 0 else text
    return f"{text} {unit}".strip()


def clock(value_s: float | None) -> str:
    """Time of a flight: 1:02:03, 2:03."""
    if value_s is None:
        return NOTHING
    whole = round(value_s)
    hours, minutes, seconds = whole // 3600, whole // 60 % 60, whole % 60
    return f"{hours}:{minutes:02}:{seconds:02}" if hours else f"{minutes}:{seconds:02}"


def _with_unit(value: float | None, unit: str) -> str:
    return shown(value, 2 if unit == "kt" else 1, _UNITS[unit])


def _doubted(name: str, doubt: str, digits: int, unit: str = "") -> Callable[[dict[str, Any]], str]:
    """A figure and how far it may be off, with a digit more of the latter where it would be nought."""

    def read(one: dict[str, Any]) -> str:
        value, off = one[name], one.get(doubt)
        if value is None or off is None:
            return shown(value, digits, unit)
        return f"{shown(value, digits)} ± {shown(off, digits if off >= 0.1**digits else digits + 1, unit)}"

    return read


def _of(part: str, name: str, digits: int, unit: str) -> Callable[[dict[str, Any]], str]:
    return lambda one: shown((one[part] or {}).get(name), digits, unit)


def _damaged(one: dict[str, Any]) -> str:
    link = one["link"]
    return f"{shown(link['frames_damaged'], 0)} ({shown(link['damaged_percent'], 3)} %)"


def _gaps(one: dict[str, Any]) -> str:
    link = one["link"]
    return f"{link['gaps']} ({shown(link['gaps_s'], 1)} s)" if link["gaps"] else "0"


def _round_trip(one: dict[str, Any]) -> str:
    trip = one["link"]["round_trip_ms"]
    return NOTHING if trip is None else f"{trip['median']:.1f} / {trip['p99']:.1f} / {trip['longest']:.1f} ms"


def _across(one: dict[str, Any]) -> str:
    leg = one["leg"]
    return NOTHING if leg["across_rms_m"] is None else f"{leg['across_rms_m']:.0f} / {leg['across_most_m']:.0f} m"


TIMES: Final = (
    Row("duration", lambda one: clock(one["times"]["duration_s"])),
    Row("airborne", lambda one: clock(one["times"]["airborne_s"])),
    Row("autopilot", lambda one: clock(one["times"]["autopilot_s"])),
    Row("distance", _of("distances", "distance_nm", 2, "NM")),
    Row("highest", _of("distances", "highest_ft", 0, "ft")),
    Row("lowest", _of("distances", "lowest_ft", 0, "ft")),
    Row("fastest", _of("distances", "fastest_kt", 1, "kt")),
    Row("climbMost", _of("distances", "climb_most_ft_min", 0, "ft/min")),
    Row("sinkMost", _of("distances", "sink_most_ft_min", 0, "ft/min")),
)
BATTERY: Final = (
    Row("batteryBegin", _of("battery", "begin_v", 2, "V")),
    Row("batteryEnd", _of("battery", "end_v", 2, "V")),
    Row("batteryLowest", _of("battery", "lowest_v", 2, "V")),
    Row("batteryDrop", _of("battery", "drop_v_per_hour", 2, "V/h")),
)
LINK: Final = (
    Row("frames", _of("link", "frames", 0, "")),
    Row("damaged", _damaged),
    Row("gaps", _gaps),
    Row("roundTrip", _round_trip),
)
_RESPONSE: Final = (
    Row("rise", lambda one: shown(one["rise_s"], 1, "s")),
    Row("overshoot", lambda one: shown(one["overshoot_percent"], 1, "%")),
    Row("settling", lambda one: shown(one["settling_s"], 1, "s")),
)
_DAMPING: Final = Row("damping", lambda one: shown(one["damping"], 2))
ANSWER: Final = (
    Row("size", lambda one: _with_unit(one["size"], one["unit"])),
    Row("rise", _doubted("rise_s", "rise_doubt_s", 1, "s")),
    Row("overshoot", _doubted("overshoot_percent", "overshoot_doubt_percent", 1, "%")),
    Row("settling", lambda one: shown(one["settling_s"], 1, "s")),
    Row("steady", lambda one: _with_unit(one["steady_error"], one["unit"])),
    Row("damping", _doubted("damping", "damping_doubt", 2)),
)
LEG: Final = (
    Row("duration", lambda one: clock(one["leg"]["duration_s"])),
    Row("distance", _of("leg", "distance_m", 0, "m")),
    Row("across", _across),
    Row("altitudeError", _of("leg", "altitude_error_ft", 1, "ft")),
    Row("speedError", _of("leg", "speed_error_kt", 2, "kt")),
)
GAIN: Final = (
    Row("loopError", lambda one: _with_unit(one["error_rms"], _LOOP_UNITS[one["loop"]])),
    *_RESPONSE,
    Row("steady", lambda one: _with_unit(one["steady_error"], _LOOP_UNITS[one["loop"]])),
    _DAMPING,
)
