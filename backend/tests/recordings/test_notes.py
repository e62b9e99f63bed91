"""Notes survive their way through a file, and foreign ones are left out."""

from __future__ import annotations

import pytest

from epf_gcs.recordings.notes import MARK, Note, read, written


def test_a_note_is_read_as_it_was_written() -> None:
    content = {"text": "aquí", "by": None, "id": "1"}
    assert read(MARK, written(1_700_000_000_123_456_789, content)) == Note(1_700_000_000_123_456_789, MARK, content)


@pytest.mark.parametrize("values", [{}, {"t_ns": "soon", "json": "{}"}, {"t_ns": "1", "json": "{"}])
def test_a_record_that_is_no_note_of_ours_is_left_out(values: dict[str, str]) -> None:
    assert read(MARK, values) is None
