"""The Python that is made imports, and its tables say what the definition says."""

from __future__ import annotations

import math
from typing import Any

import pytest

from generator import emit_python
from tests.example import definition


@pytest.fixture(scope="module")
def module() -> dict[str, Any]:
    names: dict[str, Any] = {}
    exec(compile(emit_python.messages(definition()), "messages_gen.py", "exec"), names)  # noqa: S102
    return names


def test_the_first_line_names_the_generator() -> None:
    assert emit_python.messages(definition()).startswith("# Made by protocol/generator (emit_python.py).")


def test_messages_unpack_the_bytes_of_the_wire(module: dict[str, Any]) -> None:
    message = module["TELEMETRY"][0]
    assert message.struct.unpack(bytes.fromhex("0102feff")) == (1, 2, -2)
    assert [value.name for value in message.values] == ["armed", "auto", "stick", "count"]
    assert module["TELEMETRY_BY_NAME"]["place"].size == 120


def test_values_carry_unit_range_sign_and_oddity(module: dict[str, Any]) -> None:
    roll, *_, digits = module["TELEMETRY"][1].values
    assert (roll.unit, roll.minimum, roll.maximum, roll.sign) == ("deg", -180.0, 180.0, "right wing down")
    assert math.isnan(roll.absent)
    assert digits.absent is None
    assert module["TELEMETRY"][0].values[3].absent == -1
    assert digits.encoding == "ascii_digits"


def test_commands_carry_their_proof(module: dict[str, Any]) -> None:
    commands = module["COMMANDS"]
    assert commands["stop"].confirm.flags == {"armed": False}
    assert commands["set_k_roll"].confirm.by == "read_back"
    assert commands["set_k_roll"].parameter == "k_roll"
    assert commands["mode"].values[0].names == {"auto": 0, "stick": 1}
    assert module["COMMANDS_BY_ID"][61].name == "set_k_time"


def test_parameters_rows_and_routes_are_there(module: dict[str, Any]) -> None:
    assert [(p.name, p.is_integer, p.default) for p in module["PARAMETERS"]] == [
        ("k_roll", False, 2.0),
        ("k_time", True, 700),
    ]
    assert module["XPLANE_ROWS"]["new"][16].values[0].name == "q_deg_s"
    assert module["ROUTES"]["home"].waypoints[1].latitude_deg == 27.95
