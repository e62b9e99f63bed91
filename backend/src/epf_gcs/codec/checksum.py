"""The frame's checksum: minus the sum of all 32-bit words of type and payload, wrapping."""

from __future__ import annotations

from struct import Struct
from typing import Final

MASK: Final = 0xFFFFFFFF
_WORDS: Final = {size: Struct(f"<{size // 4}I") for size in range(4, 129, 4)}


def checksum(body: bytes) -> int:
    """Checksum word of `body` (type and payload, whole words): the number that makes all words sum to 0."""
    words = _WORDS.get(len(body)) or Struct(f"<{len(body) // 4}I")
    total: int = sum(words.unpack(body))
    return -total & MASK
