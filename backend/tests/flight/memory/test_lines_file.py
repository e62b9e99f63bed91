"""A file of lines and what a disk can do to it."""

from __future__ import annotations

import asyncio
import os
from pathlib import Path

import pytest

from epf_gcs.errors import GatewayError
from epf_gcs.flight.memory.lines_file import LinesFile
from tests.support.files import the_one_like
from tests.support.waiting import eventually_async

pytestmark = pytest.mark.anyio


def a_file(path: Path, keep: int = 3) -> tuple[LinesFile, list[GatewayError]]:
    reported: list[GatewayError] = []
    return LinesFile(path, keep, reported.append), reported


async def test_lines_are_there_after_a_restart_in_their_order(tmp_path: Path) -> None:
    path = tmp_path / "deep" / "lines.jsonl"
    file, reported = a_file(path)
    assert file.read() == []
    file.begin_with([], damaged=False)
    file.append(b"a")
    file.append(b"b")
    file.close()
    again, _ = a_file(path)
    assert again.read() == [b"a", b"b"]
    again.begin_with([b"a", b"b"], damaged=False)
    again.append(b"c")
    again.close()
    assert path.read_bytes() == b"a\nb\nc\n"
    assert reported == []


async def test_the_file_never_grows_beyond_twice_what_is_kept(tmp_path: Path) -> None:
    path = tmp_path / "lines.jsonl"
    file, _ = a_file(path)
    file.begin_with(file.read(), damaged=False)
    for number in range(100):
        file.append(b"%d" % number)
    file.close()
    lines = path.read_bytes().splitlines()
    assert lines[-3:] == [b"97", b"98", b"99"]
    assert len(lines) <= 6


async def test_the_file_is_cut_when_it_holds_twice_what_is_kept_and_not_before(tmp_path: Path) -> None:
    lengths = []
    for appended in range(1, 13):
        path = tmp_path / f"{appended}.jsonl"
        file, _ = a_file(path)
        for number in range(appended):
            file.append(b"%d" % number)
        file.close()
        lengths.append(len(path.read_bytes().splitlines()))
    assert lengths == [1, 2, 3, 4, 5, 6, 3, 4, 5, 6, 3, 4]


async def test_a_file_that_is_just_long_enough_is_left_as_it_is(tmp_path: Path) -> None:
    path = tmp_path / "lines.jsonl"
    path.write_bytes(b"a\nb\nc\n")
    with path.open("rb") as as_it_was:
        file, _ = a_file(path)
        file.begin_with(file.read(), damaged=False)
        file.append(b"d")
        file.close()
        assert as_it_was.read() == b"a\nb\nc\nd\n"


async def test_each_line_is_pushed_to_the_disk_before_the_next(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = tmp_path / "lines.jsonl"
    pushed: list[bytes] = []
    monkeypatch.setattr(os, "fsync", lambda _: pushed.append(path.read_bytes()))
    file, _ = a_file(path)
    file.append(b"a")
    file.append(b"b")
    file.close()
    assert pushed == [b"a\n", b"a\nb\n"]


async def test_a_file_that_became_too_long_is_cut_at_the_start(tmp_path: Path) -> None:
    path = tmp_path / "lines.jsonl"
    path.write_bytes(b"a\nb\nc\nd\n")
    file, _ = a_file(path)
    file.begin_with(file.read(), damaged=False)
    file.close()
    assert path.read_bytes() == b"b\nc\nd\n"


async def test_a_line_that_was_cut_off_at_its_end_does_not_swallow_the_next(tmp_path: Path) -> None:
    path = tmp_path / "lines.jsonl"
    path.write_bytes(b"a\nb")
    file, _ = a_file(path)
    file.begin_with(file.read(), damaged=False)
    file.append(b"c")
    file.close()
    assert path.read_bytes() == b"a\nb\nc\n"


async def test_a_damaged_file_is_kept_aside(tmp_path: Path) -> None:
    path = tmp_path / "lines.jsonl"
    path.write_bytes(b"a\nrubbish\nb\n")
    file, _ = a_file(path)
    file.read()
    file.begin_with([b"a", b"b"], damaged=True)
    file.append(b"c")
    file.close()
    assert path.read_bytes() == b"a\nb\nc\n"
    assert the_one_like(tmp_path, "lines.jsonl.damaged-*").read_bytes() == b"a\nrubbish\nb\n"


async def test_a_disk_that_refuses_is_reported_and_the_next_line_is_tried(tmp_path: Path) -> None:
    path = tmp_path / "folder" / "lines.jsonl"
    (tmp_path / "folder").write_text("a file where the folder should be")
    file, reported = a_file(path)
    file.append(b"a")
    await eventually_async(lambda: len(reported) == 1, "the failure is told")
    assert reported[0].code == "journal_not_written"
    assert f"The journal could not be kept in {path} (File exists): " in reported[0].detail
    (tmp_path / "folder").unlink()
    file.append(b"b")
    await asyncio.to_thread(file.close)
    assert path.read_bytes() == b"b\n"
    assert len(reported) == 1


async def test_after_the_end_nothing_is_written_and_nothing_fails(tmp_path: Path) -> None:
    file, reported = a_file(tmp_path / "lines.jsonl")
    file.close()
    file.append(b"a")
    assert not (tmp_path / "lines.jsonl").exists()
    assert reported == []


async def test_a_line_is_appended_without_writing_the_others_again(tmp_path: Path) -> None:
    path = tmp_path / "lines.jsonl"
    path.write_bytes(b"a\n")
    with path.open("rb") as as_it_was:
        file, _ = a_file(path, keep=300)
        file.begin_with(file.read(), damaged=False)
        for number in range(5):
            file.append(b"%d" % number)
        file.close()
        assert as_it_was.read() == b"a\n0\n1\n2\n3\n4\n"


async def test_a_link_in_the_place_of_the_file_is_not_written_through_and_that_is_told(tmp_path: Path) -> None:
    foreign, path = tmp_path / "foreign", tmp_path / "lines.jsonl"
    foreign.write_bytes(b"of somebody else\n")
    path.symlink_to(foreign)
    file, reported = a_file(path)
    file.append(b"a")
    file.close()
    await eventually_async(lambda: bool(reported), "the person is told")
    assert foreign.read_bytes() == b"of somebody else\n"
