"""The encoder makes exactly the bytes that the deployed station sent."""

from __future__ import annotations

import math
from typing import Any

import pytest

from epf_gcs.codec.encode import EMPTY_COMMANDS, encode_command, encode_telemetry
from epf_gcs.codec.messages_gen import COMMANDS, OPEN_BINARY_MODE
from tests.codec.vectors import load

COMMAND_VECTORS = load("commands.jsonl")


def _bytes_of(sent: dict[str, Any]) -> bytes:
    if "text" in sent:
        return str(sent["text"]).encode("ascii")
    return encode_command(sent["command"], *sent["values"])


@pytest.mark.parametrize("vector", COMMAND_VECTORS, ids=lambda vector: f"{vector['action']} {vector.get('value', '')}")
def test_captured_commands_are_made_byte_for_byte(vector: dict[str, Any]) -> None:
    assert b"".join(_bytes_of(sent) for sent in vector["sends"]).hex() == vector["hex"]


def test_the_captures_cover_every_command_of_the_deployed_station_but_those_without_a_control() -> None:
    assert len(COMMAND_VECTORS) == 279
    used = {sent.get("command") for vector in COMMAND_VECTORS for sent in vector["sends"]}
    # do_nothing has no control; xplane_info goes out by itself and is in simulator.jsonl.
    unseen = {command.name for command in COMMANDS.values() if not command.extension} - used
    assert unseen == {"do_nothing", "xplane_info"}


def test_the_line_that_opens_binary_mode_is_the_captured_one() -> None:
    assert OPEN_BINARY_MODE.hex() == "2351540a"


def test_captured_telemetry_is_made_byte_for_byte() -> None:
    frame = encode_telemetry("gps", -33.86882, 151.209296, -12.5, 0, -10, 0x3132, 0x32, 0x56)
    assert frame.hex() == next(v["hex"] for v in load("telemetry.jsonl") if v["case"] == "9 GPS")


def test_ready_made_frames_are_those_of_the_encoder() -> None:
    assert EMPTY_COMMANDS["stop"] == encode_command("stop")
    assert set(EMPTY_COMMANDS) == {command.name for command in COMMANDS.values() if not command.values}


@pytest.mark.parametrize(
    ("name", "values", "fault"),
    [
        ("set_fms_task_rate", (49,), "period_ms must be in 50..10000, not 49"),
        ("set_fms_task_rate", (99.5,), "period_ms must be a whole number, not 99.5"),
        ("set_k_elev", (math.nan,), "value must be a number"),
        ("set_k_elev", (100.0,), "value must be in 0..99.99, not 100"),
        ("servo_out", (20, 0.0), "servo must be in 0..19, not 20"),
        ("servo_out", (3,), "servo_out takes 2 values, not 1"),
    ],
)
def test_a_wrong_call_is_refused_with_a_clear_sentence(name: str, values: tuple[float, ...], fault: str) -> None:
    with pytest.raises(ValueError, match=fault):
        encode_command(name, *values)
