"""Messages between the station and its worker processes: two lengths, a JSON head, and bytes."""

from __future__ import annotations

import struct
from typing import Any, BinaryIO, Final

import orjson

MOST_HEAD_BYTES: Final = 40_000_000
MOST_DATA_BYTES: Final = 16_000_000

_LENGTHS: Final = struct.Struct("<II")


def send(pipe: BinaryIO, head: dict[str, Any], data: bytes = b"") -> None:
    """Send a message. Raises OSError or ValueError if the other end is closed."""
    packed = orjson.dumps(head)
    pipe.write(_LENGTHS.pack(len(packed), len(data)) + packed)
    pipe.write(data)
    pipe.flush()


def receive(pipe: BinaryIO) -> tuple[dict[str, Any], bytes] | None:
    """Receive a message; None if the other end is closed, or if this is no valid message. Raises OSError."""
    lengths = pipe.read(_LENGTHS.size)
    if len(lengths) < _LENGTHS.size:
        return None
    head_bytes, data_bytes = _LENGTHS.unpack(lengths)
    if head_bytes > MOST_HEAD_BYTES or data_bytes > MOST_DATA_BYTES:
        return None
    packed, data = pipe.read(head_bytes), pipe.read(data_bytes)
    if len(packed) < head_bytes or len(data) < data_bytes:
        return None
    head = orjson.loads(packed)
    return (head, data) if isinstance(head, dict) else None
