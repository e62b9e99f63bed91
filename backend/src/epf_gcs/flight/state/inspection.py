"""Counts and rates of all messages on the lines: calculated on request, from counters kept all the time.

In two steps: `take_snapshot` only copies, for it blocks the event loop and with it the HIL loop; `build_inspector`
calculates and may run in a thread.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Final

from epf_gcs.codec.messages_gen import TELEMETRY_BY_NAME, XPLANE_ROWS
from epf_gcs.contract.inspector import InspectedLink, Inspector
from epf_gcs.flight.hil.simulator import CHANNEL_BYTES_PER_S
from epf_gcs.flight.state.sources import StateSources
from epf_gcs.vehicle.advice import AdviceFacts, MissingRow, Stream, advice
from epf_gcs.vehicle.arrivals import Arrivals
from epf_gcs.vehicle.health import TASK_OF_TOPIC
from epf_gcs.vehicle.inspection import (
    EXPECTED_ROWS,
    CountedFrame,
    copy_frames,
    inspect_frames,
    inspect_rows,
    share_percent,
)
from epf_gcs.vehicle.wanted import RATE_COMMANDS, STREAM_FLAGS

_SERVO_STREAMS: Final = ("servos_in", "fly_by_wire")
_FRAME_BYTES: Final = 16  # header, type, checksum and end
_LOOP_ALIVE_S: Final = 1.0
_SILENT_S: Final = 3.0
_STRANGERS_S: Final = 10.0


@dataclass(frozen=True, slots=True)
class Snapshot:
    """All inputs of an answer. `expected_hz`: the rate that each enabled stream should reach.

    `now_s` is the Unix time of frames and rows.
    """

    now_s: float
    frames: Sequence[CountedFrame]
    rows: Mapping[int, Arrivals]
    profile: str
    link: InspectedLink
    observed: AdviceFacts
    expected_hz: Mapping[str, float]


def take_snapshot(parts: StateSources) -> Snapshot:
    """Copy the counters."""
    link = _link(parts)
    return Snapshot(
        now_s=parts.clock.now_s(),
        frames=copy_frames(parts.board.frame_statistics, parts.telemetry),
        rows={row: arrivals.copy() for row, arrivals in parts.hil.arrivals.items()},
        profile=parts.hil.profile,
        link=link,
        observed=_observed(parts, link),
        expected_hz=_expected_hz(parts) if parts.board.is_open else {},
    )


def build_inspector(snapshot: Snapshot) -> Inspector:
    """Calculate rates, jitter and advice."""
    board = inspect_frames(snapshot.frames, snapshot.now_s)
    rate_hz = {frame.name: frame.rate_hz for frame in board}
    observed = replace(
        snapshot.observed,
        streams=[Stream(topic, rate_hz[topic], hz) for topic, hz in snapshot.expected_hz.items()],
        servos_percent=share_percent(_servo_bytes_per_s(rate_hz), snapshot.link.capacity_bytes_per_s),
    )
    return Inspector(
        t_s=snapshot.now_s,
        board=board,
        rows=inspect_rows(snapshot.rows, snapshot.profile, snapshot.now_s),
        link=snapshot.link,
        advice=list(advice(observed)),
    )


def _link(parts: StateSources) -> InspectedLink:
    rates, board = parts.rates, parts.board
    capacity = board.baud / 10.0 if board.link is not None else None
    rx, tx, simulator = rates.board_in.per_s(), rates.board_out.per_s(), rates.simulator_in.per_s()
    return InspectedLink(
        rx_bytes_per_s=round(rx, 1),
        tx_bytes_per_s=round(tx, 1),
        capacity_bytes_per_s=capacity,
        rx_percent=share_percent(rx, capacity),
        tx_percent=share_percent(tx, capacity),
        simulator_bytes_per_s=round(simulator, 1),
        simulator_percent=share_percent(simulator, CHANNEL_BYTES_PER_S) or 0.0,
        round_trip_ms=parts.hil.round_trip.summary(),
        round_trips=parts.hil.round_trip.answers,
    )


def _observed(parts: StateSources, link: InspectedLink) -> AdviceFacts:
    """The observations that need no rate."""
    surfaces_s = parts.hil.last_surfaces_s
    is_alive = surfaces_s is not None and parts.clock.steady_s() - surfaces_s < _LOOP_ALIVE_S
    return AdviceFacts(
        silent_target=_silent_target(parts),
        rubbish_at_baud=_rubbish_at_baud(parts),
        rx_percent=link.rx_percent,
        tx_percent=link.tx_percent,
        servos_ms=round(1000.0 * parts.memory.now.wanted.period_s(RATE_COMMANDS[2])),
        damaged_percent=parts.watch.damaged_percent,
        damaged_limit_percent=parts.alarms.thresholds["frames_damaged_percent"],
        silent_port=_silent_port(parts),
        missing_rows=_missing_rows(parts) if parts.simulator.state == "open" else (),
        strangers=_strangers(parts),
        round_trip_p99_ms=link.round_trip_ms.p99 if is_alive else None,
    )


def _silent_target(parts: StateSources) -> str | None:
    address = parts.supervisor.address
    if address is None:
        return None
    age_s = parts.board.heartbeat_age_s()
    limit_s = max(_SILENT_S, parts.telemetry.stale_after_s("heartbeat") or 0.0)
    is_heard = parts.board.link is not None and age_s is not None and age_s <= limit_s
    return None if is_heard else address.target


def _rubbish_at_baud(parts: StateSources) -> int | None:
    address = parts.supervisor.address
    is_rubbish = address is not None and address.scheme == "serial" and parts.board.hears_only_rubbish
    return parts.board.baud if is_rubbish else None


def _silent_port(parts: StateSources) -> int | None:
    address = parts.simulator.address
    is_silent = address is not None and parts.simulator.state in ("opening", "lost")
    return address.receive_port if address is not None and is_silent else None


def _missing_rows(parts: StateSources) -> list[MissingRow]:
    definitions = XPLANE_ROWS[parts.hil.profile]
    return [MissingRow(row, definitions[row].name) for row in sorted(EXPECTED_ROWS - set(parts.hil.rows))]


def _strangers(parts: StateSources) -> int:
    """Number of datagrams from unknown senders; 0 if none came recently."""
    last_s = parts.simulator.last_stranger_s
    is_recent = last_s is not None and parts.clock.steady_s() - last_s < _STRANGERS_S
    return parts.simulator.dropped["stranger"] if is_recent else 0


def _expected_hz(parts: StateSources) -> dict[str, float]:
    """Expected rate of each stream that is on, according to the board's heartbeat or else to our own requests."""
    heartbeat = parts.telemetry.newest("heartbeat") or {}
    wanted = parts.memory.now.wanted.streams
    expected: dict[str, float] = {}
    for topic in TASK_OF_TOPIC:
        flag = STREAM_FLAGS.get(topic)
        is_on = topic == "heartbeat" or (topic in wanted if flag is None else heartbeat.get(flag) is True)
        period_s = parts.telemetry.commanded_s(topic)
        if is_on and period_s:
            expected[topic] = 1.0 / period_s
    return expected


def _servo_bytes_per_s(rate_hz: Mapping[str, float]) -> float:
    return sum(rate_hz[name] * (TELEMETRY_BY_NAME[name].size + _FRAME_BYTES) for name in _SERVO_STREAMS)
