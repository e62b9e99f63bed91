"""The commands for the time between flights, as a user gives them."""

from __future__ import annotations

import os
import shutil
import socket
from pathlib import Path

import pytest
import typer
from typer.testing import CliRunner

from epf_gcs import __version__
from epf_gcs.data_folder import place
from epf_gcs.data_folder.lock import DataFolder
from epf_gcs.launcher import doctor_serial
from epf_gcs.launcher.upkeep import add_commands

app = typer.Typer()
add_commands(app)


def run(*arguments: str | Path) -> tuple[int, str]:
    result = CliRunner().invoke(app, [str(one) for one in arguments])
    return result.exit_code, result.output


def test_the_version_is_the_package_s() -> None:
    assert run("version") == (0, f"epf-gcs {__version__}\n")


def test_a_station_is_not_replaced_while_it_runs(tmp_path: Path) -> None:
    data = tmp_path / "data"
    data.mkdir()
    (data / "state.json").write_text("{}")
    assert run("backup", tmp_path / "kept.tar", "--data-dir", data)[0] == 0
    with DataFolder(data):
        code, said = run("restore", tmp_path / "kept.tar", "--data-dir", data)
    assert (code, "stop it first" in said) == (1, True)
    code, said = run("restore", tmp_path / "kept.tar", "--data-dir", data)
    assert (code, "is as it was" in said) == (0, True)


def test_a_folder_that_is_none_is_said_to_be_none(tmp_path: Path) -> None:
    code, said = run("backup", tmp_path / "kept.tar", "--data-dir", tmp_path / "nowhere")
    assert code == 1
    assert "is no folder" in said


def test_the_doctor_finds_a_taken_port_and_says_what_to_do(tmp_path: Path) -> None:
    with socket.create_server(("127.0.0.1", 0)) as taken:
        code, said = run("doctor", "--data-dir", tmp_path, "--port", str(taken.getsockname()[1]))
    assert code in (0, 1)  # what else this computer lacks is not this test's
    assert "is taken by another program" in said
    assert "choose with --port" in said


def test_the_doctor_says_how_to_free_a_full_disk_and_ends_with_1(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    usage = type(shutil.disk_usage(tmp_path))(10**12, 10**12 - 1000, 1000)
    monkeypatch.setattr(shutil, "disk_usage", lambda _path: usage)
    code, said = run("doctor", "--data-dir", tmp_path)
    assert code == 1
    assert "recordings stop when it is full" in said


def test_the_doctor_names_a_port_that_may_not_be_opened(monkeypatch: pytest.MonkeyPatch) -> None:
    port = type("Port", (), {"device": "/dev/ttyUSB0", "hwid": "USB"})
    monkeypatch.setattr("serial.tools.list_ports.comports", lambda: [port])
    monkeypatch.setattr(os, "access", lambda _path, _mode: False)
    (found,) = doctor_serial.serial_ports()
    assert found.state == "fault"
    assert "usermod -a -G dialout" in found.mend


def test_in_a_source_tree_the_data_lie_in_it_and_else_with_the_user_s_data(monkeypatch: pytest.MonkeyPatch) -> None:
    tree = Path(__file__).parents[3]
    assert place.data_folder() == tree / "data"
    monkeypatch.setattr(place, "source_tree", lambda: None)
    monkeypatch.setenv("XDG_DATA_HOME", "/home/ana/.local/share")
    assert place.data_folder().name == "epf-gcs"
    assert place.data_folder() != tree / "data"
