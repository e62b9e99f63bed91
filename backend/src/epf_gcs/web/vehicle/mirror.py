"""The newest samples and status from the flight process, passed on to the stream as they arrive."""

from __future__ import annotations

from collections.abc import Callable
from typing import Final

import structlog

from epf_gcs.bus.definition import NamedText
from epf_gcs.clock import Clock
from epf_gcs.contract.base import Values
from epf_gcs.contract.events import FlightProcessEvent
from epf_gcs.contract.hello import ControlHolder, Hello
from epf_gcs.contract.playback import Playback
from epf_gcs.contract.status import Status
from epf_gcs.web.stream.hub import Hub
from epf_gcs.web.vehicle.absent_flight import status_without_flight

# Age limit of topics that the status gives none for: they arrive only on request and have no rate.
_UNKNOWN_LASTS_S: Final = 3.0

log = structlog.get_logger("web")


class VehicleMirror:
    """Implements `epf_gcs.bus.station_end.Listener`. `on_change` is called on a new status; `on_here` when the flight
    process connects, with the browser that has control according to it, or None."""

    def __init__(
        self,
        hub: Hub,
        clock: Clock,
        *,
        on_change: Callable[[], None],
        on_here: Callable[[ControlHolder | None], None],
    ) -> None:
        self._hub = hub
        self._clock = clock
        self._on_change = on_change
        self._on_here = on_here
        self._listeners: dict[str, Callable[[float, Values], None]] = {}
        self._status: Status | None = None
        self._lost_s: float | None = None
        self.is_here = False

    def listen(self, topic: str, listener: Callable[[float, Values], None]) -> None:
        """Call `listener` with the Unix time and the values of each sample of this topic."""
        self._listeners[topic] = listener

    @property
    def status(self) -> Status:
        """The status sent last; without the flight process, one that marks everything as lost."""
        if self.is_here and self._status is not None:
            return self._status
        now_s = self._clock.now_s()
        return status_without_flight(self._status or Status(), now_s, self._lost_s or now_s)

    @property
    def is_emulated(self) -> bool:
        """Whether the data is emulated and not a flight's."""
        return self.is_here and self._status is not None and self._status.board.emulated

    def newest(self, topic: str) -> Values | None:
        """The newest values of a topic, however old."""
        sample = self._hub.state.samples().get(topic)
        return None if sample is None else sample.values

    def newest_at_s(self, topic: str) -> float | None:
        """Unix time of the newest values of a topic."""
        sample = self._hub.state.samples().get(topic)
        return None if sample is None else sample.t_s

    def is_live(self, topic: str) -> bool:
        """Whether the topic's newest sample is not stale."""
        sample = self._hub.state.samples().get(topic)
        if sample is None or not self.is_here or self._status is None:
            return False
        health = self._status.topics.get(topic)
        limit_s = _UNKNOWN_LASTS_S if health is None else health.stale_after_s
        return limit_s is None or self._clock.now_s() - sample.t_s <= limit_s

    def on_hello(self, hello: Hello) -> None:
        """The flight process connected."""
        self._clock.follow(hello.clock_offset_ns)
        self._status = hello.status
        was_lost, self._lost_s = self._lost_s is not None, None
        self.is_here = True
        log.info("the flight process is there", version=hello.version)
        self._on_here(hello.control)
        if was_lost:
            self._hub.event(FlightProcessEvent("back"))
        self._on_change()

    def on_sample(self, sample: NamedText) -> None:
        """Take a sample of a topic."""
        newest = self._hub.state.put(sample.name, sample.t_s, sample.text)
        listener = self._listeners.get(sample.name)
        if listener is not None:
            listener(sample.t_s, newest.values)

    def on_samples_end(self) -> None:
        """A group of samples is complete: send it to the viewers."""
        self._hub.flush()

    def on_event(self, event: NamedText) -> None:
        """Pass an event on to the viewers."""
        self._hub.send_event(event.text)

    def learn(self, status: Status) -> None:
        """Take the status from the answer to a request, without calling `on_change`."""
        self._status = status

    def on_status(self, status: Status) -> None:
        """Take a new status."""
        self._status = status
        self._on_change()

    def on_playback(self, playback: Playback) -> None:
        """A live vehicle does not say this."""

    def on_silence(self, *, silent: bool) -> None:
        """The flight process hangs: nothing of it counts as live until it is heard again."""
        self.is_here = not silent
        if silent:
            self._lost_s = self._clock.now_s()
            log.error("the flight process is there and says nothing")
        else:
            self._lost_s = None
            log.info("the flight process is heard again")
        self._hub.event(FlightProcessEvent("lost" if silent else "back"))
        self._on_change()

    def on_lost(self, *, ended: bool) -> None:
        """The flight process is gone: tell the viewers at once."""
        if not self.is_here:
            return
        self.is_here = False
        self._lost_s = self._clock.now_s()
        if ended:
            log.info("the flight process has ended; it is looked for again")
        else:
            log.error("the flight process is gone; it is looked for again")
        self._hub.event(FlightProcessEvent("lost"))
        self._on_change()
