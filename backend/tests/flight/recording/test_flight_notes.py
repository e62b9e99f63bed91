"""What the bytes do not say is in the file: who was there, what was known, commanded and marked, and when."""

from __future__ import annotations

from pathlib import Path
from types import SimpleNamespace

import pytest

from epf_gcs.bus.definition import Asker, Client
from epf_gcs.bus.vehicle_end import Broadcast
from epf_gcs.contract.answers import AircraftName, DiskPolicy
from epf_gcs.contract.events import ConsoleEvent, Event
from epf_gcs.contract.requests import ChooseDiskPolicy, NameAircraft, SetMark
from epf_gcs.errors import ConflictError
from epf_gcs.flight.flight import Flight
from epf_gcs.flight.hil.simulator import SimulatorAddress
from epf_gcs.flight.recording.flight_notes import FlightNotes
from epf_gcs.link.address import parse_address
from epf_gcs.recordings.notes import EVENT, IDENTITY, LINE, MARK, PARAMETERS, PLAN
from epf_gcs.recordings.reading import notes_of
from tests.support.fake_board import FakeBoard, own_row
from tests.support.ports import free_udp_port
from tests.support.waiting import eventually_async

pytestmark = pytest.mark.anyio


async def test_the_boards_own_gains_are_in_the_file_with_their_table(tmp_path: Path, board: FakeBoard) -> None:
    board.describe(own_row(0))
    flight = Flight(tmp_path)
    async with flight.running():
        await flight.lines.open_board(parse_address(board.url))
        await eventually_async(lambda: flight.recorder is not None and flight.recorder.file is not None, "it records")
        values = flight.parameters.own
        await eventually_async(lambda: any(one.value == 3.0 for one in values.known.values.values()), "it is read")
        await flight.parameters.set({"line_k_bank": 4.0}, None)
    (file,) = (tmp_path / "recordings").glob("*.mcap")
    own = [note.content for note in notes_of(file) if note.name == EVENT and note.content["event"] == "own_gains"]
    tables = [one["data"]["table"] for one in own if one["data"]["table"] is not None]
    assert tables[-1]["gains"][0]["name"] == "line_k_bank"
    assert [one["data"]["values"]["line_k_bank"]["value"] for one in own if one["data"]["values"]][-1] == 4.0


async def test_a_flight_is_told_by_its_notes(tmp_path: Path, board: FakeBoard, monkeypatch: pytest.MonkeyPatch) -> None:
    told: list[tuple[str, float]] = []
    tell = Broadcast.event

    def note(self: Broadcast, event: Event) -> None:
        told.append((event.NAME, self._now_s()))
        tell(self, event)

    monkeypatch.setattr(Broadcast, "event", note)
    flight = Flight(tmp_path)
    async with flight.running():
        ask = flight._requests
        with pytest.raises(ConflictError, match="nothing is recorded"):
            await ask[SetMark](SetMark("too early"), Asker())
        await flight.lines.open_board(parse_address(board.url))
        await eventually_async(lambda: flight.supervisor.state == "open", "the board opens")
        await eventually_async(lambda: flight.recorder is not None and flight.recorder.file is not None, "it records")
        await flight.parameters.load(None)
        await flight.missions.read("flight")
        await flight.commands.run("gps_on")
        mark = await ask[SetMark](SetMark("aquí", "Ana"), Asker())
        await flight.lines.close_board()
    (file,) = (tmp_path / "recordings").glob("*.mcap")
    notes = notes_of(file)
    newest = {note.name: note.content for note in notes}
    assert newest[IDENTITY]["board"]["firmware_name"]
    plans = [note.content for note in notes if note.name == PLAN]
    assert plans == [{"plan": "flight", "waypoints": []}, {"plan": "flight", "waypoints": None}], "unknown once closed"
    lines = [note.content for note in notes if note.name == LINE and note.content["line"] == "board"]
    assert [(line["open"], line["url"], line["baud"], line["profile"], line["emulated"]) for line in lines][-2:] == [
        (True, board.url, 115200, None, False),
        (False, None, None, None, False),
    ]
    assert any(
        value["value"] is not None for note in notes if note.name == PARAMETERS for value in note.content.values()
    )
    commands = [note.content["data"] for note in notes if note.name == EVENT and note.content["event"] == "command"]
    assert ("gps_on", "confirmed") in [(one["name"], one["state"]) for one in commands]
    (marked,) = [note for note in notes if note.name == MARK]
    assert marked.content == {"text": "aquí", "by": "Ana", "id": mark.id}
    assert marked.t_ns * 1e-9 == mark.t_s
    events = [(note.content["event"], note.t_ns * 1e-9) for note in notes if note.name == EVENT]
    hil = [note.content["data"] for note in notes if note.name == EVENT and note.content["event"] == "hil"]
    assert [one["path"] for one in hil] == ["manual"], "each file begins with it"
    events = [one for one in events if one[0] not in ("hil", "limits")]
    assert set(events) <= set(told), "at the very time that the stations were told"
    assert ("mark", mark.t_s) not in events, "it has a note of its own"


async def test_the_person_in_control_is_noted_as_the_operator(tmp_path: Path, board: FakeBoard) -> None:
    flight = Flight(tmp_path)
    async with flight.running():
        await flight.lines.open_board(parse_address(board.url))
        await eventually_async(lambda: flight.supervisor.state == "open", "the board opens")
        await eventually_async(lambda: flight.recorder is not None and flight.recorder.file is not None, "it records")
        flight.stick.control_changed(Client("1", "Ana"))
        flight.stick.control_changed(None)
    (file,) = (tmp_path / "recordings").glob("*.mcap")
    notes = notes_of(file)
    assert [note.content["operator"] for note in notes if note.name == IDENTITY][-2:] == ["Ana", None]
    control = [note.content["data"] for note in notes if note.name == EVENT and note.content["event"] == "control"]
    assert [one["name"] for one in control] == ["Ana", None]


async def test_of_the_console_is_noted_what_a_person_sent_for_the_rest_is_in_the_boards_bytes(
    tmp_path: Path, board: FakeBoard
) -> None:
    flight = Flight(tmp_path)
    async with flight.running():
        await flight.lines.open_board(parse_address(board.url))
        await eventually_async(lambda: flight.recorder is not None and flight.recorder.file is not None, "it records")
        flight.outlet.event(ConsoleEvent("received", "ready"))
        flight.outlet.event(ConsoleEvent("sent", "help"))
    (file,) = (tmp_path / "recordings").glob("*.mcap")
    told = [note.content["data"] for note in notes_of(file) if note.name == EVENT]
    assert [one["text"] for one in told if "text" in one and "direction" in one] == ["help"]


async def test_whether_the_simulators_port_is_listened_to_is_noted(tmp_path: Path, board: FakeBoard) -> None:
    flight = Flight(tmp_path)
    async with flight.running():
        await flight.lines.open_board(parse_address(board.url))
        await eventually_async(lambda: flight.recorder is not None and flight.recorder.file is not None, "it records")
        await flight.lines.open_simulator(SimulatorAddress(free_udp_port(), "127.0.0.1", 49000, "xp12"))
        await flight.lines.close_simulator()
    (file,) = (tmp_path / "recordings").glob("*.mcap")
    lines = [note.content for note in notes_of(file) if note.name == LINE and note.content["line"] == "simulator"]
    assert [(line["open"], line["profile"], line["url"]) for line in lines][-2:] == [
        (True, "xp12", "udp://127.0.0.1:49000"),
        (False, None, None),
    ]
    assert all(line["baud"] is None and line["emulated"] is False for line in lines)


async def test_the_disks_policy_is_the_recorders_and_is_remembered(tmp_path: Path) -> None:
    async with Flight(tmp_path).running():
        pass
    flight = Flight(tmp_path)
    async with flight.running():
        ask = flight._requests[ChooseDiskPolicy]
        assert flight.recorder is not None
        assert await ask(ChooseDiskPolicy(), Asker()) == DiskPolicy()
        assert await ask(ChooseDiskPolicy(keep_free_bytes=5), Asker()) == DiskPolicy(keep_free_bytes=5)
        chosen = await ask(ChooseDiskPolicy(delete_oldest=True), Asker())
        assert chosen == DiskPolicy(delete_oldest=True, keep_free_bytes=5), "what is not given stays"
        assert flight.recorder.policy == DiskPolicy(delete_oldest=True, keep_free_bytes=5)
        nonsense = await ask(ChooseDiskPolicy(keep_free_bytes=-1), Asker())
        assert nonsense.keep_free_bytes == 1_000_000_000
        await ask(ChooseDiskPolicy(keep_free_bytes=7), Asker())
    again = Flight(tmp_path)
    assert again.recorder is not None
    assert again.recorder.policy == DiskPolicy(delete_oldest=True, keep_free_bytes=7)


async def test_the_aircraft_has_the_name_that_a_person_gave_it_before_or_in_flight(
    tmp_path: Path, board: FakeBoard
) -> None:
    before = Flight(tmp_path)
    async with before.running():
        ask = before._requests[NameAircraft]
        assert await ask(NameAircraft(), Asker()) == AircraftName("")
        assert await ask(NameAircraft("Ala fija"), Asker()) == AircraftName("Ala fija")
    flight = Flight(tmp_path)
    async with flight.running():
        ask = flight._requests[NameAircraft]
        assert await ask(NameAircraft(), Asker()) == AircraftName("Ala fija"), "it is remembered"
        await flight.lines.open_board(parse_address(board.url))
        await eventually_async(lambda: flight.recorder is not None and flight.recorder.file is not None, "it records")
        await ask(NameAircraft("Ala fija 2"), Asker())
        await ask(NameAircraft(""), Asker())
    (file,) = (tmp_path / "recordings").glob("*.mcap")
    names = [note.content["aircraft"] for note in notes_of(file) if note.name == IDENTITY]
    assert [names[0], *names[-2:]] == ["Ala fija", "Ala fija 2", None]


async def test_a_mark_stands_at_the_moment_that_was_meant_and_not_when_its_words_were_typed() -> None:
    clock = SimpleNamespace(now_ns=lambda: 1_000_000_000_000)
    notes = FlightNotes(None, clock)  # type: ignore[arg-type]
    assert notes.mark("here", None).t_s == pytest.approx(1000.0)
    assert notes.mark("there", None, ago_s=2.5).t_s == pytest.approx(997.5)
