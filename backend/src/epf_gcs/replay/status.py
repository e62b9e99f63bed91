"""The status of a flight at a moment of its recording, in the live one's shape; what no recording tells is null."""

from __future__ import annotations

from typing import Any, Final

from epf_gcs.codec.session import SessionState
from epf_gcs.replay.playhead import Playhead
from epf_gcs.vehicle.wanted import RATE_COMMANDS

_FEATURES: Final = ("acknowledgements", "store", "sources", "missions")
_TASKS: Final = ("parameters", "fms", "servos")
CHANNEL_BYTES_PER_S: Final = 73_000


def build_status(head: Playhead, file: str, size: int) -> dict[str, Any]:
    """Plain values, as `epf_gcs.flight.state.status.build_status` gives them; `size` is the recording's in bytes."""
    known = head.known
    return {
        "server_time_s": head.clock.now_s(),
        "board": _board(head),
        "simulator": _simulator(head),
        "hil": _hil(head),
        "recording": {
            "active": False,
            "file": file,
            "bytes": size,
            "bytes_lost": known.now["lost_bytes"],
            "failure": None,
            "free_bytes": None,
            "hours_left": None,
        },
        "alarms": head.alarms,
        "errors": dict(head.errors.counts),
        "topics": head.vehicle.telemetry.summary(),
    }


def _board(head: Playhead) -> dict[str, Any]:
    board, known = head.vehicle.board, head.known
    line = known.lines["board"]
    capabilities = known.now["identity"].get("board") or board.capabilities()
    state = _heard(head) if board.link is not None else line["said"]
    is_extended = bool(capabilities)
    return {
        "state": state,
        "url": line["url"],
        "failure": None,
        "reopened": 0,
        "mode": None if state != "open" else "extended" if is_extended else "legacy",
        "features": {name: bool(capabilities.get(f"has_{name}")) for name in _FEATURES},
        "firmware": {"name": capabilities.get("firmware_name"), "version": capabilities.get("firmware_version")}
        if is_extended
        else None,
        "ahrs_test": "off" if board.exclusive_user is None else "running",
        "emulated": board.is_emulated,
        "before_emulation_url": None,
        "periods_ms": {
            task: {"ms": round(1000.0 * known.period_s(command)), "chosen": command in known.now["periods_ms"]}
            for task, command in zip(_TASKS, RATE_COMMANDS, strict=True)
        },
        "heartbeat_age_s": head.vehicle.telemetry.age_s("heartbeat"),
        "frames_received": board.frames_received,
        "frames_damaged": board.frames_damaged,
        "damage": dict(board.damage),
        "bytes_in": board.bytes_in,
        "bytes_out": head.bytes_sent,
        "rx_percent": _percent(head.board_in.per_s(), board.baud / 10.0),
        "tx_percent": _percent(head.board_out.per_s(), board.baud / 10.0),
    }


def _simulator(head: Playhead) -> dict[str, Any]:
    simulator, known, now_s = head.vehicle.simulator, head.known, head.clock.now_s()
    line = known.lines["simulator"]
    rows = simulator.rows(now_s)
    heard = "open" if rows else "lost" if simulator.arrivals else None
    state = (heard or "opening") if line["open"] else line["said"] if known.now["has_lines"] else heard or "closed"
    return {
        "state": state,
        "receive_port": None,
        "send_host": None,
        "send_port": None,
        "profile": simulator.profile if state != "closed" else None,
        "fitting_profile": simulator.fitting_profile,
        "failure": None,
        "rows": rows,
        "missing_rows": simulator.missing_rows(now_s) if state == "open" else [],
        "unusable": [value.params for value in simulator.unusable(now_s)] if state == "open" else [],
        "paused": simulator.motion.is_paused(now_s),
        "advice": None,
        "datagrams_received": simulator.datagrams,
        "datagrams_dropped": head.datagrams_dropped,
        "drop_reasons": {"malformed": head.datagrams_dropped} if head.datagrams_dropped else {},
        "bytes_in": simulator.bytes_in,
        "percent": _percent(head.simulator_in.per_s(), CHANNEL_BYTES_PER_S),
        "frames_to_board": head.frames_to_board,
        "frames_to_simulator": head.frames_to_simulator,
        "frames_skipped": {},
        # The times of a recording are shared by reads a millisecond apart: too coarse for this figure.
        "hil_round_trip_ms": {"newest": None, "p50": None, "p99": None},
    }


def _hil(head: Playhead) -> dict[str, Any]:
    joystick = (head.vehicle.telemetry.newest("heartbeat") or {}).get("source_joystick")
    stick = head.known.event("stick")
    return {
        "source": None if joystick is None else "joystick" if joystick else "rc",
        "path": "assisted" if head.known.event("hil").get("path") == "assisted" else "manual",
        "stick": {
            "source": "gamepad" if stick.get("source") == "gamepad" else "simulator",
            "state": stick.get("state"),
            "client": stick.get("client"),
            "name": stick.get("name"),
            "gamepad": stick.get("gamepad") if stick.get("source") == "gamepad" else None,
            "samples": {},
        },
    }


def _heard(head: Playhead) -> str:
    """The state of the board's open line, as `Supervisor.state` gives it live."""
    board = head.vehicle.board
    if board.is_open or board.exclusive_user is not None:
        return "open"
    is_silent = board.session.state is SessionState.OPENING and board.session.heartbeat_s is not None
    return "lost" if is_silent else "opening"


def _percent(bytes_per_s: float, full: float) -> float:
    return round(100.0 * bytes_per_s / full, 1) if full else 0.0
