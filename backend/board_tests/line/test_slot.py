"""The images for the processors themselves, which QEMU lends nothing: a memory card in the slot, or none.

QEMU's STM32F405 cannot be given a card: `-device ssi-sd` is refused ("Parameter 'driver' expects a pluggable device
type"), and reading the data register of its serial peripheral interface clocks the bus once more. The LM3S6965's board
has a card of its own there, and runs the same application, file system and driver of the card on the same core.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Protocol

import pytest

from board_tests.line.emulated import LM3S6965, STM32F405, Bare, Image, Machine
from board_tests.line.station import Station

DONE, STORAGE_FAILED = 0, 4
CARD_ALARM = 1 << 4
STANDARD, HIGH_CAPACITY = 1 << 20, 1 << 32


class Boards(Protocol):
    """Starts a board with this card and opens its line; one that runs already loses its power without a warning."""

    def __call__(self, card: Path | None, board: Machine = LM3S6965) -> Station: ...


@pytest.fixture
def powered(built_images: None, stations: Callable[[Station], Station]) -> Iterator[Boards]:
    started: list[Bare] = []

    def power(card: Path | None, board: Machine = LM3S6965) -> Station:
        for running in started:
            running.cut_power()
        started[:] = [Bare(board, card)]
        return stations(started[0].station())

    yield power
    for board in started:
        assert board.stop() == ""


def blank_card(path: Path, size: int) -> Path:
    """A card that never held anything; the disk keeps only what is written to it."""
    with path.open("wb") as card:
        card.truncate(size)
    return path


def opened(station: Station) -> Station:
    station.open_binary()
    station.extend()
    return station


def alarms(station: Station) -> bool:
    station.command("capabilities")
    features = station.next("capabilities").values[1]
    return bool(int(features) & CARD_ALARM)


@pytest.mark.parametrize("size", [STANDARD, HIGH_CAPACITY], ids=["standard", "high_capacity"])
def test_parameters_and_plan_outlive_a_power_cut(powered: Boards, tmp_path: Path, size: int) -> None:
    card = blank_card(tmp_path / "card", size)
    station = opened(powered(card))
    assert not alarms(station)
    assert station.ask("set_k_roll", 3.25) == DONE
    assert station.ask("mission_begin", 0, 1) == DONE
    assert station.ask("mission_item", 0, 0, 27.95123456789, -15.37987654321, 700.0, 55.0) == DONE
    assert station.ask("mission_commit", 0) == DONE
    assert station.ask("store_parameters") == DONE
    again = powered(card)
    assert "27.95123" in again.lines("fms")[-1]
    assert again.line("param k_roll").split()[1] == "3.25"
    assert again.table("status")["card"] == "present"


def test_the_card_of_another_of_our_boards_is_read(powered: Boards, tmp_path: Path) -> None:
    lent = Image(STM32F405, tmp_path / "folder")
    station = opened(lent.station())
    assert station.ask("set_k_roll", 5.5) == DONE
    assert station.ask("store_parameters") == DONE
    station.close()
    assert lent.stop() == ""
    card = blank_card(tmp_path / "card", STANDARD)
    with card.open("r+b") as device:
        device.write((tmp_path / "folder" / "card.img").read_bytes())
    station = powered(card)
    assert station.line("param k_roll").split()[1] == "5.5"
    opened(station)
    assert station.ask("set_k_roll", 6.5) == DONE
    assert station.ask("store_parameters") == DONE
    assert powered(card).line("param k_roll").split()[1] == "6.5"


@pytest.mark.parametrize("board", [LM3S6965, STM32F405], ids=["lm3s6965evb", "stm32f405"])
def test_an_empty_slot_gives_the_defaults_and_the_alarm(powered: Boards, board: Machine) -> None:
    station = powered(None, board)
    assert station.line("param k_roll").split()[1] == "2"
    assert station.table("status")["card"] == "cannot be read"
    opened(station)
    assert alarms(station)
    assert station.ask("store_parameters") == STORAGE_FAILED
    # It takes its time with every card, and hangs with none.
    station.command("exit_binary_mode")
    station.send(b"reset\n")
    assert station.table("status")["last restart"] == "-"


def test_another_device_s_card_is_told_until_something_is_stored(powered: Boards, tmp_path: Path) -> None:
    card = blank_card(tmp_path / "card", STANDARD)
    with card.open("r+b") as device:
        device.write(bytes(range(1, 251)) * 100)
    station = opened(powered(card))
    assert alarms(station)
    assert station.ask("set_k_roll", 4.5) == DONE
    assert station.ask("store_parameters") == DONE
    assert not alarms(station)
    assert powered(card).line("param k_roll").split()[1] == "4.5"
