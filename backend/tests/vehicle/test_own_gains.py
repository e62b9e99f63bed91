"""Which rows of a board's table can be used, and what its gains may be."""

from __future__ import annotations

from typing import Any

import pytest

from epf_gcs.contract.own_gains import LeftOutRow, OwnGainState
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
        ({"kind": 2}, "kind"),
        ({"kind": 9}, "kind"),
        ({"type": 6}, "type"),
        ({"name": ""}, "name"),
        ({"name": "Line-K"}, "name"),
        ({"name": "bad\x07"}, "name"),
        ({"name": "k_pitch"}, "name_taken"),
        ({"name": "first"}, "name_taken"),
        ({"group": "Of the line"}, "group"),
        ({"help": "caf\xe9"}, "text"),
        ({"minimum": 11.0}, "range"),
        ({"maximum": float("nan")}, "range"),
        ({"step": 0.0}, "step"),
        ({"default_value": 10.5}, "default"),
        ({"type": 5, "choices": "deployed|line"}, "choices"),
        ({"type": 5, "minimum": 0, "maximum": 1, "default_value": 0, "choices": "one|one"}, "choices"),
        ({"type": 5, "minimum": 0, "maximum": 1, "default_value": 0, "choices": "one|"}, "choices"),
    ],
)
def test_a_row_that_breaks_a_rule_is_left_out_with_the_reason_and_the_rest_works(
    changed: dict[str, Any], reason: str
) -> None:
    gains, left_out = usable_rows([own_row(0, "first"), own_row(1, **changed), own_row(2, "third")])
    assert [(gain.name, gain.row) for gain in gains] == [("first", 0), ("third", 2)]
    assert [(one.row, one.reason) for one in left_out] == [(1, reason)]


def test_a_lost_row_has_no_name() -> None:
    gains, left_out = usable_rows([None, own_row(1)])
    assert [gain.row for gain in gains] == [1]
    assert left_out == (LeftOutRow(0, None, "lost"),)


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
