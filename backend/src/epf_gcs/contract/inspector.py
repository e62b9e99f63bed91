"""Every message of both lines, measured, and advice."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Literal

from epf_gcs.contract.base import ParamValue, Shape
from epf_gcs.contract.status import RoundTripMs

AdviceCode = Literal[
    "baud_wrong",
    "foreign_datagrams",
    "frames_damaged",
    "line_full",
    "no_heartbeat",
    "round_trip_long",
    "row_missing",
    "servo_rate_high",
    "simulator_silent",
    "stream_slow",
    "streams_slow",
]


@dataclass(frozen=True, slots=True)
class InspectedFrame(Shape):
    """One type of frame from the board, heard or not. `jitter_ms` is the standard deviation of the intervals, null
    for what is only sent when asked for.

    A type that this gateway does not know is named `unknown_0x…` and has no values. `units` are those of the values, by
    name, "1" for a plain number.
    """

    id: int
    name: str
    count: int
    rate_hz: float
    jitter_ms: float | None
    damaged: int
    age_s: float | None
    stale_after_s: float | None
    values: Mapping[str, float | int | bool | str | None] | None
    units: Mapping[str, str]


@dataclass(frozen=True, slots=True)
class InspectedRow(Shape):
    """One row of the simulator; `expected` ones are what the HIL loop needs. A row that we do not know is `row_n`."""

    row: int
    name: str
    expected: bool
    count: int
    rate_hz: float
    jitter_ms: float | None
    age_s: float | None
    values: list[float | None] | None


@dataclass(frozen=True, slots=True)
class InspectedLink(Shape):
    """What the lines carry against what they can; null while no board's link is open, and 73,000 for the simulator.

    A recording does not tell the round trips: null.
    """

    rx_bytes_per_s: float
    tx_bytes_per_s: float
    capacity_bytes_per_s: float | None
    rx_percent: float | None
    tx_percent: float | None
    simulator_bytes_per_s: float
    simulator_percent: float
    round_trip_ms: RoundTripMs = field(default_factory=RoundTripMs)
    round_trips: int | None = None


@dataclass(frozen=True, slots=True)
class AdviceState(Shape):
    """Something to do about what does not go well."""

    code: AdviceCode
    level: Literal["info", "warning"]
    text: str
    params: Mapping[str, ParamValue]


@dataclass(frozen=True, slots=True)
class Inspector(Shape):
    """All of it now; made to be asked for some times a second."""

    t_s: float
    board: list[InspectedFrame]
    rows: list[InspectedRow]
    link: InspectedLink
    advice: list[AdviceState] = field(default_factory=list)
