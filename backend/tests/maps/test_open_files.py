"""Files that stay open for a while: never more than some, and never closed under a reader."""

from __future__ import annotations

import pytest

from epf_gcs.maps.layer import UNKNOWN, Description, Tile
from epf_gcs.maps.open_files import OpenFiles


class Source:
    """Counts how it is used."""

    def __init__(self) -> None:
        self.closed = 0

    @property
    def description(self) -> Description:
        return UNKNOWN

    def tile(self, zoom: int, column: int, row: int) -> Tile | None:
        return None

    def close(self) -> None:
        self.closed += 1


def test_a_file_is_opened_once_until_it_changes() -> None:
    files, opened = OpenFiles(), [Source(), Source()]
    waiting = list(opened)
    for stamp in ((1,), (1,), (2,), (2,)):
        with files.reading("a", stamp, lambda: waiting.pop(0)) as source:
            assert source is opened[stamp[0] - 1]
    assert [one.closed for one in opened] == [1, 0]
    files.close()
    assert [one.closed for one in opened] == [1, 1]


def test_those_not_used_for_longest_are_closed() -> None:
    files, opened = OpenFiles(most=2), {name: Source() for name in "abc"}
    for name in "abac":
        with files.reading(name, (1,), lambda name=name: opened[name]):  # type: ignore[misc]
            pass
    assert {name: source.closed for name, source in opened.items()} == {"a": 0, "b": 1, "c": 0}
    assert len(files) == 2


def test_a_file_that_is_being_read_is_closed_when_the_reader_is_done() -> None:
    files, source = OpenFiles(), Source()
    with files.reading("a", (1,), lambda: source), files.reading("a", (1,), Source):
        files.forget("a")
        assert source.closed == 0
    assert source.closed == 1


def test_a_file_that_cannot_be_opened_is_not_kept() -> None:
    files = OpenFiles()

    def fail() -> Source:
        raise OSError("no")

    with pytest.raises(OSError, match="no"), files.reading("a", (1,), fail):
        pass
    assert len(files) == 0
