"""Finds where the records of a damaged file go on.

A wrong length leads into the middle of another record. A message of this station is known by its two times, which are
equal; what is found counts only with whole records behind it.
"""

from __future__ import annotations

import re
from typing import BinaryIO, Final

from mcap.opcode import Opcode

from epf_gcs.recordings.scan import HEAD, KNOWN

_MESSAGE: Final = re.compile(rb"\x05.{3}\x00{5}.{6}(.{8})\1", re.DOTALL)
# A message, a note (with its name's length), or the end of the data.
_FIRST: Final = re.compile(
    rb"(?=\x05.{3}\x00{5}.{6}(.{8})\1|\x0c.{3}\x00{5}.{2}\x00\x00|\x0f\x04\x00{7})",
    re.DOTALL,
)
_RECORDS: Final = 3
# The next record is mostly near.
_NEAR_BYTES: Final = 1 << 16
_WINDOW_BYTES: Final = 4 << 20
# Three records are in it, so the longest of them is about a third.
_BEYOND_BYTES: Final = 1 << 20


def next_record(file: BinaryIO, place: int, end: int | None = None) -> int | None:
    """Where the next record begins, at `place` or later: the first that whole records follow. None if there is none.

    The search stops at `end`, because what a flight in the air has written since is no proof of damage before it.
    """
    window = _NEAR_BYTES
    while True:
        most = window + _BEYOND_BYTES
        file.seek(place)
        data = file.read(most if end is None else max(0, min(most, end - place)))
        for found in _FIRST.finditer(data):
            if found.start() >= window:
                break
            if _is_followed(data, found.start()):
                return place + found.start()
        if len(data) < most:
            return None
        place, window = place + window, _WINDOW_BYTES


def _is_followed(data: bytes, at: int) -> bool:
    """Whether whole records stand one behind the other from here on."""
    for _ in range(_RECORDS):
        if at + HEAD.size > len(data):
            return False
        opcode, length = HEAD.unpack_from(data, at)
        is_message = opcode == Opcode.MESSAGE
        if opcode not in KNOWN or (is_message and _MESSAGE.match(data, at) is None):
            return False
        at += HEAD.size + length
        if at > len(data):
            return False
    return True
