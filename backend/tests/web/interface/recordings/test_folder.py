"""Recordings that are read while they grow."""

from __future__ import annotations

from pathlib import Path

from epf_gcs.web.interface.recordings.folder import GrowingFile, RecordingFolder

NAME = "20260101T000000Z"


def test_what_is_written_after_the_request_is_not_sent(tmp_path: Path) -> None:
    file = tmp_path / f"{NAME}.mcap"
    file.write_bytes(b"a" * 600_000)
    found = RecordingFolder(tmp_path, lambda: None).find(NAME)
    assert found is not None
    pieces = found.pieces()
    first = next(pieces)
    with file.open("ab") as end:
        end.write(b"b" * 600_000)
    assert first + b"".join(pieces) == b"a" * 600_000


def test_the_one_that_is_written_ends_at_a_whole_record(tmp_path: Path) -> None:
    (tmp_path / f"{NAME}.mcap").write_bytes(b"whole, and tor")
    folder = RecordingFolder(tmp_path, lambda: GrowingFile(f"{NAME}.mcap", 5))
    found = folder.find(NAME)
    assert found is not None
    assert (found.active, b"".join(found.pieces())) == (True, b"whole")


def test_a_file_that_went_meanwhile_is_none(tmp_path: Path) -> None:
    assert RecordingFolder(tmp_path, lambda: None).find(NAME) is None
    assert RecordingFolder(tmp_path / "nowhere", lambda: None).all() == []
