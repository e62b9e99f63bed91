"""The program that makes the page's backup looks for room first, and leaves a whole file or none."""

from __future__ import annotations

import errno
import os
from pathlib import Path
from typing import Final

import pytest

from epf_gcs.backup.archive import restore
from epf_gcs.errors import GatewayError
from epf_gcs.flights.backup_verb import run
from epf_gcs.flights.export.asked import RESERVE_BYTES

PASSWORD: Final = "correct horse"  # noqa: S105
BYTES: Final = 3_000_000


@pytest.fixture
def data(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setattr("epf_gcs.backup.age_archive.WORK", 10)
    folder = tmp_path / "data"
    for name in ("a", "b"):
        (folder / "recordings").mkdir(parents=True, exist_ok=True)
        (folder / "recordings" / f"{name}.mcap").write_bytes(bytes(BYTES))
    return folder


def test_the_share_of_bytes_is_told_and_the_file_comes_back(data: Path, tmp_path: Path) -> None:
    told: list[float] = []
    target = data / "exports" / "made"
    answer = run(
        [str(data), str(target)],
        lambda share, _doing: told.append(share),
        lambda: PASSWORD,
        lambda _folder: RESERVE_BYTES + 2 * BYTES,
    )
    assert answer == {"bytes": target.stat().st_size}
    assert told == [0.0, 0.5]
    restore(target, tmp_path / "back", lambda _name: None, PASSWORD)
    assert (tmp_path / "back" / "recordings" / "b.mcap").stat().st_size == BYTES


@pytest.mark.parametrize("rooms", [[0], [RESERVE_BYTES + 2 * BYTES, RESERVE_BYTES + 2 * BYTES, RESERVE_BYTES]])
def test_without_room_for_it_beside_the_flights_nothing_is_made(data: Path, rooms: list[int]) -> None:
    left = iter(rooms)
    with pytest.raises(GatewayError) as caught:
        run([str(data), str(data / "exports" / "made")], lambda *_: None, lambda: PASSWORD, lambda _folder: next(left))
    assert caught.value.code == "backup_disk_full"
    assert caught.value.params["reserve_mb"] == 1500
    assert list((data / "exports").iterdir()) == []


def test_a_disk_that_refuses_is_told_and_nothing_stays(data: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def broken(_descriptor: int) -> None:
        raise OSError(errno.EIO, "Input/output error")

    monkeypatch.setattr(os, "fsync", broken)
    with pytest.raises(GatewayError) as caught:
        run([str(data), str(data / "exports" / "made")], lambda *_: None, lambda: PASSWORD, lambda _: 10**12)
    assert (caught.value.code, caught.value.params) == ("backup_not_written", {"why": "Input/output error"})
    assert list((data / "exports").iterdir()) == []
