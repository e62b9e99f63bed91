"""Requests about the recording of the flight."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict
from typing import Any

from epf_gcs.bus.definition import Asker
from epf_gcs.errors import ConflictError
from epf_gcs.flight.memory.memory import Memory
from epf_gcs.flight.recording.flight_notes import FlightNotes
from epf_gcs.flight.recording.known_notes import KnownNotes
from epf_gcs.flight.recording.recorder import DiskPolicy, Recorder
from epf_gcs.flight.requests.client_names import Table
from epf_gcs.vehicle.outside import Outlet


def policy_of(remembered: Mapping[str, Any]) -> DiskPolicy:
    """The policy in these values; the default for what is missing or makes no sense."""
    default = DiskPolicy()
    keep = remembered.get("keep_free_bytes")
    if not isinstance(keep, int) or isinstance(keep, bool) or keep < 0:
        keep = default.keep_free_bytes
    return DiskPolicy(remembered.get("delete_oldest") is True, keep)


def recording_requests(
    recorder: Recorder | None, notes: FlightNotes, known: KnownNotes, memory: Memory, outlet: Outlet
) -> Table:
    """recording.mark {text, by, ago_s}: puts a mark into the recording and answers it: {id, text, by, t_s}.

    recording.policy {delete_oldest, keep_free_bytes}: changes what is given, keeps it, and answers the whole policy.
    recording.aircraft {name}: notes what the aircraft is called from now on if a name is given, and answers {name}.
    """

    if recorder is not None:
        recorder.policy = policy_of(memory.now.recording)

    async def mark(_: Asker, arguments: dict[str, Any]) -> dict[str, Any]:
        if recorder is None or recorder.file is None:
            raise ConflictError(
                "flight_not_recorded", "The mark was not set because nothing is recorded: open a line first."
            )
        by = arguments.get("by")
        ago_s = float(arguments.get("ago_s") or 0.0)
        made = notes.mark(str(arguments["text"]), None if by is None else str(by), ago_s)
        outlet.event("mark", made)
        return made

    async def choose_policy(_: Asker, arguments: dict[str, Any]) -> dict[str, Any]:
        policy = policy_of({**memory.now.recording, **arguments})
        memory.update(recording=asdict(policy))
        if recorder is not None:
            recorder.policy = policy
        return asdict(policy)

    async def name_aircraft(_: Asker, arguments: dict[str, Any]) -> dict[str, Any]:
        name = arguments.get("name")
        if isinstance(name, str):
            memory.update(aircraft=name)
            known.name_aircraft(name)
        return {"name": memory.now.aircraft}

    return {"recording.mark": mark, "recording.policy": choose_policy, "recording.aircraft": name_aircraft}
