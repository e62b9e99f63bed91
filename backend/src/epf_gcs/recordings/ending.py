"""How an MCAP file ends: whether its writer closed it, and whether something follows behind that end."""

from __future__ import annotations

import os
from typing import BinaryIO, Final, NamedTuple

from mcap.opcode import Opcode

from epf_gcs.recordings.mcap_file import MAGIC
from epf_gcs.recordings.scan import HEAD

# Records of a summary that are stepped over; ours has one for each chunk and note.
_MOST_RECORDS: Final = 200_000
_BLOCK_BYTES: Final = 1 << 20


class Ending(NamedTuple):
    """`is_whole`: the writer closed the file. `has_more`: bytes follow, as where two files were put into one."""

    is_whole: bool
    has_more: bool


def ending(file: BinaryIO, place: int) -> Ending:
    """How the file goes on from the record at `place`, with which its data end."""
    size = file.seek(0, os.SEEK_END)
    for _ in range(_MOST_RECORDS):
        if place + HEAD.size > size:
            break
        file.seek(place)
        opcode, length = HEAD.unpack(file.read(HEAD.size))
        place += HEAD.size + length
        if opcode == Opcode.FOOTER:
            file.seek(place)
            is_whole = file.read(len(MAGIC)) == MAGIC
            return Ending(is_whole, is_whole and bool(file.read(1)))
    return Ending(False, False)


def zeros_to_end(file: BinaryIO, place: int) -> int | None:
    """How many zeros follow up to the end, as a power cut leaves them; None if anything else does."""
    file.seek(place)
    count = 0
    while block := file.read(_BLOCK_BYTES):
        if block.count(0) != len(block):
            return None
        count += len(block)
    return count
