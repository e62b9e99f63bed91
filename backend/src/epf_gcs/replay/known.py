"""What the notes of a recording say up to a moment: lines, identity, gains, plans, alarms, control and periods."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Final

from epf_gcs.contract.status import AlarmState
from epf_gcs.recordings import notes
from epf_gcs.recordings.notes import Note
from epf_gcs.vehicle.wanted import RATE_COMMANDS, IntendedSettings

_DONE: Final = frozenset({"confirmed", "sent"})
_CLOSED: Final[dict[str, Any]] = {
    "open": False,
    "url": None,
    "baud": None,
    "profile": None,
    "emulated": False,
    # As the newest event of the links said.
    "said": "closed",
}
# What an event of these kinds says is in the newest of its kind.
_NEWEST: Final = frozenset({"control", "stick", "hil"})


class RecordedState:
    """Plain values only, so that a key frame can hold them; `has_lines`: the notes say when each line was open."""

    def __init__(self) -> None:
        self.now: dict[str, Any] = {
            "identity": {},
            "parameters": None,
            "plans": {},
            "alarms": {},
            "lines": {"board": dict(_CLOSED), "simulator": dict(_CLOSED)},
            "periods_ms": {},
            "events": {},
            "lost_bytes": 0,
            "has_lines": False,
        }

    @property
    def lines(self) -> dict[str, dict[str, Any]]:
        """Of "board" and "simulator": whether it is open, url, baud, profile, emulated and what was said of it."""
        lines: dict[str, dict[str, Any]] = self.now["lines"]
        return lines

    @property
    def wanted(self) -> IntendedSettings:
        """The periods of the board's tasks that were commanded by then."""
        return IntendedSettings(periods_ms=self.now["periods_ms"])

    def alarms(self) -> list[AlarmState]:
        """The alarms listed at that moment, oldest first."""
        return sorted(map(_alarm_state, self.now["alarms"].values()), key=lambda alarm: alarm.since_s)

    def event(self, kind: str) -> dict[str, Any]:
        """The newest event of this kind, empty if there was none."""
        found: dict[str, Any] = self.now["events"].get(kind, {})
        return found

    def take(self, note: Note) -> str | None:
        """Take a note; returns the command whose period it changes, if it does."""
        content = note.content
        if not isinstance(content, Mapping):
            return None
        match note.name:
            case notes.IDENTITY:
                self.now["identity"] = dict(content)
            case notes.PARAMETERS:
                self.now["parameters"] = dict(content)
            case notes.PLAN if isinstance(content.get("plan"), str):
                self.now["plans"][content["plan"]] = content.get("waypoints")
            case notes.LINE if content.get("line") in self.lines:
                self._line(content)
            case notes.LOST if isinstance(content.get("bytes"), int):
                self.now["lost_bytes"] += content["bytes"]
            case notes.EVENT if isinstance(content.get("data"), Mapping):
                return self._event(str(content.get("event")), content["data"])
        return None

    def _line(self, content: Mapping[str, Any]) -> None:
        self.now["has_lines"] = True
        line = {name: content.get(name) for name in ("url", "baud", "profile")}
        flags = {name: content.get(name) is True for name in ("open", "emulated")}
        self.lines[content["line"]].update(line | flags)

    def _event(self, kind: str, data: Mapping[str, Any]) -> str | None:
        if kind in _NEWEST:
            self.now["events"][kind] = dict(data)
        elif kind == "link":
            for name, line in self.lines.items():
                line["said"] = data.get(name, line["said"])
        elif kind == "alarm":
            self._alarm(data)
        elif kind == "parameter" and isinstance(data.get("parameters"), Mapping):
            self.now["parameters"] = {**(self.now["parameters"] or {}), **data["parameters"]}
        elif kind == "command":
            return self._command(data)
        return None

    def _alarm(self, data: Mapping[str, Any]) -> None:
        alarm = {name: value for name, value in data.items() if name != "active"}
        name = str(alarm.get("id"))
        if alarm.get("until_s") is not None and alarm.get("acknowledged"):
            self.now["alarms"].pop(name, None)
        else:
            self.now["alarms"][name] = alarm

    def _command(self, data: Mapping[str, Any]) -> str | None:
        name, value = data.get("name"), data.get("value")
        if name not in RATE_COMMANDS or data.get("state") not in _DONE or not isinstance(value, list) or not value:
            return None
        self.now["periods_ms"] = {**self.now["periods_ms"], name: int(value[0])}
        return str(name)


def _alarm_state(noted: Mapping[str, Any]) -> AlarmState:
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
