"""Which rows of a board's table can be used, and what its gains may be."""

from __future__ import annotations

from typing import Any

import pytest

from epf_gcs.codec.description import FieldRow, TopicRow, UnreadableRow, packed_rows, rows_of
from epf_gcs.contract.own_gains import MOST_ROWS, LeftOutRow, OwnGainState
from epf_gcs.vehicle.own_gains import after_read, usable_rows, value_fault
from tests.support.fake_board import law_row, own_row


def test_a_row_is_read_with_its_numbers_in_their_shortest_form() -> None:
    (gain,), left_out = usable_rows([own_row(0, minimum=0.1, step=0.05)])
    assert (gain.name, gain.group, gain.type, gain.unit) == ("line_k_bank", "line", "f32", "1/rad")
    assert (gain.minimum, gain.maximum, gain.step, gain.default) == (0.1, 10.0, 0.05, 3.0)
    assert (gain.doc, gain.choices, gain.needs_restart, left_out) == (
        "Aileron for each radian of bank error.",
        (),
        False,
        (),
    )


def test_an_enum_has_the_texts_of_its_values() -> None:
    (law,), _ = usable_rows([law_row(0)])
    assert (law.type, law.choices, law.default) == ("enum", ("deployed", "line"), 0.0)
    assert value_fault(law, 1.0) is None
    assert value_fault(law, 0.5) == "guidance_law must be a whole number, not 0.5."
    assert value_fault(law, 2.0) == "guidance_law must be in 0..1, not 2."


@pytest.mark.parametrize(
    ("changed", "reason"),
    [
        ({"type": 6}, "type"),
        ({"name": ""}, "name"),
        ({"name": "Line-K"}, "name"),
        ({"name": "a" * 33}, "name"),
        ({"name": "k_pitch"}, "name_taken"),
        ({"name": "first"}, "name_taken"),
        ({"group": "Of the line"}, "group"),
        ({"minimum": 11.0}, "range"),
        ({"maximum": float("nan")}, "range"),
        ({"minimum": float("-inf")}, "range"),
        ({"step": 0.0}, "step"),
        ({"default": 10.5}, "default"),
        ({"type": 5, "choices": "deployed|line"}, "choices"),
        ({"type": 5, "minimum": 0, "maximum": 1, "default": 0, "choices": "one|one"}, "choices"),
        ({"type": 5, "minimum": 0, "maximum": 1, "default": 0, "choices": "one|"}, "choices"),
    ],
)
def test_a_row_that_breaks_a_rule_is_left_out_with_the_reason_and_the_rest_works(
    changed: dict[str, Any], reason: str
) -> None:
    gains, left_out = usable_rows([own_row(0, "first"), own_row(1, **changed), own_row(2, "third")])
    assert [(gain.name, gain.row) for gain in gains] == [("first", 0), ("third", 2)]
    assert [(one.row, one.reason) for one in left_out] == [(1, reason)]


def test_a_row_that_cannot_be_read_is_left_out_and_a_topic_is_no_gain_and_nothing_to_complain_of() -> None:
    topic = TopicRow(1, 0x1000, 500, "wind", "")
    field = FieldRow(2, 1, 1.0, 0.0, 360.0, "wind_from", "deg", "", "")
    gains, left_out = usable_rows([own_row(0), topic, field, UnreadableRow(3, None, "kind"), own_row(4, "other")])
    assert [(gain.name, gain.row) for gain in gains] == [("line_k_bank", 0), ("other", 4)]
    assert left_out == (LeftOutRow(3, None, "kind"),)


@pytest.mark.parametrize("cut", [0, 1, 40])
def test_of_a_table_that_ends_early_the_row_that_is_cut_and_all_after_it_are_lost(cut: int) -> None:
    first = packed_rows([own_row(0)])
    rows = rows_of(first + packed_rows([own_row(1, "other")])[:cut])
    gains, left_out = usable_rows(rows, is_whole=False)
    assert [gain.name for gain in gains] == ["line_k_bank"]
    assert left_out == (LeftOutRow(1, None, "lost"),)


def test_nothing_of_a_table_is_there_where_its_first_block_is_lost() -> None:
    assert usable_rows([], is_whole=False) == ((), (LeftOutRow(0, None, "lost"),))


def test_there_is_a_bound_to_how_many_rows_are_taken() -> None:
    gains, left_out = usable_rows([own_row(row, f"gain_{row}") for row in range(MOST_ROWS + 2)])
    assert len(gains) == MOST_ROWS
    assert left_out == (LeftOutRow(MOST_ROWS, None, "too_many"),)


def test_a_value_has_the_time_at_which_it_was_heard_and_no_number_is_no_value() -> None:
    heard = after_read(OwnGainState(), 0.10000000149011612, 5.0)
    assert heard == OwnGainState(0.1, "loaded", 0.1, 5.0)
    assert after_read(heard, 0.5, 6.0) == OwnGainState(0.5, "loaded", 0.1, 6.0)
    assert after_read(heard, None, 7.0) == OwnGainState(loaded=0.1)


def test_a_pending_gain_waits_for_its_own_end_and_a_confirmed_one_stays_so_while_the_value_stays() -> None:
    pending = OwnGainState(1.0, "pending", 1.0, 1.0)
    assert after_read(pending, 2.0, 2.0).state == "pending"
    confirmed = OwnGainState(2.0, "confirmed", 1.0, 2.0)
    assert after_read(confirmed, 2.0, 3.0).state == "confirmed"
    assert after_read(confirmed, 3.0, 3.0).state == "loaded"
