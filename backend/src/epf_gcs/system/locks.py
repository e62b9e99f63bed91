"""A lock on an open file, which the system takes back when its process ends, however that ends."""

from __future__ import annotations

import os
import sys
from typing import IO, Any, Final

# Windows locks ranges of bytes and makes them unreadable: this one lies behind anything that is written in such a file.
_LOCKED_BYTE: Final = 1 << 30


def lock(file: IO[Any] | int) -> bool:
    """Take the lock at once; False if another process, or another opening of the file, has it.

    `file` is open for writing (Windows) or anything else (elsewhere). Raises OSError where files cannot be locked.
    """
    return _lock(file if isinstance(file, int) else file.fileno())


if sys.platform == "win32":
    import msvcrt

    def _lock(descriptor: int) -> bool:
        place = os.lseek(descriptor, 0, os.SEEK_CUR)
        os.lseek(descriptor, _LOCKED_BYTE, os.SEEK_SET)
        try:
            msvcrt.locking(descriptor, msvcrt.LK_NBLCK, 1)
        except OSError:
            return False
        finally:
            os.lseek(descriptor, place, os.SEEK_SET)
        return True

else:

    def _lock(descriptor: int) -> bool:
        import fcntl  # noqa: PLC0415 - a module of this system alone

        try:
            fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            return False
        return True
