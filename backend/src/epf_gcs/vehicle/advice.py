"""Hints for the operator: one sentence for each problem that the state of the links shows."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field
from typing import Final, Literal, NamedTuple

from epf_gcs.contract.inspector import AdviceState

_FULL_PERCENT: Final = 90.0
# Advise a lower servo rate only if the servo frames take a large part of a full line.
_SERVOS_PERCENT: Final = 20.0
_LONG_ROUND_TRIP_MS: Final = 100.0
_SLOW: Final = 0.8
# From this many on, slow streams are one hint: they have one cause.
_TOGETHER: Final = 3
# Without row 18 (ground track) the heading of row 17 is used.
_REPLACEABLE_ROWS: Final = frozenset({18})


class MissingRow(NamedTuple):
    """A row of the simulator that is needed and does not come."""

    row: int
    name: str


class Stream(NamedTuple):
    """A topic that the board was asked for: its measured and its expected rate."""

    topic: str
    rate_hz: float
    expected_hz: float


@dataclass(frozen=True, slots=True)
class AdviceFacts:
    """All that advice is made from; None or empty: unknown, or no problem.

    `silent_target` is the address of a board that sends nothing, `silent_port` the UDP port at which a simulator's
    data should arrive and does not. `rx_percent`, `tx_percent` and `servos_percent` (both servo streams together) are
    shares of the line's capacity.
    """

    silent_target: str | None = None
    rubbish_at_baud: int | None = None
    rx_percent: float | None = None
    tx_percent: float | None = None
    servos_percent: float | None = None
    servos_ms: int = 20
    damaged_percent: float = 0.0
    damaged_limit_percent: float = 1.0
    streams: Sequence[Stream] = field(default_factory=tuple)
    silent_port: int | None = None
    missing_rows: Sequence[MissingRow] = field(default_factory=tuple)
    strangers: int = 0
    round_trip_p99_ms: float | None = None


def advice(observed: AdviceFacts) -> list[AdviceState]:
    """All hints that apply, warnings first."""
    found = [one for look in _LOOKS for one in look(observed)]
    return sorted(found, key=lambda one: one.level != "warning")


def _look_at_board(observed: AdviceFacts) -> Iterator[AdviceState]:
    baud, target = observed.rubbish_at_baud, observed.silent_target
    if baud is not None:
        text = f"Only rubbish comes from the board's line at {baud} baud: try another baud rate."
        yield AdviceState("baud_wrong", "warning", text, {"baud": baud})
    elif target is not None:
        text = f"No heartbeat comes from {target}: check that the board is on, the port and the baud rate."
        yield AdviceState("no_heartbeat", "warning", text, {"target": target})


def _look_at_load(observed: AdviceFacts) -> Iterator[AdviceState]:
    for direction, words, percent in (
        ("rx", "from", observed.rx_percent),
        ("tx", "to", observed.tx_percent),
    ):
        if percent is not None and percent >= _FULL_PERCENT:
            text = f"The line {words} the board is {percent:.0f} % full: lower the rates, or take a faster line."
            yield AdviceState("line_full", "warning", text, {"percent": round(percent), "direction": direction})
    share = observed.servos_percent
    if share is None or share < _SERVOS_PERCENT or (observed.rx_percent or 0.0) < _FULL_PERCENT:
        return
    ms = observed.servos_ms
    text = f"The servo streams take {share:.0f} % of the line at {ms} ms: lower the servo rate."
    yield AdviceState("servo_rate_high", "info", text, {"ms": ms, "percent": round(share)})


def _look_at_damage(observed: AdviceFacts) -> Iterator[AdviceState]:
    if observed.damaged_percent > observed.damaged_limit_percent:
        percent = round(observed.damaged_percent, 1)
        text = f"{percent:g} % of the board's frames are damaged: check baud rate, cable and radio."
        yield AdviceState("frames_damaged", "warning", text, {"percent": percent})


def _look_at_streams(observed: AdviceFacts) -> Iterator[AdviceState]:
    slow = [stream for stream in observed.streams if stream.rate_hz < _SLOW * stream.expected_hz]
    if len(slow) >= _TOGETHER:
        listed = ", ".join(f"{topic} {rate_hz:.1f}/{expected_hz:.1f} Hz" for topic, rate_hz, expected_hz in slow)
        text = f"{len(slow)} streams come slower than asked for: {listed}."
        yield AdviceState("streams_slow", "info", text, {"number": len(slow), "list": listed})
        return
    for topic, rate_hz, expected_hz in slow:
        text = f"{topic} comes {rate_hz:.1f} times a second and should come {expected_hz:.1f} times."
        params: dict[str, str | int | float | bool | None] = {
            "topic": topic,
            "rate_hz": round(rate_hz, 1),
            "expected_hz": round(expected_hz, 1),
        }
        yield AdviceState("stream_slow", "info", text, params)


def _look_at_simulator(observed: AdviceFacts) -> Iterator[AdviceState]:
    port = observed.silent_port
    if port is not None:
        text = f"The simulator sends nothing to UDP port {port}: check that it runs, its data output and its address."
        yield AdviceState("simulator_silent", "warning", text, {"port": port})
    else:
        for row, name in observed.missing_rows:
            text = f"Row {row} ({name}) is not being sent: tick it in the simulator's data output."
            level: Literal["info", "warning"] = "info" if row in _REPLACEABLE_ROWS else "warning"
            yield AdviceState("row_missing", level, text, {"row": row, "name": name})
    if observed.strangers:
        text = f"{observed.strangers} datagrams came from another machine and were dropped: correct the simulator's IP."
        yield AdviceState("foreign_datagrams", "info", text, {"count": observed.strangers})


def _look_at_loop(observed: AdviceFacts) -> Iterator[AdviceState]:
    ms = observed.round_trip_p99_ms
    if ms is not None and ms > _LONG_ROUND_TRIP_MS:
        text = f"One in a hundred answers of the HIL loop takes {ms:.0f} ms or longer: lower the rates of the streams."
        yield AdviceState("round_trip_long", "warning", text, {"ms": round(ms)})


_LOOKS: Final[tuple[Callable[[AdviceFacts], Iterator[AdviceState]], ...]] = (
    _look_at_board,
    _look_at_load,
    _look_at_damage,
    _look_at_simulator,
    _look_at_loop,
    _look_at_streams,
)
