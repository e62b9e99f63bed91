"""Packed KML: an archive that every reader opens, written without going back."""

from __future__ import annotations

import io
import random
import zipfile
from collections.abc import Iterator

from hypothesis import given
from hypothesis import strategies as st

from epf_gcs.formats.kmz import kmz_pieces


@given(st.lists(st.binary(max_size=3000), max_size=8), st.binary(max_size=100))
def test_what_goes_in_comes_out(document: list[bytes], model: bytes) -> None:
    data = b"".join(kmz_pieces([("doc.kml", iter(document)), ("models/aircraft.dae", [model])]))
    with zipfile.ZipFile(io.BytesIO(data)) as archive:
        assert archive.testzip() is None
        assert archive.namelist() == ["doc.kml", "models/aircraft.dae"]
        assert archive.read("doc.kml") == b"".join(document)
        assert archive.read("models/aircraft.dae") == model


def test_it_is_written_while_it_is_made() -> None:
    """Memory stays small however long the document: what came out before the end is nearly all of it."""
    made = 0

    def document() -> Iterator[bytes]:
        nonlocal made
        noise = random.Random(1)
        for _ in range(2000):
            made += 1
            yield noise.randbytes(500)

    sizes = [(made, len(piece)) for piece in kmz_pieces([("doc.kml", document())])]
    before_the_end = sum(size for made_then, size in sizes if made_then < 2000)
    assert before_the_end > 0.8 * sum(size for _, size in sizes)
