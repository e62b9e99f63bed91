"""Reading and writing at a place in an open file."""

from __future__ import annotations

import os
import sys

if sys.platform == "win32":

    def read_at(descriptor: int, count: int, place: int) -> bytes:
        """Up to `count` bytes from `place` on. One thread at a time. Raises OSError."""
        os.lseek(descriptor, place, os.SEEK_SET)
        return os.read(descriptor, count)

    def write_at(descriptor: int, data: bytes, place: int) -> int:
        """Write from `place` on; returns how many bytes. One thread at a time. Raises OSError."""
        os.lseek(descriptor, place, os.SEEK_SET)
        return os.write(descriptor, data)

else:
    read_at = os.pread
    write_at = os.pwrite
