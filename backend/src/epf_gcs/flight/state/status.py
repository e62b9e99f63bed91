"""The state of a flight in one object: links, HIL, recording, alarms, errors and topics."""

from __future__ import annotations

from epf_gcs.contract.status import BoardStatus, Failure, HilState, RecordingState, SimulatorStatus, Status, StickState
from epf_gcs.errors import GatewayError
from epf_gcs.flight.hil.hil import Hil
from epf_gcs.flight.hil.simulator import CHANNEL_BYTES_PER_S
from epf_gcs.flight.recording.recorder import Recorder
from epf_gcs.flight.state.sources import StateSources
from epf_gcs.vehicle.board_facts import features_of, firmware_of, percent, periods_of


def build_status(parts: StateSources) -> Status:
    """What the flight process knows of it; the web process adds version, control, surroundings and viewers."""
    return Status(
        server_time_s=parts.clock.now_s(),
        board=_board(parts),
        simulator=_simulator(parts),
        hil=hil_state(parts.hil),
        recording=_recording(parts.recorder),
        alarms=[alarm.state for alarm in parts.alarms.active],
        errors=dict(parts.errors.counts),
        topics=parts.telemetry.summary(),
    )


def hil_state(hil: Hil) -> HilState:
    """Source, path and stick of the HIL loop."""
    stick, pilot = hil.stick, hil.stick.pilot
    return HilState(
        source=hil.source,
        path=hil.path,
        stick=StickState(
            source=stick.source,
            state=stick.state,
            client=None if pilot is None else pilot.id,
            name=None if pilot is None else pilot.name,
            gamepad=stick.gamepad,
            samples=dict(stick.counts),
        ),
    )


def _board(parts: StateSources) -> BoardStatus:
    board, supervisor = parts.board, parts.supervisor
    capabilities = board.capabilities()
    bytes_per_s = board.baud / 10.0
    return BoardStatus(
        state=supervisor.state,
        url=None if supervisor.address is None else supervisor.address.url,
        failure=_failure(supervisor.failure),
        reopened=supervisor.reopened,
        mode=None if not board.session.is_open else "extended" if board.session.is_extended else "legacy",
        features=features_of(capabilities),
        firmware=firmware_of(capabilities),
        ahrs_test=parts.ahrs_test.stage,
        emulated=board.is_emulated,
        before_emulation_url=None if parts.lines.before_emulation is None else parts.lines.before_emulation.url,
        periods_ms=periods_of(parts.memory.now.wanted),
        heartbeat_age_s=parts.telemetry.age_s("heartbeat"),
        frames_received=board.frames_received,
        frames_damaged=board.frames_damaged,
        damage=dict(board.damage),
        bytes_in=board.bytes_in,
        bytes_out=board.bytes_out,
        rx_percent=percent(parts.rates.board_in.per_s(), bytes_per_s),
        tx_percent=percent(parts.rates.board_out.per_s(), bytes_per_s),
    )


def _simulator(parts: StateSources) -> SimulatorStatus:
    simulator, hil = parts.simulator, parts.hil
    address = simulator.address
    return SimulatorStatus(
        state=simulator.state,
        receive_port=address.receive_port if address else None,
        send_host=address.send_host if address else None,
        send_port=address.send_port if address else None,
        tells_rows=address is not None and address.tells_rows,
        profile=address.profile if address else None,
        fitting_profile=hil.fitting_profile,
        failure=_failure(simulator.failure),
        rows=hil.rows,
        missing_rows=hil.missing_rows if simulator.state == "open" else [],
        unusable=[value.state for value in hil.unusable] if simulator.state == "open" else [],
        paused=hil.is_paused,
        faults=parts.faults.flown,
        advice=_advice(parts),
        datagrams_received=simulator.datagrams,
        datagrams_dropped=sum(simulator.dropped.values()),
        drop_reasons=dict(simulator.dropped),
        bytes_in=simulator.bytes_in,
        percent=percent(parts.rates.simulator_in.per_s(), CHANNEL_BYTES_PER_S),
        frames_to_board=hil.frames_to_board,
        frames_to_simulator=hil.frames_to_simulator,
        frames_skipped=dict(hil.skipped),
        hil_round_trip_ms=hil.round_trip.summary(),
    )


def _advice(parts: StateSources) -> str | None:
    """What the operator should do about a simulator that is not in the loop yet; None if unknown."""
    state, missing = parts.simulator.state, parts.hil.missing_rows
    address = parts.simulator.address
    if state in ("opening", "lost") and address is not None and parts.simulator.failure is None:
        return f"Nothing comes: let the simulator send its data output to UDP port {address.receive_port} here."
    if state == "open" and missing:
        return f"Rows {', '.join(map(str, missing))} are missing: tick them in the simulator's data output."
    return None


def _recording(recorder: Recorder | None) -> RecordingState:
    if recorder is None:
        return RecordingState()
    file = recorder.file
    return RecordingState(
        active=file is not None,
        file=None if file is None else file.name,
        bytes=recorder.bytes_written,
        bytes_lost=recorder.bytes_lost,
        failure=recorder.failure,
        free_bytes=recorder.free_bytes,
        hours_left=recorder.hours_left,
    )


def _failure(error: GatewayError | None) -> Failure | None:
    return None if error is None else Failure(error.code, error.detail, error.params)
