"""The board's own gains over its line: told with a checksum, set, read back, refused."""

from __future__ import annotations

import math
import zlib

from board_tests.line.station import Station
from epf_gcs.codec.description import BLOCK_SIZE, GainRow, Row, TopicRow, UnreadableRow, rows_of
from epf_gcs.codec.frame import Frame
from epf_gcs.codec.messages_gen import COMMANDS

DONE, BAD_VALUE = 0, 1
LAW, BANK_LIMIT = 0, 1
DEPLOYED, LINE = 0.0, 1.0


def answer(station: Station, name: str) -> Frame:
    frame = station.newest(name)
    assert frame is not None
    return frame


def table_of(station: Station) -> tuple[bytes, int]:
    """The table in which the board describes itself, and its checksum as the board tells it."""
    assert station.ask("describe") == DONE
    size, crc32 = answer(station, "description").values
    count = -(-size // BLOCK_SIZE)
    table = b""
    for first in range(0, count, 8):
        number = min(8, count - first)
        assert station.ask("describe_blocks", first, number) == DONE
        station.wait(lambda number=number: station.count("description_block") == number)  # type: ignore[misc]
        blocks = [frame for frame in station.frames if frame.message.name == "description_block"]
        assert [frame.values[0] for frame in blocks] == list(range(first, first + number))
        table += b"".join(frame.payload[-BLOCK_SIZE:] for frame in blocks)
    return table[:size], crc32


def rows_of_board(station: Station) -> list[Row]:
    return rows_of(table_of(station)[0])


def value_of(station: Station, row: int) -> float:
    assert station.ask("own_gain_get", row) == DONE
    told, value = answer(station, "own_gain").values
    assert told == row
    return float(value)


def set_value(station: Station, row: int, value: float) -> int:
    """Any value, also one that the encoder would refuse."""
    payload = station.command_struct("own_gain_set").pack(row, value)
    return station.ask_bytes(COMMANDS["own_gain_set"].id, station.raw_command("own_gain_set", payload))


def test_the_board_tells_its_table_and_the_checksum_of_it(extended: Station) -> None:
    table, crc32 = table_of(extended)
    assert zlib.crc32(table) == crc32
    rows = rows_of(table)
    law, bank_limit, *others = [row for row in rows if isinstance(row, GainRow)]
    assert (law.row, law.name, law.choices, law.default) == (LAW, "guidance_law", "deployed|line", DEPLOYED)
    assert (bank_limit.row, bank_limit.name, bank_limit.unit) == (BANK_LIMIT, "line_bank_limit", "deg")
    assert bank_limit.maximum == 60.0
    assert len(others) == 17
    assert not any(isinstance(row, UnreadableRow) for row in rows)
    topics = [(row.name, row.type_word, row.period_ms) for row in rows if isinstance(row, TopicRow)]
    assert topics == [("wind", 0x1000, 500), ("line_law", 0x1001, 200)]


def test_the_law_is_chosen_over_the_line_and_read_back(extended: Station) -> None:
    assert value_of(extended, LAW) == DEPLOYED
    assert set_value(extended, LAW, LINE) == DONE
    assert value_of(extended, LAW) == LINE


def test_what_a_gain_cannot_be_is_refused_and_the_value_that_stands_is_told(extended: Station) -> None:
    assert set_value(extended, BANK_LIMIT, 40.0) == DONE
    for value in (61.0, 9.0, math.nan, math.inf):
        assert set_value(extended, BANK_LIMIT, value) == BAD_VALUE
        assert answer(extended, "own_gain").values == (BANK_LIMIT, 40.0)
    assert set_value(extended, LAW, 0.5) == BAD_VALUE
    assert answer(extended, "own_gain").values == (LAW, DEPLOYED)


def test_a_row_that_is_not_there_is_refused(extended: Station) -> None:
    for row in (19, -1):
        frame = extended.raw_command("own_gain_get", extended.command_struct("own_gain_get").pack(row))
        assert extended.ask_bytes(COMMANDS["own_gain_get"].id, frame) == BAD_VALUE
        assert set_value(extended, row, 1.0) == BAD_VALUE
        assert extended.newest("own_gain") is None


def test_a_block_behind_the_end_is_refused(extended: Station) -> None:
    end = -(-len(table_of(extended)[0]) // BLOCK_SIZE)
    for first, count in ((end, 1), (end - 1, 2), (-1, 1), (0, 0), (0, 9)):
        frame = extended.raw_command("describe_blocks", extended.command_struct("describe_blocks").pack(first, count))
        assert extended.ask_bytes(COMMANDS["describe_blocks"].id, frame) == BAD_VALUE


def test_own_topics_come_while_they_are_on_and_end_when_the_line_is_opened_again(extended: Station) -> None:
    wind = b"\rQT,\x00\x10\x00\x80"
    extended.received.clear()
    assert extended.ask("own_topics", 1) == DONE
    extended.wait(lambda: extended.received.count(wind) >= 2)
    extended.open_binary()
    extended.heartbeats(2)
    extended.received.clear()
    extended.heartbeats(12)
    assert extended.received.count(wind) == 0
