"""All that can be asked of a vehicle, each with the type of its answer. A request is a value; its class is its name.

result = await vehicle.ask(OpenBoard(url), by=operator)
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Generic, TypeVar, get_args

from epf_gcs.codec.tables import Waypoint
from epf_gcs.contract.answers import (
    AircraftName,
    AlarmBook,
    AlarmLimits,
    CommandOutcome,
    DiskPolicy,
    LinkResult,
    Mark,
    ParameterJournal,
    PortState,
    Sample,
)
from epf_gcs.contract.base import ControlSource, PlanName, SimulatorProfile, StickSource, SurfacePath
from epf_gcs.contract.flight_knowledge import FlightKnowledge
from epf_gcs.contract.inspector import Inspector
from epf_gcs.contract.own_gains import AllGains
from epf_gcs.contract.playback import Playback
from epf_gcs.contract.simulator_faults import FaultKind, FaultPlace, FaultState, SimulatedFaults, TurbulenceName
from epf_gcs.contract.status import AlarmState, HilState, Status

AnswerT_co = TypeVar("AnswerT_co", covariant=True)


class Request(Generic[AnswerT_co]):
    """The base of all requests. An answer comes back, or the GatewayError that the vehicle raised."""

    __slots__ = ()


def answer_type(request: type[Request[Any]]) -> Any:
    """The type of a request's answer."""
    (base,) = request.__orig_bases__  # type: ignore[attr-defined]
    return get_args(base)[0]


# ---- what can be read, live and of a flight of the past ------------------------------------------


@dataclass(frozen=True, slots=True)
class ReadStatus(Request[Status]):
    """The state now."""


@dataclass(frozen=True, slots=True)
class ReadTelemetry(Request[dict[str, Sample]]):
    """The newest sample of each topic, with its age."""


@dataclass(frozen=True, slots=True)
class ReadInspector(Request[Inspector]):
    """Every message of both lines, measured."""


@dataclass(frozen=True, slots=True)
class ReadKnown(Request[FlightKnowledge]):
    """Identity, gains and plans at the moment that a replay shows."""


@dataclass(frozen=True, slots=True)
class ReadPlayback(Request[Playback]):
    """Where a replay is."""


# ---- lines ---------------------------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class ReadPorts(Request[list[PortState]]):
    """The serial ports of the station's computer."""


@dataclass(frozen=True, slots=True)
class OpenBoard(Request[LinkResult]):
    """Open the board's line at this URL, and keep it open."""

    url: str


@dataclass(frozen=True, slots=True)
class CloseBoard(Request[None]):
    """Close the board's line."""


@dataclass(frozen=True, slots=True)
class OpenSimulator(Request[LinkResult]):
    """Listen for the simulator's datagrams, and send it the surfaces.

    `tells_rows`: an X-Plane is told which rows to send, and where to; nobody has to click in it.
    """

    receive_port: int
    send_host: str
    send_port: int
    profile: SimulatorProfile
    tells_rows: bool = False


@dataclass(frozen=True, slots=True)
class CloseSimulator(Request[None]):
    """Close the simulator's socket."""


# ---- commands and HIL ----------------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class RunCommand(Request[CommandOutcome]):
    """Send a command and wait for its proof. The arguments are checked already."""

    name: str
    arguments: list[bool | int | float]


@dataclass(frozen=True, slots=True)
class SendLine(Request[None]):
    """Send a line of text to the board; a line end is added."""

    text: str


@dataclass(frozen=True, slots=True)
class StartAhrsTest(Request[CommandOutcome]):
    """Begin the AHRS test, which has the line for itself."""


@dataclass(frozen=True, slots=True)
class StopAhrsTest(Request[CommandOutcome]):
    """End the AHRS test."""


@dataclass(frozen=True, slots=True)
class ReadHil(Request[HilState]):
    """The HIL switches."""


@dataclass(frozen=True, slots=True)
class SetHil(Request[HilState]):
    """Change the HIL switches; None: no change. `gamepad` is its name for people."""

    source: ControlSource | None = None
    path: SurfacePath | None = None
    stick: StickSource | None = None
    gamepad: str = ""


# ---- faults of the embedded simulator -----------------------------------------------------------


@dataclass(frozen=True, slots=True)
class BeginFault(Request[FaultState]):
    """Let something go wrong `start_s` from now; None: as usual for its kind."""

    place: FaultPlace
    kind: FaultKind
    start_s: float = 0.0
    length_s: float | None = None
    strength: float | None = None


@dataclass(frozen=True, slots=True)
class EndFault(Request[SimulatedFaults]):
    """End a fault; None: all."""

    id: str | None = None


@dataclass(frozen=True, slots=True)
class SetWind(Request[SimulatedFaults]):
    """Steady wind and turbulence from now on."""

    from_deg: float
    speed_kt: float
    turbulence: TurbulenceName


# ---- gains and plans -----------------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class ReadParameters(Request[AllGains]):
    """The gains as far as they are known."""


@dataclass(frozen=True, slots=True)
class LoadParameters(Request[AllGains]):
    """Read all gains from the board."""


@dataclass(frozen=True, slots=True)
class SetParameters(Request[AllGains]):
    """Write gains, built-in ones and the board's own, and read them back."""

    values: Mapping[str, float]


@dataclass(frozen=True, slots=True)
class UndoParameters(Request[AllGains]):
    """Take the newest step back."""


@dataclass(frozen=True, slots=True)
class RedoParameters(Request[AllGains]):
    """Do again what was taken back."""


@dataclass(frozen=True, slots=True)
class StoreParameters(Request[CommandOutcome]):
    """Have the board store its gains on its card."""


@dataclass(frozen=True, slots=True)
class ReadJournal(Request[ParameterJournal]):
    """What was written to the gains, by whom."""


@dataclass(frozen=True, slots=True)
class ReadPlan(Request[list[Waypoint]]):
    """The plan that the board has."""

    plan: PlanName


@dataclass(frozen=True, slots=True)
class WritePlan(Request[list[Waypoint]]):
    """Send a plan, and read back what the board has."""

    plan: PlanName
    waypoints: list[Waypoint]


# ---- alarms and recording ------------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class ReadAlarms(Request[AlarmBook]):
    """What is wrong now, and what was."""


@dataclass(frozen=True, slots=True)
class ReadThresholds(Request[AlarmLimits]):
    """The limits of the alarms, by name."""


@dataclass(frozen=True, slots=True)
class ChooseThresholds(Request[AlarmLimits]):
    """Change limits of alarms."""

    values: Mapping[str, float]


@dataclass(frozen=True, slots=True)
class AcknowledgeAlarm(Request[AlarmState]):
    """Show an alarm quietly until its cause goes."""

    id: str


@dataclass(frozen=True, slots=True)
class SetMark(Request[Mark]):
    """Put a mark into the recording, `ago_s` seconds before now."""

    text: str
    by: str | None = None
    ago_s: float = 0.0


@dataclass(frozen=True, slots=True)
class ChooseDiskPolicy(Request[DiskPolicy]):
    """Change what is given of the policy, and keep it."""

    delete_oldest: bool | None = None
    keep_free_bytes: int | None = None


@dataclass(frozen=True, slots=True)
class NameAircraft(Request[AircraftName]):
    """Say what the aircraft is called from now on; None: only ask."""

    name: str | None = None


REQUESTS: Mapping[str, type[Request[Any]]] = {kind.__name__: kind for kind in Request.__subclasses__()}
"""Every request, by the name that the stream between the processes has for it."""
