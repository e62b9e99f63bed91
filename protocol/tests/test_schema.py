"""The small JSON Schema checker."""

from __future__ import annotations

from typing import Any

import pytest

from generator.model import DefinitionError
from generator.schema import validate

RULE: dict[str, Any] = {
    "type": "object",
    "required": ["name"],
    "additionalProperties": False,
    "properties": {
        "name": {"type": "string", "pattern": "^[a-z]+$"},
        "count": {"$ref": "#/$defs/count"},
        "pair": {"type": "array", "minItems": 2, "maxItems": 2, "items": {"type": "number"}},
        "choice": {"enum": ["a", True]},
        "names": {"type": "object", "additionalProperties": {"type": "integer"}},
    },
}
ROOT: dict[str, Any] = {"$defs": {"count": {"type": "integer", "minimum": 1, "maximum": 3}}}


def test_what_fits_is_accepted() -> None:
    validate({"name": "abc", "count": 3, "pair": [1, 2.5], "choice": True, "names": {"x": -1}}, RULE, ROOT, "here")


@pytest.mark.parametrize(
    ("value", "sentence"),
    [
        ([], "here: [] is not of type object"),
        ({}, "here: ['name'] missing"),
        ({"name": "ABC"}, "here.name: 'ABC' does not look like"),
        ({"name": "a", "count": 0}, "here.count: 0 is under 1"),
        ({"name": "a", "count": 4}, "here.count: 4 is over 3"),
        ({"name": "a", "count": True}, "here.count: True is not of type integer"),
        ({"name": "a", "pair": [1]}, "here.pair: 1 entries are not allowed"),
        ({"name": "a", "pair": [1, "2"]}, "here.pair.1: '2' is not of type number"),
        ({"name": "a", "choice": "b"}, "here.choice: 'b' is not one of"),
        ({"name": "a", "names": {"x": 1.5}}, "here.names.x: 1.5 is not of type integer"),
        ({"name": "a", "other": 1}, "here: other is not a known entry"),
    ],
)
def test_what_does_not_fit_is_refused_with_its_place(value: object, sentence: str) -> None:
    with pytest.raises(DefinitionError) as refused:
        validate(value, RULE, ROOT, "here")
    assert sentence in str(refused.value)


def test_a_rule_that_would_not_be_checked_is_refused() -> None:
    with pytest.raises(DefinitionError, match="oneOf"):
        validate(1, {"oneOf": []}, ROOT, "here")
