"""The HIL loop over a real socket and a real line: who moves the simulator, when, and with what."""

from __future__ import annotations

import math
import socket
import struct
from collections.abc import AsyncIterator, Iterator, Mapping
from pathlib import Path
from typing import Any

import pytest

from epf_gcs.bus.definition import Asker
from epf_gcs.codec.encode import encode_telemetry
from epf_gcs.contract.requests import ReadTelemetry
from epf_gcs.flight.flight import Flight
from epf_gcs.flight.hil.simulator import SimulatorAddress
from epf_gcs.link.address import EMULATION, parse_address
from epf_gcs.xplane.datagram import Record, Surfaces, build, release_datagram, surfaces_datagram
from tests.support.contract import as_told
from tests.support.fake_board import FakeBoard
from tests.support.ports import free_udp_port
from tests.support.simulator import ROWS, WHOLE, Simulator
from tests.support.waiting import eventually_async

pytestmark = pytest.mark.anyio

FROM_BOARD = surfaces_datagram(Surfaces(0.25, -0.5, 0.125, 0.75))
STICK = surfaces_datagram(Surfaces(0.25, -0.5, 0.125, 0.75))


@pytest.fixture
def simulator() -> Iterator[Simulator]:
    with Simulator() as end:
        yield end


@pytest.fixture
async def station(tmp_path: Path, simulator: Simulator) -> AsyncIterator[Flight]:
    made = Flight(tmp_path / "data", record=False)
    async with made.running():
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as probe:
            probe.bind(("127.0.0.1", 0))
            simulator.port = probe.getsockname()[1]
        await made.lines.open_simulator(SimulatorAddress(simulator.port, "127.0.0.1", simulator.own_port, "xp10"))
        yield made


async def connect(station: Flight, board: FakeBoard, source: str) -> None:
    await station.lines.open_board(parse_address(board.url))
    await eventually_async(lambda: station.supervisor.state == "open", "the board opens")
    await station.commands.run("control_source", (int(source == "joystick"),))
    await eventually_async(lambda: station.hil.source == source, "the source is known")


async def test_a_frame_of_the_simulator_becomes_command_50(
    station: Flight, simulator: Simulator, board: FakeBoard
) -> None:
    await connect(station, board, "joystick")
    simulator.send(WHOLE)
    await eventually_async(lambda: board.count("xplane_info") == 1, "the command arrives")
    info = board.arguments[board.received.index("xplane_info")]
    expected = (0.25, -0.5, 0.125, 0.75, -0.02, 0.01, 0.03, 270.0, 2.5, -10.25, 1235.75, 512.0, 95.5, 27.9319, -15.3866)
    assert info == struct.unpack("<15f", struct.pack("<15f", *expected))
    await eventually_async(lambda: station.hil.rows == sorted(ROWS), "its rows are counted")
    assert station.hil.missing_rows == []


async def test_rows_in_ten_datagrams_become_one_command(
    station: Flight, simulator: Simulator, board: FakeBoard
) -> None:
    await connect(station, board, "joystick")
    for _ in range(3):
        for row, values in ROWS.items():
            simulator.send(build([Record(row, values)]))
    await eventually_async(lambda: station.simulator.datagrams == 30, "all rows arrive")
    await eventually_async(lambda: board.count("xplane_info") >= 2, "the commands arrive")
    assert board.count("xplane_info") <= 3


async def test_without_a_row_nothing_goes_to_the_board(station: Flight, simulator: Simulator, board: FakeBoard) -> None:
    await connect(station, board, "joystick")
    simulator.send(build(Record(row, values) for row, values in ROWS.items() if row != 16))
    await eventually_async(lambda: station.simulator.datagrams == 1, "it arrives")
    assert station.hil.missing_rows == [16]
    assert station.hil.frames_to_board == 0


async def test_assisted_the_boards_surfaces_move_the_simulator(
    station: Flight, simulator: Simulator, board: FakeBoard
) -> None:
    await connect(station, board, "joystick")
    station.switches.choose_path("assisted")
    simulator.send(WHOLE)
    await eventually_async(lambda: simulator.heard(FROM_BOARD), "the surfaces arrive")
    assert len(simulator.got) == 1
    assert station.hil.round_trip.summary().newest is not None


async def test_manual_the_stick_moves_the_simulator_as_each_datagram_arrives(
    station: Flight, simulator: Simulator, board: FakeBoard
) -> None:
    await connect(station, board, "joystick")
    simulator.send(WHOLE)
    await eventually_async(lambda: simulator.heard(STICK), "the stick arrives")
    await eventually_async(lambda: station.hil.last_surfaces_s is not None, "the board answers too")
    assert len(simulator.got) == 1, "the board's surfaces are not sent on this path"


async def test_manual_the_rc_channels_move_the_simulator_as_each_frame_arrives(
    station: Flight, simulator: Simulator, board: FakeBoard
) -> None:
    await connect(station, board, "rc")
    channels = [-0.5, 0.25, 0.75, 0.125] + [0.0] * 8
    board.send(encode_telemetry("servos_in", *channels))
    await eventually_async(lambda: simulator.heard(surfaces_datagram(Surfaces(0.25, -0.5, 0.125, 0.75))), "they arrive")
    simulator.send(WHOLE)
    await eventually_async(lambda: board.count("xplane_info") == 1, "the board is told all the same")
    assert len(simulator.got) == 1, "the stick is ignored on this source"


async def test_assisted_the_rc_channels_do_not_move_the_simulator(
    station: Flight, simulator: Simulator, board: FakeBoard
) -> None:
    await connect(station, board, "rc")
    station.switches.choose_path("assisted")
    board.send(encode_telemetry("servos_in", *[0.5] * 12))
    board.send(encode_telemetry("hil_surfaces", 0.25, -0.5, 0.125, 0.75))
    await eventually_async(lambda: simulator.heard(FROM_BOARD), "the surfaces arrive")
    assert simulator.got == [FROM_BOARD]


async def test_what_a_simulator_sends_during_the_emulation_is_counted_and_goes_nowhere(
    station: Flight, simulator: Simulator
) -> None:
    await station.lines.open_board(EMULATION)
    before = station.hil.skipped["emulation"]
    simulator.send(WHOLE)
    await eventually_async(lambda: station.simulator.datagrams == 1, "it arrives")
    assert station.hil.skipped["emulation"] == before + 1
    assert station.hil.frames_to_board == station.hil.frames_to_simulator == 0


async def test_surfaces_beyond_their_limits_are_clamped_and_no_number_is_not_sent(
    station: Flight, simulator: Simulator, board: FakeBoard
) -> None:
    await connect(station, board, "joystick")
    station.switches.choose_path("assisted")
    board.send(encode_telemetry("hil_surfaces", math.nan, 0.0, 0.0, 0.0))
    await eventually_async(lambda: station.hil.skipped["surfaces_not_finite"] == 1, "it is counted")
    board.send(encode_telemetry("hil_surfaces", 5.0, -5.0, 0.0, 9.0))
    await eventually_async(lambda: simulator.heard(surfaces_datagram(Surfaces(1.0, -1.0, 0.0, 1.0))), "clamped")
    assert len(simulator.got) == 1


async def test_without_a_board_frames_are_counted_and_dropped_not_kept(
    station: Flight, simulator: Simulator, board: FakeBoard
) -> None:
    for _ in range(5):
        simulator.send(WHOLE)
    await eventually_async(lambda: station.hil.skipped["board_not_open"] == 5, "they are counted")
    await connect(station, board, "joystick")
    assert board.count("xplane_info") == 0, "old data is never sent"


async def test_to_a_line_on_which_no_board_has_spoken_no_frame_is_sent(
    station: Flight, simulator: Simulator, board: FakeBoard
) -> None:
    board.silent = True
    await station.lines.open_board(parse_address(board.url))
    await eventually_async(lambda: station.board.link is not None, "the line is there")
    simulator.send(WHOLE)
    await eventually_async(lambda: station.hil.skipped["board_not_open"] == 1, "it is counted")
    assert station.hil.frames_to_board == 0


async def test_a_frame_for_a_line_that_is_busy_is_counted_and_dropped(
    station: Flight, simulator: Simulator, board: FakeBoard, monkeypatch: pytest.MonkeyPatch
) -> None:
    await connect(station, board, "joystick")
    backlog = 257
    monkeypatch.setattr(type(station.board.link), "backlog", property(lambda _: backlog))
    simulator.send(WHOLE)
    await eventually_async(lambda: station.hil.skipped["line_busy"] == 1, "it is counted")
    assert station.hil.frames_to_board == 0
    backlog = 256
    simulator.send(WHOLE)
    await eventually_async(lambda: station.hil.frames_to_board == 1, "as soon as there is room the next one leaves")
    assert station.hil.skipped["line_busy"] == 1
    monkeypatch.setattr(station.board, "write", lambda _: False)
    simulator.send(WHOLE)
    await eventually_async(lambda: station.hil.skipped["line_busy"] == 2, "so is one that the line did not take")
    assert station.hil.frames_to_board == 1


async def test_the_viewers_see_every_row_by_name_and_raw(station: Flight, simulator: Simulator) -> None:
    simulator.send(WHOLE)
    await eventually_async(lambda: station.telemetry.newest("xplane_rows") is not None, "it is shown")
    named = station.telemetry.newest("simulator")
    raw = station.telemetry.newest("xplane_rows")
    assert named is not None
    assert raw is not None
    assert named["mach"] == pytest.approx(0.148)
    assert named["alpha_deg"] == 3.25
    assert raw["rows"]["17"][:3] == [2.5, -10.25, 135.0]


async def test_a_row_that_never_came_has_no_values(station: Flight, simulator: Simulator) -> None:
    simulator.send(build([Record(3, ROWS[3])]))
    await eventually_async(lambda: station.telemetry.newest("simulator") is not None, "it is shown")
    named = station.telemetry.newest("simulator")
    assert named is not None
    assert named["indicated_airspeed_kt"] == 95.5
    assert named["mach"] is None


async def test_closing_hands_the_controls_back(station: Flight, simulator: Simulator) -> None:
    await station.lines.close_simulator()
    await eventually_async(lambda: simulator.heard(release_datagram()), "the release arrives")
    assert station.simulator.state == "closed"


async def test_the_end_of_the_gateway_hands_the_controls_back(tmp_path: Path, simulator: Simulator) -> None:
    station = Flight(tmp_path / "data", record=False)
    async with station.running():
        await station.lines.open_simulator(SimulatorAddress(free_udp_port(), "127.0.0.1", simulator.own_port, "xp10"))
    await eventually_async(lambda: simulator.heard(release_datagram()), "the release arrives")


async def test_a_simulator_that_is_paused_in_flight_is_said_to_be_and_its_round_trips_are_not_counted(
    station: Flight, simulator: Simulator, board: FakeBoard
) -> None:
    await connect(station, board, "joystick")

    def alarms() -> set[str]:
        return {alarm.id for alarm in station.status().alarms if alarm.until_s is None}

    def paused(*, raised: bool) -> bool:
        simulator.send(WHOLE)
        return station.status().simulator.paused and ("simulator_paused" in alarms()) == raised

    await eventually_async(lambda: paused(raised=True), "it is paused, and the alarm comes")
    assert "hil_lost" not in alarms()
    newest = await station._requests[ReadTelemetry](ReadTelemetry(), Asker())
    assert {topic for topic, one in newest.items() if one.stale} >= {"simulator", "xplane_info"}, "not live"
    answers, sent = station.hil.round_trip.answers, station.hil.frames_to_board
    await eventually_async(lambda: paused(raised=True) and station.hil.frames_to_board > sent + 50, "rows go on")
    assert station.hil.round_trip.answers == answers
    moved = 0

    def moves() -> bool:
        nonlocal moved
        moved += 1
        rows = {**ROWS, 17: (2.5 + 0.01 * (moved % 2), *ROWS[17][1:])}
        simulator.send(build(Record(row, values) for row, values in rows.items()))
        alarms = {alarm.id for alarm in station.status().alarms if alarm.until_s is None}
        return "simulator_paused" not in alarms and not station.status().simulator.paused

    await eventually_async(moves, "it flies on, and the alarm goes")
    newest = await station._requests[ReadTelemetry](ReadTelemetry(), Asker())
    assert not newest["simulator"].stale
    await eventually_async(lambda: moves() and station.hil.round_trip.answers > answers, "and it is measured again")


async def test_an_aircraft_that_is_put_elsewhere_is_an_event_for_every_viewer(
    station: Flight, simulator: Simulator, monkeypatch: pytest.MonkeyPatch
) -> None:
    kept: list[tuple[str, Mapping[str, Any]]] = []
    monkeypatch.setattr(station.outlet, "event", lambda event: kept.append(as_told(event)))
    simulator.send(WHOLE)
    await eventually_async(lambda: station.simulator.datagrams == 1, "it is heard")
    elsewhere = {**ROWS, 20: (28.4532, -13.8661, *ROWS[20][2:])}
    simulator.send(build(Record(row, values) for row, values in elsewhere.items()))
    await eventually_async(lambda: "simulator_jumped" in {kind for kind, _ in kept}, "the event comes")
    (data,) = [data for kind, data in kept if kind == "simulator_jumped"]
    assert data["distance_m"] == pytest.approx(160_000, rel=0.02)
    assert data["latitude_deg"] == pytest.approx(28.4532)
