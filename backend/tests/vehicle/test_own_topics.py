"""Topics that a board describes: what can be used of its table, and what their frames say."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from math import inf, nan

import pytest

from epf_gcs.codec.description import FieldRow, Row, TopicRow, UnreadableRow
from epf_gcs.codec.frame import Damage, Frame, FrameDecoder
from epf_gcs.codec.values import meaning
from epf_gcs.contract.own_gains import LeftOutRow
from epf_gcs.vehicle.own_topics import own_messages, usable_topics
from tests.support.own_rows import ENUM, FLAG, I16, field_row, filter_rows, own_frame, topic_row


def told(rows: Sequence[Row]) -> tuple[list[str], list[tuple[int, str | None, str]]]:
    """Names of the usable topics, and what was left out."""
    topics, left_out = usable_topics(rows)
    return [topic.name for topic in topics], [(one.row, one.name, one.reason) for one in left_out]


def test_a_frame_of_an_own_topic_has_the_values_that_the_board_meant() -> None:
    topics, left_out = usable_topics(filter_rows())
    assert left_out == ()
    decoder = FrameDecoder()
    decoder.learn(own_messages(topics))
    (frame,) = decoder.feed(own_frame(topics, 0.5, 2150, 1, 2))
    assert isinstance(frame, Frame)
    assert frame.message.name == "filter"
    assert frame.message.size == 8
    assert meaning(frame).values == {"bias_x_rad_s": 0.5, "temperature_c": 21.5, "is_settled": True, "mode": 2}


def test_a_value_outside_its_range_is_no_data_and_counted_and_nan_is_no_data_alone() -> None:
    topics, _ = usable_topics(filter_rows())
    decoder = FrameDecoder()
    decoder.learn(own_messages(topics))
    wrong, none = (
        frame
        for frame in decoder.feed(own_frame(topics, 1.5, 9000, 2, 3) + own_frame(topics, nan, 0, 0, 0))
        if isinstance(frame, Frame)
    )
    assert meaning(wrong).values == dict.fromkeys(("bias_x_rad_s", "temperature_c", "is_settled", "mode"))
    assert set(meaning(wrong).implausible) == {"bias_x_rad_s", "temperature_c", "is_settled", "mode"}
    assert meaning(none).values["bias_x_rad_s"] is None
    assert meaning(none).implausible == ()


def test_before_the_table_is_known_such_a_frame_is_of_an_unknown_type_and_again_after_it_is_forgotten() -> None:
    topics, _ = usable_topics(filter_rows())
    frame = own_frame(topics, 0.5, 0, 0, 0)
    decoder = FrameDecoder()
    damage = [one for one in decoder.feed(frame) if isinstance(one, Damage)]
    decoder.learn(own_messages(topics))
    assert [one.kind for one in damage if one.is_failed_frame] == ["unknown_type"]
    assert any(isinstance(one, Frame) for one in decoder.feed(frame))
    decoder.learn(())
    assert not any(isinstance(one, Frame) for one in decoder.feed(frame))


HEAD, FIELD = topic_row(), field_row(1, "bias_x_rad_s")


@pytest.mark.parametrize(
    ("head", "reason"),
    [
        (replace(HEAD, name="Filter"), "name"),
        (replace(HEAD, name="f" * 33), "name"),
        (replace(HEAD, name="ahrs"), "name_taken"),
        (replace(HEAD, name="keyframes"), "name_taken"),
        (replace(HEAD, name="sent_reset"), "name_taken"),
        (replace(HEAD, type_word=0xFFF), "type_word"),
        (replace(HEAD, period_ms=0), "period"),
    ],
)
def test_a_topic_that_breaks_a_rule_is_left_out_with_the_reason_and_the_next_works(head: TopicRow, reason: str) -> None:
    rows: list[Row] = [head, FIELD, topic_row(2, name="other", type_word=0x1001), replace(FIELD, row=3)]
    assert told(rows) == (["other"], [(0, head.name, reason)])


@pytest.mark.parametrize(
    ("field", "reason"),
    [
        (replace(FIELD, name="bias X"), "name"),
        (replace(FIELD, name="t_ns"), "name_taken"),
        (replace(FIELD, type=0), "type"),
        (replace(FIELD, type=11), "type"),
        (replace(FIELD, minimum=2.0), "range"),
        (replace(FIELD, maximum=inf), "range"),
        (replace(FIELD, minimum=nan), "range"),
        (replace(FIELD, scale=0.0), "scale"),
        (replace(FIELD, scale=nan), "scale"),
        (replace(FIELD, scale=0.5), "scale"),
        (replace(FIELD, type=FLAG, scale=2.0), "scale"),
        (replace(FIELD, choices="a|b"), "choices"),
        (replace(FIELD, type=ENUM), "choices"),
        (replace(FIELD, type=ENUM, choices="a|a"), "choices"),
        (replace(FIELD, type=ENUM, choices="a||b"), "choices"),
    ],
)
def test_a_field_that_breaks_a_rule_takes_its_topic_with_it_and_the_next_works(field: FieldRow, reason: str) -> None:
    rows: list[Row] = [HEAD, field, topic_row(2, name="other", type_word=0x1001), replace(FIELD, row=3)]
    assert told(rows) == (["other"], [(0, "filter", "fields"), (1, field.name, reason)])


def test_two_topics_of_one_name_or_type_two_fields_of_one_name_and_rows_that_belong_nowhere_are_said() -> None:
    again = replace(HEAD, row=2)
    alike = topic_row(4, name="alike")
    twin = topic_row(6, name="twin", type_word=0x1001)
    rows: list[Row] = [
        *(HEAD, FIELD),
        *(replace(again, type_word=0x1002), replace(FIELD, row=3)),
        *(alike, replace(FIELD, row=5)),
        *(twin, replace(FIELD, row=7), replace(FIELD, row=8)),
        topic_row(9, name="empty", type_word=0x1003),
    ]
    assert told(rows) == (
        ["filter"],
        [
            (2, "filter", "name_taken"),
            (4, "alike", "type_word"),
            (6, "twin", "fields"),
            (8, "bias_x_rad_s", "name_taken"),
            (9, "empty", "fields"),
        ],
    )
    assert usable_topics([FIELD])[1] == (LeftOutRow(1, "bias_x_rad_s", "topic"),)


def test_a_topic_that_fills_a_frame_is_used_and_a_longer_one_is_left_out() -> None:
    whole: list[Row] = [HEAD, *(field_row(1 + n, f"f{n}") for n in range(32))]
    assert told(whole) == (["filter"], [])
    assert told([*whole, field_row(33, "more", FLAG, minimum=0.0)]) == ([], [(0, "filter", "size")])


def test_a_row_that_cannot_be_read_among_the_fields_takes_the_topic_with_it() -> None:
    assert told([HEAD, FIELD, UnreadableRow(2, None, "text")]) == ([], [(0, "filter", "fields")])
    assert told([HEAD, FIELD, UnreadableRow(2, None, "kind")]) == (["filter"], [])


def test_the_last_topic_of_a_table_that_was_cut_short_is_left_out_for_it_may_have_more_fields() -> None:
    rows: list[Row] = [HEAD, FIELD, topic_row(2, name="other", type_word=0x1001), replace(FIELD, row=3)]
    topics, left_out = usable_topics(rows, is_whole=False)
    assert [topic.name for topic in topics] == ["filter"]
    assert left_out == (LeftOutRow(2, "other", "fields"),)


def test_a_scaled_integer_is_a_number_whose_limits_are_in_its_unit() -> None:
    topics, _ = usable_topics([HEAD, field_row(1, "force", I16, scale=0.1, minimum=-1.0, maximum=0.3, unit="N")])
    decoder = FrameDecoder()
    decoder.learn(own_messages(topics))
    for raw, value in ((3, 0.3), (4, None), (-10, -1.0), (-11, None)):
        (frame,) = decoder.feed(own_frame(topics, raw))
        assert isinstance(frame, Frame)
        assert meaning(frame).values == {"force": value}


def test_the_same_table_gives_the_same_messages_so_that_what_was_made_for_one_serves() -> None:
    one, other = usable_topics(filter_rows())[0], usable_topics(filter_rows())[0]
    assert own_messages(one) is own_messages(other)
