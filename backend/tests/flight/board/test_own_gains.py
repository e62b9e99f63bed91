"""The gains that a board describes itself: read once, written with read-back, undone."""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from pathlib import Path

import pytest

from epf_gcs.codec.description import FieldRow, TopicRow, blocks_of
from epf_gcs.contract.own_gains import LeftOutRow, OwnGainTable
from epf_gcs.errors import ConflictError, GatewayError, InvalidInputError, LinkError
from epf_gcs.flight.board import answers, own_table
from epf_gcs.flight.flight import Flight
from epf_gcs.link.address import parse_address
from tests.support.fake_board import FakeBoard, law_row, own_row
from tests.support.waiting import eventually_async

pytestmark = pytest.mark.anyio

ROWS = (law_row(0), own_row(1), own_row(2, "line_approach", unit="s"))
LONG = tuple(own_row(row, f"line_k_{row}") for row in range(27))


@pytest.fixture(autouse=True)
def describing(board: FakeBoard) -> None:
    board.describe(*ROWS)


@asynccontextmanager
async def a_station(folder: Path, board: FakeBoard) -> AsyncIterator[Flight]:
    """The board is open, and nothing is being read any more."""
    station = Flight(folder / "data", record=False)
    async with station.running():
        await station.lines.open_board(parse_address(board.url))
        await is_read(station)
        yield station


async def is_read(station: Flight) -> None:
    own = station.parameters.own
    await eventually_async(
        lambda: own.known.table.state == "known" and not own._reading.locked(), "its own gains are read"
    )


def questions(board: FakeBoard) -> list[tuple[float, ...]]:
    """First block and how many, of each question."""
    asked = zip(board.received, board.arguments, strict=True)
    return [arguments for name, arguments in asked if name == "describe_blocks"]


def values(station: Flight) -> dict[str, float | None]:
    return {name: one.value for name, one in station.parameters.own.known.values.items()}


async def test_the_table_and_every_value_are_read_when_the_board_opens(tmp_path: Path, board: FakeBoard) -> None:
    board.own_gains[1] = 4.0
    async with a_station(tmp_path, board) as station:
        assert values(station) == {"guidance_law": 0.0, "line_k_bank": 4.0, "line_approach": 3.0}
        assert {one.state for one in station.parameters.own.known.values.values()} == {"loaded"}
        assert all(one.heard_s is not None for one in station.parameters.own.known.values.values())
        assert station.parameters.own.known.table.left_out == ()


async def test_a_board_that_does_not_describe_itself_is_not_asked(tmp_path: Path, board: FakeBoard) -> None:
    board.features = 15
    station = Flight(tmp_path / "data", record=False)
    async with station.running():
        await station.lines.open_board(parse_address(board.url))
        await eventually_async(lambda: station.supervisor.state == "open", "the board opens")
        await station.parameters.load(None)
        assert station.parameters.own.known.table.state == "none"
        assert board.count("describe") == 0


async def test_a_known_checksum_costs_one_question_also_after_a_start_of_the_station(
    tmp_path: Path, board: FakeBoard
) -> None:
    async with a_station(tmp_path, board):
        assert board.count("describe_blocks") == 1
    async with a_station(tmp_path, board) as station:
        assert (board.count("describe"), board.count("describe_blocks")) == (2, 1)
        assert values(station)["line_k_bank"] == 3.0


async def test_blocks_are_asked_for_eight_at_a_time_and_the_last_ones_without_what_is_behind_the_end(
    tmp_path: Path, board: FakeBoard
) -> None:
    board.describe(*LONG)
    count = len(blocks_of(board.table))
    assert count == 18
    async with a_station(tmp_path, board) as station:
        assert questions(board) == [(0, 8), (8, 8), (16, 2)]
        assert len(station.parameters.own.known.table.gains) == len(LONG)


async def test_lost_blocks_are_asked_for_again_without_those_that_came(
    tmp_path: Path, board: FakeBoard, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(own_table, "_SILENCE_S", 0.05)
    board.describe(*LONG)
    board.lose_block.update({1: 1, 7: 2, 8: 1, 17: 1})
    async with a_station(tmp_path, board) as station:
        assert station.parameters.own.known.table.left_out == ()
        assert len(station.parameters.own.known.table.gains) == len(LONG)
        assert questions(board) == [(0, 8), (8, 8), (16, 2), (1, 1), (7, 2), (17, 1), (7, 1)]


async def test_a_lost_acknowledgement_or_value_costs_no_gain(
    tmp_path: Path, board: FakeBoard, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(answers, "_ANSWER_S", 0.05)
    board.lose_row[1] = 2
    board.lose_acknowledgement["describe_blocks"] = 1
    async with a_station(tmp_path, board) as station:
        assert (station.parameters.own.known.table.left_out, values(station)["line_k_bank"]) == ((), 3.0)
        assert questions(board) == [(0, 2)]


async def test_the_progress_is_told_in_blocks(tmp_path: Path, board: FakeBoard) -> None:
    board.describe(*LONG)
    station = Flight(tmp_path / "data", record=False)
    told: list[tuple[int, int]] = []
    async with station.running():
        tell = station.parameters.own._tell_table

        def listen(table: OwnGainTable) -> None:
            if table.state == "reading":
                told.append((table.blocks_read, table.block_count))
            tell(table)

        station.parameters.own._tell_table = listen  # type: ignore[method-assign]
        await station.lines.open_board(parse_address(board.url))
        await is_read(station)
    assert told == [(0, 18), (8, 18), (16, 18), (18, 18)]


async def test_a_block_that_never_comes_loses_what_follows_it_until_the_next_opening(
    tmp_path: Path, board: FakeBoard, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(own_table, "_SILENCE_S", 0.05)
    board.lose_block[1] = 4
    async with a_station(tmp_path, board) as station:
        assert station.parameters.own.known.table.left_out == (LeftOutRow(1, None, "lost"),)
        assert values(station) == {"guidance_law": 0.0}
        assert not (tmp_path / "data" / "own-gains.json").exists()
    async with a_station(tmp_path, board) as station:
        assert values(station)["line_k_bank"] == 3.0


async def test_a_board_that_sends_no_block_is_soon_asked_no_more(
    tmp_path: Path, board: FakeBoard, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(own_table, "_SILENCE_S", 0.05)
    board.describe(*LONG)
    board.lose_block.update(dict.fromkeys(range(18), 99))
    async with a_station(tmp_path, board) as station:
        assert station.parameters.own.known.table.left_out == (LeftOutRow(0, None, "lost"),)
        assert questions(board) == [(0, 8), (8, 8), (16, 2), (0, 8)]


async def test_a_table_of_nothing_is_a_table(tmp_path: Path, board: FakeBoard) -> None:
    board.describe()
    async with a_station(tmp_path, board) as station:
        assert (values(station), station.parameters.own.known.table.left_out) == ({}, ())


async def test_topics_in_the_table_are_no_gains_and_count_as_rows(tmp_path: Path, board: FakeBoard) -> None:
    topic = TopicRow(0, 0x1000, 500, "wind", "")
    board.describe(topic, FieldRow(1, 1, 1.0, 0.0, 360.0, "wind_from", "deg", "", ""), own_row(2))
    async with a_station(tmp_path, board) as station:
        assert values(station) == {"line_k_bank": 3.0}
        assert station.parameters.own.known.table.left_out == ()
        await station.parameters.set({"line_k_bank": 4.0}, None)
        assert board.own_gains == {2: 4.0}


async def test_a_table_whose_checksum_does_not_hold_is_used_and_not_kept(tmp_path: Path, board: FakeBoard) -> None:
    board.own_checksum = 7
    async with a_station(tmp_path, board) as station:
        assert values(station)["line_k_bank"] == 3.0
        assert not (tmp_path / "data" / "own-gains.json").exists()


@pytest.mark.parametrize("text", ['{"rows": ["00"]}', '{"table": "0"}', '{"table": 7}', "[]", ""])
async def test_a_damaged_or_older_kept_table_is_set_aside_and_read_anew(
    tmp_path: Path, board: FakeBoard, text: str
) -> None:
    (tmp_path / "data").mkdir()
    (tmp_path / "data" / "own-gains.json").write_text(text)
    async with a_station(tmp_path, board) as station:
        assert values(station)["line_k_bank"] == 3.0
        assert len(list((tmp_path / "data").glob("own-gains.json.damaged-*"))) == 1


async def test_after_a_restart_with_another_table_nothing_of_the_old_one_is_known(
    tmp_path: Path, board: FakeBoard
) -> None:
    async with a_station(tmp_path, board) as station:
        await station.parameters.set({"line_k_bank": 5.0}, None)
        board.unplug()
        await eventually_async(lambda: set(values(station).values()) == {None}, "its values are unknown")
        assert station.parameters.own.known.table.state == "unknown"
        with pytest.raises(ConflictError) as refused:
            await station.parameters.set({"line_k_bank": 5.0}, None)
        assert refused.value.code == "own_gains_not_read"
        board.describe(own_row(0, "line_k_bank", maximum=4.0), own_row(1, "other"))
        board.plug_in()
        await is_read(station)
        assert values(station) == {"line_k_bank": 3.0, "other": 3.0}
        assert station.parameters.journal.steps.undo is None


async def test_a_write_is_confirmed_by_what_is_read_back_and_can_be_undone(tmp_path: Path, board: FakeBoard) -> None:
    async with a_station(tmp_path, board) as station:
        parameters = station.parameters
        await parameters.set({"guidance_law": 1, "line_k_bank": 3.3}, "c1")
        assert board.own_gains == {0: 1.0, 1: pytest.approx(3.3), 2: 3.0}
        assert parameters.own.known.values["line_k_bank"].state == "confirmed"
        assert values(station)["line_k_bank"] == 3.3
        entry = parameters.journal.entries[0]
        assert [(one.name, one.before, one.after, one.state) for one in entry.changes] == [
            ("guidance_law", 0.0, 1.0, "confirmed"),
            ("line_k_bank", 3.0, 3.3, "confirmed"),
        ]
        await parameters.undo("c1")
        assert values(station) == {"guidance_law": 0.0, "line_k_bank": 3.0, "line_approach": 3.0}
        await parameters.redo("c1")
        assert board.own_gains[0] == 1.0


async def test_what_was_written_and_not_stored_is_lost_by_a_restart(tmp_path: Path, board: FakeBoard) -> None:
    async with a_station(tmp_path, board) as station:
        await station.parameters.set({"k_roll": 3.0, "line_k_bank": 4.0}, None)
        await station.parameters.store(None)
        await station.parameters.set({"guidance_law": 1}, None)
        assert station.parameters.take_unstored() == ("guidance_law",)


async def test_own_and_built_in_gains_of_one_request_are_a_step_each(tmp_path: Path, board: FakeBoard) -> None:
    async with a_station(tmp_path, board) as station:
        await station.parameters.set({"line_k_bank": 4.0, "k_roll": 3.0}, None)
        assert (board.own_gains[1], board.gains["k_roll"]) == (4.0, 3.0)
        await station.parameters.undo(None)
        assert (board.own_gains[1], board.gains["k_roll"]) == (3.0, 3.0)
        await station.parameters.undo(None)
        assert board.gains["k_roll"] == 2.0


async def test_a_refused_write_shows_what_the_board_has_and_is_not_to_undo(tmp_path: Path, board: FakeBoard) -> None:
    board.refuse["own_gain_set"] = 1
    async with a_station(tmp_path, board) as station:
        await station.parameters.set({"line_k_bank": 4.0}, None)
        held = station.parameters.own.known.values["line_k_bank"]
        assert (held.value, held.state) == (3.0, "rejected")
        assert station.parameters.unconfirmed == ("line_k_bank",)
        assert station.parameters.journal.steps.undo is None


async def test_a_write_whose_read_back_is_lost_is_read_again(
    tmp_path: Path, board: FakeBoard, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(answers, "_ANSWER_S", 0.05)
    async with a_station(tmp_path, board) as station:
        board.lose_value = 1
        await station.parameters.set({"line_k_bank": 4.0}, None)
        held = station.parameters.own.known.values["line_k_bank"]
        assert (held.value, held.state) == (4.0, "confirmed")


async def test_a_write_without_any_read_back_leaves_a_value_that_nobody_knows(
    tmp_path: Path, board: FakeBoard, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(answers, "_ANSWER_S", 0.05)
    async with a_station(tmp_path, board) as station:
        board.lose_value = 99
        with pytest.raises(GatewayError) as lost:
            await station.parameters.set({"line_k_bank": 4.0}, None)
        assert lost.value.code == "parameters_not_read"
        held = station.parameters.own.known.values["line_k_bank"]
        assert (held.value, held.state) == (None, "unknown")
        assert station.parameters.unconfirmed == ("line_k_bank",)
        board.lose_value = 0
        await station.parameters.load(None)
        assert values(station)["line_k_bank"] == 4.0


async def test_a_board_that_is_lost_during_a_write_leaves_an_entry_and_an_unknown_value(
    tmp_path: Path, board: FakeBoard
) -> None:
    async with a_station(tmp_path, board) as station:
        board.ignore["own_gain_set"] = 99
        writing = asyncio.create_task(station.parameters.set({"line_k_bank": 4.0}, None))
        await eventually_async(lambda: board.count("own_gain_set") > 0, "the command is on its way")
        board.unplug()
        with pytest.raises(LinkError):
            await writing
        assert station.parameters.journal.entries[0].state == "timed_out"
        assert station.parameters.own.known.values["line_k_bank"].value is None


@pytest.mark.parametrize("value", [10.5, float("nan")])
async def test_a_value_that_the_row_does_not_allow_is_refused_before_anything_is_sent(
    tmp_path: Path, board: FakeBoard, value: float
) -> None:
    async with a_station(tmp_path, board) as station:
        with pytest.raises(InvalidInputError):
            await station.parameters.set({"k_roll": 3.0, "line_k_bank": value}, None)
        assert (board.count("own_gain_set"), board.count("set_k_roll")) == (0, 0)


async def test_a_load_sets_the_mark_from_which_changes_count(tmp_path: Path, board: FakeBoard) -> None:
    async with a_station(tmp_path, board) as station:
        await station.parameters.set({"line_k_bank": 4.0}, None)
        assert station.parameters.own.known.values["line_k_bank"].loaded == 3.0
        board.own_gains[2] = 2.0
        await station.parameters.load(None)
        assert station.parameters.own.known.values["line_k_bank"].loaded == 4.0
        assert values(station)["line_approach"] == 2.0
