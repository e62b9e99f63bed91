"""Values of a command, as people and programs send them."""

from __future__ import annotations

import math
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from epf_gcs.codec.messages_gen import COMMANDS
from epf_gcs.web.interface.commands.arguments import ArgumentFault, read_arguments


@pytest.mark.parametrize(
    ("name", "given_value", "arguments"),
    [
        ("start", None, ()),
        ("control_source", 1, (1,)),
        ("control_source", "joystick", (1,)),
        ("set_fms_task_rate", 100.0, (100,)),
        ("servo_out", [3, -0.5], (3, -0.5)),
        ("servo_out", {"position": -0.5, "servo": 3}, (3, -0.5)),
        ("go_to_waypoint", {"plan": "hil", "index": 2}, (1, 2)),
        ("set_k_pitch", 99.99, (99.99,)),
    ],
)
def test_every_spelling_is_read(name: str, given_value: Any, arguments: tuple[float, ...]) -> None:
    assert read_arguments(COMMANDS[name], given_value) == arguments


@pytest.mark.parametrize(
    ("name", "given_value", "field"),
    [
        ("start", 0, ""),
        ("control_source", None, ""),
        ("control_source", True, "source"),
        ("control_source", "pilot", "source"),
        ("control_source", [1, 2], ""),
        ("set_fms_task_rate", math.nan, "period_ms"),
        ("set_fms_task_rate", 10**400, "period_ms"),
        ("servo_out", {"servo": 1, "position": 0.0, "wing": 2}, "wing"),
        ("servo_out", {"servo": 1}, "position"),
        ("servo_out", [1, 1.01], "position"),
    ],
)
def test_a_wrong_value_is_named(name: str, given_value: Any, field: str) -> None:
    with pytest.raises(ArgumentFault) as caught:
        read_arguments(COMMANDS[name], given_value)
    assert caught.value.field == field
    assert caught.value.sentence.endswith(".")


json_values = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats() | st.text(),
    lambda inner: st.lists(inner, max_size=4) | st.dictionaries(st.text(), inner, max_size=4),
    max_leaves=8,
)


@given(st.sampled_from(sorted(COMMANDS)), json_values)
def test_no_value_does_anything_but_pass_or_be_named(name: str, value: Any) -> None:
    command = COMMANDS[name]
    try:
        arguments = read_arguments(command, value)
    except ArgumentFault:
        return
    assert len(command.struct.pack(*arguments)) == command.size
