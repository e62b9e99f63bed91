"""The figures of the report's page, each with its name in the words and how it is written."""

from __future__ import annotations

from collections.abc import Callable
from typing import Final, Generic, NamedTuple, TypeVar

from epf_gcs.contract.report import (
    EarlierFlight,
    FlightReport,
    LoopName,
    ReportBattery,
    ReportEffect,
    ReportLeg,
    ReportManoeuvre,
    ReportModel,
)

_UNITS: Final = {"ft": "ft", "deg": "°", "kt": "kt", "m": "m"}
_LOOP_UNITS: Final = {"altitude": "ft", "heading": "deg", "speed": "kt"}
NOTHING: Final = "—"

Flown = FlightReport | EarlierFlight
T = TypeVar("T")


class Row(NamedTuple, Generic[T]):
    """`read` is given a report, a manoeuvre or a gain's effect."""

    name: str
    read: Callable[[T], str]


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


def _doubted(known: float | None, off: float | None, digits: int, unit: str = "") -> str:
    """A figure and how far it may be off, with a digit more of the latter where it would be nought."""
    if known is None or off is None:
        return shown(known, digits, unit)
    return f"{shown(known, digits)} ± {shown(off, digits if off >= 0.1**digits else digits + 1, unit)}"


def _of_model(read: Callable[[ReportModel], str]) -> Callable[[ReportManoeuvre], str]:
    return lambda one: NOTHING if one.model is None else read(one.model)


def _battery(value: Callable[[ReportBattery], float | None], unit: str = "V") -> Callable[[Flown], str]:
    return lambda one: shown(None if one.battery is None else value(one.battery), 2, unit)


def _leg(read: Callable[[ReportLeg], str]) -> Callable[[ReportManoeuvre], str]:
    return lambda one: NOTHING if one.leg is None else read(one.leg)


def _gaps(one: Flown) -> str:
    link = one.link
    return f"{link.gaps} ({shown(link.gaps_s, 1)} s)" if link.gaps else "0"


def _round_trip(one: Flown) -> str:
    trip = one.link.round_trip_ms
    return NOTHING if trip is None else f"{trip.median:.1f} / {trip.p99:.1f} / {trip.longest:.1f} ms"


def _across(leg: ReportLeg) -> str:
    return NOTHING if leg.across_rms_m is None else f"{leg.across_rms_m:.0f} / {leg.across_most_m:.0f} m"


TIMES: Final[tuple[Row[Flown], ...]] = (
    Row("duration", lambda one: clock(one.times.duration_s)),
    Row("airborne", lambda one: clock(one.times.airborne_s)),
    Row("autopilot", lambda one: clock(one.times.autopilot_s)),
    Row("distance", lambda one: shown(one.distances.distance_nm, 2, "NM")),
    Row("highest", lambda one: shown(one.distances.highest_ft, 0, "ft")),
    Row("lowest", lambda one: shown(one.distances.lowest_ft, 0, "ft")),
    Row("fastest", lambda one: shown(one.distances.fastest_kt, 1, "kt")),
    Row("climbMost", lambda one: shown(one.distances.climb_most_ft_min, 0, "ft/min")),
    Row("sinkMost", lambda one: shown(one.distances.sink_most_ft_min, 0, "ft/min")),
)
BATTERY: Final[tuple[Row[Flown], ...]] = (
    Row("batteryBegin", _battery(lambda one: one.begin_v)),
    Row("batteryEnd", _battery(lambda one: one.end_v)),
    Row("batteryLowest", _battery(lambda one: one.lowest_v)),
    Row("batteryDrop", _battery(lambda one: one.drop_v_per_hour, "V/h")),
)
LINK: Final[tuple[Row[Flown], ...]] = (
    Row("frames", lambda one: shown(one.link.frames, 0)),
    Row("damaged", lambda one: f"{shown(one.link.frames_damaged, 0)} ({shown(one.link.damaged_percent, 3)} %)"),
    Row("gaps", _gaps),
    Row("roundTrip", _round_trip),
)
ANSWER: Final[tuple[Row[ReportManoeuvre], ...]] = (
    Row("size", lambda one: _with_unit(one.size, one.unit)),
    Row("rise", lambda one: shown(one.rise_s, 1, "s")),
    Row("overshoot", lambda one: shown(one.overshoot_percent, 1, "%")),
    Row("settling", lambda one: shown(one.settling_s, 1, "s")),
    Row("steady", lambda one: _with_unit(one.steady_error, one.unit)),
)
MODEL: Final[tuple[Row[ReportManoeuvre], ...]] = (
    Row("modelRise", _of_model(lambda one: _doubted(one.rise_s, one.rise_doubt_s, 1, "s"))),
    Row("modelOvershoot", _of_model(lambda one: _doubted(one.overshoot_percent, one.overshoot_doubt_percent, 1, "%"))),
    Row("damping", _of_model(lambda one: _doubted(one.damping, one.damping_doubt, 2))),
    Row("modelOff", lambda one: _with_unit(None if one.model is None else one.model.off, one.unit)),
)
LEG: Final[tuple[Row[ReportManoeuvre], ...]] = (
    Row("duration", _leg(lambda leg: clock(leg.duration_s))),
    Row("distance", _leg(lambda leg: shown(leg.distance_m, 0, "m"))),
    Row("across", _leg(_across)),
    Row("altitudeError", _leg(lambda leg: shown(leg.altitude_error_ft, 1, "ft"))),
    Row("speedError", _leg(lambda leg: shown(leg.speed_error_kt, 2, "kt"))),
)


def gain_rows(loop: LoopName) -> tuple[Row[ReportEffect], ...]:
    """How a loop flew before or after a change of its gain."""
    unit = _LOOP_UNITS[loop]
    return (
        Row("loopError", lambda one: _with_unit(one.error_rms, unit)),
        Row("rise", lambda one: shown(one.rise_s, 1, "s")),
        Row("overshoot", lambda one: shown(one.overshoot_percent, 1, "%")),
        Row("settling", lambda one: shown(one.settling_s, 1, "s")),
        Row("steady", lambda one: _with_unit(one.steady_error, unit)),
        Row("damping", lambda one: shown(one.damping, 2)),
    )
