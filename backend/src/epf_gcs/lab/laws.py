"""The board's own C code in this process: bytes of the line in, bytes out (`make -C firmware flight-lib`)."""

from __future__ import annotations

import ctypes
from pathlib import Path
from typing import Final

from epf_gcs.lab.errors import LabError
from epf_gcs.product import BOARD

FMS_TASK: Final = 1
"""The board's task that sends plans and waypoints; it runs every `FMS_PERIOD_S`."""
FMS_PERIOD_S: Final = 0.1

LINE: Final = "line"
LAWS: Final = ("bearing", LINE)
"""How a plan is flown, in the order of the board's numbers: towards the next waypoint, as deployed; along the line."""
LINE_GAIN: Final = "line_"
"""What the names of the line law's gains begin with."""
BANK_LIMIT: Final = "line_bank_limit"
USUAL_BANK_DEG: Final = 30.0
"""Default of `BANK_LIMIT`."""

_OUT_BYTES: Final = 16384


class Laws:
    """One board: its laws, its line and its plans, with the flash empty. Raises LabError where the library is missing.

    `hil_period_s`: the time of one step of the laws; 0: the board measures it, as deployed (see `advance`).
    """

    def __init__(self, hil_period_s: float, library: Path | None = None) -> None:
        loaded = _load(library)
        self._feed = loaded.epf_flight_feed
        self._library = loaded
        self._board = ctypes.c_void_p(loaded.epf_flight_new(hil_period_s))
        self._out = ctypes.create_string_buffer(_OUT_BYTES)

    def close(self) -> None:
        """Free the board."""
        self._library.epf_flight_free(self._board)

    def feed(self, data: bytes) -> bytes:
        """Give the board bytes; returns what it sends. Raises LabError if it had more to send than its line takes."""
        size = self._feed(self._board, data, len(data), self._out, _OUT_BYTES)
        if self._library.epf_flight_lost_bytes(self._board):
            raise LabError("the board sent more than its line takes")
        return self._out.raw[:size] if size else b""

    def select(self, law: str) -> None:
        """Fly plans by one of `LAWS`. Raises LabError if the board has only the deployed one."""
        if law == LAWS[0] and not hasattr(self._library, "epf_flight_select_law"):
            return
        if not self._library.epf_flight_select_law(self._board, LAWS.index(law)):
            raise LabError(f"the board has no law {law}")

    def set_line_gain(self, name: str, value: float) -> None:
        """Set a gain of the line law. Raises LabError for one that it has not, or refuses."""
        if not self._library.epf_flight_set_line_gain(self._board, name.encode(), value):
            raise LabError(f"the board takes no gain {name} of {value}")

    def advance(self, elapsed_ms: int) -> None:
        """Let time pass; needed between two commands 50 only if the board measures the time of its steps."""
        self._library.epf_flight_advance(self._board, elapsed_ms)

    def send_streams(self, task: int) -> bytes:
        """Let one of the board's tasks send its streams; returns them."""
        self._library.epf_flight_send_streams(self._board, task)
        return self.feed(b"")


def library() -> Path:
    """The laws of this station's own board. Raises LabError where they are not built."""
    try:
        return BOARD.file("posix/libepf-flight.so")
    except FileNotFoundError as error:
        raise LabError(str(error)) from error


def _load(path: Path | None) -> ctypes.CDLL:
    try:
        loaded = ctypes.CDLL(str(path or library()))
    except OSError as error:
        raise LabError(f"{path} cannot be loaded as the laws of a board: {error}") from error
    loaded.epf_flight_new.restype = ctypes.c_void_p
    loaded.epf_flight_new.argtypes = (ctypes.c_float,)
    loaded.epf_flight_free.argtypes = (ctypes.c_void_p,)
    loaded.epf_flight_feed.restype = ctypes.c_size_t
    loaded.epf_flight_feed.argtypes = (
        ctypes.c_void_p,
        ctypes.c_char_p,
        ctypes.c_size_t,
        ctypes.c_char_p,
        ctypes.c_size_t,
    )
    if hasattr(loaded, "epf_flight_select_law"):
        loaded.epf_flight_select_law.restype = ctypes.c_bool
        loaded.epf_flight_select_law.argtypes = (ctypes.c_void_p, ctypes.c_int32)
        loaded.epf_flight_set_line_gain.restype = ctypes.c_bool
        loaded.epf_flight_set_line_gain.argtypes = (ctypes.c_void_p, ctypes.c_char_p, ctypes.c_float)
    loaded.epf_flight_advance.argtypes = (ctypes.c_void_p, ctypes.c_uint32)
    loaded.epf_flight_send_streams.argtypes = (ctypes.c_void_p, ctypes.c_uint32)
    loaded.epf_flight_lost_bytes.restype = ctypes.c_size_t
    loaded.epf_flight_lost_bytes.argtypes = (ctypes.c_void_p,)
    return loaded
