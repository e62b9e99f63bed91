"""A directory of a PMTiles file, read with bounds on size and entries, which the library does not have."""

from __future__ import annotations

import zlib
from typing import Any, Final

from pmtiles.tile import Entry

MOST_ENTRIES: Final = 200_000
"""Usual writers put a few thousand into one directory."""

_MOST_BYTES: Final = 4_000_000
_PARTS: Final = 4
_MOST_SHIFT: Final = 63


def unpacked(data: bytes, most_bytes: int) -> bytes:
    """The content of a gzip stream. Raises ValueError if it is longer than `most_bytes`, EOFError if cut off."""
    unpacker = zlib.decompressobj(wbits=31)
    found = unpacker.decompress(data, most_bytes + 1)
    if len(found) > most_bytes:
        raise ValueError(f"more than {most_bytes} bytes are packed into {len(data)}")
    if not unpacker.eof:
        raise EOFError("cut off")
    return found


def read_directory(data: bytes) -> list[Any]:
    """The entries of a packed directory, by tile id. Raises ValueError, EOFError, zlib.error."""
    numbers = _Numbers(unpacked(data, _MOST_BYTES))
    count = numbers.next()
    if count > MOST_ENTRIES:
        raise ValueError(f"a directory with {count} entries")
    ids, run_lengths, lengths, offsets = ([numbers.next() for _ in range(count)] for _ in range(_PARTS))
    entries: list[Any] = []
    tile_id = end = 0
    for step, run_length, length, offset in zip(ids, run_lengths, lengths, offsets, strict=True):
        tile_id += step
        # 0 means directly after the previous entry.
        start = end if offset == 0 and entries else offset - 1
        entries.append(Entry(tile_id, start, length, run_length))
        end = start + length
    return entries


class _Numbers:
    """Varints: seven bits a byte, the lowest first."""

    def __init__(self, data: bytes) -> None:
        self._data = data
        self._at = 0

    def next(self) -> int:
        value = shift = 0
        while True:
            if self._at >= len(self._data):
                raise EOFError("cut off")
            byte = self._data[self._at]
            self._at += 1
            value |= (byte & 127) << shift
            if byte < 128:
                return value
            shift += 7
            if shift > _MOST_SHIFT:
                raise ValueError("a number that has no end")
