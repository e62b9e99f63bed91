"""Figures of a flight that limits are set for: height, airspeed, distance, satellites."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Final

from epf_gcs.contract.base import Values
from epf_gcs.earth import distance_m
from epf_gcs.units import ft_from_m

# Of the least airspeed: an aircraft as slow as that has landed.
_LANDED: Final = 0.5


class FlightFigures:
    """By the name of the limit that each is held against; None where it is not known now.

    Distance counts from the first valid position. The airspeed has a least value only in flight: from when it was
    reached until it is half of that.
    """

    def __init__(self) -> None:
        self._begin: tuple[float, float] | None = None
        self._is_airborne = False

    def kept(self) -> list[Any]:
        """Plain values for `restore`."""
        return [self._begin, self._is_airborne]

    def restore(self, kept: Sequence[Any]) -> None:
        """Go on from what `kept` gave."""
        begin, self._is_airborne = kept
        self._begin = None if begin is None else (begin[0], begin[1])

    def of(self, analog: Values | None, gps: Values | None, least_airspeed_kt: float) -> dict[str, float | None]:
        """`analog` and `gps` are the newest samples, None while they are not live."""
        altitude_m = None if analog is None else analog.get("altitude_m")
        airspeed_kt = None if analog is None else analog.get("calibrated_airspeed_kt")
        if airspeed_kt is not None:
            self._is_airborne = airspeed_kt > least_airspeed_kt or (
                self._is_airborne and airspeed_kt > _LANDED * least_airspeed_kt
            )
        return {
            "altitude_high_ft": None if altitude_m is None else ft_from_m(altitude_m),
            "airspeed_low_kt": airspeed_kt if self._is_airborne else None,
            "airspeed_high_kt": airspeed_kt,
            "distance_far_m": self._distance_m(gps),
            "satellites_few": None if gps is None else gps.get("satellites"),
        }

    def _distance_m(self, gps: Values | None) -> float | None:
        if gps is None or gps.get("valid") is not True:
            return None
        here = (gps["latitude_deg"], gps["longitude_deg"])
        if self._begin is None:
            self._begin = here
        return distance_m(*self._begin, *here)
