"""With --legacy the board is a deployed one: extensions do not exist, and nothing comes unasked."""

from collections.abc import Callable

import pytest

from gateway.codec.messages_gen import COMMANDS, PARAMETERS
from tests.board.station import EXTENSIONS, LEVEL_FLIGHT, Station
from tests.board.test_commands import ARGUMENTS


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
    legacy.heartbeats(2)
    quiet = legacy.next("heartbeat").payload
    legacy.received.clear()
    legacy.frames.clear()
    for name, command in COMMANDS.items():
        if command.extension:
            legacy.command(name, *ARGUMENTS.get(name, ()))
    legacy.heartbeats(4)
    assert legacy.names() == {"heartbeat"}
    assert {frame.payload for frame in legacy.frames} == {quiet}
    assert legacy.failed == 0
    # Whole heartbeats, but for the last one, and not a byte between them.
    assert bytes(legacy.received).replace(b"\r\n\r\n", b"").count(b"\rQT,") == len(legacy.received) // 28


def test_no_original_command_is_answered_by_an_extension(legacy: Station) -> None:
    legacy.command("capabilities")
    for name, command in COMMANDS.items():
        if not command.extension and name not in ("reset", "exit_binary_mode", "xplane_info"):
            legacy.command(name, *ARGUMENTS.get(name, ()))
    legacy.command("load_autopilot_parameters")
    legacy.next("autopilot_parameters")
    legacy.command("start")
    legacy.heartbeats(6)
    assert legacy.failed == 0
    assert legacy.names() & EXTENSIONS == set()


def test_commands_do_what_they_do_on_any_board(legacy: Station) -> None:
    legacy.command("control_source", 1)
    legacy.command("autopilot_on")
    assert legacy.heartbeat()["autopilot_hil"] == 3
    legacy.command("set_k_pitch", 2.5)
    legacy.command("load_autopilot_parameters")
    values = legacy.next("autopilot_parameters").values
    assert values[[parameter.name for parameter in PARAMETERS].index("k_pitch")] == 2.5
    legacy.command("xplane_info", *LEVEL_FLIGHT)
    legacy.next("hil_surfaces")


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
