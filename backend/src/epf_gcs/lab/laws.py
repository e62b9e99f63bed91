"""The board's own C code in this process: bytes of the line in, bytes out (`make -C firmware flight-lib`)."""

from __future__ import annotations

import ctypes
from collections.abc import Sequence
from pathlib import Path
from typing import Any, Final

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
READINGS: Final = (
    *("p_rad_s", "q_rad_s", "r_rad_s", "yaw_deg", "pitch_deg", "roll_deg"),
    *("altitude_m", "vvi_ft_min", "calibrated_airspeed_kt"),
    *("gps_latitude_deg", "gps_longitude_deg", "gps_altitude_m", "gps_speed_kt", "gps_heading_deg"),
    *(f"channel_{number}" for number in range(12)),
)
"""What the real aircraft's loop is flown by, in the order of the library's `epf_flight_readings_t`."""
SERVO_COUNT: Final = 20

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

    def advance(self, elapsed_ms: int) -> None:
        """Let time pass; needed between two commands 50 only if the board measures the time of its steps."""
        self._library.epf_flight_advance(self._board, elapsed_ms)

    def supervise(self) -> None:
        """Let the board see whether command 50 has stopped, as it does each 20 ms."""
        _newer(self._library, "epf_flight_supervise")(self._board)

    def step(self, readings: Sequence[float], elapsed_s: float) -> None:
        """One step of the real aircraft's loop. `readings`: those of `READINGS`, NaN where nothing is measured."""
        packed = (ctypes.c_float * len(READINGS))(*readings)
        _newer(self._library, "epf_flight_step")(self._board, packed, ctypes.c_float(elapsed_s))

    def positions(self) -> list[float]:
        """Of the servos, -1..+1 (throttle 0..1): aileron, elevator, throttle, rudder, and those beside them."""
        positions = (ctypes.c_float * SERVO_COUNT)()
        _newer(self._library, "epf_flight_positions")(self._board, positions)
        return list(positions)

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


def _newer(loaded: ctypes.CDLL, name: str) -> Any:
    """A function that a library of before faults were flown has not. All of them take the board first, a pointer."""
    try:
        return getattr(loaded, name)
    except AttributeError as error:
        raise LabError(f"these laws have no {name}, which faults need: build them anew (make laws)") from error


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
    loaded.epf_flight_advance.argtypes = (ctypes.c_void_p, ctypes.c_uint32)
    loaded.epf_flight_send_streams.argtypes = (ctypes.c_void_p, ctypes.c_uint32)
    loaded.epf_flight_lost_bytes.restype = ctypes.c_size_t
    loaded.epf_flight_lost_bytes.argtypes = (ctypes.c_void_p,)
    return loaded
