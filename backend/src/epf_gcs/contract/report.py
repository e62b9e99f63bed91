"""The shapes of the flight report. `at_s` is seconds since the flight's start; null is what cannot be known."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from epf_gcs.contract.answers import FlightIdentity
from epf_gcs.contract.base import PlanName, Shape

ManoeuvreKind = Literal["climb", "descent", "turn_right", "turn_left", "faster", "slower", "leg"]
LoopName = Literal["altitude", "heading", "speed"]
NoManoeuvres = Literal["no_targets", "autopilot_off", "no_changes"]
ReportEventKind = Literal[
    "assisted", "manual", "stick", "limits", "restart", "jump", "silence", "simulator_silence", "pause"
]
NotKnown = Literal["wind", "battery", "round_trip", "position", "speed", "gains", "gaps", "file", "lost"]


@dataclass(frozen=True, slots=True)
class ReportTimes(Shape):
    """`airborne_s` is the time faster than 20 kt, `autopilot_s` that with an autopilot on; `started_s` Unix time."""

    started_s: float
    duration_s: float
    airborne_s: float | None
    autopilot_s: float


@dataclass(frozen=True, slots=True)
class ReportDistances(Shape):
    """Way over the ground, altitudes above the sea, and the highest rates over two seconds, both positive."""

    distance_nm: float | None
    highest_ft: float | None
    lowest_ft: float | None
    fastest_kt: float | None
    climb_most_ft_min: float | None
    sink_most_ft_min: float | None


@dataclass(frozen=True, slots=True)
class ReportBattery(Shape):
    """Volts: the means of the first and the last ten seconds, and the lowest sample."""

    begin_v: float
    end_v: float
    lowest_v: float
    drop_v_per_hour: float | None


@dataclass(frozen=True, slots=True)
class ReportRoundTrip(Shape):
    """Milliseconds from a simulator frame sent to the board until its answer."""

    count: int
    median: float
    p99: float
    longest: float


@dataclass(frozen=True, slots=True)
class ReportLink(Shape):
    """What the board's line brought. A gap is a second or more without a byte while the line was open."""

    frames: int | None
    frames_damaged: int | None
    damaged_percent: float | None
    gaps: int
    gaps_s: float
    longest_gap_s: float | None
    round_trip_ms: ReportRoundTrip | None


@dataclass(frozen=True, slots=True)
class ReportAlarm(Shape):
    """An alarm that sounded: when first, how often, and for how long together; `lasted_s` is null where the recording
    ended before it did."""

    name: str
    level: str | None
    at_s: float
    lasted_s: float | None
    count: int


@dataclass(frozen=True, slots=True)
class ReportMark(Shape):
    """Words that a person set at a moment."""

    at_s: float
    text: str


@dataclass(frozen=True, slots=True)
class ReportEvent(Shape):
    """What changed or broke the flight; `until_s` is null for a moment, or where the recording ended before it did.
    `detail` says which and how, as text of no language."""

    kind: ReportEventKind
    at_s: float
    until_s: float | None
    detail: str


@dataclass(frozen=True, slots=True)
class ReportTrace(Shape):
    """What the picture of a manoeuvre draws; `at_s` is counted from the manoeuvre's begin."""

    at_s: list[float]
    value: list[float | None]
    target: list[float | None]


@dataclass(frozen=True, slots=True)
class ReportLeg(Shape):
    """The flight to a waypoint. `across`: distance from the straight line; errors are root mean squares of the
    leg's second half."""

    duration_s: float
    distance_m: float | None
    across_rms_m: float | None
    across_most_m: float | None
    altitude_error_ft: float | None
    speed_error_kt: float | None


@dataclass(frozen=True, slots=True)
class ReportModel(Shape):
    """What a second-order model says of an answer that it explains: the same figures on the same time, each within its
    doubt of the true one in 95 of 100 cases, and `off`, the root mean square of what it leaves of the samples, in the
    signal's unit."""

    rise_s: float | None
    rise_doubt_s: float | None
    overshoot_percent: float | None
    overshoot_doubt_percent: float | None
    damping: float | None
    damping_doubt: float | None
    frequency_rad_s: float | None
    off: float


@dataclass(frozen=True, slots=True)
class ReportManoeuvre(Shape):
    """A manoeuvre and how the loop answered it. Times are counted from its begin; `size` is the step of the target
    (of a leg its seconds), and `start`, `target`, `final`, `peak` and `steady_error` have the unit `unit`.

    `method` says where the figures are from: the smoothed samples, or nothing, where they can't be judged. They are
    shares of the step that was asked for, of what was flown alone. `is_cut`: the manoeuvre ended before the answer came
    to rest. `model` is null where no model explains the samples. `earlier` is the place of the like manoeuvre in
    `earlier.manoeuvres`.
    """

    kind: ManoeuvreKind
    plan: PlanName
    cause: Literal["waypoint", "target", "engaged"]
    at_s: float
    until_s: float
    unit: str
    size: float
    start: float | None
    target: float | None
    waypoint: int | None
    method: Literal["samples", "none"]
    rise_s: float | None
    rise_from_s: float | None
    rise_to_s: float | None
    overshoot_percent: float | None
    peak: float | None
    peak_s: float | None
    settling_s: float | None
    final: float | None
    steady_error: float | None
    is_cut: bool
    model: ReportModel | None
    leg: ReportLeg | None
    trace: ReportTrace | None
    earlier: int | None


@dataclass(frozen=True, slots=True)
class ReportLoop(Shape):
    """The medians of one loop over all its manoeuvres that have figures."""

    loop: LoopName
    manoeuvres: int
    unit: str
    rise_s: float | None
    overshoot_percent: float | None
    settling_s: float | None
    steady_error: float | None
    damping: float | None


@dataclass(frozen=True, slots=True)
class ReportEffect(Shape):
    """How a loop flew in a stretch: medians of the manoeuvres that lie in it whole, and the root mean square of its
    error all the time (null for less than ten seconds of it)."""

    from_s: float
    to_s: float
    manoeuvres: int
    error_rms: float | None
    rise_s: float | None
    overshoot_percent: float | None
    settling_s: float | None
    steady_error: float | None
    damping: float | None


@dataclass(frozen=True, slots=True)
class ReportGain(Shape):
    """A gain that was changed in flight, and its loop before and after; null for gains that belong to no loop."""

    name: str
    at_s: float
    before: float
    after: float
    loop: LoopName | None
    earlier: ReportEffect | None
    later: ReportEffect | None


@dataclass(frozen=True, slots=True)
class GainDifference(Shape):
    """A gain that had another value at the end of the earlier flight."""

    name: str
    before: float
    after: float


@dataclass(frozen=True, slots=True)
class EarlierFlight(Shape):
    """The flight that this one is compared with."""

    flight: str
    times: ReportTimes
    distances: ReportDistances
    battery: ReportBattery | None
    link: ReportLink
    loops: list[ReportLoop]
    manoeuvres: list[ReportManoeuvre]
    gains: list[GainDifference]


@dataclass(frozen=True, slots=True)
class FlightReport(Shape):
    """What a test pilot writes after landing. `unknown` lists what the recording does not say, `no_manoeuvres` why
    none was found; `gains_known` are the gains at the end."""

    flight: str
    identity: FlightIdentity
    times: ReportTimes
    distances: ReportDistances
    battery: ReportBattery | None
    link: ReportLink
    alarms: list[ReportAlarm]
    events: list[ReportEvent]
    marks: list[ReportMark]
    manoeuvres: list[ReportManoeuvre]
    no_manoeuvres: NoManoeuvres | None
    loops: list[ReportLoop]
    gains: list[ReportGain]
    gains_known: dict[str, float]
    unknown: list[NotKnown]
    earlier: EarlierFlight | None
