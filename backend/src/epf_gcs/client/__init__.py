"""A station for programs: status, samples, commands with their proof, gains, plans, flights, HIL.

async with Station("http://127.0.0.1:8080") as station:
    async for sample in station.samples(Ahrs):
        print(sample.t_s, sample.values.roll_deg)
"""

from __future__ import annotations

from epf_gcs.client.errors import ControlError, StationError, StationLostError
from epf_gcs.client.samples_gen import (
    Ahrs,
    Analog,
    AutopilotParameters,
    BoardStatus,
    FlyByWire,
    FmsHilPlan,
    FmsPlan,
    Gps,
    Heartbeat,
    HilSurfaces,
    Inertial,
    ServosIn,
    Simulator,
    Statistics,
    Topic,
    XplaneInfo,
)
from epf_gcs.client.station import Newest, Station
from epf_gcs.client.stream import Sample
from epf_gcs.codec.tables import Waypoint

__all__ = [
    "Ahrs",
    "Analog",
    "AutopilotParameters",
    "BoardStatus",
    "ControlError",
    "FlyByWire",
    "FmsHilPlan",
    "FmsPlan",
    "Gps",
    "Heartbeat",
    "HilSurfaces",
    "Inertial",
    "Newest",
    "Sample",
    "ServosIn",
    "Simulator",
    "Station",
    "StationError",
    "StationLostError",
    "Statistics",
    "Topic",
    "Waypoint",
    "XplaneInfo",
]
