"""The board's image in the demonstration: what is started, and what is told where that cannot be."""

from pathlib import Path

import pytest

from epf_gcs.launcher.emulated import EmulatedBoard
from epf_gcs.launcher.errors import LaunchError
from epf_gcs.launcher.options import Options

ON_A_LINE = EmulatedBoard(40123)


@pytest.fixture
def qemu(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder of built firmware with an image, and a QEMU on the path that is never started."""
    programs = tmp_path / "bin"
    programs.mkdir()
    program = programs / "qemu-system-arm"
    program.write_text("#!/bin/sh\n")
    program.chmod(0o755)
    monkeypatch.setenv("PATH", str(programs))
    image = tmp_path / "build" / "stm32f405" / "epf-board-qemu.elf"
    image.parent.mkdir(parents=True)
    image.write_bytes(b"")
    return tmp_path / "build"


def test_the_image_is_named_and_gets_a_port_of_its_own() -> None:
    emulated = EmulatedBoard.named("qemu")
    assert emulated is not None
    assert emulated.folder == "stm32f405"
    assert emulated.url == f"tcp://127.0.0.1:{emulated.port}"


@pytest.mark.parametrize("board", [None, "/dev/ttyUSB0", "qemu-an386", "tcp://qemu:4000"])
def test_every_other_board_is_no_image(board: str | None) -> None:
    assert EmulatedBoard.named(board) is None


def test_the_gateway_opens_the_line_on_which_the_image_listens(qemu: Path, tmp_path: Path) -> None:
    command = ON_A_LINE.command(qemu, tmp_path / "card")
    line = command[command.index("-chardev") + 1].split(",")
    assert {"socket", "id=line", "host=127.0.0.1", "port=40123", "server=on", "wait=off", "nodelay=on"} <= set(line)
    assert command[command.index("-serial") + 1] == "chardev:line"
    assert command[command.index("-M") + 1] == "netduinoplus2"
    assert Options(emulated=ON_A_LINE).board_url() == "tcp://127.0.0.1:40123"


def test_no_byte_of_the_line_is_a_command_to_the_emulator(qemu: Path, tmp_path: Path) -> None:
    command = ON_A_LINE.command(qemu, tmp_path / "card")
    assert "mux=on" in command[command.index("-chardev") + 1]
    assert int(command[command.index("-echr") + 1]) not in range(256)


def test_the_image_s_card_may_have_any_name(qemu: Path, tmp_path: Path) -> None:
    card = tmp_path / "one, two"
    assert ON_A_LINE.command(qemu, card)[-1].endswith("/one,, two")
    assert card.is_dir()


def test_a_missing_image_is_told_with_what_builds_it(qemu: Path, tmp_path: Path) -> None:
    with pytest.raises(LaunchError, match="make images"):
        EmulatedBoard(40123, "another").command(qemu, tmp_path)


def test_a_missing_qemu_is_told_with_what_installs_it(
    qemu: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("PATH", str(tmp_path))
    with pytest.raises(LaunchError, match="apt install qemu-system-arm"):
        ON_A_LINE.command(qemu, tmp_path)
