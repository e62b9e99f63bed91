"""One browser on the stream: what it was sent, what is still to be sent, and what it missed."""

from __future__ import annotations

from collections import deque
from typing import Final, Protocol

from epf_gcs.web.stream.hub_state import HubState

# A batch is under way until the browser acknowledges that it was shown. With four of them a browser 60 ms away
# still gets 60 a second; a stalled browser has four pending, and gets the newest state as soon as it resumes.
MAX_UNDER_WAY: Final = 4
# Enough for the events of a mission upload; a browser that is further behind gets the number it missed.
_MAX_EVENTS: Final = 256
_MAX_UNSENT_BYTES: Final = 262144
MAX_RATE_HZ: Final = 60


class Outlet(Protocol):
    """Where the messages of one viewer go."""

    def send(self, messages: list[bytes]) -> None:
        """Send JSON texts, without waiting."""

    def unsent_bytes(self) -> int:
        """Bytes that the system has not taken yet."""


class Viewer:
    """Sends the newest state, events from a bounded queue, and never more than a few batches ahead.

    `rate_hz` 0 means every sample as it arrives.
    """

    def __init__(self, client: str, name: str, outlet: Outlet, state: HubState, rate_hz: int) -> None:
        self.client = client
        self.name = name
        self.rate_hz = rate_hz
        self._outlet = outlet
        self._state = state
        self._seq = 0
        self._acknowledged = 0
        self._version = 0
        # The first time, the newest of every topic is sent; with none there yet, nothing of what follows is left out.
        self._is_new = True
        self._events: deque[bytes] = deque()
        self._status: bytes | None = None
        self._missed = 0
        self._missed_events = 0
        self.waiting = False
        self.queued = False

    def greet(self, hello: bytes) -> None:
        """Send the first message."""
        self._outlet.send([hello])

    def offer_event(self, event: bytes) -> None:
        """Queue an event; if the queue is full, drop and count the oldest."""
        if len(self._events) >= _MAX_EVENTS:
            self._events.popleft()
            self._missed_events += 1
        self._events.append(event)

    def offer_status(self, status: bytes) -> None:
        """Queue the status, in place of an older one that was not sent yet."""
        self._status = status

    def acknowledge(self, seq: int) -> bool:
        """The browser has shown this batch and all before it. False if the number is not one of a batch under way."""
        if not self._acknowledged <= seq <= self._seq:
            return False
        self._acknowledged = seq
        return True

    @property
    def is_under_way(self) -> bool:
        """Whether a batch was sent and is not acknowledged."""
        return self._seq != self._acknowledged

    @property
    def blocked(self) -> bool:
        """Whether the limit of batches or bytes under way is reached."""
        return self._seq - self._acknowledged >= MAX_UNDER_WAY or self._outlet.unsent_bytes() > _MAX_UNSENT_BYTES

    def flush(self) -> None:
        """Send everything pending, or mark the viewer as waiting while it is blocked."""
        if self.is_under_way and self.blocked:
            self.waiting = True
            if self.rate_hz and self._version != self._state.version:
                self._missed += 1
            return
        self.waiting = False
        messages: list[bytes] = []
        if self._events:
            messages += self._events
            self._events.clear()
        if self._status is not None:
            messages.append(self._status)
            self._status = None
        body, missed = b"", 0
        since, self._version = self._version, self._state.version
        is_first, self._is_new = self._is_new, False
        if since != self._version:
            if self.rate_hz or is_first:
                body = self._state.changed_since(since)
            else:
                body, missed = self._state.every_since(since)
        # Events and status have no numbers: the batch after them, empty if need be, makes them acknowledged.
        if body or messages:
            self._seq += 1
            messages.append(
                b'{"type":"batch","seq":%d,"t_s":%.6f,"missed":%d,"missed_events":%d,"samples":[%b]}'
                % (self._seq, self._state.newest_s, self._missed + missed, self._missed_events, body)
            )
            self._missed = 0
            self._missed_events = 0
            self._outlet.send(messages)
