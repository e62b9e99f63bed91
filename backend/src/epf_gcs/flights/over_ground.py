"""Metres over the ground between places of a flight, on the sphere of `earth.py`."""

from __future__ import annotations

import numpy as np

from epf_gcs.earth import M_PER_DEG
from epf_gcs.flights.signals import Array


def offsets_m(
    latitude_deg: Array, longitude_deg: Array, from_latitude_deg: Array, from_longitude_deg: Array
) -> tuple[Array, Array]:
    """How far north and east of other places these are, in metres, each (n,); also over the date line.

    The other places are (n,) or (1,). Right for distances that are short against the earth.
    """
    east_deg = (longitude_deg - from_longitude_deg + 180.0) % 360.0 - 180.0
    north_m: Array = (latitude_deg - from_latitude_deg) * M_PER_DEG
    east_m: Array = east_deg * M_PER_DEG * np.cos(np.radians(from_latitude_deg))
    return north_m, east_m


def steps_m(latitude_deg: Array, longitude_deg: Array) -> Array:
    """The way over the ground between each two places that follow each other, in metres, (n - 1,)."""
    north_m, east_m = offsets_m(latitude_deg[1:], longitude_deg[1:], latitude_deg[:-1], longitude_deg[:-1])
    return np.hypot(north_m, east_m)
