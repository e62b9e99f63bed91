"""The events that changed or broke a flight, as its report tells them."""

from __future__ import annotations

from typing import Final

from epf_gcs.contract.report import ReportEvent, ReportEventKind
from epf_gcs.flights.events import Event

_MOST: Final = 200


def told(events: list[Event], start_ns: int) -> list[ReportEvent]:
    """In order of time: hand and board, stick, limits, restarts, new starts, silences and pauses."""
    found: list[ReportEvent] = []
    for event in events:
        meaning = _meaning(event)
        if meaning is not None:
            until_s = None if event.until_ns is None else (event.until_ns - start_ns) * 1e-9
            found.append(ReportEvent(meaning[0], (event.t_ns - start_ns) * 1e-9, until_s, meaning[1]))
    return found[:_MOST]


def _meaning(event: Event) -> tuple[ReportEventKind, str] | None:
    """Kind and detail; None for what stands elsewhere in the report."""
    data = event.data
    match event.kind, event.name:
        case "mode", "assisted":
            return "assisted" if data.get("on") else "manual", ""
        case "stick", _:
            words = (event.name, data.get("gamepad"), "lost" if data.get("state") == "lost" else None)
            return "stick", " ".join(str(word) for word in words if word)
        case "limits", name:
            return "limits", f"{name} {data.get('before'):g} → {data.get('after'):g}"
        case "restart", _:
            return "restart", ""
        case "jump", _:
            return "jump", f"{data.get('distance_m')} m"
        case "gap", name:
            return "simulator_silence" if name == "simulator" else "silence", ""
        case "alarm", "simulator_paused":
            return "pause", ""
    return None
