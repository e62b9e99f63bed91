"""The index at the end of a finished, packed recording: where to begin reading for a time."""

from __future__ import annotations

import os
from pathlib import Path
from struct import Struct
from typing import BinaryIO, Final

import numpy as np
from mcap.opcode import Opcode

from epf_gcs.recordings.limits import Limits
from epf_gcs.recordings.mcap_file import MAGIC
from epf_gcs.recordings.scan import HEAD, scan

_FOOTER: Final = Struct("<BQQQI")
_TAIL_BYTES: Final = _FOOTER.size + len(MAGIC)
# Of a chunk's index: earliest time, latest time (ns), offset of the chunk. A chunk begins with the same two times.
_INDEX: Final = Struct("<QQQ")
_TIMES: Final = Struct("<QQ")


def chunk_before(path: Path, t_ns: int, limits: Limits) -> int:
    """The offset of the first chunk that ends at or after `t_ns`; 0 without a usable index."""
    try:
        with path.open("rb") as file:
            chunks = _chunks(file, limits)
            # One entry that lies could hide a chunk, so all are looked at.
            if all(_is_chunk(file, offset, start_ns, end_ns) for start_ns, end_ns, offset in chunks):
                return next((offset for _, end_ns, offset in chunks if end_ns >= t_ns), 0)
    except OSError:
        pass  # whoever reads the file meets the same error and reports it
    return 0


def _chunks(file: BinaryIO, limits: Limits) -> list[tuple[int, int, int]]:
    """Earliest time, latest time and offset of each chunk, in file order."""
    size = file.seek(0, os.SEEK_END)
    if size < _TAIL_BYTES:
        return []
    file.seek(size - _TAIL_BYTES)
    tail = file.read(_TAIL_BYTES)
    opcode, length, summary_start, _, _ = _FOOTER.unpack_from(tail)
    if not tail.endswith(MAGIC) or (opcode, length) != (Opcode.FOOTER, _FOOTER.size - HEAD.size):
        return []
    if not 0 < summary_start < size or size - summary_start > limits.chunk_bytes:
        return []
    file.seek(summary_start)
    data = file.read(size - _TAIL_BYTES - summary_start)
    others = scan(np.frombuffer(data, dtype=np.uint8), limits.chunk_bytes).others
    found = [
        _INDEX.unpack_from(data, other.start)
        for other in others
        if other.opcode == Opcode.CHUNK_INDEX and other.length >= _INDEX.size
    ]
    return sorted(found, key=lambda index: index[2])


def _is_chunk(file: BinaryIO, offset: int, start_ns: int, end_ns: int) -> bool:
    """Whether the chunk that the index names is there."""
    if offset >= file.seek(0, os.SEEK_END):
        return False
    file.seek(offset)
    head = file.read(HEAD.size + _TIMES.size)
    if len(head) < HEAD.size + _TIMES.size or head[0] != Opcode.CHUNK:
        return False
    return _TIMES.unpack_from(head, HEAD.size) == (start_ns, end_ns)
