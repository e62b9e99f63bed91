"""The chosen online sources are on the disk whole after a power cut; a damaged file is kept aside."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from epf_gcs.errors import GatewayError
from epf_gcs.maps.online_file import OnlineFile
from epf_gcs.maps.sources import OnlineChoice

CHOICE = OnlineChoice(enabled=True, limit_bytes=5, sources=())


def a_file(folder: Path) -> tuple[OnlineFile, list[GatewayError]]:
    reported: list[GatewayError] = []
    return OnlineFile(folder, reported.append), reported


def test_a_choice_is_read_back_by_the_next_run(tmp_path: Path) -> None:
    assert a_file(tmp_path / "data")[0].read() == OnlineChoice()
    a_file(tmp_path / "data")[0].write(CHOICE)
    assert a_file(tmp_path / "data")[0].read() == CHOICE


def test_the_new_file_is_on_the_disk_before_it_takes_the_old_one_s_place(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    synced: list[Path] = []
    monkeypatch.setattr(os, "fsync", lambda descriptor: synced.append(Path(f"/proc/self/fd/{descriptor}").readlink()))
    a_file(tmp_path)[0].write(CHOICE)
    assert synced == [tmp_path / "online-maps.json.new", tmp_path]


@pytest.mark.parametrize("content", [b"{", b"5", b"\xff"])
def test_a_file_that_makes_no_sense_is_reported_and_kept_aside(tmp_path: Path, content: bytes) -> None:
    (tmp_path / "online-maps.json").write_bytes(content)
    file, reported = a_file(tmp_path)
    assert file.read() == OnlineChoice()
    (aside,) = tmp_path.glob("online-maps.json.damaged-*")
    assert aside.read_bytes() == content
    assert [error.code for error in reported] == ["memory_unreadable"]
    assert aside.name in reported[0].detail
    file.write(CHOICE)
    assert a_file(tmp_path)[0].read() == CHOICE


def test_a_disk_that_refuses_is_reported(tmp_path: Path) -> None:
    (tmp_path / "online-maps.json").mkdir()
    file, reported = a_file(tmp_path)
    assert file.read() == OnlineChoice()
    file.write(CHOICE)
    assert [error.code for error in reported] == ["memory_unreadable", "memory_not_written"]
