"""The part of JSON Schema that definition.schema.json uses, checked with the standard library alone."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Any

from .model import DefinitionError

TYPES: Mapping[str, tuple[type, ...]] = {
    "object": (dict,),
    "array": (list,),
    "string": (str,),
    "boolean": (bool,),
    "integer": (int,),
    "number": (int, float),
}
KNOWN = {
    "$schema",
    "$id",
    "$defs",
    "$ref",
    "title",
    "description",
    "type",
    "enum",
    "pattern",
    "minimum",
    "maximum",
    "minItems",
    "maxItems",
    "items",
    "properties",
    "required",
    "additionalProperties",
}


def validate(value: Any, rule: Mapping[str, Any], root: Mapping[str, Any], where: str) -> None:
    """Raise DefinitionError when `value` breaks `rule`; `root` resolves references; `where` names the place."""
    if "$ref" in rule:
        rule = root["$defs"][rule["$ref"].removeprefix("#/$defs/")]
    unknown = set(rule) - KNOWN
    if unknown:
        raise DefinitionError(f"definition.schema.json uses {sorted(unknown)}, which is not checked here")
    kind = rule.get("type")
    if kind is not None and not _is(value, kind):
        raise DefinitionError(f"{where}: {value!r} is not of type {kind}")
    if "enum" in rule and value not in rule["enum"]:
        raise DefinitionError(f"{where}: {value!r} is not one of {rule['enum']}")
    if "pattern" in rule and not re.search(rule["pattern"], value):
        raise DefinitionError(f"{where}: {value!r} does not look like {rule['pattern']}")
    if "minimum" in rule and value < rule["minimum"]:
        raise DefinitionError(f"{where}: {value} is under {rule['minimum']}")
    if "maximum" in rule and value > rule["maximum"]:
        raise DefinitionError(f"{where}: {value} is over {rule['maximum']}")
    if isinstance(value, list):
        _validate_list(value, rule, root, where)
    if isinstance(value, dict):
        _validate_object(value, rule, root, where)


def _is(value: Any, kind: str) -> bool:
    if isinstance(value, bool) and kind != "boolean":
        return False
    return isinstance(value, TYPES[kind])


def _validate_list(value: list[Any], rule: Mapping[str, Any], root: Mapping[str, Any], where: str) -> None:
    if len(value) < rule.get("minItems", 0) or len(value) > rule.get("maxItems", len(value)):
        raise DefinitionError(f"{where}: {len(value)} entries are not allowed")
    if "items" in rule:
        for index, entry in enumerate(value):
            name = entry.get("name", index) if isinstance(entry, dict) else index
            validate(entry, rule["items"], root, f"{where}.{name}")


def _validate_object(value: dict[str, Any], rule: Mapping[str, Any], root: Mapping[str, Any], where: str) -> None:
    missing = set(rule.get("required", ())) - set(value)
    if missing:
        raise DefinitionError(f"{where}: {sorted(missing)} missing")
    properties = rule.get("properties", {})
    other = rule.get("additionalProperties", True)
    for key, entry in value.items():
        if key in properties:
            validate(entry, properties[key], root, f"{where}.{key}")
        elif other is False:
            raise DefinitionError(f"{where}: {key} is not a known entry")
        elif isinstance(other, dict):
            validate(entry, other, root, f"{where}.{key}")
