"""The whole state of the station in one object; the same for REST and for the stream."""

from __future__ import annotations

from dataclasses import asdict
from typing import Any

from epf_gcs import __version__
from epf_gcs.errors import GatewayError
from epf_gcs.flight.hil.simulator import CHANNEL_BYTES_PER_S
from epf_gcs.flight.station import Station
from epf_gcs.vehicle.wanted import RATE_COMMANDS, Wanted


def build_status(station: Station) -> dict[str, Any]:
    """Plain values, ready for JSON; its shape is `epf_gcs.web.schemas.Status`."""
    holder = station.control.holder
    return {
        "version": __version__,
        "server_time_s": station.clock.now_s(),
        "board": _board(station),
        "simulator": _simulator(station),
        "hil": hil_state(station),
        "control": {"client": holder.id if holder else None, "name": holder.name if holder else None},
        "recording": _recording(station),
        "alarms": [alarm.as_dict() for alarm in station.alarms.active],
        "errors": station.errors.counts,
        "topics": station.telemetry.summary(),
        "viewers": len(station.hub.viewers),
    }


def hil_state(station: Station) -> dict[str, Any]:
    """The two switches, and where the stick comes from; its shape is `epf_gcs.web.schemas.HilState`."""
    stick = station.stick
    pilot = stick.pilot
    return {
        "source": station.hil.source,
        "path": station.hil.path,
        "stick": {
            "source": stick.source,
            "state": stick.state,
            "client": None if pilot is None else pilot.id,
            "name": None if pilot is None else pilot.name,
            "gamepad": stick.gamepad,
            "samples": stick.counts,
        },
    }


def _board(station: Station) -> dict[str, Any]:
    board, supervisor = station.board, station.supervisor
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
        "ahrs_test": station.ahrs_test.stage,
        "emulated": board.is_emulated,
        "before_emulation_url": None if station.before_emulation is None else station.before_emulation.url,
        "periods_ms": _periods(station.memory.now.wanted),
        "heartbeat_age_s": station.telemetry.age_s("heartbeat"),
        "frames_received": board.frames_received,
        "frames_damaged": board.frames_damaged,
        "damage": board.damage,
        "bytes_in": board.bytes_in,
        "bytes_out": board.bytes_out,
        "rx_percent": _percent(station.rates.board_in.per_s(), bytes_per_s),
        "tx_percent": _percent(station.rates.board_out.per_s(), bytes_per_s),
    }


def _periods(wanted: Wanted) -> dict[str, Any]:
    return {
        task: {"ms": round(1000.0 * wanted.period_s(command)), "chosen": command in wanted.periods_ms}
        for task, command in zip(("parameters", "fms", "servos"), RATE_COMMANDS, strict=True)
    }


def _simulator(station: Station) -> dict[str, Any]:
    simulator, hil = station.simulator, station.hil
    address = simulator.address
    return {
        "state": simulator.state,
        "receive_port": address.receive_port if address else None,
        "send_host": address.send_host if address else None,
        "send_port": address.send_port if address else None,
        "profile": address.profile if address else None,
        "failure": _failure(simulator.failure),
        "rows": hil.rows,
        "missing_rows": hil.missing_rows if simulator.state == "open" else [],
        "advice": _advice(station),
        "datagrams_received": simulator.datagrams,
        "datagrams_dropped": sum(simulator.dropped.values()),
        "drop_reasons": simulator.dropped,
        "bytes_in": simulator.bytes_in,
        "percent": _percent(station.rates.simulator_in.per_s(), CHANNEL_BYTES_PER_S),
        "frames_to_board": hil.frames_to_board,
        "frames_to_simulator": hil.frames_to_simulator,
        "frames_skipped": hil.skipped,
        "hil_round_trip_ms": asdict(hil.round_trip.summary()),
    }


def _advice(station: Station) -> str | None:
    """What to do about a simulator that does not fly with us yet, where we can tell."""
    state, missing = station.simulator.state, station.hil.missing_rows
    address = station.simulator.address
    if state in ("opening", "lost") and address is not None and station.simulator.failure is None:
        return f"Nothing comes: let the simulator send its data output to UDP port {address.receive_port} here."
    if state == "open" and missing:
        return f"Rows {', '.join(map(str, missing))} are missing: tick them in the simulator's data output."
    return None


def _recording(station: Station) -> dict[str, Any]:
    recorder = station.recorder
    if recorder is None:
        return {"active": False, "file": None, "bytes": 0, "bytes_lost": 0, "failure": None}
    file = recorder.file
    return {
        "active": file is not None,
        "file": None if file is None else file.name,
        "bytes": recorder.bytes_written,
        "bytes_lost": recorder.bytes_lost,
        "failure": recorder.failure,
    }


def _failure(error: GatewayError | None) -> dict[str, Any] | None:
    return None if error is None else {"code": error.code, "detail": error.detail, "params": error.params}


def _percent(bytes_per_s: float, full: float) -> float:
    return round(100.0 * bytes_per_s / full, 1) if full else 0.0
