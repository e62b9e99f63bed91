"""Requests about the recording of the flight."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict
from typing import Any

from epf_gcs.bus.definition import Asker
from epf_gcs.bus.vehicle_end import Handlers
from epf_gcs.contract.answers import AircraftName, DiskPolicy, Mark
from epf_gcs.contract.events import MarkEvent
from epf_gcs.contract.requests import ChooseDiskPolicy, NameAircraft, SetMark
from epf_gcs.errors import ConflictError
from epf_gcs.flight.memory.memory import Memory
from epf_gcs.flight.recording.flight_notes import FlightNotes
from epf_gcs.flight.recording.known_notes import KnownNotes
from epf_gcs.flight.recording.recorder import Recorder
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
) -> Handlers:
    """Marks, what happens when the disk fills, and the aircraft's name, which is noted in recordings."""

    if recorder is not None:
        recorder.policy = policy_of(memory.now.recording)

    async def mark(request: SetMark, _: Asker) -> Mark:
        if recorder is None or recorder.file is None:
            raise ConflictError(
                "flight_not_recorded", "The mark was not set because nothing is recorded: open a line first."
            )
        made = notes.mark(request.text, request.by, request.ago_s)
        outlet.event(MarkEvent(**asdict(made)))
        return made

    async def choose_policy(request: ChooseDiskPolicy, _: Asker) -> DiskPolicy:
        given = {name: value for name, value in asdict(request).items() if value is not None}
        policy = policy_of({**memory.now.recording, **given})
        memory.update(recording=asdict(policy))
        if recorder is not None:
            recorder.policy = policy
        return policy

    async def name_aircraft(request: NameAircraft, _: Asker) -> AircraftName:
        if request.name is not None:
            memory.update(aircraft=request.name)
            known.name_aircraft(request.name)
        return AircraftName(memory.now.aircraft)

    return {SetMark: mark, ChooseDiskPolicy: choose_policy, NameAircraft: name_aircraft}
