"""The topics that a board describes itself: switched on with the table, heard like the built-in ones, and recorded."""

from __future__ import annotations

from pathlib import Path

import pytest

from epf_gcs.flight.flight import Flight
from epf_gcs.link.address import parse_address
from epf_gcs.recordings.notes import EVENT
from epf_gcs.recordings.reading import notes_of
from epf_gcs.vehicle.own_topics import usable_topics
from tests.support.fake_board import FakeBoard, own_row
from tests.support.own_rows import field_row, filter_rows, own_frame, topic_row
from tests.support.waiting import eventually_async

pytestmark = pytest.mark.anyio

TOPICS, _ = usable_topics(filter_rows())


@pytest.fixture(autouse=True)
def describing(board: FakeBoard) -> None:
    board.describe(own_row(0), *filter_rows())


async def opened(station: Flight, board: FakeBoard) -> None:
    await station.lines.open_board(parse_address(board.url))
    await eventually_async(lambda: board.count("own_topics") > 0, "the topics are switched on")


async def test_they_are_switched_on_once_the_table_is_known_and_their_samples_are_telemetry(
    tmp_path: Path, board: FakeBoard
) -> None:
    station = Flight(tmp_path / "data", record=False)
    async with station.running():
        await opened(station, board)
        told = dict(zip(board.received, board.arguments, strict=True))
        assert list(told["own_topics"]) == [1]
        board.send(own_frame(TOPICS, 0.5, 2150, 1, 2))
        await eventually_async(lambda: station.telemetry.is_live("filter"), "its sample comes")
        values = station.telemetry.samples()["filter"].values
        assert values == {"bias_x_rad_s": 0.5, "temperature_c": 21.5, "is_settled": True, "mode": 2}
        assert station.board.frames_damaged == 0
        assert station.parameters.own.known.table.topics[0].name == "filter"


async def test_a_lost_switch_is_sent_again(tmp_path: Path, board: FakeBoard) -> None:
    board.ignore["own_topics"] = 1
    station = Flight(tmp_path / "data", record=False)
    async with station.running():
        await opened(station, board)
        await eventually_async(lambda: board.count("own_topics") == 2, "it is sent again")


async def test_a_board_without_own_topics_is_told_nothing_of_them(tmp_path: Path, board: FakeBoard) -> None:
    board.describe(own_row(0))
    station = Flight(tmp_path / "data", record=False)
    async with station.running():
        await station.lines.open_board(parse_address(board.url))
        own = station.parameters.own
        await eventually_async(lambda: own.known.table.state == "known" and not own._reading.locked(), "it is read")
        assert board.count("own_topics") == 0


async def test_a_topic_that_breaks_a_rule_is_said_and_the_others_work(tmp_path: Path, board: FakeBoard) -> None:
    board.describe(topic_row(name="Broken", type_word=0x1001), field_row(1, "x"), own_row(2), *filter_rows())
    station = Flight(tmp_path / "data", record=False)
    async with station.running():
        await opened(station, board)
        table = station.parameters.own.known.table
        assert [(one.row, one.name, one.reason) for one in table.left_out] == [(0, "Broken", "name")]
        assert [gain.name for gain in table.gains] == ["line_k_bank"]
        board.send(own_frame(table.topics, 0.25, 0, 0, 0))
        await eventually_async(lambda: station.telemetry.newest("filter") is not None, "its sample comes")


async def test_their_table_is_in_the_recording_before_their_first_frame(tmp_path: Path, board: FakeBoard) -> None:
    station = Flight(tmp_path / "data")
    async with station.running():
        await opened(station, board)
        board.send(own_frame(TOPICS, 0.5, 0, 1, 2))
        await eventually_async(lambda: station.telemetry.newest("filter") is not None, "its sample comes")
    (file,) = (tmp_path / "data" / "recordings").glob("*.mcap")
    tables = [
        note.content["data"]["table"]
        for note in notes_of(file)
        if note.name == EVENT and note.content["event"] == "own_gains" and note.content["data"]["table"]
    ]
    assert [topic["name"] for topic in tables[-1]["topics"]] == ["filter"]


async def test_a_table_whose_checksum_does_not_hold_gives_no_topics_for_their_values_might_be_false(
    tmp_path: Path, board: FakeBoard
) -> None:
    board.own_checksum = 7
    station = Flight(tmp_path / "data", record=False)
    async with station.running():
        await station.lines.open_board(parse_address(board.url))
        own = station.parameters.own
        await eventually_async(lambda: own.known.table.state == "known" and not own._reading.locked(), "it is read")
        assert own.known.table.topics == ()
        assert [(one.name, one.reason) for one in own.known.table.left_out] == [("filter", "checksum")]
        assert [gain.name for gain in own.known.table.gains] == ["line_k_bank"]
        assert board.count("own_topics") == 0
