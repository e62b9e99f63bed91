"""What the bytes do not say is in the file: who was there, what was known, commanded and marked, and when."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import pytest

from epf_gcs.bus.definition import Asker
from epf_gcs.bus.vehicle_end import Broadcast
from epf_gcs.errors import ConflictError
from epf_gcs.flight.flight import Flight
from epf_gcs.link.address import parse_address
from epf_gcs.recordings.notes import EVENT, IDENTITY, LINE, MARK, PARAMETERS, PLAN
from epf_gcs.recordings.reading import notes_of
from tests.support.fake_board import FakeBoard
from tests.support.waiting import eventually_async

pytestmark = pytest.mark.anyio


async def test_a_flight_is_told_by_its_notes(tmp_path: Path, board: FakeBoard, monkeypatch: pytest.MonkeyPatch) -> None:
    told: list[tuple[str, float]] = []
    event = Broadcast.event

    def note(self: Broadcast, kind: str, data: Mapping[str, Any]) -> None:
        told.append((kind, self._now_s()))
        event(self, kind, data)

    monkeypatch.setattr(Broadcast, "event", note)
    flight = Flight(tmp_path)
    async with flight.running():
        ask = flight._requests
        with pytest.raises(ConflictError, match="nothing is recorded"):
            await ask["recording.mark"](Asker(), {"text": "too early", "by": None})
        await flight.lines.open_board(parse_address(board.url))
        await eventually_async(lambda: flight.supervisor.state == "open", "the board opens")
        await eventually_async(lambda: flight.recorder is not None and flight.recorder.file is not None, "it records")
        await flight.parameters.load(None)
        await flight.missions.read("flight")
        await flight.commands.run("gps_on")
        mark = await ask["recording.mark"](Asker(), {"text": "aquí", "by": "Ana"})
        await flight.lines.close_board()
    (file,) = (tmp_path / "recordings").glob("*.mcap")
    notes = notes_of(file)
    newest = {note.name: note.content for note in notes}
    assert newest[IDENTITY]["board"]["firmware_name"]
    assert newest[PLAN] == {"plan": "flight", "waypoints": []}
    lines = [note.content for note in notes if note.name == LINE and note.content["line"] == "board"]
    assert [line["open"] for line in lines][-2:] == [True, False]
    assert board.url in [line["url"] for line in lines]
    assert any(
        value["value"] is not None for note in notes if note.name == PARAMETERS for value in note.content.values()
    )
    commands = [note.content["data"] for note in notes if note.name == EVENT and note.content["event"] == "command"]
    assert ("gps_on", "confirmed") in [(one["name"], one["state"]) for one in commands]
    (marked,) = [note for note in notes if note.name == MARK]
    assert marked.content == {"text": "aquí", "by": "Ana", "id": mark["id"]}
    assert marked.t_ns * 1e-9 == mark["t_s"]
    events = [(note.content["event"], note.t_ns * 1e-9) for note in notes if note.name == EVENT]
    assert set(events) <= set(told), "at the very time that the stations were told"
    assert ("mark", mark["t_s"]) not in events, "it has a note of its own"
