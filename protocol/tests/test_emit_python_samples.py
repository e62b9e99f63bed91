"""The types of samples that are made import, and say what the definition says."""

from __future__ import annotations

import dataclasses
import sys
import types
from typing import Any

import pytest

from generator import emit_python_samples
from tests.example import definition


@pytest.fixture
def module(monkeypatch: pytest.MonkeyPatch) -> Any:
    made = types.ModuleType("samples_gen")
    # A dataclass looks for its own module while it is made.
    monkeypatch.setitem(sys.modules, "samples_gen", made)
    exec(compile(emit_python_samples.samples(definition()), "samples_gen.py", "exec"), vars(made))  # noqa: S102
    return made


def test_a_topic_has_its_name_and_its_values_in_order(module: Any) -> None:
    assert module.Attitude.NAME == "attitude"
    names = [field.name for field in dataclasses.fields(module.Attitude)]
    assert names == ["roll_deg", "servo_0", "servo_1", "digits"]
    assert module.Attitude(12.5).roll_deg == 12.5


def test_a_value_without_data_is_none(module: Any) -> None:
    assert module.Heartbeat() == module.Heartbeat(None, None, None, None)


def test_what_is_no_topic_has_no_type(module: Any) -> None:
    assert not hasattr(module, "Place")


def test_the_simulators_rows_are_one_topic(module: Any) -> None:
    assert "q_rad_s" in {field.name for field in dataclasses.fields(module.Simulator)}
