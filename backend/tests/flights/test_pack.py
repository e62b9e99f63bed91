"""The worker that packs: a finished recording becomes smaller, one that is cut or packed stays as it is."""

from __future__ import annotations

from pathlib import Path

import pytest

from epf_gcs.flights.pack import run
from epf_gcs.recordings.limits import RecordingError
from epf_gcs.recordings.reading import read_file
from tests.flights.flown_flights import recording


def test_a_finished_recording_is_packed_once_and_holds_the_same_messages(tmp_path: Path) -> None:
    file = tmp_path / "20260131T120000Z.mcap"
    file.write_bytes(recording(4))
    before = len(read_file(file).messages.channel)
    told: list[float] = []
    packed = run([str(file)], lambda share, _: told.append(share))
    assert packed["bytes_after"] == file.stat().st_size < packed["bytes_before"] / 2
    assert len(read_file(file).messages.channel) == before
    assert told == sorted(told)
    assert run([str(file)], lambda *_: None)["bytes_after"] == file.stat().st_size


def test_one_that_is_cut_is_left_and_what_is_no_recording_is_refused(tmp_path: Path) -> None:
    file = tmp_path / "20260131T120000Z.mcap"
    cut = recording(2)[:-3000]
    file.write_bytes(cut)
    assert run([str(file)], lambda *_: None) == {"bytes_before": len(cut), "bytes_after": len(cut)}
    assert file.read_bytes() == cut
    file.write_bytes(b"no recording at all" * 100)
    with pytest.raises(RecordingError):
        run([str(file)], lambda *_: None)
