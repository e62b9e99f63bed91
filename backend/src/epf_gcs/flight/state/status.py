"""The state of a flight in one object: links, HIL, recording, alarms, errors and topics."""

from __future__ import annotations

from dataclasses import asdict, dataclass
from typing import Any

from epf_gcs.bus.definition import client_fields
from epf_gcs.clock import Clock
from epf_gcs.error_log import ErrorLog
from epf_gcs.errors import GatewayError
from epf_gcs.flight.board.ahrs_test import AhrsTestRun
from epf_gcs.flight.board.board_link import Supervisor
from epf_gcs.flight.hil.hil import Hil
from epf_gcs.flight.hil.simulator import CHANNEL_BYTES_PER_S, Simulator
from epf_gcs.flight.memory.memory import Memory
from epf_gcs.flight.recording.recorder import Recorder
from epf_gcs.flight.state.line_rates import LineRates
from epf_gcs.flight.state.lines import Lines
from epf_gcs.vehicle.alarms import Alarms
from epf_gcs.vehicle.board import Board
from epf_gcs.vehicle.telemetry import Telemetry
from epf_gcs.vehicle.wanted import RATE_COMMANDS, Wanted


@dataclass(frozen=True, slots=True)
class StatusSources:
    """The parts whose state is shown."""

    clock: Clock
    errors: ErrorLog
    memory: Memory
    board: Board
    telemetry: Telemetry
    supervisor: Supervisor
    lines: Lines
    simulator: Simulator
    hil: Hil
    rates: LineRates
    ahrs_test: AhrsTestRun
    recorder: Recorder | None
    alarms: Alarms


def build_status(parts: StatusSources) -> dict[str, Any]:
    """Plain values, ready for JSON. The web process adds version, control and viewers."""
    return {
        "server_time_s": parts.clock.now_s(),
        "board": _board(parts),
        "simulator": _simulator(parts),
        "hil": hil_state(parts.hil),
        "recording": _recording(parts),
        "alarms": [alarm.as_dict() for alarm in parts.alarms.active],
        "errors": parts.errors.counts,
        "topics": parts.telemetry.summary(),
    }


def hil_state(hil: Hil) -> dict[str, Any]:
    """Source, path and stick of the HIL loop; its shape is `epf_gcs.contract.shapes.HilState`."""
    stick = hil.stick
    return {
        "source": hil.source,
        "path": hil.path,
        "stick": {
            "source": stick.source,
            "state": stick.state,
            **client_fields(stick.pilot),
            "gamepad": stick.gamepad,
            "samples": stick.counts,
        },
    }


def _board(parts: StatusSources) -> dict[str, Any]:
    board, supervisor = parts.board, parts.supervisor
    capabilities = board.capabilities()
    known = board.session.is_open
    bytes_per_s = board.baud / 10.0
    return {
        "state": supervisor.state,
        "url": None if supervisor.address is None else supervisor.address.url,
        "failure": _failure(supervisor.failure),
        "reopened": supervisor.reopened,
        "mode": None if not known else "extended" if board.session.is_extended else "legacy",
        "features": {
            name: bool(capabilities.get(f"has_{name}")) for name in ("acknowledgements", "store", "sources", "missions")
        },
        "firmware": None
        if not capabilities
        else {"name": capabilities["firmware_name"], "version": capabilities["firmware_version"]},
        "ahrs_test": parts.ahrs_test.stage,
        "emulated": board.is_emulated,
        "before_emulation_url": None if parts.lines.before_emulation is None else parts.lines.before_emulation.url,
        "periods_ms": _periods(parts.memory.now.wanted),
        "heartbeat_age_s": parts.telemetry.age_s("heartbeat"),
        "frames_received": board.frames_received,
        "frames_damaged": board.frames_damaged,
        "damage": board.damage,
        "bytes_in": board.bytes_in,
        "bytes_out": board.bytes_out,
        "rx_percent": _percent(parts.rates.board_in.per_s(), bytes_per_s),
        "tx_percent": _percent(parts.rates.board_out.per_s(), bytes_per_s),
    }


def _periods(wanted: Wanted) -> dict[str, Any]:
    return {
        task: {"ms": round(1000.0 * wanted.period_s(command)), "chosen": command in wanted.periods_ms}
        for task, command in zip(("parameters", "fms", "servos"), RATE_COMMANDS, strict=True)
    }


def _simulator(parts: StatusSources) -> dict[str, Any]:
    simulator, hil = parts.simulator, parts.hil
    address = simulator.address
    return {
        "state": simulator.state,
        "receive_port": address.receive_port if address else None,
        "send_host": address.send_host if address else None,
        "send_port": address.send_port if address else None,
        "profile": address.profile if address else None,
        "fitting_profile": hil.fitting_profile,
        "failure": _failure(simulator.failure),
        "rows": hil.rows,
        "missing_rows": hil.missing_rows if simulator.state == "open" else [],
        "unusable": [value.params for value in hil.unusable] if simulator.state == "open" else [],
        "paused": hil.is_paused,
        "advice": _advice(parts),
        "datagrams_received": simulator.datagrams,
        "datagrams_dropped": sum(simulator.dropped.values()),
        "drop_reasons": simulator.dropped,
        "bytes_in": simulator.bytes_in,
        "percent": _percent(parts.rates.simulator_in.per_s(), CHANNEL_BYTES_PER_S),
        "frames_to_board": hil.frames_to_board,
        "frames_to_simulator": hil.frames_to_simulator,
        "frames_skipped": hil.skipped,
        "hil_round_trip_ms": asdict(hil.round_trip.summary()),
    }


def _advice(parts: StatusSources) -> str | None:
    """What the operator should do about a simulator that is not in the loop yet; None if unknown."""
    state, missing = parts.simulator.state, parts.hil.missing_rows
    address = parts.simulator.address
    if state in ("opening", "lost") and address is not None and parts.simulator.failure is None:
        return f"Nothing comes: let the simulator send its data output to UDP port {address.receive_port} here."
    if state == "open" and missing:
        return f"Rows {', '.join(map(str, missing))} are missing: tick them in the simulator's data output."
    return None


def _recording(parts: StatusSources) -> dict[str, Any]:
    recorder = parts.recorder
    if recorder is None:
        return {
            "active": False,
            "file": None,
            "bytes": 0,
            "bytes_lost": 0,
            "failure": None,
            "free_bytes": None,
            "hours_left": None,
        }
    file = recorder.file
    return {
        "active": file is not None,
        "file": None if file is None else file.name,
        "bytes": recorder.bytes_written,
        "bytes_lost": recorder.bytes_lost,
        "failure": recorder.failure,
        "free_bytes": recorder.free_bytes,
        "hours_left": recorder.hours_left,
    }


def _failure(error: GatewayError | None) -> dict[str, Any] | None:
    return None if error is None else {"code": error.code, "detail": error.detail, "params": error.params}


def _percent(bytes_per_s: float, full: float) -> float:
    return round(100.0 * bytes_per_s / full, 1) if full else 0.0
