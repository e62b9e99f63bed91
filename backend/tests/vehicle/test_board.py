"""The board's line: the opening dialogue, what is heard, and rubbish."""

from __future__ import annotations

from pathlib import Path

import pytest

from epf_gcs.codec.encode import encode_telemetry
from epf_gcs.flight.flight import Flight
from epf_gcs.link.address import parse_address
from tests.support.fake_board import FakeBoard
from tests.support.waiting import eventually_async

pytestmark = pytest.mark.anyio


async def an_open_station(folder: Path, board: FakeBoard) -> Flight:
    station = Flight(folder / "data", record=False)
    await station.supervisor.open(parse_address(board.url))
    return station


async def opened(station: Flight) -> None:
    def look() -> bool:
        station.board.tick()
        return station.board.is_open

    await eventually_async(look, "the board opens")


async def test_an_extended_board_is_asked_once_and_known(tmp_path: Path, board: FakeBoard) -> None:
    station = await an_open_station(tmp_path, board)
    await opened(station)
    assert station.board.session.is_extended
    assert station.board.capabilities()["firmware_name"] == "fake"
    assert board.received == ["capabilities"]
    station.supervisor.shut_down()


async def test_a_legacy_board_gets_no_second_extension_frame(tmp_path: Path, legacy_board: FakeBoard) -> None:
    station = await an_open_station(tmp_path, legacy_board)
    await opened(station)
    assert not station.board.session.is_extended
    await eventually_async(lambda: station.board.frames_received > 20, "it lives")
    assert legacy_board.received == ["capabilities"]
    station.supervisor.shut_down()


async def test_rubbish_hides_no_frame_and_is_counted(tmp_path: Path, board: FakeBoard) -> None:
    station = await an_open_station(tmp_path, board)
    await opened(station)
    good = encode_telemetry("gps", 27.9, -15.4, 30.0, 0.0, 0.0, 0x38, 0x31, 0x41)
    broken = bytearray(good)
    broken[12] ^= 1
    board.send(b"\x80\x81\x82" + bytes(broken) + good)
    await eventually_async(lambda: station.telemetry.newest("gps") is not None, "the good one is found")
    assert station.board.damage["bad_checksum"] == 1
    assert station.board.damage["noise"] >= 1
    assert station.board.frames_damaged == 1
    assert station.errors.counts["line_garbage"] >= 2
    station.supervisor.shut_down()


async def test_a_value_that_cannot_be_true_is_no_data_and_is_counted(tmp_path: Path, board: FakeBoard) -> None:
    station = await an_open_station(tmp_path, board)
    await opened(station)
    board.send(encode_telemetry("ahrs", 370.0, 5.0, float("nan")))
    await eventually_async(lambda: station.telemetry.newest("ahrs") is not None, "it is heard")
    assert station.telemetry.newest("ahrs") == {"yaw_deg": None, "pitch_deg": 5.0, "roll_deg": None}
    assert station.telemetry.summary()["ahrs"].implausible == {"yaw_deg": 1, "roll_deg": 1}
    station.supervisor.shut_down()


async def test_a_line_of_text_is_no_damage(tmp_path: Path, board: FakeBoard) -> None:
    station = await an_open_station(tmp_path, board)
    await opened(station)
    board.send(b"\rstatus: all is well\n")
    await eventually_async(lambda: station.board.damage["text"] >= 1, "it is read")
    assert station.board.frames_damaged == 0
    assert "line_garbage" not in station.errors.counts
    station.supervisor.shut_down()


async def test_text_without_a_line_end_is_read_after_a_silence(tmp_path: Path, board: FakeBoard) -> None:
    station = await an_open_station(tmp_path, board)
    await opened(station)
    board.silent = True
    board.send(b"prompt> ")

    def look() -> bool:
        station.board.tick()
        return station.board.damage["text"] >= 1

    await eventually_async(look, "the prompt is read")
    station.supervisor.shut_down()


async def test_nothing_is_written_without_a_line(tmp_path: Path) -> None:
    station = Flight(tmp_path / "data", record=False)
    assert not station.board.write(b"#QT\n")
    assert station.board.bytes_out == 0
    assert not station.board.is_open
