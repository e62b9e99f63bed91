"""A kept file holds the old or the new value; one that makes no sense is told, and lies beside it."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from epf_gcs.disk import DamagedFileError, KeptFile


def numbers(folder: Path) -> KeptFile[int]:
    return KeptFile(folder / "number", int, lambda value: str(value).encode(), unix_s=lambda: 0.0)


def test_a_value_is_read_back_and_none_removes_its_file(tmp_path: Path) -> None:
    numbers(tmp_path).write(5)
    assert numbers(tmp_path).read() == 5
    numbers(tmp_path).write(None)
    assert numbers(tmp_path).read() is None
    assert list(tmp_path.iterdir()) == []


def test_a_disk_that_refuses_the_new_value_leaves_the_old_one(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    numbers(tmp_path).write(5)

    def refuse(descriptor: int) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(os, "fsync", refuse)
    with pytest.raises(OSError, match="No space"):
        numbers(tmp_path).write(6)
    assert numbers(tmp_path).read() == 5


def test_content_that_makes_no_sense_is_told_and_set_aside_without_losing_an_earlier_one(tmp_path: Path) -> None:
    told: list[str] = []
    for content in ("x", "y"):
        (tmp_path / "number").write_text(content)
        with pytest.raises(DamagedFileError, match="number"):
            numbers(tmp_path).read()
        assert numbers(tmp_path).read_or_set_aside(lambda kept: told.append(kept.name if kept else "")) is None
    assert told == ["number.damaged-19700101T000000Z", "number.damaged-19700101T000000Z-2"]
    assert [(tmp_path / name).read_text() for name in told] == ["x", "y"]


def test_a_file_that_cannot_be_read_raises_and_stays(tmp_path: Path) -> None:
    (tmp_path / "number").mkdir()
    with pytest.raises(IsADirectoryError):
        numbers(tmp_path).read_or_set_aside(lambda kept: pytest.fail("nothing is damaged"))
    assert [path.name for path in tmp_path.iterdir()] == ["number"]
