"""What the notes of a recording say up to a moment: lines, identity, gains, plans, alarms, control and periods."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import Final, Literal, get_args

from epf_gcs.contract.base import LinkState
from epf_gcs.contract.events import OwnGainsEvent, noted_event
from epf_gcs.contract.own_gains import OwnGains
from epf_gcs.contract.status import AlarmState
from epf_gcs.recordings import notes
from epf_gcs.recordings.notes import Content, Note
from epf_gcs.vehicle.own_gains import own_gains_after
from epf_gcs.vehicle.wanted import RATE_COMMANDS, IntendedSettings

_DONE: Final = frozenset({"confirmed", "sent"})
LineName = Literal["board", "simulator"]
# What an event of these kinds says is in the newest of its kind.
_NEWEST: Final = frozenset({"control", "stick", "hil", "faults"})


@dataclass(frozen=True, slots=True)
class LineNote:
    """Whether a line is open, and to what. `said`: as the newest event of the links said."""

    open: bool = False
    url: str | None = None
    baud: int | None = None
    profile: str | None = None
    emulated: bool = False
    said: LinkState = "closed"


@dataclass(slots=True)
class KnownState:
    """What is known; identity, gains, plans, alarms and events as they were noted. `has_lines`: the notes say when each
    line was open."""

    identity: Content = field(default_factory=dict)
    parameters: Content | None = None
    plans: Content = field(default_factory=dict)
    alarms: dict[str, Content] = field(default_factory=dict)
    lines: dict[LineName, LineNote] = field(default_factory=lambda: {"board": LineNote(), "simulator": LineNote()})
    periods_ms: dict[str, int] = field(default_factory=dict)
    events: dict[str, Content] = field(default_factory=dict)
    own: OwnGains | None = None
    lost_bytes: int = 0
    has_lines: bool = False


class RecordedState:
    """`now` is what is known; a key frame holds it."""

    def __init__(self) -> None:
        self.now = KnownState()

    @property
    def wanted(self) -> IntendedSettings:
        """The periods of the board's tasks that were commanded by then."""
        return IntendedSettings(periods_ms=self.now.periods_ms)

    def alarms(self) -> list[AlarmState]:
        """The alarms listed at that moment, oldest first."""
        return sorted(map(_alarm_state, self.now.alarms.values()), key=lambda alarm: alarm.since_s)

    def event(self, kind: str) -> Content:
        """The newest event of this kind, empty if there was none."""
        return self.now.events.get(kind, {})

    def take(self, note: Note) -> str | None:
        """Take a note; returns the command whose period it changes, if it does."""
        content = note.content
        if not isinstance(content, dict):
            return None
        match note.name:
            case notes.IDENTITY:
                self.now.identity = dict(content)
            case notes.PARAMETERS:
                self.now.parameters = dict(content)
            case notes.PLAN if isinstance(content.get("plan"), str):
                self.now.plans[content["plan"]] = content.get("waypoints")
            case notes.LINE if content.get("line") in self.now.lines:
                self._line(content["line"], content)
            case notes.LOST if isinstance(content.get("bytes"), int):
                self.now.lost_bytes += content["bytes"]
            case notes.EVENT if isinstance(content.get("data"), dict):
                return self._event(str(content.get("event")), content["data"])
        return None

    def _line(self, name: LineName, content: Content) -> None:
        self.now.has_lines = True
        url, baud, profile = (content.get(key) for key in ("url", "baud", "profile"))
        self.now.lines[name] = LineNote(
            open=content.get("open") is True,
            url=url if isinstance(url, str) else None,
            baud=baud if isinstance(baud, int) else None,
            profile=profile if isinstance(profile, str) else None,
            emulated=content.get("emulated") is True,
            said=self.now.lines[name].said,
        )

    def _event(self, kind: str, data: Content) -> str | None:
        if kind in _NEWEST:
            self.now.events[kind] = dict(data)
        elif kind == "link":
            for name, line in self.now.lines.items():
                if data.get(name) in get_args(LinkState):
                    self.now.lines[name] = replace(line, said=data[name])
        elif kind == "alarm":
            self._alarm(data)
        elif kind == "parameter" and isinstance(data.get("parameters"), dict):
            self.now.parameters = {**(self.now.parameters or {}), **data["parameters"]}
        elif kind == OwnGainsEvent.NAME:
            event = noted_event(kind, data)
            self.now.own = own_gains_after(self.now.own, event) if isinstance(event, OwnGainsEvent) else self.now.own
        elif kind == "command":
            return self._command(data)
        return None

    def _alarm(self, data: Content) -> None:
        alarm = {name: value for name, value in data.items() if name != "active"}
        name = str(alarm.get("id"))
        if alarm.get("until_s") is not None and alarm.get("acknowledged"):
            self.now.alarms.pop(name, None)
        else:
            self.now.alarms[name] = alarm

    def _command(self, data: Content) -> str | None:
        name, value = data.get("name"), data.get("value")
        if name not in RATE_COMMANDS or data.get("state") not in _DONE or not isinstance(value, list) or not value:
            return None
        self.now.periods_ms = {**self.now.periods_ms, name: int(value[0])}
        return str(name)


def _alarm_state(noted: Content) -> AlarmState:
    return AlarmState(
        id=noted["id"],
        level="critical" if noted.get("level") == "critical" else "warning",
        since_s=float(noted.get("since_s") or 0.0),
        until_s=noted.get("until_s"),
        text=str(noted.get("text")),
        params=noted.get("params") or {},
        acknowledged=noted.get("acknowledged") is True,
        count=int(noted.get("count") or 1),
    )
