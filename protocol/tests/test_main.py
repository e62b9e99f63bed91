"""The command writes every file, and with --check sees each one that is stale."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from generator.__main__ import main, outputs
from generator.load import load
from tests.example import PROTOCOL

NAMES = list(outputs(load(PROTOCOL / "definition")))


@pytest.fixture
def tree(tmp_path: Path) -> Path:
    shutil.copytree(PROTOCOL / "definition", tmp_path / "protocol" / "definition")
    for name in ("definition.schema.json", "released.json"):
        shutil.copy(PROTOCOL / name, tmp_path / "protocol" / name)
    assert main([], tmp_path) == 0
    return tmp_path


def test_the_committed_files_are_what_the_definition_makes() -> None:
    assert main(["--check"]) == 0


def test_a_written_tree_passes_its_check_and_is_the_same_when_written_again(tree: Path) -> None:
    first = {name: (tree / name).read_bytes() for name in NAMES}
    assert main(["--check"], tree) == 0
    assert main([], tree) == 0
    assert {name: (tree / name).read_bytes() for name in NAMES} == first


@pytest.mark.parametrize("name", NAMES)
def test_a_stale_or_missing_file_fails_the_check(tree: Path, name: str, capsys: pytest.CaptureFixture[str]) -> None:
    (tree / name).write_text((tree / name).read_text("utf-8") + "\n", "utf-8")
    assert main(["--check"], tree) == 1
    assert f"{name} is out of date" in capsys.readouterr().err
    (tree / name).unlink()
    assert main(["--check"], tree) == 1


def test_a_changed_frame_fails_until_it_is_released(tree: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = tree / "protocol" / "definition" / "telemetry.toml"
    file.write_text(file.read_text("utf-8").replace('name = "pitot"', 'name = "pressure"'), "utf-8")
    assert main([], tree) == 1
    assert "to_pc analog was released as" in capsys.readouterr().err
    assert main(["--release"], tree) == 0
    assert main(["--check"], tree) == 0


def test_a_contradiction_is_told_and_nothing_is_written(tree: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = tree / "protocol" / "definition" / "telemetry.toml"
    file.write_text(file.read_text("utf-8").replace("size = 12", "size = 16", 1), "utf-8")
    before = {name: (tree / name).read_bytes() for name in NAMES}
    assert main([], tree) == 1
    assert "protocol/definition: heartbeat: fields are 12 bytes, size says 16" in capsys.readouterr().err
    assert {name: (tree / name).read_bytes() for name in NAMES} == before
