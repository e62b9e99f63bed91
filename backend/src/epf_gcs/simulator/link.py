"""A network between the simulator and the station that delays, jitters and loses datagrams.

Times are simulated seconds, and the random numbers are seeded: the same seed loses the same datagrams.
"""

import random
from collections import deque
from dataclasses import dataclass
from typing import Generic, TypeVar

T = TypeVar("T")


@dataclass(frozen=True, slots=True)
class LinkQuality:
    """One direction of the link: fixed delay, extra delay of 0..`jitter_ms`, share of datagrams lost 0..1."""

    delay_ms: float = 0.0
    jitter_ms: float = 0.0
    loss: float = 0.0


class Link(Generic[T]):
    """One direction, for any kind of datagram. They arrive in the order of sending, even with jitter."""

    def __init__(self, quality: LinkQuality, seed: str) -> None:
        self._quality = quality
        # The seed is a text that names the direction, so each direction has its own random numbers.
        self._dice = random.Random(seed)
        self._under_way: deque[tuple[float, T]] = deque()
        self.lost = 0

    def send(self, datagram: T, now_s: float) -> None:
        """Put a datagram on the link; it may get lost there."""
        quality = self._quality
        if quality.loss > 0.0 and self._dice.random() < quality.loss:
            self.lost += 1
            return
        delay_ms = quality.delay_ms
        if quality.jitter_ms > 0.0:
            delay_ms += self._dice.random() * quality.jitter_ms
        # Rounded, so that a delay of whole frames ends exactly at a frame, not a rounding error after it.
        self._under_way.append((round(now_s + delay_ms / 1000.0, 9), datagram))

    @property
    def next_due_s(self) -> float | None:
        """When the next datagram arrives; None when nothing is under way."""
        return self._under_way[0][0] if self._under_way else None

    def due(self, now_s: float) -> list[T]:
        """Take the datagrams that have arrived by `now_s`, in order."""
        arrived = []
        while self._under_way and self._under_way[0][0] <= now_s:
            arrived.append(self._under_way.popleft()[1])
        return arrived
