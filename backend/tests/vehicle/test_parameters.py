"""The 17 gains as values."""

from __future__ import annotations

import math

import pytest

from epf_gcs.codec.messages_gen import PARAMETERS
from epf_gcs.codec.values import single
from epf_gcs.contract.answers import GainState
from epf_gcs.vehicle.parameters import (
    BY_NAME,
    UNKNOWN,
    GainRecord,
    after_read,
    as_held,
    differing,
    fault,
    forgotten,
    gain_state,
    loaded_now,
    shown,
    with_state,
)

VALUES = {parameter.name: parameter.default for parameter in PARAMETERS}
READ = {name: single(value) for name, value in VALUES.items()}


def test_a_read_fills_all() -> None:
    held = after_read(UNKNOWN, READ)
    assert {one.state for one in held.values()} == {"loaded"}
    assert held["k_div_velocidad"].value == 700


def test_a_value_that_is_no_data_is_unknown() -> None:
    held = after_read(UNKNOWN, {**READ, "k_pitch": None})
    assert (held["k_pitch"].value, held["k_pitch"].state) == (None, "unknown")


def test_what_waits_for_its_proof_keeps_waiting() -> None:
    held = after_read(with_state(after_read(UNKNOWN, READ), {"k_pitch": 2.5}, "pending"), READ)
    assert held["k_pitch"].state == "pending"
    assert held["k_roll"].state == "loaded"


def test_a_confirmed_gain_that_the_board_changed_is_only_loaded() -> None:
    held = with_state(after_read(UNKNOWN, READ), {"k_pitch": 2.0}, "confirmed")
    assert after_read(held, READ)["k_pitch"].state == "confirmed"
    assert after_read(held, {**READ, "k_pitch": 3.0})["k_pitch"].state == "loaded"


def test_single_precision_is_no_difference() -> None:
    assert differing({"k_int_pitch": 0.6}, {"k_int_pitch": single(0.6)}) == []
    assert differing({"k_int_pitch": 0.6}, {"k_int_pitch": 0.61}) == ["k_int_pitch"]
    assert differing({"k_int_pitch": 0.6}, {"k_int_pitch": None}) == ["k_int_pitch"]
    assert differing({"k_div_velocidad": 710}, {"k_div_velocidad": 710}) == []
    assert differing({"k_div_velocidad": 710, "k_pitch": 2.0}, {"k_pitch": 2.0, "k_div_velocidad": 700}) == [
        "k_div_velocidad"
    ]


def test_a_value_is_shown_as_it_was_written() -> None:
    assert shown("k_int_pitch", single(0.6)) == 0.6
    assert shown("k_div_velocidad", 700) == 700


@pytest.mark.parametrize("name", sorted(BY_NAME))
def test_the_limits_are_allowed_and_nothing_beyond(name: str) -> None:
    parameter = BY_NAME[name]
    assert fault(name, parameter.minimum) is None
    assert fault(name, parameter.maximum) is None
    assert fault(name, parameter.minimum - 1) is not None
    assert fault(name, parameter.maximum + 1) is not None
    assert fault(name, math.nan) is not None
    assert fault(name, math.inf) is not None


def test_the_integer_must_be_whole() -> None:
    assert fault("k_div_velocidad", 700.5) == "k_div_velocidad must be a whole number, not 700.5."


def test_the_first_read_and_a_load_set_the_mark_and_no_other_read_does() -> None:
    held = after_read(UNKNOWN, READ)
    assert held["k_pitch"].loaded == 2.0
    held = after_read(held, {**READ, "k_pitch": 3.0})
    assert (held["k_pitch"].value, held["k_pitch"].loaded) == (3.0, 2.0)
    assert loaded_now(held)["k_pitch"].loaded == 3.0
    pending = with_state(after_read(UNKNOWN, READ), {"k_pitch": None}, "pending")
    assert after_read(pending, {**READ, "k_pitch": 3.0})["k_pitch"].loaded == 2.0


def test_what_is_forgotten_keeps_its_mark() -> None:
    held = forgotten(after_read(UNKNOWN, READ), ["k_pitch"])
    assert (held["k_pitch"].value, held["k_pitch"].state, held["k_pitch"].loaded) == (None, "unknown", 2.0)
    assert held["k_roll"] == after_read(UNKNOWN, READ)["k_roll"]
    assert after_read(held, {**READ, "k_pitch": None})["k_pitch"].loaded == 2.0


def test_a_value_is_written_down_as_the_board_holds_it() -> None:
    assert as_held("k_int_pitch", 0.6) == 0.6
    assert as_held("k_int_pitch", 0.60000000001) == 0.6
    assert as_held("k_div_velocidad", 700) == 700


def test_a_gain_is_given_with_what_it_is_and_what_it_was_as_they_were_written() -> None:
    assert gain_state("k_int_pitch", GainRecord()) == GainState()
    held = GainRecord(single(0.6), "confirmed", single(0.1))
    assert gain_state("k_int_pitch", held) == GainState(0.6, "confirmed", 0.1)
