"""What happened in a flight, in order of time: from its notes, and from its samples where the bytes say it."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Final

import numpy as np
import orjson
import pyarrow as pa
import pyarrow.parquet as pq

from epf_gcs.contract.flights import EventKind, FlightEvent, FlightEvents
from epf_gcs.flights.flight_data import Damage, FlightData, read_field
from epf_gcs.flights.known_changes import limit_changes, surface_paths
from epf_gcs.flights.rates import GAP_NS
from epf_gcs.flights.resets import resets
from epf_gcs.recordings import notes
from epf_gcs.recordings.notes import Content, Note
from epf_gcs.recordings.table_names import EVENTS

FILE: Final = f"{EVENTS}.parquet"

_MODES: Final = ("autopilot", "autotrim", "auto_switch", "autopilot_hil", "source_joystick", "autotrim_hil")
_PLANS: Final = {"fms_plan": "flight", "fms_hil_plan": "hil"}
# Kinds of the stream's events, and what they are called here; those that are not listed are no event of a flight.
_KINDS: Final[Mapping[str, EventKind]] = {
    "advice": "advice",
    "alarm": "alarm",
    "board_restarted": "restart",
    "command": "command",
    "console": "console",
    "control": "control",
    "fault": "fault",
    "link": "link",
    "mission": "plan",
    "parameter": "parameter",
    "simulator_jumped": "jump",
    "stick": "stick",
    "wind": "wind",
}
_NAMES: Final = {
    "advice": "code",
    "alarm": "id",
    "command": "name",
    "console": "direction",
    "mission": "plan",
    "control": "name",
    "fault": "place",
    "stick": "source",
}
# A burst of damaged frames with no longer pause than this is one event.
_DAMAGE_PAUSE_NS: Final = 2_000_000_000
# An alarm that lasted less is brief; one that comes again within the other time is the same.
_BRIEF_S: Final = 1.0
_AGAIN_NS: Final = 10_000_000_000
# A jump is noted this long after its sample at the most.
_SAME_JUMP_NS: Final = 2_000_000_000
# Kinds of damage that are no frame.
_NO_FRAMES: Final = ("noise", "remains", "text")
# A restart or a broken file may leave a command or alarm without its end; one flight has no more events than this.
MOST_EVENTS: Final = 100_000


@dataclass(slots=True)
class Event:
    """What happened, in Unix ns; `data` is as the stream or the note has it. `until_ns` is None for a moment, or while
    it lasts; `id` is a mark's."""

    t_ns: int
    kind: EventKind
    name: str
    data: Content
    until_ns: int | None = None
    id: str | None = None


def find_events(flight: FlightData, silences: list[tuple[int, int]], damaged: list[Damage]) -> list[Event]:
    """All events in order of time; `silences`: from and to (Unix ns) of the stretches without a byte of the board.

    Raises OSError, RecordingError.
    """
    noted = flight.notes()
    found = [
        *_with_resets(flight, _merged(_noted(noted))),
        *_modes(flight),
        *_known_changes(noted),
        *_waypoints(flight),
    ]
    found += _bursts(damaged)
    for name, spans in (("silence", silences), ("simulator", _simulator_silences(flight))):
        found += [Event(begin, "gap", name, {"duration_s": (end - begin) * 1e-9}, until_ns=end) for begin, end in spans]
    found.sort(key=lambda event: event.t_ns)
    return found[:MOST_EVENTS]


def as_answer(events: list[Event], start_ns: int) -> FlightEvents:
    """Events as the interface gives them."""
    return FlightEvents(
        [
            FlightEvent(
                t_s=event.t_ns * 1e-9,
                at_s=(event.t_ns - start_ns) * 1e-9,
                kind=event.kind,
                name=event.name,
                id=event.id,
                data=event.data,
                until_s=None if event.until_ns is None else event.until_ns * 1e-9,
            )
            for event in events
        ]
    )


def write_events(path: Path, events: list[Event]) -> None:
    """Write them as a table; `data` is JSON text. Raises OSError."""
    table = pa.table(
        {
            "t_ns": pa.array([event.t_ns for event in events], pa.int64()),
            "until_ns": pa.array([event.until_ns for event in events], pa.int64()),
            "kind": pa.array([event.kind for event in events], pa.string()),
            "name": pa.array([event.name for event in events], pa.string()),
            "id": pa.array([event.id for event in events], pa.string()),
            "data": pa.array([orjson.dumps(event.data).decode() for event in events], pa.string()),
        }
    )
    pq.write_table(table, path, compression="zstd")


def read_events(path: Path) -> list[Event]:
    """Read them back. Raises OSError."""
    try:
        rows = pq.read_table(path).to_pylist()
    except pa.ArrowException as error:
        raise OSError(f"{path.name} cannot be read: {error}") from error
    return [Event(**{**row, "data": orjson.loads(row["data"])}) for row in rows]


def _noted(found: list[Note]) -> list[Event]:
    """Events from notes. The end of a command or alarm becomes the end of the event that it began with."""
    events: list[Event] = []
    open_events: dict[tuple[str, Any], Event] = {}
    lines: dict[str, Content] = {}
    has_lines, lost = any(note.name == notes.LINE for note in found), set[str]()
    for note in found:
        content = note.content if isinstance(note.content, dict) else {}
        if note.name == notes.MARK:
            mark = {"text": str(content.get("text", "")), "by": content.get("by")}
            events.append(Event(note.t_ns, "mark", "", mark, id=str(content.get("id", note.t_ns))))
        elif note.name == notes.LOST:
            events.append(Event(note.t_ns, "lost", str(content.get("reason", "")), content))
        elif note.name == notes.LINE:
            # Said again, or closed from the start: nothing happened.
            line = str(content.get("line"))
            before = lines.get(line, {})
            if content != before and (content.get("open") or before.get("open")):
                name = f"{line}_{'opened' if content.get('open') else 'closed'}"
                events.append(Event(note.t_ns, "link", name, content))
            lines[line] = content
        elif note.name == notes.EVENT and content.get("event") in _KINDS:
            event = _from_stream(note.t_ns, content)
            if event.kind == "link" and has_lines and not _is_lost_or_back(event.data, lost):
                continue
            if not _ends_another(event, open_events):
                events.append(event)
    return events


def _merged(events: list[Event]) -> list[Event]:
    """Brief alarms that come again soon are one event, as long as from the first to the last.

    Its data say how often (`times`), and for how long together (`lasted_s`).
    """
    found: list[Event] = []
    newest: dict[str, Event] = {}
    for event in events:
        before = newest.get(event.name) if event.kind == "alarm" else None
        if before is None or not _belongs(event, before):
            if event.kind == "alarm":
                newest[event.name] = event
            found.append(event)
            continue
        times, lasted_s = before.data.get("times", 1), before.data.get("lasted_s", _lasted_s(before))
        together_s = None if event.until_ns is None else lasted_s + _lasted_s(event)
        before.data = {**event.data, "times": times + 1, "lasted_s": together_s}
        before.until_ns = event.until_ns
    return found


def _belongs(event: Event, before: Event) -> bool:
    if before.until_ns is None or event.t_ns - before.until_ns > _AGAIN_NS:
        return False
    return _lasted_s(before) < _BRIEF_S or _lasted_s(event) < _BRIEF_S


def _lasted_s(event: Event) -> float:
    return math.inf if event.until_ns is None else (event.until_ns - event.t_ns) * 1e-9


def _is_lost_or_back(states: Mapping[str, object], lost: set[str]) -> bool:
    """Whether a line fell silent, or is heard again: that it was opened or closed is noted by itself."""
    silent = {line for line, state in states.items() if state == "lost"}
    back = {line for line in lost if states.get(line) == "open"}
    is_news = bool(silent - lost or back)
    lost.clear()
    lost.update(silent)
    return is_news


def _from_stream(t_ns: int, content: Content) -> Event:
    kind = str(content["event"])
    data = content["data"] if isinstance(content.get("data"), dict) else {}
    return Event(t_ns, _KINDS[kind], str(data.get(_NAMES.get(kind, ""), "") or ""), data)


def _ends_another(event: Event, open_events: dict[tuple[str, Any], Event]) -> bool:
    """Whether this is the outcome of a command that began, or the end or acknowledgement of an alarm."""
    data, kind = event.data, event.kind
    if kind not in ("command", "alarm"):
        return False
    key = (kind, data.get("id"))
    is_open = data.get("state") == "pending" if kind == "command" else data.get("active") is True
    before = open_events.get(key)
    if is_open and (before is None or kind == "command"):
        open_events[key] = event
        return False
    if before is None:
        # An alarm that is acknowledged after its end was told already.
        return kind == "alarm" and data.get("acknowledged") is True
    before.data = data
    if not is_open:
        before.until_ns = event.t_ns
        del open_events[key]
    return True


def _modes(flight: FlightData) -> list[Event]:
    """Changes of the modes that the heartbeat reports."""
    found = []
    for name in _MODES:
        for t_ns, _, value in _changes(flight, "heartbeat", name):
            found.append(Event(t_ns, "mode", name, {"on": bool(value)}))
    return found


def _known_changes(noted: list[Note]) -> list[Event]:
    """Assisted and manual flight of the simulator's aircraft, and limits of alarms."""
    paths, limits = surface_paths(noted)[1:], limit_changes(noted)
    return [Event(t_ns, "mode", "assisted", {"on": path == "assisted"}) for t_ns, path in paths] + [
        Event(t_ns, "limits", name, {"before": before, "after": after}) for t_ns, name, before, after in limits
    ]


def _with_resets(flight: FlightData, noted: list[Event]) -> list[Event]:
    """The events with a jump of the simulator for each that its samples have, in place of the note of the same."""
    found = resets(flight)
    told = [
        event
        for event in noted
        if event.kind != "jump" or not any(abs(event.t_ns - one.after_ns) < _SAME_JUMP_NS for one in found)
    ]
    for one in found:
        place = one._asdict()
        before_ns, after_ns = place.pop("before_ns"), place.pop("after_ns")
        told.append(Event(before_ns, "jump", "", place, until_ns=after_ns))
    return told


def _waypoints(flight: FlightData) -> list[Event]:
    """Waypoints that a plan left for another, whichever way."""
    found = []
    for topic, plan in _PLANS.items():
        for t_ns, before, after in _changes(flight, topic, "waypoint"):
            found.append(Event(t_ns, "waypoint", plan, {"from": int(before), "to": int(after)}))
    return found


def _simulator_silences(flight: FlightData) -> list[tuple[int, int]]:
    """From and to (Unix ns) of the stretches without a sample of the simulator."""
    t_s = read_field(flight, "simulator", "latitude_deg").t_s
    t_ns = flight.start_ns + np.round(t_s * 1e9).astype(np.int64)
    places = np.flatnonzero(np.diff(t_ns) > GAP_NS)
    return [(int(t_ns[place]), int(t_ns[place + 1])) for place in places]


def _bursts(damaged: list[Damage]) -> list[Event]:
    """Damaged frames that came shortly after one another are one event."""
    found: list[Event] = []
    for t_ns, kind in damaged:
        if kind in _NO_FRAMES:
            continue
        last = found[-1] if found else None
        if last is None or last.until_ns is None or t_ns - last.until_ns > _DAMAGE_PAUSE_NS:
            last = Event(t_ns, "damage", "frames", {"frames": 0, "kinds": {}}, until_ns=t_ns)
            found.append(last)
        last.until_ns = t_ns
        last.data["frames"] += 1
        last.data["kinds"][kind] = last.data["kinds"].get(kind, 0) + 1
    return found


def _changes(flight: FlightData, topic: str, field: str) -> list[tuple[int, float, float]]:
    """Time (Unix ns), value before and value after of each change, without samples that have no value."""
    t_s, values = read_field(flight, topic, field)
    known = np.isfinite(values)
    t_s, values = t_s[known], values[known]
    places = np.flatnonzero(np.diff(values) != 0)[:MOST_EVENTS]
    return [
        (flight.start_ns + round(float(t_s[place + 1]) * 1e9), float(values[place]), float(values[place + 1]))
        for place in places
    ]
