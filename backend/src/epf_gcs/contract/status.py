"""The state of a station: filled by the flight process, by a replay, or by nobody. Times are Unix seconds."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Literal

from epf_gcs.contract.alarm_ids import AlarmId
from epf_gcs.contract.base import (
    ControlSource,
    LinkState,
    PageKind,
    ParamValue,
    RoleName,
    Shape,
    SimulatorProfile,
    StickSource,
    SurfacePath,
)
from epf_gcs.contract.simulator_faults import SimulatedFaults
from epf_gcs.contract.surroundings import SurroundingsState
from epf_gcs.errors import ErrorCode


@dataclass(frozen=True, slots=True)
class Failure(Shape):
    """Why a link is not open."""

    code: ErrorCode
    detail: str
    params: Mapping[str, ParamValue]


@dataclass(frozen=True, slots=True)
class Features(Shape):
    """What an extended board can do."""

    acknowledgements: bool = False
    store: bool = False
    sources: bool = False
    missions: bool = False


@dataclass(frozen=True, slots=True)
class Firmware(Shape):
    """What an extended board calls itself."""

    name: str | None
    version: str | None


@dataclass(frozen=True, slots=True)
class TaskPeriod(Shape):
    """Period of a task of the board: as this station commanded it, else the board's own."""

    ms: int = 0
    chosen: bool = False


@dataclass(frozen=True, slots=True)
class TaskPeriods(Shape):
    """The three tasks whose period can be commanded."""

    parameters: TaskPeriod = TaskPeriod()
    fms: TaskPeriod = TaskPeriod()
    servos: TaskPeriod = TaskPeriod()


@dataclass(frozen=True, slots=True)
class BoardStatus(Shape):
    """The board's link. `open`: commands work, but during the AHRS test. Percentages are of baud / 10 bytes a second.

    `emulated`: these are example values and no board; the link `before_emulation_url` comes back when it is closed.
    """

    state: LinkState = "closed"
    url: str | None = None
    failure: Failure | None = None
    reopened: int = 0
    mode: Literal["legacy", "extended"] | None = None
    features: Features = Features()
    firmware: Firmware | None = None
    ahrs_test: Literal["off", "starting", "running", "ending"] = "off"
    emulated: bool = False
    before_emulation_url: str | None = None
    periods_ms: TaskPeriods = TaskPeriods()
    heartbeat_age_s: float | None = None
    frames_received: int = 0
    frames_damaged: int = 0
    damage: Mapping[str, int] = field(default_factory=dict)
    bytes_in: int = 0
    bytes_out: int = 0
    rx_percent: float = 0.0
    tx_percent: float = 0.0


@dataclass(frozen=True, slots=True)
class RoundTripMs(Shape):
    """Simulator frame to the board until its surfaces came back; of the last 512."""

    newest: float | None = None
    p50: float | None = None
    p99: float | None = None


@dataclass(frozen=True, slots=True)
class UnusableValue(Shape):
    """A value of a row that the board needs and that cannot be used: not a number, -999, or beyond its range."""

    row: int
    row_name: str
    name: str
    value: str


@dataclass(frozen=True, slots=True)
class SimulatorStatus(Shape):
    """The simulator's socket. `opening`: nothing heard yet; `lost`: it stopped sending, or the port is taken.

    `profile` is what its rows are read as, `fitting_profile` what they are of; null while the data have not said.
    `paused`: its rows come, but an aircraft in flight hangs still in them, bit for bit; its values are not live.
    `tells_rows`: X-Plane is told by the station which rows to send, and where to.
    `faults`: what goes wrong in it by order; null if it takes no orders, as X-Plane.
    """

    state: LinkState = "closed"
    receive_port: int | None = None
    send_host: str | None = None
    send_port: int | None = None
    tells_rows: bool = False
    profile: SimulatorProfile | None = None
    fitting_profile: SimulatorProfile | None = None
    failure: Failure | None = None
    rows: list[int] = field(default_factory=list)
    missing_rows: list[int] = field(default_factory=list)
    unusable: list[UnusableValue] = field(default_factory=list)
    paused: bool = False
    faults: SimulatedFaults | None = None
    advice: str | None = None
    datagrams_received: int = 0
    datagrams_dropped: int = 0
    drop_reasons: Mapping[str, int] = field(default_factory=dict)
    bytes_in: int = 0
    percent: float = 0.0
    frames_to_board: int = 0
    frames_to_simulator: int = 0
    frames_skipped: Mapping[str, int] = field(default_factory=dict)
    hil_round_trip_ms: RoundTripMs = RoundTripMs()


@dataclass(frozen=True, slots=True)
class StickState(Shape):
    """Where the pilot's stick comes from: the simulator's rows 8 and 25, or a browser's gamepad.

    `state`: whether its samples come; while they are `lost` the stick counts as let go. `client` and `name` are those
    of the browser. `samples` counts what came: `taken`, `late`, `not_operator`, `invalid`.
    """

    source: StickSource = "simulator"
    state: Literal["live", "lost"] | None = None
    client: str | None = None
    name: str | None = None
    gamepad: str | None = None
    samples: Mapping[str, int] = field(default_factory=dict)


@dataclass(frozen=True, slots=True)
class HilState(Shape):
    """Who holds the stick, as the board reports it (null: not heard), who moves the simulator's surfaces, and where
    the stick comes from."""

    source: ControlSource | None = None
    path: SurfacePath = "manual"
    stick: StickState = StickState()


@dataclass(frozen=True, slots=True)
class RecordingState(Shape):
    """The file being written. `hours_left`: how long the disk's room lasts at its rate; null while not known."""

    active: bool = False
    file: str | None = None
    bytes: int = 0
    bytes_lost: int = 0
    failure: str | None = None
    free_bytes: int | None = None
    hours_left: float | None = None


@dataclass(frozen=True, slots=True)
class AlarmState(Shape):
    """Something that is wrong now; an acknowledged one is shown quietly until its cause goes.

    `until_s` is null while it lasts. One that has an end has recovered, and is listed until it is acknowledged.
    `count`: how often it came since somebody last acknowledged it.
    """

    id: AlarmId
    level: Literal["warning", "critical"]
    since_s: float
    until_s: float | None
    text: str
    params: Mapping[str, ParamValue]
    acknowledged: bool
    count: int = 1


@dataclass(frozen=True, slots=True)
class TopicHealth(Shape):
    """How well a topic arrives; older than `stale_after_s` its value is not live."""

    count: int
    rate_hz: float
    age_s: float | None
    stale_after_s: float | None
    implausible: Mapping[str, int]


@dataclass(frozen=True, slots=True)
class ControlReservation(Shape):
    """Who has just lost control; it comes back without asking until then, while nobody else has asked for it."""

    client: str
    name: str
    kind: PageKind
    number: int
    until_s: float


@dataclass(frozen=True, slots=True)
class ControlRequest(Shape):
    """Somebody asks for control since then. `given_at_s`: when it is given by time alone if the holder does nothing
    until then; null: only the holder or an owner gives it."""

    client: str
    name: str
    kind: PageKind
    number: int
    role: RoleName
    since_s: float
    given_at_s: float | None


@dataclass(frozen=True, slots=True)
class ControlState(Shape):
    """The one page that may command, null while nobody has control, and who asks for it, the longest first.

    `name` is ready to show; `number` tells pages of one name apart. Times are Unix seconds.
    """

    client: str | None = None
    name: str | None = None
    kind: PageKind | None = None
    number: int | None = None
    since_s: float | None = None
    reserved: ControlReservation | None = None
    requests: list[ControlRequest] = field(default_factory=list)


@dataclass(frozen=True, slots=True)
class Status(Shape):
    """The whole state of the station. `version`, `control`, `surroundings` and `viewers` are the web process's."""

    version: str = ""
    server_time_s: float = 0.0
    board: BoardStatus = BoardStatus()
    simulator: SimulatorStatus = SimulatorStatus()
    hil: HilState = HilState()
    control: ControlState = field(default_factory=ControlState)
    recording: RecordingState = RecordingState()
    alarms: list[AlarmState] = field(default_factory=list)
    surroundings: SurroundingsState = field(default_factory=SurroundingsState)
    errors: Mapping[str, int] = field(default_factory=dict)
    topics: Mapping[str, TopicHealth] = field(default_factory=dict)
    viewers: int = 0
