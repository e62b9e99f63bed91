"""With --legacy the board is a deployed one: extensions do not exist, and nothing comes unasked."""

from collections.abc import Callable

import pytest

from board_tests.line.others import (
    commands_do_what_they_do_on_any_board,
    extensions_are_ignored_to_the_byte,
    original_commands_are_answered_by_no_extension,
)
from board_tests.line.station import Station


@pytest.fixture
def legacy(plug: Callable[..., Station]) -> Station:
    station = plug("--legacy")
    station.open_binary()
    station.command("set_parameter_task_rate", 20)
    return station


def test_asking_for_capabilities_gives_nothing(legacy: Station) -> None:
    legacy.command("capabilities")
    legacy.heartbeats(60)  # more than the second in which a board status would come
    assert legacy.names() == {"heartbeat"}


def test_every_extension_command_is_ignored_to_the_byte(legacy: Station) -> None:
    extensions_are_ignored_to_the_byte(legacy)


def test_no_original_command_is_answered_by_an_extension(legacy: Station) -> None:
    original_commands_are_answered_by_no_extension(legacy)


def test_commands_do_what_they_do_on_any_board(legacy: Station) -> None:
    commands_do_what_they_do_on_any_board(legacy)


def test_a_card_gives_a_deployed_board_no_extension(
    plug: Callable[..., Station], tmp_path_factory: pytest.TempPathFactory
) -> None:
    card = tmp_path_factory.mktemp("card")
    station = plug("--legacy", "--card", str(card))
    station.open_binary()
    station.command("store_parameters")
    station.heartbeats(5)
    assert list(card.iterdir()) == []
    assert station.names() == {"heartbeat"}
