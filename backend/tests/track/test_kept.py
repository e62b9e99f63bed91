"""A track on the disk comes back as it was, whatever was cut off it."""

from __future__ import annotations

import os
from pathlib import Path

import numpy as np
import pytest

from epf_gcs.track.kept import KeptTrack
from epf_gcs.track.track import ATTITUDE, POINT, Track

T0_S = 1_000_000.0


def a_track(points: int, begin: int = 0) -> Track:
    track = Track(T0_S, 7)
    fly(track, points, begin)
    return track


def fly(track: Track, points: int, begin: int = 0) -> None:
    for n in range(begin, begin + points):
        # A second aircraft's worth of gap after 5,000 points.
        t_s = T0_S + n * 0.02 + (60.0 if n >= 5000 else 0.0)
        track.add(t_s, (27.9 + n * 1e-6, -15.4, 300.0 + n * 0.01), (n % 360.0, 2.0, -3.0) if n % 2 else None)


def save(kept: KeptTrack, track: Track) -> None:
    first = kept.first_unwritten(track)
    blocks = track.blocks(first)
    points, attitudes = b"".join(b.points for b in blocks), b"".join(b.attitudes for b in blocks)
    kept.save(track.epoch, track.t0_s, len(track), points, attitudes, first)


def same(left: Track, right: Track) -> bool:
    def whole(track: Track) -> tuple[bytes, bytes]:
        blocks = track.blocks()
        return b"".join(b.points for b in blocks), b"".join(b.attitudes for b in blocks)

    return whole(left) == whole(right) and left.spans() == right.spans() and left.t0_s == right.t0_s


def test_it_comes_back_whole_with_its_pieces_and_is_flown_on(tmp_path: Path) -> None:
    path = tmp_path / "folder" / "hil.track"
    track, kept = a_track(3000), KeptTrack(path)
    save(kept, track)
    fly(track, 7000, 3000)
    save(kept, track)
    again = KeptTrack(path).load(T0_S + 300.0, 9)
    assert again is not None
    assert same(again, track)
    for one in (again, track):
        fly(one, 10, 10_000)
    assert same(again, track)


def test_a_cleared_track_replaces_the_file(tmp_path: Path) -> None:
    kept = KeptTrack(tmp_path / "hil.track")
    save(kept, a_track(3000))
    short = Track(T0_S, 8)
    fly(short, 3)
    save(kept, short)
    again = KeptTrack(tmp_path / "hil.track").load(T0_S, 9)
    assert again is not None
    assert same(again, short)


@pytest.mark.parametrize("cut", range(1, 60))
def test_a_file_cut_anywhere_gives_every_whole_point(tmp_path: Path, cut: int) -> None:
    path = tmp_path / "hil.track"
    save(KeptTrack(path), a_track(100))
    data = path.read_bytes()
    path.write_bytes(data[:-cut])
    again = KeptTrack(path).load(T0_S, 9)
    assert again is not None
    assert len(again) == 100 - -(-cut // (POINT.itemsize + ATTITUDE.itemsize))


def test_what_is_no_track_or_of_another_day_is_left_alone(tmp_path: Path) -> None:
    path = tmp_path / "hil.track"
    assert KeptTrack(path).load(T0_S, 1) is None
    path.write_bytes(np.random.default_rng(1).bytes(1000))
    assert KeptTrack(path).load(T0_S, 1) is None
    save(KeptTrack(path), a_track(10))
    assert KeptTrack(path).load(T0_S + 86_400.0, 1) is None


def test_a_new_track_is_on_the_disk_before_it_takes_the_old_one_s_place(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    synced: list[Path] = []
    monkeypatch.setattr(os, "fsync", lambda descriptor: synced.append(Path(f"/proc/self/fd/{descriptor}").readlink()))
    save(KeptTrack(tmp_path / "hil.track"), a_track(10))
    assert synced == [tmp_path / "hil.track.new", tmp_path]
