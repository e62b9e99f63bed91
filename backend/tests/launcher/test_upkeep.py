"""The commands for the time between flights, as a user gives them."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest
import typer
from typer.testing import CliRunner

from epf_gcs import __version__
from epf_gcs.data_folder import place, whereabouts
from epf_gcs.data_folder.lock import DataFolder
from epf_gcs.data_folder.upgrade import bring_up_to_date
from epf_gcs.launcher.upkeep import add_commands
from tests.support.waiting import DEADLINE_S

app = typer.Typer()
add_commands(app)


def run(*arguments: str | Path, typed: str | None = None) -> tuple[int, str]:
    result = CliRunner().invoke(app, [str(one) for one in arguments], input=typed)
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


@pytest.fixture
def kept(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A backup in the making, of a folder `data` beside it; a password costs a millisecond."""
    monkeypatch.setattr("epf_gcs.backup.age_archive.WORK", 10)
    (tmp_path / "data").mkdir()
    (tmp_path / "data" / "state.json").write_text("{}")
    return tmp_path / "kept.tar.age"


def test_a_password_is_asked_twice_and_again_for_restoring(kept: Path) -> None:
    data = kept.parent / "data"
    code, said = run("backup", kept, "--data-dir", data, "--encrypt", typed="long enough\nlong enough\n")
    assert (code, "without its password" in said, "long enough" in said) == (0, True, False)
    code, said = run("restore", kept, "--data-dir", data, typed="another one\n")
    assert (code, "password is wrong" in said) == (1, True)
    code, said = run("restore", kept, "--data-dir", data, typed="long enough\n")
    assert (code, "is as it was" in said) == (0, True)


@pytest.mark.parametrize(
    ("typed", "why"), [("long enough\nlong enouhg\n", "differ"), ("short\n", "10 to 200 characters")]
)
def test_passwords_that_differ_or_are_short_make_no_backup(kept: Path, typed: str, why: str) -> None:
    code, said = run("backup", kept, "--data-dir", kept.parent / "data", "--encrypt", typed=typed)
    assert (code, why in said, kept.exists()) == (1, True, False)


def test_a_password_can_come_from_a_file(kept: Path) -> None:
    data, file = kept.parent / "data", kept.parent / "password"
    file.write_text("long enough\n")
    assert run("backup", kept, "--data-dir", data, "--password-file", file)[0] == 0
    assert kept.read_bytes().startswith(b"age-encryption.org/v1\n")
    assert run("restore", kept, "--data-dir", data, "--password-file", file)[0] == 0


def test_in_a_source_tree_the_data_lie_in_it_and_else_with_the_user_s_data(monkeypatch: pytest.MonkeyPatch) -> None:
    tree = Path(__file__).parents[3]
    assert place.data_folder() == tree / "data"
    monkeypatch.setattr(place, "source_tree", lambda: None)
    monkeypatch.setenv("XDG_DATA_HOME", "/home/ana/.local/share")
    assert place.data_folder().name == "epf-gcs"
    assert place.data_folder() != tree / "data"
    assert place.demonstration_folder().name == "epf-gcs-demonstration"


def test_a_command_that_names_no_folder_means_the_demonstration_while_it_alone_runs(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    own, other = tmp_path / "own", tmp_path / "other"
    monkeypatch.setattr(whereabouts, "data_folder", lambda: own)
    monkeypatch.setattr(whereabouts, "demonstration_folder", lambda: other)
    own.mkdir()
    other.mkdir()
    found = whereabouts.Whereabouts("127.0.0.1", 8000, tls=False)
    assert whereabouts.folder_meant() == own
    with DataFolder(other):
        whereabouts.leave(other, found)
        assert whereabouts.folder_meant() == other
        with DataFolder(own):
            whereabouts.leave(own, found)
            assert whereabouts.folder_meant() == own
    assert whereabouts.folder_meant() == own


def test_what_an_upgrade_changed_is_put_back_by_a_command(tmp_path: Path) -> None:
    (tmp_path / "state.json").write_text('{"online": {}}')
    bring_up_to_date(tmp_path, lambda _said: None)
    assert "online" not in (tmp_path / "state.json").read_text()
    code, said = run("downgrade", "--data-dir", tmp_path)
    assert (code, "is of format 1 again" in said) == (0, True)
    assert (tmp_path / "state.json").read_text() == '{"online": {}}'
    code, said = run("downgrade", "--data-dir", tmp_path)
    assert (code, "No upgrade" in said) == (1, True)


@pytest.mark.parametrize("program", ["epf_gcs.launcher", "epf_gcs.launcher.gateway", "epf_gcs.simulator"])
def test_the_help_is_whole_on_a_terminal_of_80_columns(program: str) -> None:
    command = [sys.executable, "-m", program, "--help"]
    said = subprocess.run(
        command, capture_output=True, text=True, check=True, env={**os.environ, "COLUMNS": "80"}, timeout=DEADLINE_S
    ).stdout
    assert "…" not in said
    assert max(map(len, said.splitlines())) <= 80
    assert "\n    epf-" in said, "an example stands on a line of its own"
