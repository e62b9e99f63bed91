"""Writing gains: what the journal says, what can be undone, and what an interrupted write leaves behind."""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from pathlib import Path
from typing import Any

import pytest

from epf_gcs.bus.vehicle_end import Broadcast
from epf_gcs.codec.frame import Frame, FrameDecoder
from epf_gcs.codec.messages_gen import COMMANDS
from epf_gcs.contract.answers import CommandOutcome, ParameterMove
from epf_gcs.contract.events import Event, ParameterEvent
from epf_gcs.errors import BoardError, ConflictError, LinkError
from epf_gcs.flight.board import commands
from epf_gcs.flight.flight import Flight
from epf_gcs.link.address import parse_address
from tests.support.contract import as_told
from tests.support.fake_board import FakeBoard
from tests.support.waiting import eventually_async

pytestmark = pytest.mark.anyio


@asynccontextmanager
async def a_station(folder: Path, board: FakeBoard) -> AsyncIterator[Flight]:
    station = Flight(folder / "data", record=False)
    async with station.running():
        await station.lines.open_board(parse_address(board.url))
        await eventually_async(lambda: station.supervisor.state == "open", "the board opens")
        yield station


def story(station: Flight) -> list[tuple[str, str, list[tuple[str, float | None, float, str]]]]:
    """Kind, state and changes of all entries, oldest first."""
    return [
        (entry.kind, entry.state, [(one.name, one.before, one.after, one.state) for one in entry.changes])
        for entry in reversed(station.parameters.journal.entries)
    ]


@pytest.mark.parametrize("kind", ["board", "legacy_board"])
async def test_what_was_written_can_be_undone_and_done_again(
    tmp_path: Path, request: pytest.FixtureRequest, kind: str
) -> None:
    board: FakeBoard = request.getfixturevalue(kind)
    async with a_station(tmp_path, board) as station:
        parameters = station.parameters
        await parameters.set({"k_pitch": 2.5, "k_div_velocidad": 800}, "c1")
        await parameters.undo("c1")
        assert (board.gains["k_pitch"], board.gains["k_div_velocidad"]) == (2.0, 700)
        assert parameters.held["k_pitch"].state == "confirmed"
        await parameters.redo("c1")
        assert (board.gains["k_pitch"], board.gains["k_div_velocidad"]) == (2.5, 800)
        both = [("k_pitch", 2.0, 2.5, "confirmed"), ("k_div_velocidad", 700.0, 800.0, "confirmed")]
        back = [("k_pitch", 2.5, 2.0, "confirmed"), ("k_div_velocidad", 800.0, 700.0, "confirmed")]
        assert story(station) == [
            ("write", "confirmed", both),
            ("undo", "confirmed", back),
            ("redo", "confirmed", both),
        ]


async def test_an_undo_gives_exactly_what_was_there(tmp_path: Path, board: FakeBoard) -> None:
    board.gains["k_int_pitch"] = 0.1
    async with a_station(tmp_path, board) as station:
        await station.parameters.load(None)
        exactly = station.parameters.held["k_int_pitch"].value
        await station.parameters.set({"k_int_pitch": 0.7}, None)
        await station.parameters.undo(None)
        assert station.parameters.held["k_int_pitch"].value == exactly


async def test_with_nothing_to_undo_nothing_is_sent(tmp_path: Path, board: FakeBoard) -> None:
    async with a_station(tmp_path, board) as station:
        await station.parameters.load(None)
        sent = list(board.received)
        for action, code in (
            (station.parameters.undo, "nothing_to_undo"),
            (station.parameters.redo, "nothing_to_redo"),
        ):
            with pytest.raises(ConflictError) as refused:
                await action(None)
            assert refused.value.code == code
        assert board.received == sent


async def test_before_the_first_write_the_gains_are_read_for_what_they_were(tmp_path: Path, board: FakeBoard) -> None:
    async with a_station(tmp_path, board) as station:
        await station.parameters.set({"k_pitch": 2.5}, None)
        assert board.received[-3:] == ["load_autopilot_parameters", "set_k_pitch", "load_autopilot_parameters"]
        assert station.parameters.held["k_pitch"].loaded == 2.0
        sent = len(board.received)
        await station.parameters.set({"k_pitch": 2.6}, None)
        assert board.received[sent:] == ["set_k_pitch", "load_autopilot_parameters"], "known gains are not read first"


async def test_a_load_sets_the_mark_from_which_changes_count(tmp_path: Path, board: FakeBoard) -> None:
    async with a_station(tmp_path, board) as station:
        await station.parameters.set({"k_pitch": 2.5}, None)
        assert station.parameters.held["k_pitch"].loaded == 2.0
        board.gains["k_roll"] = 3.0
        await station.parameters.load(None)
        assert station.parameters.held["k_pitch"].loaded == 2.5
        assert station.parameters.held["k_roll"].value == 3.0


async def test_a_refused_gain_is_in_the_journal_and_not_to_undo(tmp_path: Path, board: FakeBoard) -> None:
    async with a_station(tmp_path, board) as station:
        board.refuse["set_k_pitch"] = 1
        await station.parameters.set({"k_pitch": 2.5, "k_roll": 3.0}, None)
        assert story(station) == [
            ("write", "rejected", [("k_pitch", 2.0, 2.5, "rejected"), ("k_roll", 2.0, 3.0, "confirmed")])
        ]
        assert station.parameters.journal.steps.undo == (ParameterMove("k_roll", 3.0, 2.0),)
        assert station.parameters.unconfirmed == ("k_pitch",)
        station.parameters.accept_unconfirmed()
        assert not station.parameters.unconfirmed


async def test_a_lost_set_command_is_timed_out_and_a_later_write_settles_it(tmp_path: Path, board: FakeBoard) -> None:
    async with a_station(tmp_path, board) as station:
        board.ignore["set_k_pitch"] = 2
        await station.parameters.set({"k_pitch": 2.5}, None)
        assert story(station) == [("write", "timed_out", [("k_pitch", 2.0, 2.5, "timed_out")])]
        assert station.parameters.unconfirmed == ("k_pitch",)
        await station.parameters.set({"k_pitch": 2.5}, None)
        assert not station.parameters.unconfirmed


async def test_a_write_without_a_read_back_is_timed_out_and_can_be_undone(tmp_path: Path, board: FakeBoard) -> None:
    async with a_station(tmp_path, board) as station:
        await station.parameters.load(None)
        board.ignore["load_autopilot_parameters"] = 2
        with pytest.raises(BoardError):
            await station.parameters.set({"k_pitch": 2.5}, None)
        held = station.parameters.held["k_pitch"]
        assert (held.value, held.state, held.loaded) == (None, "unknown", 2.0)
        assert story(station) == [("write", "timed_out", [("k_pitch", 2.0, 2.5, "timed_out")])]
        await station.parameters.undo(None)
        assert board.gains["k_pitch"] == 2.0
        assert not station.parameters.unconfirmed


async def test_a_board_that_is_lost_during_a_write_leaves_an_entry_and_nothing_to_undo(
    tmp_path: Path, board: FakeBoard
) -> None:
    async with a_station(tmp_path, board) as station:
        await station.parameters.set({"k_roll": 3.0}, None)
        board.ignore["set_k_pitch"] = 99
        writing = asyncio.create_task(station.parameters.set({"k_pitch": 2.5}, "c1"))
        await eventually_async(lambda: board.count("set_k_pitch") > 0, "the command is on its way")
        board.unplug()
        with pytest.raises(LinkError):
            await writing
        assert story(station)[-1] == ("write", "timed_out", [("k_pitch", 2.0, 2.5, "timed_out")])
        assert station.parameters.journal.steps.undo is None
        assert station.parameters.held["k_pitch"].state == "unknown"
        board.plug_in()
        await eventually_async(lambda: station.supervisor.state == "open", "the board is back")
        with pytest.raises(ConflictError):
            await station.parameters.undo("c1")
        assert len(story(station)) == 2


async def test_gains_that_were_known_are_read_again_as_soon_as_the_board_is_back(
    tmp_path: Path, board: FakeBoard
) -> None:
    async with a_station(tmp_path, board) as station:
        assert board.count("load_autopilot_parameters") == 0, "nobody had asked for them"
        await station.parameters.load(None)
        board.unplug()
        await eventually_async(lambda: station.parameters.held["k_pitch"].value is None, "nothing is known of them")
        board.gains["k_pitch"] = 2.75
        board.plug_in()
        await eventually_async(lambda: station.parameters.held["k_pitch"].value == 2.75, "they are read")
        assert board.count("load_autopilot_parameters") == 2


async def test_gains_are_read_again_after_a_restart_of_the_board(tmp_path: Path, board: FakeBoard) -> None:
    async with a_station(tmp_path, board) as station:
        await station.parameters.load(None)
        board.gains["k_pitch"] = 2.75
        board.restart()
        await eventually_async(lambda: station.parameters.held["k_pitch"].value == 2.75, "they are read")


async def test_a_board_that_is_lost_during_a_set_command_leaves_an_entry_and_a_gain_that_is_not_sure(
    tmp_path: Path, board: FakeBoard
) -> None:
    async with a_station(tmp_path, board) as station:
        await station.parameters.load(None)
        board.ignore["set_k_pitch"] = 99
        setting = asyncio.create_task(station.parameters.set_by_command(COMMANDS["set_k_pitch"], 2.5, "c1"))
        await eventually_async(lambda: board.count("set_k_pitch") > 0, "the command is on its way")
        board.unplug()
        with pytest.raises(LinkError):
            await setting
        assert story(station)[-1] == ("write", "timed_out", [("k_pitch", 2.0, 2.5, "timed_out")])
        assert station.parameters.unconfirmed == ("k_pitch",)


async def test_a_set_command_that_could_not_be_sent_is_in_no_journal(
    tmp_path: Path, board: FakeBoard, monkeypatch: pytest.MonkeyPatch
) -> None:
    async with a_station(tmp_path, board) as station:
        monkeypatch.setattr(station.board, "write", lambda _: False)
        with pytest.raises(ConflictError):
            await station.parameters.set_by_command(COMMANDS["set_k_pitch"], 2.5, "c1")
        assert (story(station), station.parameters.unconfirmed) == ([], ())
        monkeypatch.undo()


async def test_a_board_that_started_anew_has_nothing_to_undo(tmp_path: Path, board: FakeBoard) -> None:
    async with a_station(tmp_path, board) as station:
        await station.parameters.set({"k_pitch": 2.5}, None)
        board.restart()
        await eventually_async(lambda: board.count("capabilities") == 2, "the silence is noticed")
        await eventually_async(lambda: station.supervisor.state == "open", "it is opened anew")
        await eventually_async(lambda: station.parameters.journal.steps.undo is None, "nothing can be undone")
        await eventually_async(lambda: station.parameters.held["k_pitch"].state == "loaded", "it is read again")
        assert len(story(station)) == 1


async def test_only_what_the_board_stored_on_its_card_is_safe_from_a_restart(tmp_path: Path, board: FakeBoard) -> None:
    async with a_station(tmp_path, board) as station:
        parameters = station.parameters
        await parameters.set({"k_pitch": 2.5}, None)
        board.refuse["store_parameters"] = 2
        assert (await parameters.store(None)).state == "rejected"
        assert parameters.take_unstored() == ("k_pitch",)
        del board.refuse["store_parameters"]
        await parameters.set({"k_pitch": 2.6, "k_roll": 2.5}, None)
        assert (await parameters.store(None)).state == "confirmed"
        await parameters.set({"k_roll": 2.6}, None)
        assert parameters.take_unstored() == ("k_roll",)
        assert parameters.take_unstored() == ()


async def test_what_is_loaded_from_a_board_that_just_opened_stays_while_it_is_still_being_re_armed(
    tmp_path: Path, board: FakeBoard
) -> None:
    async with a_station(tmp_path, board) as station:
        await station.commands.run("ahrs_on")
        board.ignore["ahrs_on"] = 1000
        for _ in range(2):
            board.unplug()
            await eventually_async(lambda: station.supervisor.state == "lost", "the cable is out")
            board.plug_in()
            await eventually_async(lambda: station.supervisor.state == "open", "the board is back")
        await station.parameters.load(None)
        asked = board.count("ahrs_on")
        await eventually_async(lambda: board.count("ahrs_on") > asked, "it is asked for its stream")
        assert station.parameters.held["k_pitch"].state == "loaded"


async def test_two_writers_follow_each_other_and_each_sees_what_the_other_left(
    tmp_path: Path, board: FakeBoard
) -> None:
    async with a_station(tmp_path, board) as station:
        await asyncio.gather(
            station.parameters.set({"k_pitch": 2.5}, "c1"), station.parameters.set({"k_pitch": 2.6}, "c2")
        )
        first, second = story(station)
        assert first == ("write", "confirmed", [("k_pitch", 2.0, 2.5, "confirmed")])
        assert second == ("write", "confirmed", [("k_pitch", 2.5, 2.6, "confirmed")])
        await asyncio.gather(station.parameters.undo("c1"), station.parameters.undo("c2"))
        assert board.gains["k_pitch"] == 2.0


@pytest.mark.parametrize("kind", ["board", "legacy_board"])
async def test_a_set_command_by_itself_is_in_the_journal_too(
    tmp_path: Path, request: pytest.FixtureRequest, kind: str
) -> None:
    board: FakeBoard = request.getfixturevalue(kind)
    async with a_station(tmp_path, board) as station:
        await station.parameters.load(None)
        result = await station.parameters.set_by_command(COMMANDS["set_k_pitch"], 2.5, "c1")
        assert result.state == "confirmed"
        assert station.parameters.held["k_pitch"].value == 2.5
        assert story(station) == [("write", "confirmed", [("k_pitch", 2.0, 2.5, "confirmed")])]
        await station.parameters.undo(None)
        assert board.gains["k_pitch"] == 2.0


async def test_a_set_command_that_is_refused_or_lost_claims_nothing(tmp_path: Path, board: FakeBoard) -> None:
    async with a_station(tmp_path, board) as station:
        await station.parameters.load(None)
        board.refuse["set_k_pitch"] = 1
        board.ignore["set_k_roll"] = 99
        await station.parameters.set_by_command(COMMANDS["set_k_pitch"], 2.5, None)
        await station.parameters.set_by_command(COMMANDS["set_k_roll"], 3.0, None)
        held = station.parameters.held
        assert (held["k_pitch"].value, held["k_pitch"].state) == (2.0, "rejected")
        assert (held["k_roll"].value, held["k_roll"].state) == (None, "unknown")
        assert [state for _, state, _ in story(station)] == ["rejected", "timed_out"]
        assert station.parameters.unconfirmed == ("k_pitch", "k_roll")


async def test_a_journal_on_a_bad_disk_is_counted_and_the_write_counts_all_the_same(
    tmp_path: Path, board: FakeBoard
) -> None:
    (tmp_path / "data").mkdir()
    (tmp_path / "data" / "parameter-journal.jsonl").mkdir()
    async with a_station(tmp_path, board) as station:
        assert station.errors.counts["journal_unreadable"] == 1
        await station.parameters.set({"k_pitch": 2.5}, None)
        assert board.gains["k_pitch"] == 2.5
        await eventually_async(lambda: station.errors.counts["journal_not_written"] == 1, "the failure is counted")


async def told(station: Flight, monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """What the viewers hear from now on, each event in a word or two."""
    heard: list[str] = []

    def event(event: Event) -> None:
        kind, data = as_told(event)
        if kind in ("command", "parameter", "journal"):
            names = data["name"] if kind == "command" else ""
            heard.append(" ".join(word for word in (kind, names, data.get("state", "")) if word))

    monkeypatch.setattr(station.outlet, "event", event)
    return heard


@pytest.mark.parametrize("kind", ["board", "legacy_board"])
async def test_one_write_is_one_command_one_read_back_and_is_told_once(
    tmp_path: Path, request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch, kind: str
) -> None:
    board: FakeBoard = request.getfixturevalue(kind)
    async with a_station(tmp_path, board) as station:
        await station.parameters.load(None)
        sent = len(board.received)
        heard = await told(station, monkeypatch)
        await station.parameters.set({"k_pitch": 2.5}, "c1")
        assert board.received[sent:] == ["set_k_pitch", "load_autopilot_parameters"]
        assert heard == ["parameter", "parameter", "command set_k_pitch confirmed", "journal"]


async def test_a_load_is_a_command_that_everybody_sees(
    tmp_path: Path, board: FakeBoard, monkeypatch: pytest.MonkeyPatch
) -> None:
    async with a_station(tmp_path, board) as station:
        heard = await told(station, monkeypatch)
        await station.parameters.load("c1")
        assert [one for one in heard if one.startswith("command")] == [
            "command load_autopilot_parameters pending",
            "command load_autopilot_parameters confirmed",
        ]


@pytest.mark.parametrize("kind", ["board", "legacy_board"])
async def test_what_a_board_keeps_as_it_was_is_told_as_rejected(
    tmp_path: Path, request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch, kind: str
) -> None:
    board: FakeBoard = request.getfixturevalue(kind)
    async with a_station(tmp_path, board) as station:
        await station.parameters.load(None)
        board.refuse["set_k_pitch"] = 1
        heard = await told(station, monkeypatch)
        await station.parameters.set({"k_pitch": 2.5}, "c1")
        assert heard == ["parameter", "parameter", "command set_k_pitch rejected", "journal"]
        assert station.parameters.held["k_pitch"].state == "rejected"
        assert story(station)[-1] == ("write", "rejected", [("k_pitch", 2.0, 2.5, "rejected")])


async def test_a_write_that_could_not_be_sent_changes_nothing_and_is_in_no_journal(
    tmp_path: Path, board: FakeBoard, monkeypatch: pytest.MonkeyPatch
) -> None:
    async with a_station(tmp_path, board) as station:
        await station.parameters.load(None)
        before = station.parameters.held
        monkeypatch.setattr(station.board, "write", lambda _: False)
        with pytest.raises(ConflictError) as full:
            await station.parameters.set({"k_pitch": 2.5}, "c1")
        assert full.value.code == "board_line_full"
        assert station.parameters.held == before
        assert story(station) == []
        monkeypatch.undo()


async def test_viewers_are_told_only_of_gains_that_changed(
    tmp_path: Path, board: FakeBoard, monkeypatch: pytest.MonkeyPatch
) -> None:
    told: list[set[str]] = []
    tell = Broadcast.event

    def note(self: Broadcast, event: Event) -> None:
        if isinstance(event, ParameterEvent):
            told.append(set(event.parameters))
        tell(self, event)

    async with a_station(tmp_path, board) as station:
        await station.parameters.load(None)
        monkeypatch.setattr(Broadcast, "event", note)
        await station.parameters.set({"k_pitch": 2.5}, None)
        board.gains["k_roll"] = 3.0
        await station.parameters.load(None)
    changed = set().union(*told)
    assert changed <= {"k_pitch", "k_roll"}
    assert "k_pitch" in changed


async def test_a_gain_that_only_a_command_set_is_known_as_the_board_has_it(tmp_path: Path, board: FakeBoard) -> None:
    async with a_station(tmp_path, board) as station:
        await station.parameters.load(None)
        await station.parameters.set_by_command(COMMANDS["set_k_int_pitch"], 0.7, None)
        await station.parameters.load(None)
        assert station.parameters.held["k_int_pitch"].state == "confirmed", "the board still has what it confirmed"


async def test_a_set_command_that_another_board_confirms_says_nothing_of_the_gains_of_this_one(
    tmp_path: Path, board: FakeBoard
) -> None:
    async with a_station(tmp_path, board) as station:
        await station.parameters.load(None)
        with board._lock:
            sent = station.board.bytes_out
            setting = asyncio.create_task(station.parameters.set_by_command(COMMANDS["set_k_pitch"], 2.5, None))
            await eventually_async(lambda: station.board.bytes_out > sent, "the command is on its way")
            station.parameters.forget()
        await setting
        assert station.parameters.held["k_pitch"].value is None
        assert [kind for kind, _, _ in story(station)] == ["write"]
        assert station.parameters.journal.steps.undo is None


async def test_where_one_of_the_gains_is_not_known_all_are_read_before_they_are_written(
    tmp_path: Path, board: FakeBoard, monkeypatch: pytest.MonkeyPatch
) -> None:
    async with a_station(tmp_path, board) as station:
        await station.parameters.load(None)
        board.ignore["set_k_pitch"] = 2
        with monkeypatch.context() as patience:
            patience.setattr(commands, "_ANSWER_S", 0.01)
            await station.parameters.set_by_command(COMMANDS["set_k_pitch"], 2.1, None)
        await station.parameters.set({"k_roll": 3.0, "k_pitch": 2.5}, None)
        assert story(station)[-1][2] == [("k_roll", 2.0, 3.0, "confirmed"), ("k_pitch", 2.0, 2.5, "confirmed")]


async def test_of_a_write_that_broke_off_only_what_was_sent_is_in_the_journal_and_not_sure(
    tmp_path: Path, board: FakeBoard, monkeypatch: pytest.MonkeyPatch
) -> None:
    async with a_station(tmp_path, board) as station:
        await station.parameters.load(None)
        before = station.parameters.held
        write, written = station.board.write, list[bytes]()

        def take_one(data: bytes) -> bool:
            written.append(data)
            return len(written) == 1 and write(data)

        with monkeypatch.context() as line:
            line.setattr(station.board, "write", take_one)
            with pytest.raises(ConflictError) as full:
                await station.parameters.set({"k_pitch": 2.5, "k_roll": 3.0, "k_elev": 4.0}, "c1")
        assert full.value.code == "board_line_full"
        ((kind, state, changes),) = story(station)
        assert (kind, state) == ("write", "timed_out")
        assert [(name, after) for name, _, after, _ in changes] == [("k_pitch", 2.5)]
        assert board.gains["k_pitch"] == 2.5, "the first did arrive"
        held = dict(station.parameters.held)
        assert held["k_pitch"].state == "unknown"
        assert {**held, "k_pitch": before["k_pitch"]} == before
        assert station.parameters.unconfirmed == ("k_pitch",)


async def test_a_write_that_could_not_be_sent_brings_no_gains_of_the_board_before_back(
    tmp_path: Path, board: FakeBoard, monkeypatch: pytest.MonkeyPatch
) -> None:
    async with a_station(tmp_path, board) as station:
        await station.parameters.load(None)

        def goes_meanwhile(_: bytes) -> bool:
            station.parameters.forget()
            return False

        with monkeypatch.context() as line:
            line.setattr(station.board, "write", goes_meanwhile)
            with pytest.raises(ConflictError):
                await station.parameters.set({"k_pitch": 2.5}, None)
        assert {one.value for one in station.parameters.held.values()} == {None}


async def test_gains_that_come_twice_at_once_are_read_once(tmp_path: Path, board: FakeBoard) -> None:
    send = board._write

    def send_twice(data: bytes) -> None:
        (found,) = FrameDecoder().feed(data)
        is_gains = isinstance(found, Frame) and found.message.name == "autopilot_parameters"
        send(data * 2 if is_gains else data)

    async with a_station(tmp_path, board) as station:
        board._write = send_twice  # type: ignore[method-assign]
        await station.parameters.load(None)
        assert station.parameters.held["k_pitch"].value == 2.0
        assert station.errors.counts == {}


async def test_viewers_hear_how_each_gain_of_a_write_ended_and_why_and_who_asked(
    tmp_path: Path, board: FakeBoard, monkeypatch: pytest.MonkeyPatch
) -> None:
    heard: list[tuple[Any, ...]] = []

    def event(event: Event) -> None:
        kind, data = as_told(event)
        if kind == "command":
            heard.append(tuple(data[field] for field in ("name", "value", "state", "by", "reason", "client")))

    act = board._act

    def act_without_roll(frame: Frame) -> None:
        if frame.message.name != "set_k_roll":
            act(frame)

    async with a_station(tmp_path, board) as station:
        await station.parameters.load(None)
        board.refuse["set_k_pitch"] = 1
        board._act = act_without_roll  # type: ignore[method-assign]
        monkeypatch.setattr(station.outlet, "event", event)
        await station.parameters.set({"k_pitch": 2.5, "k_roll": 3.0, "k_elev": 4.0}, "c1")
        of_write = list(heard)
        await station.parameters.load("c2")
        await station.parameters.set_by_command(COMMANDS["set_k_elev"], 4.5, "c3")
        monkeypatch.undo()
    assert of_write == [
        ("set_k_pitch", [2.5], "rejected", "read_back", "bad_value", "c1"),
        ("set_k_roll", [3.0], "rejected", "read_back", "not_taken", "c1"),
        ("set_k_elev", [4.0], "confirmed", "read_back", None, "c1"),
    ]
    asked = [(name, client) for name, _, state, _, _, client in heard[len(of_write) :] if state == "confirmed"]
    assert asked == [("load_autopilot_parameters", "c2"), ("set_k_elev", "c3")]


async def test_a_gain_that_is_written_while_the_card_is_writing_is_not_safe_yet(
    tmp_path: Path, board: FakeBoard, monkeypatch: pytest.MonkeyPatch
) -> None:
    async with a_station(tmp_path, board) as station:
        await station.parameters.set({"k_pitch": 2.5}, None)
        run = station.commands.run

        async def write_meanwhile(name: str, *arguments: Any, **options: Any) -> CommandOutcome:
            if name == "store_parameters":
                await station.parameters.set({"k_roll": 3.0}, None)
            return await run(name, *arguments, **options)

        monkeypatch.setattr(station.commands, "run", write_meanwhile)
        await station.parameters.store(None)
        assert station.parameters.take_unstored() == ("k_roll",)
