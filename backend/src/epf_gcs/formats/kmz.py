"""A KML and the files it refers to in one archive, packed in pieces, so that a day's track need not fit into memory."""

from __future__ import annotations

import io
import zipfile
from collections.abc import Iterable, Iterator
from typing import Final

MEDIA_TYPE: Final = "application/vnd.google-earth.kmz"
# Readers open the first KML of the archive; this is its usual name.
DOCUMENT: Final = "doc.kml"
_EARLIEST: Final = (1980, 1, 1, 0, 0, 0)


class _Drain(io.RawIOBase):
    """A write-only stream without seeking, which a ZIP archive does not need: holds what was written until `taken`."""

    def __init__(self) -> None:
        self._held = bytearray()

    def writable(self) -> bool:
        """Always True."""
        return True

    def write(self, data: object) -> int:
        """Hold the bytes until they are taken."""
        view = memoryview(data).cast("B")  # type: ignore[arg-type]
        self._held += view
        return len(view)

    def taken(self) -> bytes:
        """Return and forget what was written since the last call."""
        held = bytes(self._held)
        self._held.clear()
        return held


def kmz_pieces(files: Iterable[tuple[str, Iterable[bytes]]]) -> Iterator[bytes]:
    """The archive with these files, named by their paths inside; the document comes first."""
    drain = _Drain()
    with zipfile.ZipFile(drain, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, pieces in files:
            entry = zipfile.ZipInfo(name, _EARLIEST)
            entry.compress_type = zipfile.ZIP_DEFLATED
            with archive.open(entry, "w", force_zip64=True) as file:
                for piece in pieces:
                    file.write(piece)
                    yield drain.taken()
    yield drain.taken()
