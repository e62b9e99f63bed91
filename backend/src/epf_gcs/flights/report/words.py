"""The words of the page's report, which the gateway uses too."""

from __future__ import annotations

from functools import cache
from importlib.resources import files
from typing import Any

import orjson

Words = dict[str, Any]


@cache
def words(language: str) -> Words:
    """`language` is `es` or `en`."""
    found: Words = orjson.loads(files(__package__).joinpath(f"words_gen.{language}.json").read_bytes())
    return found
