"""The chosen online sources are on the disk whole after a power cut; those of version 0.1.0 are taken over."""

from __future__ import annotations

import os
from pathlib import Path

import orjson
import pytest

from epf_gcs.errors import GatewayError
from epf_gcs.web.maps.online_file import OnlineFile

CHOICE = {"enabled": True, "limit_bytes": 5, "sources": []}


def a_file(folder: Path) -> tuple[OnlineFile, list[GatewayError]]:
    reported: list[GatewayError] = []
    return OnlineFile(folder, reported.append), reported


def test_a_choice_is_read_back_by_the_next_run(tmp_path: Path) -> None:
    assert a_file(tmp_path / "data")[0].read() == {}
    a_file(tmp_path / "data")[0].write(CHOICE)
    assert a_file(tmp_path / "data")[0].read() == CHOICE


def test_the_new_file_is_on_the_disk_before_it_takes_the_old_one_s_place(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    synced: list[Path] = []
    monkeypatch.setattr(os, "fsync", lambda descriptor: synced.append(Path(f"/proc/self/fd/{descriptor}").readlink()))
    a_file(tmp_path)[0].write(CHOICE)
    assert synced == [tmp_path / "online-maps.json.new", tmp_path]


def test_the_choice_of_version_0_1_0_is_taken_over_once(tmp_path: Path) -> None:
    old = tmp_path / "state.json"
    old.write_bytes(orjson.dumps({"online": CHOICE}))
    assert a_file(tmp_path)[0].read() == CHOICE
    old.write_bytes(orjson.dumps({"online": {}}))
    assert a_file(tmp_path)[0].read() == CHOICE


@pytest.mark.parametrize("content", [b"{", b"[]", b'{"online": 5}', b"{}"])
def test_an_unusable_old_file_is_no_choice(tmp_path: Path, content: bytes) -> None:
    (tmp_path / "state.json").write_bytes(content)
    assert a_file(tmp_path)[0].read() == {}
    assert not (tmp_path / "online-maps.json").exists()


def test_a_disk_that_refuses_is_reported(tmp_path: Path) -> None:
    (tmp_path / "online-maps.json").mkdir()
    file, reported = a_file(tmp_path)
    assert file.read() == {}
    file.write(CHOICE)
    assert [error.code for error in reported] == ["memory_unreadable", "memory_not_written"]
