"""A clock and a board's line that stand in a test's hand."""

from __future__ import annotations

from epf_gcs.clock import Clock
from epf_gcs.codec.encode import encode_telemetry
from epf_gcs.codec.frame import TO_BOARD, Frame, FrameDecoder
from epf_gcs.link.base import LinkCallbacks
from epf_gcs.vehicle.board import Board

HEARTBEAT = encode_telemetry("heartbeat", *[0] * 12)
ALL_FEATURES = 15
UNIX_S = 1.7e9
"""Unix time when a held clock stands at 0."""


class HeldClock(Clock):
    """It goes only when a test adds to `time_s`."""

    def __init__(self, time_s: float = 1000.0) -> None:
        super().__init__()
        self.time_s = time_s

    def steady_s(self) -> float:
        return self.time_s

    def now_s(self) -> float:
        return UNIX_S + self.time_s


class HeldLine:
    """A link whose other end is the test. `sent`: names of the commands that were sent; `raw`: all bytes."""

    backlog = 0

    def __init__(self, baud: int = 115200) -> None:
        self.baud = baud
        self.sent: list[str] = []
        self.raw = b""
        self.is_full = False
        self.is_closed = False
        self.delivered = 0
        self.callbacks: LinkCallbacks | None = None
        self._decoder = FrameDecoder(TO_BOARD)

    def start(self, callbacks: LinkCallbacks) -> None:
        self.callbacks = callbacks

    def deliver(self) -> None:
        self.delivered += 1

    def close(self) -> None:
        self.is_closed = True

    def write(self, data: bytes) -> bool:
        if self.is_full:
            return False
        self.raw += data
        self.sent += [found.message.name for found in self._decoder.feed(data) if isinstance(found, Frame)]
        return True


def open_session(board: Board, features: int = ALL_FEATURES) -> None:
    """Answer the station as an extended board, on the line that is attached."""
    board.on_bytes(HEARTBEAT)
    board.on_bytes(encode_telemetry("capabilities", 1, features, b"fake", b"1.0", 5))
    assert board.is_open
