"""The shapes of status, newest telemetry and control."""

from __future__ import annotations

from typing import Literal

from pydantic import Field

from epf_gcs.contract.shapes import Input, LinkState, Output, ParamValue
from epf_gcs.errors import ErrorCode
from epf_gcs.vehicle.alarm_ids import AlarmId
from epf_gcs.web.interface.surroundings.schemas import SurroundingsState


class Failure(Output):
    """Why a link is not open."""

    code: ErrorCode
    detail: str
    params: dict[str, ParamValue]


class Features(Output):
    """What an extended board can do."""

    acknowledgements: bool
    store: bool
    sources: bool
    missions: bool


class Firmware(Output):
    """What an extended board calls itself."""

    name: str | None
    version: str | None


class TaskPeriod(Output):
    """Period of a task of the board: as this station commanded it, else the board's own."""

    ms: int
    chosen: bool


class TaskPeriods(Output):
    """The three tasks whose period can be commanded."""

    parameters: TaskPeriod
    fms: TaskPeriod
    servos: TaskPeriod


class BoardStatus(Output):
    """The board's link. `open`: commands work, but during the AHRS test. Percentages are of baud / 10 bytes a second.

    `emulated`: these are example values and no board; the link `before_emulation_url` comes back when it is closed.
    """

    state: LinkState
    url: str | None
    failure: Failure | None
    reopened: int
    mode: Literal["legacy", "extended"] | None
    features: Features
    firmware: Firmware | None
    ahrs_test: Literal["off", "starting", "running", "ending"]
    emulated: bool
    before_emulation_url: str | None
    periods_ms: TaskPeriods
    heartbeat_age_s: float | None
    frames_received: int
    frames_damaged: int
    damage: dict[str, int]
    bytes_in: int
    bytes_out: int
    rx_percent: float
    tx_percent: float


class RoundTripMs(Output):
    """Simulator frame to the board until its surfaces came back; of the last 512."""

    newest: float | None
    p50: float | None
    p99: float | None


class UnusableValue(Output):
    """A value of a row that the board needs and that cannot be used: not a number, -999, or beyond its range."""

    row: int
    row_name: str
    name: str
    value: str


class SimulatorStatus(Output):
    """The simulator's socket. `opening`: nothing heard yet; `lost`: it stopped sending, or the port is taken.

    `profile` is what its rows are read as, `fitting_profile` what they are of; null while the data have not said.
    `paused`: its rows come, but an aircraft in flight hangs still in them, bit for bit; its values are not live.
    """

    state: LinkState
    receive_port: int | None
    send_host: str | None
    send_port: int | None
    profile: Literal["xp10", "xp12"] | None
    fitting_profile: Literal["xp10", "xp12"] | None
    failure: Failure | None
    rows: list[int]
    missing_rows: list[int]
    unusable: list[UnusableValue]
    paused: bool
    advice: str | None
    datagrams_received: int
    datagrams_dropped: int
    drop_reasons: dict[str, int]
    bytes_in: int
    percent: float
    frames_to_board: int
    frames_to_simulator: int
    frames_skipped: dict[str, int]
    hil_round_trip_ms: RoundTripMs


class StickState(Output):
    """Where the pilot's stick comes from: the simulator's rows 8 and 25, or a browser's gamepad.

    `state`: whether its samples come; while they are `lost` the stick counts as let go. `client` and `name` are those
    of the browser. `samples` counts what came: `taken`, `late`, `not_operator`, `invalid`.
    """

    source: Literal["simulator", "gamepad"]
    state: Literal["live", "lost"] | None
    client: str | None
    name: str | None
    gamepad: str | None
    samples: dict[str, int]


class HilState(Output):
    """Who holds the stick, as the board reports it (null: not heard), who moves the simulator's surfaces, and where
    the stick comes from."""

    source: Literal["joystick", "rc"] | None
    path: Literal["manual", "assisted"]
    stick: StickState


PageKind = Literal["local", "person", "program"]
"""A page of this computer, of a person, or a program."""
RoleName = Literal["viewer", "operator", "owner"]


class ControlReserved(Output):
    """Who has just lost control; it comes back without asking until then, while nobody else has asked for it."""

    client: str
    name: str
    kind: PageKind
    number: int
    until_s: float


class ControlRequest(Output):
    """Somebody asks for control since then. `given_at_s`: when it is given by time alone if the holder does nothing
    until then; null: only the holder or an owner gives it."""

    client: str
    name: str
    kind: PageKind
    number: int
    role: RoleName
    since_s: float
    given_at_s: float | None


class ControlState(Output):
    """The one page that may command, null while nobody has control, and who asks for it, the longest first.

    `name` is ready to show; `number` tells pages of one name apart. Times are Unix seconds.
    """

    client: str | None
    name: str | None
    kind: PageKind | None
    number: int | None
    since_s: float | None
    reserved: ControlReserved | None
    requests: list[ControlRequest]


class StreamPage(Output):
    """A page on the live stream."""

    client: str
    name: str
    kind: PageKind
    number: int
    role: RoleName


class ControlDetails(ControlState):
    """The same, and all pages on the live stream, the longest first: control can be handed over to those that are no
    viewers."""

    pages: list[StreamPage]


class RecordingState(Output):
    """The file being written. `hours_left`: how long the disk's room lasts at its rate; null while not known."""

    active: bool
    file: str | None
    bytes: int
    bytes_lost: int
    failure: str | None
    free_bytes: int | None
    hours_left: float | None


class AlarmState(Output):
    """Something that is wrong now; an acknowledged one is shown quietly until its cause goes.

    `until_s` is null while it lasts. One that has an end has recovered, and is listed until it is acknowledged.
    """

    id: AlarmId
    level: Literal["warning", "critical"]
    since_s: float
    until_s: float | None
    text: str
    params: dict[str, ParamValue]
    acknowledged: bool


class TopicHealth(Output):
    """How well a topic arrives; older than `stale_after_s` its value is not live."""

    count: int
    rate_hz: float
    age_s: float | None
    stale_after_s: float | None
    implausible: dict[str, int]


class Status(Output):
    """The whole state of the station."""

    version: str
    server_time_s: float
    board: BoardStatus
    simulator: SimulatorStatus
    hil: HilState
    control: ControlState
    recording: RecordingState
    alarms: list[AlarmState]
    surroundings: SurroundingsState
    errors: dict[str, int]
    topics: dict[str, TopicHealth]
    viewers: int


class Sample(Output):
    """The newest sample of a topic; null is no data."""

    t_s: float
    age_s: float
    stale: bool
    values: dict[str, float | int | bool | str | dict[str, list[float | None]] | None]


class ControlInput(Input):
    """`client` is the id of the caller's own stream (`hello`).

    `take` is for all while nobody has control; an owner who sends `confirm` takes it from another page. `ask` opens a
    request, `withdraw` closes it. The page that has control can `grant` or `refuse` it `to` the one who asks,
    `hand_over` without being asked, and `release`.
    """

    client: str = Field(min_length=1, max_length=64)
    action: Literal["take", "release", "ask", "withdraw", "grant", "refuse", "hand_over"]
    to: str | None = Field(default=None, min_length=1, max_length=64)
    confirm: bool = False
