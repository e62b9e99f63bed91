"""Messages between the station and its worker processes: two lengths, a JSON head, and bytes."""

from __future__ import annotations

import struct
from typing import BinaryIO, Final

import msgspec

from epf_gcs.workers.lines import ToldFault

MOST_HEAD_BYTES: Final = 40_000_000
MOST_DATA_BYTES: Final = 16_000_000

_LENGTHS: Final = struct.Struct("<II")


class ReplyHead(msgspec.Struct, omit_defaults=True):
    """What every answer's head may say; each worker adds what it answers. The greeting is an empty one."""

    fault: ToldFault | None = None


def send(pipe: BinaryIO, head: object, data: bytes = b"") -> None:
    """Send a message. Raises OSError or ValueError if the other end is closed."""
    packed = msgspec.json.encode(head)
    pipe.write(_LENGTHS.pack(len(packed), len(data)) + packed)
    pipe.write(data)
    pipe.flush()


def receive(pipe: BinaryIO) -> tuple[bytes, bytes] | None:
    """Receive a message, its head as JSON; None if the other end is closed, or if it is no message. Raises OSError."""
    lengths = pipe.read(_LENGTHS.size)
    if len(lengths) < _LENGTHS.size:
        return None
    head_bytes, data_bytes = _LENGTHS.unpack(lengths)
    if head_bytes > MOST_HEAD_BYTES or data_bytes > MOST_DATA_BYTES:
        return None
    packed, data = pipe.read(head_bytes), pipe.read(data_bytes)
    if len(packed) < head_bytes or len(data) < data_bytes:
        return None
    return packed, data
