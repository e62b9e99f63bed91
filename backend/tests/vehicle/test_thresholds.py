"""The limits of the alarms."""

from __future__ import annotations

from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from epf_gcs.vehicle.thresholds import BY_NAME, THRESHOLDS, chosen, threshold_fault

DEFAULTS = {threshold.name: threshold.default for threshold in THRESHOLDS}


def test_every_default_is_allowed_and_every_name_ends_in_its_unit() -> None:
    for threshold in THRESHOLDS:
        assert threshold_fault(threshold, threshold.default) is None
        ending = {"V": "_v", "%": "_percent", "s": "_s", "ft": "_ft", "kt": "_kt", "m": "_m", "": ""}[threshold.unit]
        assert threshold.name.endswith(ending)


@pytest.mark.parametrize(
    ("name", "value", "fault"),
    [
        ("battery_low_v", 60.0, None),
        ("battery_low_v", 0.0, None),
        ("heartbeat_lost_s", 0.5, None),
        ("heartbeat_lost_s", 30.0, None),
        ("battery_low_v", 60.1, "battery_low_v must be in 0..60, not 60.1."),
        ("heartbeat_lost_s", 0.4, "heartbeat_lost_s must be in 0.5..30, not 0.4."),
        ("hil_lost_s", float("nan"), "hil_lost_s must be a number."),
        ("hil_lost_s", float("inf"), "hil_lost_s must be a number."),
        ("hil_lost_s", float("-inf"), "hil_lost_s must be a number."),
    ],
)
def test_a_value_beyond_its_range_is_refused_in_a_sentence(name: str, value: float, fault: str | None) -> None:
    assert threshold_fault(BY_NAME[name], value) == fault


@given(
    st.dictionaries(
        st.sampled_from([*BY_NAME, "other"]),
        st.none() | st.booleans() | st.text() | st.floats() | st.integers() | st.lists(st.integers()),
    )
)
def test_whatever_was_kept_every_limit_is_allowed(kept: dict[str, Any]) -> None:
    limits = chosen(kept)
    assert limits.keys() == BY_NAME.keys()
    for name, value in limits.items():
        assert threshold_fault(BY_NAME[name], value) is None


def test_what_was_chosen_counts() -> None:
    assert chosen({"battery_low_v": 11.1}) == {**DEFAULTS, "battery_low_v": 11.1}
    assert chosen({"battery_low_v": True, "hil_lost_s": 99}) == DEFAULTS


def test_the_earlier_default_of_three_cells_is_no_choice_and_a_pack_is_judged_by_its_own_cells() -> None:
    assert chosen({"battery_low_v": 10.5, "hil_lost_s": 0.7})["battery_low_v"] == 0.0
    assert chosen({"battery_low_v": 10.5, "battery_cells": 0})["battery_low_v"] == 10.5
