"""The firmware as images of two processors, under QEMU: the same application, so the same answers.

Nothing here measures time: an emulated processor's clock slips where the computer is busy.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Protocol

import pytest

from board_tests.line.emulated import LM3S6965, STM32F405, Image
from board_tests.line.others import (
    a_foreign_station_gets_no_extension,
    commands_do_what_they_do_on_any_board,
    extensions_are_ignored_to_the_byte,
    original_commands_are_answered_by_no_extension,
)
from board_tests.line.station import LEVEL_FLIGHT, Station
from board_tests.line.test_own_gains import LAW, LINE, rows_of_board, value_of
from epf_gcs.codec.description import GainRow
from epf_gcs.codec.messages_gen import COMMANDS

DONE, BAD_VALUE = 0, 1


class Images(Protocol):
    """Starts an image with these options and opens its line; what complains at the end fails the test."""

    def __call__(self, *options: str) -> Station: ...


@pytest.fixture(params=[STM32F405, LM3S6965], ids=["stm32f405", "lm3s6965evb"])
def plugged(
    request: pytest.FixtureRequest, built_images: None, tmp_path: Path, stations: Callable[[Station], Station]
) -> Iterator[Images]:
    started: list[Image] = []

    def plug(*options: str) -> Station:
        for image in started:
            assert image.stop() == ""
        started[:] = [Image(request.param, tmp_path / "card", *options)]
        return stations(started[0].station())

    yield plug
    for image in started:
        assert image.stop() == ""


def test_the_image_starts_in_text_mode(plugged: Images) -> None:
    status = plugged().table("status")
    assert status["card"] == "present"
    assert status["extensions"] == "yes"


def test_the_image_opens_binary_mode_and_acknowledges(plugged: Images) -> None:
    station = plugged()
    station.open_binary()
    station.extend()
    assert station.ask("set_k_roll", 2.5) == DONE
    beyond = station.raw_command("set_k_roll", COMMANDS["set_k_roll"].struct.pack(-1.0))
    assert station.ask_bytes(COMMANDS["set_k_roll"].id, beyond) == BAD_VALUE
    station.command("start")
    for stream in ("ahrs", "inertial", "analog", "gps", "servos_in", "statistics"):
        station.next(stream)
    assert station.failed == 0


def test_the_image_describes_itself_and_takes_its_law(plugged: Images) -> None:
    station = plugged()
    station.open_binary()
    station.extend()
    law = rows_of_board(station)[LAW]
    assert isinstance(law, GainRow)
    assert law.name == "guidance_law"
    assert station.ask("own_gain_set", LAW, LINE) == DONE
    assert value_of(station, LAW) == LINE


def test_the_image_answers_every_hil_frame(plugged: Images) -> None:
    station = plugged()
    station.open_binary()
    station.command("start")
    for count in range(1, 51):
        station.command("xplane_info", *LEVEL_FLIGHT)
        station.wait(lambda count=count: station.count("hil_surfaces") == count)  # type: ignore[misc]
    assert station.failed == 0


def test_the_image_takes_a_burst_without_losing_a_byte(plugged: Images) -> None:
    station = plugged()
    station.open_binary()
    station.extend()
    frame = station.raw_command("set_k_roll", COMMANDS["set_k_roll"].struct.pack(1.5))
    station.frames.clear()
    station.write_without_reading(frame * 300)
    # That of `capabilities` may come in among them.
    station.wait(lambda: station.acknowledgements("set_k_roll") == 300)
    assert station.failed == 0


def test_the_image_keeps_what_it_stored(plugged: Images) -> None:
    station = plugged()
    station.open_binary()
    station.extend()
    assert station.ask("set_k_roll", 3.25) == DONE
    assert station.ask("mission_begin", 0, 1) == DONE
    assert station.ask("mission_item", 0, 0, 27.95123456789, -15.37987654321, 700.0, 55.0) == DONE
    assert station.ask("mission_commit", 0) == DONE
    assert station.ask("store_parameters") == DONE
    again = plugged()
    assert "27.95123" in again.lines("fms")[-1]
    assert again.line("param k_roll").split()[1] == "3.25"


def test_a_deployed_board_s_image_is_one(plugged: Images) -> None:
    station = plugged("--legacy")
    station.open_binary()
    extensions_are_ignored_to_the_byte(station)
    original_commands_are_answered_by_no_extension(station)
    commands_do_what_they_do_on_any_board(station)


def test_a_foreign_station_gets_of_the_image_what_a_deployed_board_gives(plugged: Images) -> None:
    station = plugged()
    station.open_binary()
    a_foreign_station_gets_no_extension(station)
