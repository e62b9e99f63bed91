"""Topics that a board described itself, in its recording: columns, fields and damage as live had them."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import pyarrow.parquet as pq
import pytest

from epf_gcs.codec.encode import encode_telemetry
from epf_gcs.flights.columns import TableFolder, write_columns
from epf_gcs.flights.fields import FieldMeaning
from epf_gcs.flights.growing import GrowingFlight
from epf_gcs.flights.indexed import Columns, IndexedFlight
from epf_gcs.recordings.notes import EVENT
from epf_gcs.recordings.topics import BOARD_RECEIVED
from epf_gcs.replay.outlet import Silence
from epf_gcs.replay.playhead import Playhead
from epf_gcs.replay.timeline import Timeline
from epf_gcs.vehicle.board import Board
from epf_gcs.vehicle.own_topics import usable_topics
from tests.replay.recordings import SECOND_NS, STARTS_NS, Made, write
from tests.support.own_rows import F32, field_row, filter_rows, own_frame, table_note, topic_row

TOPICS, _ = usable_topics(filter_rows())
OTHER, _ = usable_topics([topic_row(), field_row(1, "bias_y_rad_s", F32)])


def heard(at_s: float, frame: bytes) -> tuple[int, int, bytes]:
    return STARTS_NS + round(at_s * SECOND_NS), BOARD_RECEIVED, frame


def known(at_s: float, *, is_known: bool = True, topics: tuple = TOPICS) -> tuple[int, str, object]:  # type: ignore[type-arg]
    return STARTS_NS + round(at_s * SECOND_NS), EVENT, table_note(topics, is_known=is_known)


def recorded(tmp_path: Path, *items: tuple) -> Path:  # type: ignore[type-arg]
    made: Made = list(items)
    return write(tmp_path / "20260101T000000Z.mcap", made)


def replayed(path: Path) -> Board:
    head = Playhead(Timeline(path), Silence())
    head.advance(STARTS_NS + 10 * SECOND_NS)
    return head.vehicle.board


def columns(path: Path) -> TableFolder:
    return write_columns(path, path.parent / "columns", lambda _progress, _doing: None)


def test_frames_after_the_table_are_columns_with_the_boards_units_and_those_before_it_are_damage(
    tmp_path: Path,
) -> None:
    first, second = own_frame(TOPICS, 0.25, 2150, 1, 2), own_frame(TOPICS, 2.0, -100, 0, 0)
    path = recorded(
        tmp_path,
        heard(0.0, first),
        known(1.0),
        heard(2.0, first + second),
        known(3.0, is_known=False),
        heard(4.0, first),
    )
    made = columns(path)
    (row, other) = pq.read_table(made.folder / "filter.parquet", partitioning=None).drop(["t_ns"]).to_pylist()
    assert row == {"bias_x_rad_s": 0.25, "temperature_c": 21.5, "is_settled": True, "mode": 2}
    assert other == {"bias_x_rad_s": None, "temperature_c": -1.0, "is_settled": False, "mode": 0}
    assert made.counts.implausible == {"filter.bias_x_rad_s": 1}
    assert made.counts.damaged["unknown_type"] == 2
    flight = IndexedFlight(made.folder, made.notes, STARTS_NS, STARTS_NS + 4 * SECOND_NS, columns=Columns())
    assert [(topic.name, topic.samples) for topic in flight.topics()] == [("filter", 2)]
    assert flight.fields("filter") == {
        "bias_x_rad_s": FieldMeaning("rad/s", "number"),
        "temperature_c": FieldMeaning("degC", "number"),
        "is_settled": FieldMeaning("1", "flag"),
        "mode": FieldMeaning("1", "number"),
    }
    assert flight.samples("filter", "temperature_c").values.tolist() == [21.5, -1.0]


def test_the_flight_in_the_air_has_them_as_the_finished_one(tmp_path: Path) -> None:
    path = recorded(tmp_path, known(1.0), heard(2.0, own_frame(TOPICS, 0.25, 2150, 1, 2)), heard(3.0, b"\r\n"))
    growing = GrowingFlight(path)
    growing.advance()
    made = columns(path)
    finished = IndexedFlight(made.folder, made.notes, growing.start_ns, growing.end_ns, columns=Columns())
    assert growing.topics() == finished.topics()
    assert growing.fields("filter") == finished.fields("filter")
    for name in growing.fields("filter"):
        assert growing.samples("filter", name).values.tolist() == finished.samples("filter", name).values.tolist()


def test_a_board_that_comes_back_with_another_topic_of_the_same_name_leaves_both_as_they_were(tmp_path: Path) -> None:
    renamed = replace(TOPICS[0], name="filter_2", type_word=0x1001)
    path = recorded(
        tmp_path,
        known(0.0),
        heard(1.0, own_frame(TOPICS, 0.25, 0, 0, 0)),
        known(2.0, is_known=False),
        known(3.0, topics=(*OTHER, renamed)),
        heard(4.0, own_frame((*OTHER, renamed), 0.75)),
        known(5.0),
        heard(6.0, own_frame(TOPICS, 0.5, 0, 0, 0)),
    )
    folder = columns(path).folder
    tables = {file.stem: pq.read_table(file, partitioning=None) for file in folder.glob("filter*.parquet")}
    assert tables["filter"].column("bias_x_rad_s").to_pylist() == [0.25, 0.5]
    assert tables["filter_2"].column("bias_y_rad_s").to_pylist() == [0.75]
    assert sorted(tables) == ["filter", "filter_2"]


@pytest.mark.parametrize(
    "change",
    [
        {"name": "../../../outside"},
        {"name": "keyframes"},
        {"name": "heartbeat"},
        {"type_word": 1},
        {"type_word": 2**40},
        {"type_word": -1},
        {"fields": ()},
        {"fields": TOPICS[0].fields * 40},
        {"fields": (replace(TOPICS[0].fields[0], name="t_ns"),)},
        {"fields": (TOPICS[0].fields[0], TOPICS[0].fields[0])},
        {"fields": (replace(TOPICS[0].fields[1], scale=0.0),)},
        {"fields": (replace(TOPICS[0].fields[3], choices=("",) * 300),)},
    ],
)
def test_a_strangers_table_that_no_board_could_have_gives_no_topics_and_no_file_elsewhere(
    tmp_path: Path, change: dict[str, Any]
) -> None:
    """The board's frames are read as if nothing were known of its table, in the columns and in a replay."""
    folder = tmp_path / "in" / "here"
    folder.mkdir(parents=True)
    stranger = (replace(TOPICS[0], **change),)
    line = encode_telemetry("ahrs", 1.0, 2.0, 3.0) + own_frame(TOPICS, 0.25, 0, 1, 2)
    path = recorded(
        folder, known(0.0, topics=stranger), heard(1.0, line), heard(2.0, encode_telemetry("ahrs", 0, 0, 0))
    )
    made = columns(path)
    assert made.counts.frames == {"ahrs": 2}
    assert made.counts.damaged == {"unknown_type": 1, "remains": 1}
    assert replayed(path).damage == made.counts.damaged
    assert all(file.is_relative_to(folder) for file in tmp_path.rglob("*.parquet"))
