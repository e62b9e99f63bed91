"""The status of a flight at a moment of its recording, in the live one's shape; what no recording tells is null."""

from __future__ import annotations

from typing import Final

from epf_gcs.codec.session import SessionState
from epf_gcs.contract.base import LinkState
from epf_gcs.contract.simulator_faults import noted_faults
from epf_gcs.contract.status import BoardStatus, HilState, RecordingState, SimulatorStatus, Status, StickState
from epf_gcs.replay.playhead import Playhead
from epf_gcs.vehicle.board_facts import features_of, firmware_of, percent, periods_of

CHANNEL_BYTES_PER_S: Final = 73_000


def build_status(head: Playhead, file: str, size: int) -> Status:
    """`file` and `size` (bytes) are the recording's. Its round trips are not told: the times of a recording are shared
    by reads a millisecond apart, too coarse for this figure."""
    return Status(
        server_time_s=head.clock.now_s(),
        board=_board(head),
        simulator=_simulator(head),
        hil=_hil(head),
        recording=RecordingState(file=file, bytes=size, bytes_lost=head.known.now.lost_bytes),
        alarms=head.alarms,
        errors=dict(head.errors.counts),
        topics=head.vehicle.telemetry.summary(),
    )


def _board(head: Playhead) -> BoardStatus:
    board, known = head.vehicle.board, head.known
    line = known.now.lines["board"]
    capabilities = known.now.identity.get("board") or board.capabilities()
    state = _heard(head) if board.link is not None else line.said
    return BoardStatus(
        state=state,
        url=line.url,
        mode=None if state != "open" else "extended" if capabilities else "legacy",
        features=features_of(capabilities),
        firmware=firmware_of(capabilities),
        ahrs_test="off" if board.exclusive_user is None else "running",
        emulated=board.is_emulated,
        periods_ms=periods_of(known.wanted),
        heartbeat_age_s=head.vehicle.telemetry.age_s("heartbeat"),
        frames_received=board.frames_received,
        frames_damaged=board.frames_damaged,
        damage=dict(board.damage),
        bytes_in=board.bytes_in,
        bytes_out=head.bytes_sent,
        rx_percent=percent(head.board_in.per_s(), board.baud / 10.0),
        tx_percent=percent(head.board_out.per_s(), board.baud / 10.0),
    )


def _simulator(head: Playhead) -> SimulatorStatus:
    simulator, known, now_s = head.vehicle.simulator, head.known, head.clock.now_s()
    line = known.now.lines["simulator"]
    rows = simulator.rows(now_s)
    heard: LinkState | None = "open" if rows else "lost" if simulator.arrivals else None
    state: LinkState = (heard or "opening") if line.open else line.said if known.now.has_lines else heard or "closed"
    return SimulatorStatus(
        state=state,
        profile=simulator.profile if state != "closed" else None,
        fitting_profile=simulator.fitting_profile,
        rows=rows,
        missing_rows=simulator.missing_rows(now_s) if state == "open" else [],
        unusable=[value.state for value in simulator.unusable(now_s)] if state == "open" else [],
        paused=simulator.motion.is_paused(now_s),
        faults=noted_faults(known.event("faults")),
        datagrams_received=simulator.datagrams,
        datagrams_dropped=head.datagrams_dropped,
        drop_reasons={"malformed": head.datagrams_dropped} if head.datagrams_dropped else {},
        bytes_in=simulator.bytes_in,
        percent=percent(head.simulator_in.per_s(), CHANNEL_BYTES_PER_S),
        frames_to_board=head.frames_to_board,
        frames_to_simulator=head.frames_to_simulator,
    )


def _hil(head: Playhead) -> HilState:
    joystick = (head.vehicle.telemetry.newest("heartbeat") or {}).get("source_joystick")
    stick = head.known.event("stick")
    is_gamepad = stick.get("source") == "gamepad"
    return HilState(
        source=None if joystick is None else "joystick" if joystick else "rc",
        path="assisted" if head.known.event("hil").get("path") == "assisted" else "manual",
        stick=StickState(
            source="gamepad" if is_gamepad else "simulator",
            state=stick.get("state"),
            client=stick.get("client"),
            name=stick.get("name"),
            gamepad=stick.get("gamepad") if is_gamepad else None,
        ),
    )


def _heard(head: Playhead) -> LinkState:
    """The state of the board's open line, as `Supervisor.state` gives it live."""
    board = head.vehicle.board
    if board.is_open or board.exclusive_user is not None:
        return "open"
    is_silent = board.session.state is SessionState.OPENING and board.session.heartbeat_s is not None
    return "lost" if is_silent else "opening"
