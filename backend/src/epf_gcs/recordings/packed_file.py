"""The bytes of an MCAP file of zstd chunks, with an index of messages, chunks and notes at its end.

The library's own writer takes one message at a time; an hour of a full line has a million of them. Here a chunk is
made of records that are already bytes, and its index of arrays.
"""

from __future__ import annotations

import zlib
from struct import Struct
from typing import BinaryIO, Final

import numpy as np
import zstandard
from mcap.opcode import Opcode
from mcap.records import ChunkIndex, MetadataIndex

from epf_gcs.recordings.mcap_file import Tally, closing, data_end, encoded, opening
from epf_gcs.recordings.parts import Messages
from epf_gcs.recordings.scan import Bytes, Places
from epf_gcs.recordings.topics import TOPICS

# Larger chunks pack better, smaller ones are quicker to search; gains above this are below a hundredth.
_CHUNK_BYTES: Final = 4 << 20
_LEVEL: Final = 12
_PACKING: Final = "zstd"

_CHUNK_HEAD: Final = Struct("<BQQQQII")
_SIZE: Final = Struct("<Q")
_INDEX_HEAD: Final = Struct("<BQHI")
_ENTRY: Final = np.dtype([("t_ns", "<u8"), ("at", "<u8")])


class PackedFile:
    """Writes into an empty file. Raises OSError."""

    def __init__(self, file: BinaryIO, library: str) -> None:
        self._file = file
        self._place = 0
        self._tally = Tally()
        self._chunks: list[ChunkIndex] = []
        self._notes: list[MetadataIndex] = []
        self._records: list[Bytes] = []
        self._channel: list[Places] = []
        self._t_ns: list[Places] = []
        self._at: list[Places] = []
        self._gathered = 0
        self._compressor = zstandard.ZstdCompressor(level=_LEVEL)
        self._put(opening(library, TOPICS))

    def put(self, records: Bytes, at: Places, messages: Messages) -> None:
        """Append message records; `at` (shape (n,)) is where each of the n messages begins in them."""
        first = 0
        while first < len(at):
            room = _CHUNK_BYTES - self._gathered
            # As many whole records as there is room for, and one at least in a new chunk.
            begin = int(at[first])
            end = int(np.searchsorted(at, begin + room, side="right")) - 1
            end = len(at) if len(records) - begin <= room else max(end, first + (self._gathered == 0))
            stop = len(records) if end == len(at) else int(at[end])
            if end > first:
                self._records.append(records[begin:stop])
                self._channel.append(messages.channel[first:end].astype(np.int64))
                self._t_ns.append(messages.t_ns[first:end])
                self._at.append(at[first:end] - begin + self._gathered)
                self._gathered += stop - begin
                first = end
            if first < len(at):
                self._end_chunk()

    def note(self, name: str, record: bytes) -> None:
        """Append a Metadata record after the messages so far: it ends the chunk, for a chunk holds messages alone."""
        self._end_chunk()
        self._notes.append(MetadataIndex(offset=self._place, length=len(record), name=name))
        self._tally.metadata_count += 1
        self._put(record)

    def finish(self) -> None:
        """Write the last chunk and the summary."""
        self._end_chunk()
        end = data_end()
        indexes = b"".join([encoded(index) for index in (*self._chunks, *self._notes)])
        summary = closing(TOPICS, self._tally, self._place + len(end), indexes, len(self._chunks))
        self._put(end + summary)

    def _end_chunk(self) -> None:
        if not self._gathered:
            return
        content = np.concatenate(self._records).tobytes()
        channel, t_ns, at = (np.concatenate(arrays) for arrays in (self._channel, self._t_ns, self._at))
        self._records, self._channel, self._t_ns, self._at, self._gathered = [], [], [], [], 0
        packed = self._compressor.compress(content)
        start_ns, end_ns = int(t_ns.min()), int(t_ns.max())
        place, name = self._place, _PACKING.encode()
        length = _CHUNK_HEAD.size - 9 + len(name) + _SIZE.size + len(packed)
        head = _CHUNK_HEAD.pack(Opcode.CHUNK, length, start_ns, end_ns, len(content), zlib.crc32(content), len(name))
        self._put(head + name + _SIZE.pack(len(packed)) + packed)
        index_place, offsets = self._place, {}
        for number in np.unique(channel).tolist():
            offsets[number] = self._place
            chosen = np.flatnonzero(channel == number)
            entries = np.empty(len(chosen), dtype=_ENTRY)
            entries["t_ns"], entries["at"] = t_ns[chosen], at[chosen]
            self._put(_INDEX_HEAD.pack(Opcode.MESSAGE_INDEX, 6 + entries.nbytes, number, entries.nbytes))
            self._put(entries.tobytes())
            self._tally.add_all(number, t_ns[chosen])
        self._chunks.append(
            ChunkIndex(
                chunk_length=index_place - place,
                chunk_start_offset=place,
                compression=_PACKING,
                compressed_size=len(packed),
                message_end_time=end_ns,
                message_index_length=self._place - index_place,
                message_index_offsets=offsets,
                message_start_time=start_ns,
                uncompressed_size=len(content),
            )
        )

    def _put(self, data: bytes) -> None:
        self._file.write(data)
        self._place += len(data)
