"""The board's own gains over its line: told with a checksum, set, read back, refused."""

from __future__ import annotations

import math
import zlib

from board_tests.line.station import Station
from epf_gcs.codec.frame import Frame
from epf_gcs.codec.messages_gen import COMMANDS, TELEMETRY_BY_NAME
from epf_gcs.codec.values import meaning

DONE, BAD_VALUE = 0, 1
LAW, BANK_LIMIT = 0, 1
DEPLOYED, LINE = 0.0, 1.0


def answer(station: Station, name: str) -> Frame:
    frame = station.newest(name)
    assert frame is not None
    return frame


def row_of(station: Station, row: int) -> Frame:
    assert station.ask("describe_item", row) == DONE
    return answer(station, "description_row")


def value_of(station: Station, row: int) -> float:
    assert station.ask("own_gain_get", row) == DONE
    told, value = answer(station, "own_gain").values
    assert told == row
    return float(value)


def set_value(station: Station, row: int, value: float) -> int:
    """Any value, also one that the encoder would refuse."""
    payload = station.command_struct("own_gain_set").pack(row, value)
    return station.ask_bytes(COMMANDS["own_gain_set"].id, station.raw_command("own_gain_set", payload))


def test_the_board_tells_its_rows_and_their_checksum(extended: Station) -> None:
    assert extended.ask("describe") == DONE
    count, crc32 = answer(extended, "description").values
    rows = [row_of(extended, row) for row in range(count)]
    layout = TELEMETRY_BY_NAME["description_row"].struct
    assert zlib.crc32(b"".join(layout.pack(*row.values) for row in rows)) == crc32
    law, bank_limit, *others = [meaning(row).values for row in rows]
    assert (law["name"], law["choices"], law["default_value"]) == ("guidance_law", "deployed|line", DEPLOYED)
    assert (bank_limit["name"], bank_limit["unit"], bank_limit["maximum"]) == ("line_bank_limit", "deg", 60.0)
    assert len(others) == 17
    assert not any(meaning(row).implausible for row in rows)


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
        for name in ("describe_item", "own_gain_get"):
            frame = extended.raw_command(name, extended.command_struct(name).pack(row))
            assert extended.ask_bytes(COMMANDS[name].id, frame) == BAD_VALUE
        assert set_value(extended, row, 1.0) == BAD_VALUE
        assert extended.newest("own_gain") is None
