"""The TypeScript that is made has a type for each topic and a table for each list."""

from __future__ import annotations

from generator import emit_typescript
from tests.example import definition

TEXT = emit_typescript.messages(definition())


def test_the_first_line_names_the_generator() -> None:
    assert TEXT.startswith("// Made by protocol/generator (emit_typescript.py).")


def test_a_topic_is_an_interface_whose_values_may_be_no_data() -> None:
    assert "export interface Attitude {" in TEXT
    assert "  /** Bank. [deg] + right wing down. */\n  readonly roll_deg: number | null;\n" in TEXT
    assert "  readonly armed: boolean | null;\n" in TEXT
    assert "  readonly attitude: Attitude;\n" in TEXT


def test_what_is_no_topic_has_no_interface() -> None:
    assert "interface Place" not in TEXT


def test_tables_hold_commands_parameters_routes_and_rows() -> None:
    assert 'export type CommandName = "stop" | "mode" | "hil_load_home" | "pace" | "set_k_roll" | "set_k_time";' in TEXT
    assert '"names": {"auto": 0, "stick": 1}' in TEXT
    assert 'name: "k_time", group: "speed", setId: 61, isInteger: true, default: 700' in TEXT
    assert '"latitude_deg": 27.95' in TEXT
    assert '"name": "q_deg_s"' in TEXT
