"""A released frame may not change; new ones may come."""

from __future__ import annotations

import json
from typing import Any

import pytest

from generator import released
from tests.example import definition

RELEASED: dict[str, Any] = json.loads(released.text(definition()))
GONE = """[[message]]
name = "gains"
id = 2
size = 8
doc = "All gains."
source = "test"
fields_of = "parameters"
"""
NEW = """[[message]]
name = "more"
id = 3
size = 4
doc = "More."
source = "test"
fields = [ { name = "more", type = "f32", unit = "1", range = [0.0, 1.0], sign = "none", doc = "More." } ]
"""


def test_the_same_wire_breaks_nothing() -> None:
    assert released.breaks(definition(), RELEASED) == []


def test_a_new_frame_breaks_nothing() -> None:
    assert released.breaks(definition(telemetry=(GONE, GONE + NEW)), RELEASED) == []


@pytest.mark.parametrize(
    ("old", "new", "what"),
    [
        ("id = 1\n", "id = 5\n", "to_pc attitude"),
        ('name = "count", type = "i16"', 'name = "number", type = "i16"', "to_pc heartbeat"),
        ('name = "roll", type = "f32"', 'name = "roll", type = "u32"', "to_pc attitude"),
        ('count = 2, unit = "1"', 'count = 2, unit = "deg"', "to_pc attitude"),
        (GONE, "", "to_pc gains was released and is gone"),
    ],
)
def test_a_changed_id_name_type_unit_or_a_lost_frame_is_a_break(old: str, new: str, what: str) -> None:
    (sentence,) = released.breaks(definition(telemetry=(old, new)), RELEASED)
    assert sentence.startswith(what)


def test_a_changed_order_is_a_break() -> None:
    swapped = json.loads(json.dumps(RELEASED))
    swapped["to_pc"]["attitude"]["fields"].reverse()
    assert len(released.breaks(definition(), swapped)) == 1
