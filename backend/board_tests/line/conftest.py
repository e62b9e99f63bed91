"""The tests run with the board that checks itself (sanitizers), those of the line itself with the one that ships too.

That one flies in the closed loop, in the demonstration and in the journeys.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Protocol

import pytest

from board_tests.line.station import Board, Station
from tests.support.firmware import make


@pytest.fixture(scope="session")
def built() -> None:
    make("board", "board-asan")


@pytest.fixture
def flavour(built: None) -> str:
    """The folder of the board's program."""
    return "posix-asan"


class Boards(Protocol):
    """Starts a board with these options; what a test does not end itself has to end cleanly when the test is over.

    `link` is where a test may have a pseudo-terminal put.
    """

    link: Path

    def __call__(self, *options: str) -> Board: ...


class _Boards:
    def __init__(self, flavour: str, link: Path) -> None:
        self.link = link
        self._flavour = flavour
        self.started: list[Board] = []

    def __call__(self, *options: str) -> Board:
        board = Board(self._flavour, *options)
        self.started.append(board)
        return board


@pytest.fixture
def boards(flavour: str, tmp_path: Path) -> Iterator[Boards]:
    made = _Boards(flavour, tmp_path / "board")
    yield made
    endings = [board.stop() for board in made.started if not board.has_ended]
    assert endings == [(0, "")] * len(endings)


@pytest.fixture
def stations() -> Iterator[Callable[[Station], Station]]:
    """Closes the stations handed to it when the test is over."""
    opened: list[Station] = []

    def keep(station: Station) -> Station:
        opened.append(station)
        return station

    yield keep
    for station in opened:
        station.close()


@pytest.fixture
def plug(boards: Boards, stations: Callable[[Station], Station]) -> Callable[..., Station]:
    """Start a board on the pseudo-terminal, with these options, and open it."""

    def start(*options: str) -> Station:
        boards("--pty", str(boards.link), *options)
        return stations(Station.on_pty(boards.link))

    return start


@pytest.fixture
def text(plug: Callable[..., Station]) -> Station:
    """A board in text mode."""
    return plug()


@pytest.fixture
def binary(plug: Callable[..., Station]) -> Station:
    """A board in binary mode whose extensions were not asked for; its heartbeat comes every 20 ms, to save time."""
    station = plug()
    station.open_binary()
    station.command("set_parameter_task_rate", 20)
    return station


@pytest.fixture
def extended(binary: Station) -> Station:
    """A board in binary mode that acknowledges."""
    binary.extend()
    return binary
