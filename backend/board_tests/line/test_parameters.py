"""Parameters on the running board: set, loaded, stored on the card and found there after a restart."""

import struct
from collections.abc import Callable
from pathlib import Path

import pytest

from board_tests.line.conftest import Boards
from board_tests.line.station import Board, Station
from epf_gcs.codec.messages_gen import COMMANDS_BY_ID, PARAMETERS

DONE, BAD_VALUE, STORAGE_FAILED = 0, 1, 4
DEFAULTS = {parameter.name: parameter.default for parameter in PARAMETERS}


def loaded(station: Station) -> dict[str, float]:
    """What the board holds, as the wire's single precision shows it to a person."""
    station.command("load_autopilot_parameters")
    values = station.next("autopilot_parameters").values
    return {parameter.name: float(f"{value:.6g}") for parameter, value in zip(PARAMETERS, values, strict=True)}


def changed(name: str) -> float:
    """Another value than the default, and in range."""
    parameter = next(parameter for parameter in PARAMETERS if parameter.name == name)
    other = float(f"{parameter.default + parameter.step:.6g}")
    return int(other) if parameter.is_integer else other


Plug = Callable[..., Station]


@pytest.fixture
def card(tmp_path: Path) -> Path:
    return tmp_path / "card"


@pytest.fixture
def restart(boards: Boards, stations: Callable[[Station], Station], card: Path) -> Callable[[], Station]:
    """Start a board with the card, after ending the one before."""
    running: list[Board] = []

    def start() -> Station:
        if running:
            assert running.pop().stop() == (0, "")
        running.append(boards("--pty", str(boards.link), "--card", str(card)))
        station = stations(Station.on_pty(boards.link))
        station.open_binary()
        station.extend()
        return station

    return start


def test_the_board_starts_with_the_defaults(binary: Station) -> None:
    assert loaded(binary) == DEFAULTS


def test_every_parameter_is_set_alone_and_read_back(extended: Station) -> None:
    expected = dict(DEFAULTS)
    for parameter in PARAMETERS:
        expected[parameter.name] = changed(parameter.name)
        assert extended.ask(f"set_{parameter.name}", expected[parameter.name]) == DONE
        assert loaded(extended) == expected


def test_a_value_outside_of_its_range_changes_nothing(extended: Station) -> None:
    for parameter in PARAMETERS:
        letter = "i" if parameter.is_integer else "f"
        wrong = [parameter.minimum - 1, parameter.maximum + 1]
        if not parameter.is_integer:
            wrong += [float("nan"), float("inf")]
        for value in wrong:
            payload = struct.pack(f"<{letter}", int(value) if parameter.is_integer else value)
            command = COMMANDS_BY_ID[parameter.set_id]
            assert extended.ask_bytes(command.id, extended.raw_command(command.name, payload)) == BAD_VALUE
    assert loaded(extended) == DEFAULTS


def test_what_is_stored_is_there_after_a_restart(restart: Callable[[], Station]) -> None:
    station = restart()
    for parameter in PARAMETERS:
        station.ask(f"set_{parameter.name}", changed(parameter.name))
    assert station.ask("store_parameters") == DONE
    assert loaded(restart()) == {parameter.name: changed(parameter.name) for parameter in PARAMETERS}


def test_what_is_not_stored_is_forgotten_by_a_restart(restart: Callable[[], Station]) -> None:
    station = restart()
    station.ask("set_k_pitch", 3.0)
    assert station.ask("store_parameters") == DONE
    station.ask("set_k_pitch", 4.0)
    assert loaded(station)["k_pitch"] == 4.0
    assert loaded(restart())["k_pitch"] == 3.0


def test_the_file_is_on_the_card_when_the_answer_comes(restart: Callable[[], Station], card: Path) -> None:
    station = restart()
    contents = []
    for value in (2.5, 3.5, 4.5):
        station.ask("set_k_pitch", value)
        assert station.ask("store_parameters") == DONE
        contents.append({path.name: path.read_bytes() for path in card.iterdir()})
    wanted = [struct.pack("<f", value) for value in (2.5, 3.5, 4.5)]
    for content, packed in zip(contents, wanted, strict=True):
        assert any(packed in data for data in content.values())
        assert content.keys() == {"card.img"}


def test_a_reset_takes_the_stored_set(restart: Callable[[], Station]) -> None:
    station = restart()
    station.ask("set_k_roll", 3.0)
    station.ask("store_parameters")
    station.ask("set_k_roll", 4.0)
    station.command("reset")
    assert station.line("param k_roll").split()[1] == "3"


def test_the_text_shell_stores_and_loads_too(restart: Callable[[], Station]) -> None:
    station = restart()
    station.ask("exit_binary_mode")
    station.line("param k_roll 3.25")
    assert station.line("param store") == "ok"
    station.line("param k_roll 1")
    assert station.line("param load") == "ok"
    assert station.line("param k_roll").split()[1] == "3.25"


def test_a_card_full_of_rubbish_gives_the_defaults_and_can_be_stored_to(
    restart: Callable[[], Station], card: Path
) -> None:
    station = restart()
    for _ in range(2):
        assert station.ask("store_parameters") == DONE
    for path in card.iterdir():
        path.write_bytes(b"\xff" * 5000)
    station = restart()
    assert loaded(station) == DEFAULTS
    station.ask("set_k_pitch", 2.5)
    assert station.ask("store_parameters") == DONE
    assert loaded(restart())["k_pitch"] == 2.5


def test_a_card_that_cannot_be_written_is_an_honest_failure(restart: Callable[[], Station], card: Path) -> None:
    station = restart()
    for path in card.iterdir():
        path.unlink()
    card.rmdir()
    assert station.ask("store_parameters") == STORAGE_FAILED
    card.mkdir()
    assert station.ask("store_parameters") == DONE


def test_streams_and_hil_answers_go_on_while_the_card_is_written(restart: Callable[[], Station]) -> None:
    station = restart()
    station.ask("set_parameter_task_rate", 20)
    station.frames.clear()
    for _ in range(20):
        station.command("store_parameters")
        station.command("xplane_info", *([0.0] * 15))
    station.wait(lambda: station.count("acknowledgement") == 20 and station.count("hil_surfaces") == 20)
    assert {frame.values for frame in station.frames if frame.message.name == "acknowledgement"} == {(0x101, DONE)}


def test_a_station_that_did_not_ask_for_extensions_can_store_and_hears_nothing_of_it(plug: Plug, card: Path) -> None:
    station = plug("--card", str(card))
    station.open_binary()
    station.command("set_parameter_task_rate", 20)
    station.command("set_k_pitch", 2.5)
    station.command("store_parameters")
    wanted = struct.pack("<f", 2.5)

    def is_stored() -> bool:
        station.heartbeats(3)
        return any(wanted in path.read_bytes() for path in card.iterdir())

    station.wait(is_stored)
    station.heartbeats(5)
    assert b"\rQT,\x01\x01\0\x80" not in station.received  # no acknowledgement
    assert station.names() == {"heartbeat"}


def test_capabilities_tell_whether_there_is_a_card(restart: Callable[[], Station]) -> None:
    assert restart().extend().values[1] & 2 == 2
