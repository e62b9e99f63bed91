"""Which lines are opened again, what is kept of one that was closed, and what the emulation leaves alone."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
import structlog

from epf_gcs.flight.flight import Flight
from epf_gcs.flight.hil.emulation import PROFILE
from epf_gcs.flight.hil.simulator import SimulatorAddress
from epf_gcs.flight.state.lines import LinkOpener
from epf_gcs.link.address import EMULATION, parse_address
from epf_gcs.xplane.datagram import Record, build
from tests.support.fake_board import FakeBoard
from tests.support.ports import free_udp_port
from tests.support.simulator import WHOLE, Simulator
from tests.support.waiting import eventually_async

pytestmark = pytest.mark.anyio


def a_station(folder: Path, *, record: bool = False) -> Flight:
    return Flight(folder / "data", record=record)


def an_address(send_port: int = 49000) -> SimulatorAddress:
    return SimulatorAddress(free_udp_port(), "127.0.0.1", send_port, "xp12")


async def test_the_lines_that_were_open_are_opened_at_the_next_start_and_one_that_was_closed_is_not(
    tmp_path: Path, board: FakeBoard
) -> None:
    address = an_address()
    station = a_station(tmp_path)
    async with station.running():
        await station.lines.open_board(parse_address(board.url))
        await station.lines.open_simulator(address)
    again = a_station(tmp_path)
    async with again.running():
        await eventually_async(lambda: again.simulator.is_listening, "the simulator is listened to again")
        assert again.simulator.address == address
        assert again.supervisor.address == parse_address(board.url)
        await again.lines.close_simulator()
        await again.lines.close_board()
    third = a_station(tmp_path)
    third.lines.reopen(None)
    assert (third.simulator.address, third.supervisor.address) == (None, None)


@pytest.mark.parametrize(
    "remembered", [{"board_url": "carrier pigeon"}, {"simulator": {"receive_port": 49001, "colour": "red"}}]
)
async def test_a_remembered_line_that_makes_no_sense_is_logged_and_the_flight_starts(
    tmp_path: Path, remembered: dict[str, Any]
) -> None:
    station = a_station(tmp_path)
    station.memory.update(**remembered)
    with structlog.testing.capture_logs() as logged:
        station.lines.reopen(None)
    assert [line["event"] for line in logged] == ["a remembered link cannot be opened"]
    assert (station.simulator.address, station.supervisor.address) == (None, None)


async def test_a_board_s_address_that_makes_no_sense_does_not_keep_the_simulator_closed(tmp_path: Path) -> None:
    station = a_station(tmp_path)
    simulator = an_address()
    station.memory.update(board_url="carrier pigeon", simulator=simulator.as_dict())
    station.lines.reopen(None)
    assert (station.supervisor.address, station.simulator.address) == (None, simulator)


async def test_the_device_behind_an_open_line_is_remembered_until_it_is_closed(tmp_path: Path) -> None:
    station = a_station(tmp_path)
    station.supervisor.find_devices_by(lambda _: "usb-1", lambda _: None)
    async with station.running():
        with FakeBoard(tmp_path / "ttyUSB0") as board:
            await station.lines.open_board(parse_address(f"serial://{board.path}"))
            assert station.memory.now.board_identity == "usb-1"
            await station.lines.close_board()
            assert station.memory.now.board_identity is None


@pytest.mark.parametrize("is_remembered", [True, False])
async def test_after_the_emulation_the_line_of_before_is_found_by_its_device_if_it_is_the_one_remembered(
    tmp_path: Path, *, is_remembered: bool
) -> None:
    station = a_station(tmp_path)
    station.supervisor.find_devices_by(lambda _: "usb-1", lambda _: None)
    before = parse_address("serial:///dev/ttyUSB0")
    station.supervisor.want(before, None)
    remembered = before.url if is_remembered else "serial:///dev/ttyUSB1?baud=115200"
    station.memory.update(board_url=remembered, board_identity="usb-1")
    await station.lines.open_board(EMULATION)
    assert station.lines.before_emulation == before
    await station.lines.close_board()
    assert station.supervisor.address == before
    assert station.supervisor.identity == ("usb-1" if is_remembered else None)
    assert station.lines.before_emulation is None


async def test_the_emulation_comes_and_goes_without_touching_a_simulator_that_is_connected(tmp_path: Path) -> None:
    with Simulator() as simulator:
        station = a_station(tmp_path)
        async with station.running():
            address = an_address(simulator.own_port)
            await station.lines.open_simulator(address)
            link = station.hil.link
            assert link is not None
            await station.lines.open_board(EMULATION)
            assert station.hil.link is link
            heard = station.simulator.datagrams
            simulator.socket.sendto(WHOLE, ("127.0.0.1", address.receive_port))
            await eventually_async(lambda: station.simulator.datagrams == heard + 1, "its datagram is heard")
            await station.lines.close_board()
            assert station.hil.link is link


async def test_example_values_are_used_only_while_no_simulator_is_connected(tmp_path: Path) -> None:
    hil = a_station(tmp_path).hil
    hil.begin(None, PROFILE)
    is_simulated = [True]
    opener = LinkOpener(hil, lambda: is_simulated[0])
    opener._take_example(build([Record(3, (0.0,) * 8)]))
    is_simulated[0] = False
    opener._take_example(build([Record(20, (0.0,) * 8)]))
    await eventually_async(lambda: bool(hil.rows), "it is shown")
    assert hil.rows == [20]


@pytest.mark.parametrize("last", ["board", "simulator"])
async def test_a_recording_ends_with_the_last_of_its_lines(
    tmp_path: Path, board: FakeBoard, monkeypatch: pytest.MonkeyPatch, last: str
) -> None:
    station = a_station(tmp_path, record=True)
    assert station.recorder is not None
    ended: list[str] = []
    async with station.running():
        await station.lines.open_board(parse_address(board.url))
        await station.lines.open_simulator(an_address())
        with monkeypatch.context() as recording:
            recording.setattr(station.recorder, "end_session", lambda: ended.append(last))
            close_board, close_simulator = station.lines.close_board, station.lines.close_simulator
            first, second = (close_simulator, close_board) if last == "board" else (close_board, close_simulator)
            await first()
            assert ended == [], "the other line is still there"
            await second()
            assert ended == [last]
