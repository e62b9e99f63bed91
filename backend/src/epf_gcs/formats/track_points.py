"""The header before the packed track points that the page reads; the points themselves are already packed."""

from __future__ import annotations

import struct
from typing import Final

MEDIA_TYPE: Final = "application/octet-stream"
HEADER_BYTES: Final = 32
_HEADER: Final = struct.Struct("<4sIIIIId")


def points_header(*, epoch: int, first: int, count: int, total: int, t0_s: float) -> bytes:
    """What comes before `count` records of 16 bytes: u32 ms since t0, i32 latitude and longitude in 1e-7 deg, i32
    altitude in mm above mean sea level, all little endian. `t0_s` is Unix time."""
    return _HEADER.pack(b"EPT1", epoch, first, count, total, 0, t0_s)
