"""Position and attitude of both aircraft now: the board's, and the simulator's."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Final, Literal

from epf_gcs.contract.base import Values
from epf_gcs.formats.kml_live import Aircraft
from epf_gcs.formats.kml_words import Words
from epf_gcs.units import ft_from_m, m_from_ft
from epf_gcs.web.vehicle.mirror import VehicleMirror

Which = Literal["flight", "hil"]
_ATTITUDE: Final = ("yaw_deg", "pitch_deg", "roll_deg")


def aircraft_now(mirror: VehicleMirror, words: Words) -> dict[Which, Aircraft]:
    """The aircraft whose position is known; without an attitude if their data is stale."""
    found: dict[Which, Aircraft] = {}
    flight = _flight(mirror, words)
    if flight is not None:
        found["flight"] = flight
    hil = _hil(mirror, words)
    if hil is not None:
        found["hil"] = hil
    return found


def followed_of(mirror: VehicleMirror, found: Mapping[Which, Aircraft], wanted: Which | None) -> Aircraft | None:
    """The aircraft the camera follows: the requested one, else the simulator's while its data is live."""
    if wanted is not None:
        return found.get(wanted)
    if "hil" in found and (mirror.is_live("simulator") or "flight" not in found):
        return found["hil"]
    return found.get("flight")


def _flight(mirror: VehicleMirror, words: Words) -> Aircraft | None:
    """The board's aircraft: position from its GPS, attitude from its AHRS."""
    gps = mirror.newest("gps")
    if gps is None or gps["valid"] is not True or not gps["fix"]:
        return None
    place = _numbers(gps, "latitude_deg", "longitude_deg", "altitude_m")
    if place is None:
        return None
    is_live = mirror.is_live("gps")
    ahrs = mirror.newest("ahrs") if is_live and mirror.is_live("ahrs") else None
    altitude_ft = ft_from_m(place[2])
    return _aircraft(
        mirror,
        words,
        words.aircraft,
        place,
        is_live=is_live,
        attitude=None if ahrs is None else _numbers(ahrs, *_ATTITUDE),
        description=_description(words, altitude_ft, gps["speed_kt"], gps["heading_deg"]),
    )


def _hil(mirror: VehicleMirror, words: Words) -> Aircraft | None:
    """The simulator's aircraft."""
    values = mirror.newest("simulator")
    place = None if values is None else _numbers(values, "latitude_deg", "longitude_deg", "altitude_msl_ft")
    if values is None or place is None:
        return None
    is_live = mirror.is_live("simulator")
    return _aircraft(
        mirror,
        words,
        words.hil_aircraft,
        (place[0], place[1], m_from_ft(place[2])),
        is_live=is_live,
        attitude=_numbers(values, "true_heading_deg", "pitch_deg", "roll_deg") if is_live else None,
        description=_description(words, place[2], values["indicated_airspeed_kt"], values["true_heading_deg"]),
    )


def _aircraft(
    mirror: VehicleMirror,
    words: Words,
    name: str,
    place: tuple[float, float, float],
    *,
    is_live: bool,
    attitude: tuple[float, float, float] | None,
    description: str,
) -> Aircraft:
    remarks = [
        *([words.examples] if mirror.is_emulated else []),
        *([] if is_live else [words.last_known]),
    ]
    shown = f"{name} ({', '.join(remarks)})" if remarks else name
    heading_deg, pitch_deg, roll_deg = attitude if attitude is not None else (None, None, None)
    return Aircraft(shown, place, heading_deg, pitch_deg, roll_deg, description if is_live else "")


def _numbers(values: Values, first: str, second: str, third: str) -> tuple[float, float, float] | None:
    """Three values, or None if one of them is missing."""
    found = (values.get(first), values.get(second), values.get(third))
    if any(value is None for value in found):
        return None
    return float(found[0] or 0.0), float(found[1] or 0.0), float(found[2] or 0.0)


def _description(words: Words, altitude_ft: float, speed_kt: Any, heading_deg: Any) -> str:
    parts = [f"{words.altitude}: {altitude_ft:.0f} ft"]
    if speed_kt is not None:
        parts.append(f"{words.speed}: {speed_kt:.0f} kt")
    if heading_deg is not None:
        parts.append(f"{words.heading}: {heading_deg % 360.0:.0f}°")
    return "\n".join(parts)
