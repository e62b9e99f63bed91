"""A packed recording at a glance: where its chunks are and what was noted, without unpacking a chunk."""

from __future__ import annotations

import os
from collections.abc import Iterator
from struct import Struct
from typing import BinaryIO, Final, NamedTuple

import numpy as np
from mcap.opcode import Opcode

from epf_gcs.recordings.mcap_file import MAGIC
from epf_gcs.recordings.notes import Note
from epf_gcs.recordings.reading import Reader
from epf_gcs.recordings.scan import HEAD, Other

# Earliest and latest time of a chunk's messages, in ns: the first fields of its record.
_TIMES: Final = Struct("<QQ")
_LATEST_NS: Final = (1 << 63) - 1
# More records than this outside of chunks: the file was not packed by this station.
_MOST_RECORDS: Final = 100_000


class ChunkAt(NamedTuple):
    """A chunk of the file: its offset, and the earliest and latest time in it as it says itself (Unix ns)."""

    place: int
    start_ns: int
    end_ns: int


def skim(reader: Reader, file: BinaryIO) -> list[ChunkAt | Note] | None:
    """Chunks and notes of a finished, packed file in its order; `reader` learns the channels and is at its end then.

    None for any other file, which must be read from its beginning.
    """
    records = _records(file)
    if records is None:
        return None
    found: list[ChunkAt | Note] = []
    for opcode, place, length in records:
        file.seek(place + HEAD.size)
        if opcode == Opcode.CHUNK:
            times = file.read(_TIMES.size)
            start_ns, end_ns = _TIMES.unpack(times) if len(times) == _TIMES.size else (0, _LATEST_NS + 1)
            if end_ns > _LATEST_NS or start_ns > end_ns:
                return None
            reader.passed(end_ns)
            found.append(ChunkAt(place, start_ns, end_ns))
        elif opcode in (Opcode.CHANNEL, Opcode.METADATA):
            if length > reader.limits.record_bytes:
                return None
            data = np.frombuffer(file.read(length), dtype=np.uint8)
            found += reader.learn(data, Other(opcode, 0, length, 0))
    reader.end_at(records[-1][1])
    return found


def _records(file: BinaryIO) -> list[tuple[int, int, int]] | None:
    """Opcode, offset and length of each record up to the end of the data; None if it has plain messages or no end."""
    size = file.seek(0, os.SEEK_END)
    if size < 2 * len(MAGIC):
        return None
    file.seek(size - len(MAGIC))
    if file.read() != MAGIC:
        return None
    records = []
    for record in _heads(file, size):
        records.append(record)
        if record[0] == Opcode.DATA_END:
            has_chunks = any(opcode == Opcode.CHUNK for opcode, _, _ in records)
            return records if has_chunks else None
        if record[0] == Opcode.MESSAGE or len(records) > _MOST_RECORDS:
            return None
    return None


def _heads(file: BinaryIO, size: int) -> Iterator[tuple[int, int, int]]:
    place = len(MAGIC)
    while place + HEAD.size <= size:
        file.seek(place)
        opcode, length = HEAD.unpack(file.read(HEAD.size))
        if place + HEAD.size + length > size:
            return
        yield opcode, place, length
        place += HEAD.size + length
