"""What is known and done in a flight, as notes in its recording: all that is known at the start of each file, then
each change and event at its time."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any, Final
from uuid import uuid4

from epf_gcs.bus.vehicle_end import Broadcast
from epf_gcs.contract.answers import Mark
from epf_gcs.contract.events import (
    AdviceEvent,
    AlarmEvent,
    BoardRestartEvent,
    CommandEvent,
    ConsoleEvent,
    Event,
    FaultEvent,
    LinkEvent,
    MissionEvent,
    OwnGainsEvent,
    ParameterEvent,
    SimulatorJumpEvent,
    StickEvent,
    WindEvent,
)
from epf_gcs.flight.clock.line_clock import LineClock
from epf_gcs.flight.recording.recorder import Recorder
from epf_gcs.recordings.notes import EVENT, MARK

# Events that say more than the bytes of the lines do.
_NOTED: Final = (
    AdviceEvent,
    AlarmEvent,
    BoardRestartEvent,
    CommandEvent,
    FaultEvent,
    LinkEvent,
    MissionEvent,
    ParameterEvent,
    SimulatorJumpEvent,
    StickEvent,
    WindEvent,
)


class FlightNotes:
    """Belongs to the event loop. Without a recorder it does nothing."""

    def __init__(self, recorder: Recorder | None, clock: LineClock) -> None:
        self._recorder = recorder
        self._clock = clock

    def know(self, name: str, content: Mapping[str, Any], about: str = "") -> None:
        """This is known from now on, until it is said anew for the same `name` and `about`."""
        if self._recorder is not None:
            self._recorder.know(name, about, self._clock.now_ns(), content)

    def event(self, event: Event, t_ns: int | None = None) -> None:
        """Note an event; at Unix time `t_ns`, or now."""
        if self._recorder is not None:
            content = {"event": event.NAME, "data": event}
            self._recorder.note(EVENT, self._clock.now_ns() if t_ns is None else t_ns, content)

    def mark(self, text: str, by: str | None, ago_s: float = 0.0) -> Mark:
        """Note a person's words for the moment `ago_s` before now. Returns the mark; its `t_s` is Unix time."""
        t_ns = self._clock.now_ns() - round(ago_s * 1e9)
        mark = Mark(uuid4().hex, text, by, t_ns * 1e-9)
        if self._recorder is not None:
            self._recorder.note(MARK, t_ns, {"text": mark.text, "by": mark.by, "id": mark.id})
        return mark


class NotedBroadcast(Broadcast):
    """Sends to the stations, and notes each event at the very time that the stations are told."""

    def __init__(self, clock: LineClock, notes: FlightNotes, on_parameters: Callable[[], None]) -> None:
        """`on_parameters` is called when gains have changed."""
        super().__init__(self._event_s)
        self._clock = clock
        self._event_ns = 0
        self._notes = notes
        self.on_parameters = on_parameters

    def event(self, event: Event, /) -> None:
        """Something happened."""
        self._event_ns = self._clock.now_ns()
        is_sent_text = isinstance(event, ConsoleEvent) and event.direction == "sent"
        if isinstance(event, _NOTED) or is_sent_text:
            self._notes.event(event, self._event_ns)
        if isinstance(event, ParameterEvent | OwnGainsEvent):
            self.on_parameters()
        super().event(event)

    def _event_s(self) -> float:
        return self._event_ns * 1e-9
