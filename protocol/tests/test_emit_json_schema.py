"""The JSON Schema says what a topic's values look like."""

from __future__ import annotations

import json

from generator import emit_json_schema
from tests.example import definition

SCHEMA = json.loads(emit_json_schema.schema(definition()))


def test_every_topic_is_there_and_nothing_else() -> None:
    assert list(SCHEMA["properties"]) == ["heartbeat", "attitude", "gains"]
    assert SCHEMA["additionalProperties"] is False


def test_a_value_is_its_type_or_no_data_inside_its_range() -> None:
    attitude = SCHEMA["properties"]["attitude"]
    assert attitude["required"] == ["roll_deg", "servo_0", "servo_1", "digits"]
    assert attitude["properties"]["roll_deg"] == {
        "description": "Bank.",
        "type": ["number", "null"],
        "x-unit": "deg",
        "x-positive": "right wing down",
        "minimum": -180.0,
        "maximum": 180.0,
    }
    assert attitude["properties"]["digits"]["type"] == ["integer", "null"]
    assert SCHEMA["properties"]["heartbeat"]["properties"]["auto"]["type"] == ["boolean", "null"]
