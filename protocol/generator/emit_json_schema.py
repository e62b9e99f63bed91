"""Model -> protocol/telemetry.schema.json: what the values of each topic look like as JSON."""

from __future__ import annotations

import json
from typing import Any

from .model import Definition, Message, Value, topics

KINDS = {"number": "number", "integer": "integer", "boolean": "boolean", "text": "string"}


def schema(definition: Definition) -> str:
    """JSON Schema of an object {topic: values}; null is "no data"."""
    document: dict[str, Any] = {
        "$comment": "Made by protocol/generator (emit_json_schema.py). Do not edit.",
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": "Values of every topic",
        "type": "object",
        "additionalProperties": False,
        "properties": {message.name: _topic(message) for message in topics(definition)},
    }
    return json.dumps(document, indent=2, ensure_ascii=False) + "\n"


def _topic(message: Message) -> dict[str, Any]:
    return {
        "description": message.doc,
        "type": "object",
        "additionalProperties": False,
        "required": [value.name for value in message.values],
        "properties": {value.name: _value(value) for value in message.values},
    }


def _value(value: Value) -> dict[str, Any]:
    made: dict[str, Any] = {"description": value.doc, "type": [KINDS[value.kind], "null"]}
    if value.unit != "1":
        made["x-unit"] = value.unit
    if value.sign != "none":
        made["x-positive"] = value.sign
    if value.kind in ("number", "integer"):
        made["minimum"] = value.minimum
        made["maximum"] = value.maximum
    return made
