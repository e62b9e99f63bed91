"""Requests about the recording of the flight."""

from __future__ import annotations

from typing import Any

from epf_gcs.bus.definition import Asker
from epf_gcs.errors import ConflictError
from epf_gcs.flight.recording.flight_notes import FlightNotes
from epf_gcs.flight.recording.recorder import Recorder
from epf_gcs.flight.requests.client_names import Table
from epf_gcs.vehicle.outside import Outlet


def recording_requests(recorder: Recorder | None, notes: FlightNotes, outlet: Outlet) -> Table:
    """recording.mark {text, by}: puts a mark into the recording and answers it: {id, text, by, t_s}."""

    async def mark(_: Asker, arguments: dict[str, Any]) -> dict[str, Any]:
        if recorder is None or recorder.file is None:
            raise ConflictError(
                "recording_not_active", "The mark was not set because nothing is recorded: open a line first."
            )
        by = arguments.get("by")
        made = notes.mark(str(arguments["text"]), None if by is None else str(by))
        outlet.event("mark", made)
        return made

    return {"recording.mark": mark}
