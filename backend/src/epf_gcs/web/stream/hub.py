"""State and events to any number of viewers, none of which can slow down anything else."""

from __future__ import annotations

import asyncio
from collections import deque
from collections.abc import Callable
from typing import Final

from epf_gcs.bus.definition import event_text
from epf_gcs.contract.base import Shape
from epf_gcs.contract.events import Event, SubjectEvent
from epf_gcs.repeating import Repeating, report_failure
from epf_gcs.web.stream.hub_state import HubState
from epf_gcs.web.stream.viewer import Viewer

# Viewers served in one turn of the event loop. Between turns the loop handles all other input, so that fifty viewers
# delay it by the time of a few, not of all.
_VIEWERS_PER_TURN: Final = 4
# The least rate at which samples are wanted, also while nobody is on the stream: for the track, Google Earth and single
# requests. A sample must not grow stale while it waits.
_LEAST_HZ: Final = 20
# A batch may leave this share of a period early: samples that come at the same rate are not held until the next.
_EARLY: Final = 0.25
# By this share of a period the beat of the fastest viewers moves towards that of the samples, while they have to wait.
_TOWARDS: Final = 0.1


class _Pacer:
    """All viewers with the same rate: their batches are sent together, at most `rate_hz` times a second."""

    def __init__(self, loop: asyncio.AbstractEventLoop, rate_hz: int, on_due: Callable[[_Pacer], None]) -> None:
        self.rate_hz = rate_hz
        self.period_s = 1.0 / rate_hz
        self.viewers: list[Viewer] = []
        self.due_s = 0.0
        self.timer = Repeating(loop, "a batch for viewers", lambda: on_due(self))


class Hub:
    """Owned by the event loop. Put any number of samples into `state`, then `flush` once.

    `rate_hz`: how many times a second samples are wanted, by the fastest viewer; 0: each at once. `on_rate` is called
    with it when it changes.
    """

    def __init__(
        self,
        loop: asyncio.AbstractEventLoop,
        now_s: Callable[[], float],
        state: HubState | None = None,
        on_rate: Callable[[int], None] = lambda _: None,
    ) -> None:
        self.state = state or HubState()
        self.rate_hz = _LEAST_HZ
        self._loop = loop
        self._now_s = now_s
        self._on_rate = on_rate
        self._pacers: dict[int, _Pacer] = {}
        self._every_sample: list[Viewer] = []
        self._queue: deque[Viewer] = deque()
        self._turns = Repeating(loop, "the stream's queue", self._turn, after_failure_s=0.0)

    @property
    def viewers(self) -> list[Viewer]:
        """All viewers on the stream."""
        return [*self._every_sample, *(viewer for pacer in self._pacers.values() for viewer in pacer.viewers)]

    def flush(self) -> None:
        """Send new samples to the viewers that are due, and set a timer for the others."""
        if self._every_sample:
            self._send(self._every_sample)
        if self._pacers:
            now = self._loop.time()
            for pacer in self._pacers.values():
                if pacer.timer.is_armed:
                    continue
                if now >= pacer.due_s - _EARLY * pacer.period_s:
                    self._release(pacer, now)
                else:
                    pacer.timer.arm(pacer.due_s - now)

    def event(self, event: Event, /) -> None:
        """Send an event of the web process to every viewer."""
        self.send_event(self.event_text(event))

    def say(self, name: SubjectEvent, data: Shape, /) -> None:
        """Send an event of a subject to every viewer."""
        self.send_event(event_text(name, self._now_s(), data))

    def send_event(self, text: bytes) -> None:
        """Send an event that is JSON text already to every viewer."""
        for viewer in self.viewers:
            viewer.offer_event(text)
            self.serve(viewer)

    def event_text(self, event: Event) -> bytes:
        """The JSON of an event that happens now."""
        return event_text(event.NAME, self._now_s(), event)

    def status(self, text: bytes) -> None:
        """Send the newest status to every viewer."""
        for viewer in self.viewers:
            viewer.offer_status(text)
            self.serve(viewer)

    def add(self, viewer: Viewer) -> None:
        """Add a viewer; it gets the newest sample of every topic first."""
        if viewer.rate_hz:
            self._pacer(viewer.rate_hz).viewers.append(viewer)
        else:
            self._every_sample.append(viewer)
            self.state.keep_all = True
        self._choose_rate()
        self.serve(viewer)

    def remove(self, viewer: Viewer) -> None:
        """Forget a viewer; nothing is sent to it any more."""
        pacer = self._pacers.get(viewer.rate_hz)
        if pacer is not None and viewer in pacer.viewers:
            pacer.viewers.remove(viewer)
            if not pacer.viewers:
                pacer.timer.stop()
                del self._pacers[viewer.rate_hz]
        elif viewer in self._every_sample:
            self._every_sample.remove(viewer)
            if not self._every_sample:
                self.state.drop_log()
        self._choose_rate()

    def change_rate(self, viewer: Viewer, rate_hz: int) -> None:
        """From now on this viewer gets `rate_hz` batches a second; 0: every sample."""
        self.remove(viewer)
        viewer.rate_hz = rate_hz
        self.add(viewer)

    def serve(self, viewer: Viewer) -> None:
        """Queue a viewer for sending."""
        if not viewer.queued:
            viewer.queued = True
            self._queue.append(viewer)
        self._turns.arm()

    def _choose_rate(self) -> None:
        rate_hz = 0 if self._every_sample else max((_LEAST_HZ, *self._pacers))
        if rate_hz != self.rate_hz:
            self.rate_hz = rate_hz
            self._on_rate(rate_hz)

    def _pacer(self, rate_hz: int) -> _Pacer:
        if rate_hz not in self._pacers:
            self._pacers[rate_hz] = _Pacer(self._loop, rate_hz, self._on_due)
        return self._pacers[rate_hz]

    def _on_due(self, pacer: _Pacer) -> None:
        self._release(pacer, self._loop.time())
        if pacer.rate_hz == self.rate_hz:
            # Samples come gathered at this very rate. When both beats agree, they are passed on without this timer.
            pacer.due_s -= _TOWARDS * pacer.period_s

    def _release(self, pacer: _Pacer, now: float) -> None:
        # Due times lie on a fixed grid, so that the mean rate is exact; after a pause the grid starts anew.
        pacer.due_s = max(pacer.due_s + pacer.period_s, now + 0.5 * pacer.period_s)
        self._send(pacer.viewers)

    def _send(self, viewers: list[Viewer]) -> None:
        # The first is sent at once, for the shortest delay to a single browser.
        for place, viewer in enumerate(tuple(viewers)):
            if place == 0:
                self._flush(viewer)
            else:
                self.serve(viewer)

    def _flush(self, viewer: Viewer) -> None:
        """One viewer that fails costs the others nothing. It hears no more, so its page notices and dials again."""
        try:
            viewer.flush()
        except Exception as error:  # noqa: BLE001 - told to the loop
            self.remove(viewer)
            report_failure(self._loop, "a viewer of the stream", error)

    def _turn(self) -> float | None:
        for _ in range(min(_VIEWERS_PER_TURN, len(self._queue))):
            viewer = self._queue.popleft()
            viewer.queued = False
            self._flush(viewer)
        return 0.0 if self._queue else None
