"""What a station may ask of the flight and what it is told, without a running loop behind it."""

from __future__ import annotations

import asyncio
import math
from collections.abc import AsyncIterator, Mapping
from dataclasses import asdict, replace
from pathlib import Path
from typing import Any

import pytest

from epf_gcs.bus.definition import Asker, Client
from epf_gcs.bus.vehicle_end import Broadcast
from epf_gcs.codec.encode import encode_telemetry
from epf_gcs.codec.messages_gen import TELEMETRY_BY_NAME
from epf_gcs.contract.answers import DiskPolicy
from epf_gcs.contract.events import (
    AdviceEvent,
    AlarmEvent,
    BoardRestartEvent,
    CommandEvent,
    ConsoleEvent,
    ErrorEvent,
    JournalEvent,
    LinkEvent,
    MarkEvent,
    MissionEvent,
    ParameterEvent,
    RecordingEvent,
    SimulatorJumpEvent,
    StickEvent,
)
from epf_gcs.contract.notices import Pace, StickSample
from epf_gcs.contract.requests import (
    AnswerT_co,
    ChooseThresholds,
    LoadParameters,
    ReadHil,
    Request,
    RunCommand,
    SendLine,
    SetHil,
    SetMark,
)
from epf_gcs.errors import ConflictError
from epf_gcs.flight.flight import Flight
from epf_gcs.flight.requests.notices import notices
from epf_gcs.flight.requests.recording import policy_of
from epf_gcs.flights.known_changes import limit_changes
from epf_gcs.recordings.notes import EVENT, IDENTITY, MARK, Note
from epf_gcs.recordings.reading import notes_of
from epf_gcs.xplane.datagram import Record, build
from tests.support.contract import as_told
from tests.support.simulator import NO, ROWS
from tests.support.waiting import eventually_async

pytestmark = pytest.mark.anyio

ANA = Asker("ana", "Ana")
HAND = {"elevator": 0.5, "aileron": 0.0, "rudder": 0.0, "throttle": 0.5}


class Line:
    """The board's line, which keeps what is written to it; one that is full takes nothing."""

    baud = 115200
    backlog = 0

    def __init__(self) -> None:
        self.written: list[bytes] = []
        self.is_full = False

    def write(self, data: bytes) -> bool:
        if not self.is_full:
            self.written.append(data)
        return not self.is_full


class Asked:
    """A flight that is asked; all that it tells the stations is kept."""

    def __init__(self, flight: Flight) -> None:
        self.flight = flight
        self.line = Line()
        self.told: list[tuple[str, Mapping[str, Any]]] = []

    async def __call__(self, request: Request[AnswerT_co]) -> AnswerT_co:
        answer: AnswerT_co = await self.flight._requests[type(request)](request, ANA)
        return answer

    def attach(self, *, is_emulated: bool = False) -> None:
        board = self.flight.board
        board.attach(self.line, is_emulated=is_emulated)
        heartbeat = encode_telemetry("heartbeat", *(0,) * TELEMETRY_BY_NAME["heartbeat"].size)
        for frame in (heartbeat, encode_telemetry("capabilities", 1, 0, b"fake", b"1.5", 0)):
            board.on_bytes(frame)
            self.flight.telemetry.catch_up()
        self.line.written.clear()

    def records(self) -> None:
        recorder = self.flight.recorder
        assert recorder is not None
        recorder.board_tap.received(b"x")
        recorder._write_queue()

    def notes(self) -> list[Note]:
        """All notes of the only file."""
        recorder = self.flight.recorder
        assert recorder is not None
        recorder.end_session()
        recorder._write_queue()
        (file,) = (self.flight._data_dir / "recordings").glob("*.mcap")
        return notes_of(file)


@pytest.fixture
async def asked(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> AsyncIterator[Asked]:
    flight = Flight(tmp_path)
    made = Asked(flight)
    monkeypatch.setattr(Broadcast, "event", lambda _, event: made.told.append(as_told(event)))
    yield made
    for kept in (flight.journal, flight._alarm_history, flight.memory):
        kept.close()


async def test_the_path_is_kept_noted_and_told_at_once(asked: Asked, tmp_path: Path) -> None:
    asked.records()
    answer = await asked(SetHil(path="assisted"))
    assert (answer.path, answer.source) == ("assisted", None)
    assert asked.flight._sending.is_armed
    asked.flight.memory.close()
    again = Flight(tmp_path)
    assert again.hil.path == "assisted"
    again.memory.close()
    noted = [note.content["data"] for note in asked.notes() if note.name == EVENT and note.content["event"] == "hil"]
    assert noted == [{"path": "manual", "source": None}, {"path": "assisted", "source": None}]


async def test_limits_of_alarms_are_noted_at_the_start_and_when_they_are_changed(asked: Asked) -> None:
    asked.records()
    await asked(ChooseThresholds({"hil_lost_s": 2.0}))
    changes = limit_changes(asked.notes())
    assert [(name, after) for _, name, _, after in changes] == [("hil_lost_s", 2.0)]


def turn(flight: Flight, profile: str) -> None:
    """The simulator's rows of an aircraft that rolls, as this generation sends them, with times of their own."""
    for frame in range(100):
        rates = (0.0, 0.2) if profile == "xp10" else (math.degrees(0.2), 0.0)
        rows = {**ROWS, 16: (*rates, 0.0, *(NO,) * 5), 17: (2.0, math.degrees(0.2) * 0.02 * frame, 90.0, *(NO,) * 5)}
        reading = flight.hil._samples.read(build(Record(*one) for one in rows.items()), 1.7e9 + 0.02 * frame)
        assert reading is not None
        flight.hil._unshown.append(reading)
    flight.hil.show()


async def test_on_the_wrong_profile_the_board_gets_neither_the_surfaces_nor_its_autopilot_and_is_told_why(
    asked: Asked,
) -> None:
    asked.attach()
    turn(asked.flight, "xp12")
    for request in (
        SetHil(path="assisted"),
        SetHil(path="assisted", source="joystick"),
        RunCommand("autopilot_on", []),
    ):
        with pytest.raises(ConflictError, match="choose the profile X-Plane 12 in the simulator's link") as refused:
            await asked(request)
        assert refused.value.code == "profile_wrong"
        assert refused.value.params == {"profile": "X-Plane 10 / 11", "fits": "X-Plane 12"}
    assert asked.flight.hil.path == "manual"
    assert (await asked(SetHil(path="manual"))).path == "manual"


async def test_the_board_loses_the_surfaces_that_it_has_when_the_profile_proves_wrong(
    asked: Asked, tmp_path: Path
) -> None:
    await asked(SetHil(path="assisted"))
    turn(asked.flight, "xp10")
    assert (await asked(ReadHil())).path == "assisted"
    asked.flight.hil.begin(None, "xp12")
    turn(asked.flight, "xp10")
    assert (await asked(ReadHil())).path == "manual"
    assert asked.flight._sending.is_armed
    errors = [data for kind, data in asked.told if kind == "error"]
    assert [error["code"] for error in errors] == ["profile_took_surfaces"]
    asked.flight.memory.close()
    again = Flight(tmp_path)
    assert again.hil.path == "manual"
    again.memory.close()


async def test_during_the_emulation_nothing_of_the_loop_can_be_set_but_the_simulators_stick(asked: Asked) -> None:
    asked.attach(is_emulated=True)
    for wish in (SetHil(stick="gamepad"), SetHil(path="assisted"), SetHil(source="joystick"), SetHil()):
        with pytest.raises(ConflictError, match="emulation"):
            await asked(wish)
        both = replace(wish, path=wish.path or "manual", stick=wish.stick or "simulator")
        with pytest.raises(ConflictError, match="emulation"):
            await asked(both)
    assert (asked.flight.hil.path, asked.line.written) == ("manual", [])
    assert (await asked(SetHil(stick="simulator"))).stick.source == "simulator"


async def test_the_gamepad_is_chosen_for_who_asks_and_the_simulators_stick_by_anybody(
    asked: Asked, monkeypatch: pytest.MonkeyPatch
) -> None:
    flight = asked.flight
    monkeypatch.setattr(type(flight.clock), "steady_s", lambda _: 100.0)
    flight.stick.control_changed(Client("ana", "Ana"))
    flight.stick.take("ana", {**HAND, "t_ms": 100_000.0})
    for gamepad in ("Test Pad", ""):
        answer = await asked(SetHil(stick="gamepad", gamepad=gamepad))
        assert (answer.stick.client, answer.stick.gamepad) == ("ana", gamepad)
    assert (await asked(ReadHil())).stick.source == "gamepad"
    answer = await flight._requests[SetHil](SetHil(stick="simulator"), Asker())
    assert answer.stick.source == "simulator"


@pytest.mark.parametrize(
    ("wish", "command"),
    [
        (SetHil(source="joystick"), "control_source"),
        (RunCommand("gps_on", []), "gps_on"),
        (RunCommand("set_k_pitch", [2.5]), "set_k_pitch"),
        (LoadParameters(), "load_autopilot_parameters"),
    ],
)
async def test_whoever_asks_is_told_as_the_one_who_commanded(asked: Asked, wish: Request[Any], command: str) -> None:
    asked.attach()
    asking = asyncio.create_task(asked(wish))
    await eventually_async(lambda: "command" in [kind for kind, _ in asked.told], "it is told")
    (told,) = [data for kind, data in asked.told if kind == "command"]
    assert (told["name"], told["client"], told["state"]) == (command, "ana", "pending")
    asking.cancel()
    await asyncio.gather(asking, return_exceptions=True)


async def test_a_line_of_the_console_goes_out_as_it_is_and_all_are_told_who_sent_it(asked: Asked) -> None:
    with pytest.raises(ConflictError, match="no board is connected"):
        await asked(SendLine(text="help"))
    asked.attach()
    await asked(SendLine(text="help"))
    assert asked.line.written == [b"help\n"]
    asked.line.is_full = True
    with pytest.raises(ConflictError):
        await asked(SendLine(text="lost"))
    sent = [data for kind, data in asked.told if kind == "console"]
    assert sent == [{"direction": "sent", "text": "help", "client": "ana"}], "what did not leave is not told as sent"


async def test_an_emulated_board_takes_no_line_of_the_console(asked: Asked) -> None:
    asked.attach(is_emulated=True)
    with pytest.raises(ConflictError, match="emulation"):
        await asked(SendLine(text="help"))
    assert (asked.line.written, [kind for kind, _ in asked.told if kind == "console"]) == ([], [])


async def test_a_mark_is_set_as_long_ago_as_was_said_and_told_as_it_was_answered(asked: Asked) -> None:
    asked.records()
    now_s = asked.flight.clock.now_s()
    made = await asked(SetMark(text="here", by="Ana", ago_s=500.0))
    also = await asked(SetMark(text="there"))
    assert -500.0 <= made.t_s - now_s < -440.0
    assert 0.0 <= also.t_s - now_s < 60.0
    assert [data for kind, data in asked.told if kind == "mark"] == [asdict(made), asdict(also)]
    marks = [note for note in asked.notes() if note.name == MARK]
    assert [note.content for note in marks] == [
        {"text": "here", "by": "Ana", "id": made.id},
        {"text": "there", "by": None, "id": also.id},
    ]
    assert [note.t_ns * 1e-9 for note in marks] == [made.t_s, also.t_s]
    assert made.id != also.id


@pytest.mark.parametrize(
    ("remembered", "policy"),
    [
        ({}, DiskPolicy()),
        ({"delete_oldest": True, "keep_free_bytes": 0}, DiskPolicy(delete_oldest=True, keep_free_bytes=0)),
        ({"delete_oldest": "yes", "keep_free_bytes": True}, DiskPolicy()),
        ({"delete_oldest": 1, "keep_free_bytes": -1}, DiskPolicy()),
        ({"delete_oldest": False, "keep_free_bytes": "5"}, DiskPolicy()),
    ],
)
async def test_of_a_remembered_policy_only_what_makes_sense_is_taken(
    remembered: dict[str, Any], policy: DiskPolicy
) -> None:
    assert policy_of(remembered) == policy


async def test_what_the_bytes_of_the_lines_do_not_say_is_noted_and_nothing_else(asked: Asked) -> None:
    asked.records()
    heard: list[str] = []
    gains = asked.flight.outlet.on_parameters
    assert gains is not None
    asked.flight.outlet.on_parameters = lambda: heard.append("gains")
    noted = (
        AdviceEvent("line_full", "info", "The line is full.", {}),
        AlarmEvent("hil_lost", "warning", 1.0, None, "Lost.", {}, acknowledged=False, active=True),
        BoardRestartEvent(),
        CommandEvent(1, "reset", [], None, "sent"),
        ConsoleEvent("sent", "help"),
        LinkEvent("open", "closed"),
        MissionEvent("flight", "pending"),
        ParameterEvent({}),
        SimulatorJumpEvent(1000.0, 28.0, -15.0, 500.0),
        StickEvent("simulator", None, "chosen", None, None, None),
    )
    others = (
        MarkEvent("1", "Gusts", None, 1.0),
        JournalEvent(None, None, None),
        ConsoleEvent("received", "help"),
        RecordingEvent(active=False, file=None),
        ErrorEvent("internal", "A fault.", {}),
    )
    for event in (*noted, *others):
        asked.flight.outlet.event(event)
    assert heard == ["gains"], "the gains are noted anew when one of them changes"
    assert asked.told[-15:] == [as_told(event) for event in (*noted, *others)], "the stations are told all the same"
    notes = [note.content for note in asked.notes() if note.name == EVENT and note.content["event"] != "hil"]
    told = [(note["event"], note["data"]) for note in notes if note["event"] != "limits"]
    assert told == [as_told(event) for event in noted]


async def test_the_identity_names_board_firmware_station_and_person(asked: Asked) -> None:
    asked.records()
    asked.flight.stick.control_changed(Client("ana", "Ana"))
    asked.attach()
    asked.flight._known.identity()
    asked.flight.stick.control_changed(None)
    notes = asked.notes()
    first, before, known, after = [note.content for note in notes if note.name == IDENTITY]
    assert first == before | {"operator": None}, "a file begins with who begins"
    assert (before["board"], before["firmware"], before["operator"]) == ({}, None, "Ana")
    assert (known["firmware"], known["aircraft"], known["emulated"]) == ("fake 1.5", None, False)
    assert known["board"]["firmware_version"] == "1.5"
    assert after == known | {"operator": None}
    control = [note.content["data"] for note in notes if note.name == EVENT and note.content["event"] == "control"]
    assert control == [{"client": "ana", "name": "Ana"}, {"client": None, "name": None}]


async def test_a_sample_without_axes_and_a_notice_for_somebody_else_move_nothing(asked: Asked) -> None:
    flight = asked.flight
    flight.stick.control_changed(Client("ana", "Ana"))
    notice = notices(flight.stick, flight.watch.surroundings, flight.clock.steady_s)
    notice(StickSample("ana", {"roll": "much"}))
    notice(Pace(5))
    assert flight.stick.holder == Client("ana", "Ana")
    assert flight.stick.counts == {"invalid": 1}
