"""Whether somebody vouches for this computer's time: a time server, a GPS receiver, the host of a virtual machine."""

from __future__ import annotations

import contextlib
import ctypes
import sys
from typing import Final

# Fields of Linux's struct timex up to `status`, its size with room to spare, and the flag "nobody vouches for it".
_STATUS_LONGS: Final = 5
_TIMEX_BYTES: Final = 512
_UNSYNCHRONISED: Final = 0x40
# What adjtimex(2) returns if the clock is not synchronised.
_TIME_ERROR: Final = 5


def is_synchronised() -> bool | None:
    """Whether the system keeps its time by another's; None if it does not say.

    A computer without a battery for its clock and without a network wakes up in the past, and says no.
    """
    if sys.platform != "linux":
        return None
    with contextlib.suppress(AttributeError, OSError):
        # struct timex: modes (int), then offset, freq, maxerror, esterror (long), then status (int).
        asked = (ctypes.c_byte * _TIMEX_BYTES)()
        state = ctypes.CDLL(None).adjtimex(asked)
        if state < 0:
            return None
        place = _STATUS_LONGS * ctypes.sizeof(ctypes.c_long)
        status = ctypes.c_int.from_buffer(asked, place).value
        return state != _TIME_ERROR and not status & _UNSYNCHRONISED
    return None
