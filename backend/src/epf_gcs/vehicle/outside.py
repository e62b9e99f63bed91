"""What a vehicle needs from outside: the time, a line to write to, and an outlet for samples and events."""

from __future__ import annotations

from collections.abc import Callable
from typing import Protocol

from epf_gcs.contract.base import Values
from epf_gcs.contract.events import Event


class Clock(Protocol):
    """Tells the time. A live vehicle has the computer's; a replayed one has its recording's."""

    def now_s(self) -> float:
        """Unix seconds."""

    def steady_s(self) -> float:
        """Seconds of a monotonic clock, for measuring durations."""


class Outlet(Protocol):
    """Takes the vehicle's samples and events. Calls never block."""

    def sample(self, topic: str, t_s: float, values: Values) -> None:
        """The newest values of a topic and their Unix time; sent with the next `flush`."""

    def flush(self) -> None:
        """Send the samples taken since the last `flush`."""

    def event(self, event: Event, /) -> None:
        """Something happened that every viewer should hear of."""

    def later(self, decode: Callable[[], None]) -> bool:
        """Frames came that nobody waits for. False: decode them now. True: `decode` is called when they are due."""


class Line(Protocol):
    """The open line to the board, as far as a vehicle uses it."""

    @property
    def baud(self) -> int:
        """Bits per second; a byte takes 10 bits."""

    @property
    def backlog(self) -> int:
        """Bytes written that have not left yet."""

    def write(self, data: bytes) -> bool:
        """Send or queue all of it. False: the queue is full, nothing was taken."""
