"""The shapes of links and serial ports."""

from __future__ import annotations

from pydantic import Field

from epf_gcs.codec.messages_gen import RECEIVE_PORT, SEND_PORT
from epf_gcs.contract.answers import PortState
from epf_gcs.contract.base import SimulatorProfile
from epf_gcs.contract.shapes import Input, Output, Port


class Ports(Output):
    """All serial ports now."""

    ports: list[PortState]


class BoardLink(Input):
    """serial:///dev/ttyUSB0?baud=115200, tcp://host:port or pty:///path."""

    url: str = Field(min_length=1, max_length=500)


class NearbySimulator(Output):
    """An X-Plane heard within the last 5 s: its computer's name, its version, and how its rows are read."""

    name: str
    host: str
    port: int
    version: str
    profile: SimulatorProfile


class NearbySimulators(Output):
    """All X-Planes on the networks of the station's computer."""

    simulators: list[NearbySimulator]


class SimulatorLink(Input):
    """Where we listen, and where the simulator is. `tells_rows`: have an X-Plane send its rows here by itself."""

    receive_port: Port = RECEIVE_PORT
    send_host: str = Field("127.0.0.1", min_length=1, max_length=253, pattern=r"^[A-Za-z0-9._:\-]+$")
    send_port: Port = SEND_PORT
    profile: SimulatorProfile = "xp10"
    tells_rows: bool = False
