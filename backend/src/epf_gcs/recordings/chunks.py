"""One chunk of a packed recording: the records in it, however its compressed bytes end."""

from __future__ import annotations

import zlib
from struct import Struct, error
from typing import Final, NamedTuple

import numpy as np
import zstandard
from mcap.opcode import Opcode

from epf_gcs.recordings.limits import Limits, RecordingError
from epf_gcs.recordings.scan import Bytes, Other

_FIELDS: Final = Struct("<QQQII")
_SIZE: Final = Struct("<Q")


class Chunk(NamedTuple):
    """The unpacked records of a chunk; `damage` says what is wrong with it, None if nothing is."""

    data: Bytes
    damage: str | None


class ChunkHead(NamedTuple):
    """What a chunk says of itself: earliest and latest time (ns), unpacked size, checksum, packing, packed bytes."""

    start_ns: int
    end_ns: int
    unpacked: int
    crc: int
    packing: str
    content: memoryview
    is_whole: bool


def unpack(body: memoryview, limits: Limits) -> Chunk:
    """Unpack the content of a Chunk record, also of one that was cut: as many bytes of it as there are.

    Raises RecordingError for a chunk that is larger than the limit, or packed in another way than ours.
    """
    head = read_head(body)
    if head is None:
        return Chunk(np.empty(0, dtype=np.uint8), "a chunk's head makes no sense")
    if head.unpacked > limits.chunk_bytes:
        raise RecordingError(
            "recording_too_large",
            f"A chunk of this file unpacks to {head.unpacked} bytes; at most {limits.chunk_bytes} are read.",
            most=limits.chunk_bytes,
        )
    data, damage = _content(head)
    if damage is None and not head.is_whole:
        damage = "the file ends inside a chunk"
    elif damage is None and len(data) != head.unpacked:
        damage = "a chunk unpacks to another size than it says"
    elif damage is None and head.crc and zlib.crc32(data) != head.crc:
        damage = "a chunk's checksum is wrong"
    return Chunk(np.frombuffer(data, dtype=np.uint8), damage)


def read_head(body: memoryview) -> ChunkHead | None:
    """The fields of a Chunk record's content; None if they make no sense."""
    try:
        start_ns, end_ns, unpacked, crc, name_size = _FIELDS.unpack_from(body)
        at = _FIELDS.size + name_size
        packing = bytes(body[_FIELDS.size : at]).decode()
        (size,) = _SIZE.unpack_from(body, at)
    except (error, UnicodeDecodeError):
        return None
    content = body[at + _SIZE.size :]
    return ChunkHead(start_ns, end_ns, unpacked, crc, packing, content[:size], size <= len(content))


def _content(head: ChunkHead) -> tuple[bytes, str | None]:
    if head.packing == "":
        return bytes(head.content[: head.unpacked]), None
    if head.packing != "zstd":
        raise RecordingError(
            "recording_packing_unknown",
            f"This file is packed with {head.packing[:20]!r}: pack it with zstd, or not at all.",
            packing=head.packing[:20],
        )
    reader = zstandard.ZstdDecompressor(max_window_size=1 << 27).stream_reader(head.content)
    data = b""
    try:
        # As a stream, and never more than the chunk claims: what a frame says of its own size is not believed.
        while len(data) < head.unpacked and (more := reader.read(head.unpacked - len(data))):
            data = data + more if data else more
    except zstandard.ZstdError:
        return data, "a chunk cannot be unpacked to its end"
    return data, None


def chunk_begins(data: Bytes, others: list[Other]) -> list[int]:
    """The time at which the first of these chunks begins, if there is one."""
    for other in others:
        if other.opcode == Opcode.CHUNK:
            head = read_head(data.data[other.start : other.start + other.length])
            return [] if head is None else [head.start_ns]
    return []
