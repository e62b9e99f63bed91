"""A task that hangs is noticed, and the board does not fly on without it."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from board_tests.line.conftest import Boards
from board_tests.line.emulated import STM32F405, Image
from board_tests.line.station import Station

HANGS = 3


@pytest.mark.parametrize("task", ["sensorTask", "cardTask"])
def test_a_board_whose_task_hangs_ends_and_says_which(boards: Boards, task: str) -> None:
    board = boards("--tcp", "0", "--hang", task)
    assert board.ended() == (HANGS, f"epf-board: the watchdog ends the board: {task} hangs\n")


def test_what_is_no_task_cannot_hang(boards: Boards) -> None:
    code, complaint = boards("--tcp", "0", "--hang", "nobody").ended()
    assert code == 2
    assert "nobody" in complaint


def test_an_image_whose_task_hangs_starts_anew_and_says_why(
    built_images: None, tmp_path: Path, stations: Callable[[Station], Station]
) -> None:
    image = Image(STM32F405, tmp_path / "card", "--hang", "controlTask")
    station = stations(image.station())
    try:
        assert "watchdog" not in station.text
        station.ask_until(lambda: station.send(b"status\n"), lambda: "watchdog: controlTask" in station.text)
    finally:
        assert image.stop() == ""
