"""The printed reference has every table."""

from __future__ import annotations

from generator import emit_markdown
from tests.example import definition

LINES = emit_markdown.reference(definition()).splitlines()


def test_the_first_line_names_the_generator() -> None:
    assert LINES[0].startswith("<!-- Made by protocol/generator (emit_markdown.py).")


def test_fields_have_offset_unit_range_and_sign() -> None:
    assert "| 0 | f32 | roll_deg | deg | -180..180 | right wing down | Bank. NaN: no data. |" in LINES
    assert "| 8 | f32 | servo_1 | 1 | -1..1 | up | Servo. NaN: no data. |" in LINES
    assert "| 2 | i16 | count | 1 | 0..9 | none | Counts. -1: no data. |" in LINES
    assert "| 1 | i8 | stick | 1 |  | none | Bit 1: By stick. |" in LINES


def test_commands_have_their_proof() -> None:
    assert "| 1 | stop | 0 | Stop. | heartbeat: armed = false |" in LINES
    assert "| 60 | set_k_roll | 4 | Set the parameter k_roll. | read back |" in LINES


def test_parameters_rows_and_routes_are_printed() -> None:
    assert "| k_time | speed | 61 | i32 | 700 | 10 | 10000 | 10 | Time. |" in LINES
    assert "| 16 rates | 1 | q_deg_s | deg/s | -2300..2300 | nose up | Pitch rate. |" in LINES
    assert "| 1 | 27.9500 | -15.3700 | 700 | 55 |" in LINES
