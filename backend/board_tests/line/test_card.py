"""The running board's card: what outlives a power cut, and what the board says when it cannot be read or written."""

from __future__ import annotations

import signal
import struct
import zlib
from collections.abc import Callable
from pathlib import Path

import pytest

from board_tests.line.conftest import Boards
from board_tests.line.station import Board, Station
from board_tests.line.test_missions import FLIGHT, HIL, SQUARE, read, upload
from board_tests.line.test_own_gains import LAW, LINE, value_of
from board_tests.line.test_parameters import DEFAULTS, loaded

DONE, STORAGE_FAILED = 0, 4
HAS_CARD_ALARM = 0x10


def alarms(station: Station) -> bool:
    """What the board tells of its card when it is asked what it can do."""
    return bool(station.extend().values[1] & HAS_CARD_ALARM)


@pytest.fixture
def card(tmp_path: Path) -> Path:
    return tmp_path / "card"


@pytest.fixture
def start(boards: Boards, stations: Callable[[Station], Station], card: Path) -> Callable[[], Station]:
    """Start a board with the card, after cutting the power of the one before."""
    running: list[Board] = []

    def power_on() -> Station:
        if running:
            assert running.pop().stop(signal.SIGKILL) == (-signal.SIGKILL, "")
        running.append(boards("--pty", str(boards.link), "--card", str(card)))
        station = stations(Station.on_pty(boards.link))
        station.open_binary()
        station.extend()
        return station

    return power_on


def damage(card: Path, where: bytes) -> None:
    """One wrong bit behind each place on the card that holds these bytes."""
    image = bytearray((card / "card.img").read_bytes())
    at = image.find(where)
    assert at >= 0
    while at >= 0:
        image[at + 20] ^= 1
        at = image.find(where, at + 1)
    (card / "card.img").write_bytes(image)


def test_plans_parameters_and_own_gains_outlive_a_power_cut(start: Callable[[], Station]) -> None:
    station = start()
    assert upload(station, FLIGHT, SQUARE) == DONE
    assert upload(station, HIL, SQUARE[::-1]) == DONE
    assert station.ask("set_k_pitch", 2.5) == DONE
    assert station.ask("own_gain_set", LAW, LINE) == DONE
    assert station.ask("store_parameters") == DONE  # behind the plans, so they are there too
    station = start()
    assert value_of(station, LAW) == LINE
    assert read(station, FLIGHT) == list(SQUARE)
    assert read(station, HIL) == list(SQUARE[::-1])
    assert loaded(station) == DEFAULTS | {"k_pitch": 2.5}
    assert not alarms(station)


def test_a_reset_keeps_a_plan_that_was_acknowledged(start: Callable[[], Station]) -> None:
    station = start()
    assert upload(station, HIL, SQUARE) == DONE
    station.command("reset")
    station.open_binary()
    assert read(station, HIL) == list(SQUARE)


def test_rubbish_for_a_card_gives_the_defaults_and_the_board_says_so(start: Callable[[], Station], card: Path) -> None:
    card.mkdir()
    rubbish = bytes(range(1, 256)) * 1000
    (card / "card.img").write_bytes(rubbish)
    station = start()
    assert alarms(station)
    assert loaded(station) == DEFAULTS
    assert read(station, HIL) == []
    station.command("reset")
    alarm = "card: parameters unreadable, own gains unreadable, flight plan unreadable, hil plan unreadable"
    station.wait(lambda: f"\rALARM: {alarm}; defaults are used\n" in station.text)
    assert station.table("status")["card alarm"] == alarm.removeprefix("card: ")
    assert (card / "card.img").read_bytes() == rubbish  # nothing is written by looking
    station.open_binary()
    station.extend()
    assert station.ask("store_parameters") == DONE
    assert not alarms(start())


def test_a_damaged_plan_is_not_flown_and_leaves_the_rest(start: Callable[[], Station], card: Path) -> None:
    station = start()
    many = [(27.9 + index / 1000, -15.4, 1000.0, 55.0) for index in range(60)]
    assert upload(station, FLIGHT, many) == DONE
    assert upload(station, HIL, many) == DONE
    assert station.ask("set_k_pitch", 2.5) == DONE
    assert station.ask("store_parameters") == DONE
    damage(card, b"HLPF")
    station = start()
    assert alarms(station)
    assert read(station, HIL) == []
    assert read(station, FLIGHT) == many
    assert loaded(station)["k_pitch"] == 2.5
    assert upload(station, HIL, SQUARE) == DONE
    station.wait(lambda: not alarms(station))


def test_a_plan_that_cannot_be_stored_is_flown_and_the_board_says_so_by_itself(
    start: Callable[[], Station], card: Path
) -> None:
    station = start()
    assert not alarms(station)
    card.rmdir()
    station.frames.clear()
    assert upload(station, HIL, SQUARE) == DONE
    station.wait(lambda: station.newest("capabilities"))
    assert alarms(station)
    assert read(station, HIL) == list(SQUARE)
    assert station.ask("store_parameters") == STORAGE_FAILED
    card.mkdir()
    assert station.ask("store_parameters") == DONE
    assert upload(station, HIL, SQUARE) == DONE
    station.wait(lambda: not alarms(station))


def test_the_files_of_boards_before_move_to_the_card(start: Callable[[], Station], card: Path) -> None:
    card.mkdir()
    values = [value + 0.5 if name != "k_div_velocidad" else 650.0 for name, value in DEFAULTS.items()]
    record = b"PEPF" + struct.pack("<3I17f", 1, 7, 17, *values)
    (card / "params.b").write_bytes(record + struct.pack("<I", zlib.crc32(record)))
    station = start()
    expected = {name: float(f"{value:.6g}") for name, value in zip(DEFAULTS, values, strict=True)}
    assert loaded(station) == expected
    assert not alarms(station)
    assert [path.name for path in card.iterdir()] == ["params.b"]
    assert station.ask("store_parameters") == DONE
    assert [path.name for path in card.iterdir()] == ["card.img"]
    assert loaded(start()) == expected
