"""Model -> backend/src/epf_gcs/client/samples_gen.py: the values of each topic as a type, for programs."""

from __future__ import annotations

import textwrap
from collections.abc import Iterator, Mapping

from .model import Definition, RowValue, Value, topics

NOTICE = (
    "# Made by protocol/generator (emit_python_samples.py). "
    "Do not edit: change protocol/definition and run `make generate`."
)

IMPORTS = """\
from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

"""

BASE = """
class Topic:
    \"\"\"The base of the values of every topic; None is "no data". NAME is its name on the stream.\"\"\"

    __slots__ = ()
    NAME: ClassVar[str]
"""

TYPES: Mapping[str, str] = {"number": "float", "integer": "int", "boolean": "bool", "text": "str"}
WIDTH = 118


def samples(definition: Definition) -> str:
    """The whole module."""
    return "\n".join(_module(definition)).rstrip("\n") + "\n"


def _module(definition: Definition) -> Iterator[str]:
    yield NOTICE
    yield '"""The values of each topic of the stream, by name, with unit and sign."""'
    yield ""
    yield IMPORTS + BASE
    for message in topics(definition):
        yield from _topic(
            message.name, message.doc, [(value.name, TYPES[value.kind], _meaning(value)) for value in message.values]
        )
    # The gateway converts what other profiles have in other units.
    first = definition.datagram.profiles[0]
    named = {value.name: value for row in definition.rows for value in row.profiles[first]}
    doc = "What the simulator says, by name; None until its row has arrived."
    yield from _topic("simulator", doc, [(name, "float", _meaning(value)) for name, value in named.items()])


def _topic(name: str, doc: str, fields: list[tuple[str, str, str]]) -> Iterator[str]:
    yield ""
    yield "@dataclass(frozen=True, slots=True)"
    yield f"class {''.join(word.capitalize() for word in name.split('_'))}(Topic):"
    yield from textwrap.wrap(f'"""{doc}"""', WIDTH, initial_indent="    ", subsequent_indent="    ")
    yield ""
    yield f'    NAME = "{name}"'
    for field, kind, meaning in fields:
        yield f"    {field}: {kind} | None = None"
        yield from textwrap.wrap(f'"""{meaning}"""', WIDTH, initial_indent="    ", subsequent_indent="    ")
    yield ""


def _meaning(value: Value | RowValue) -> str:
    """What a value is, its unit, and what a positive one means."""
    unit = "" if value.unit == "1" else f" In {value.unit}."
    sign = "" if value.sign == "none" else f" Positive: {value.sign}."
    return f"{value.doc}{unit}{sign}".replace("\\", "\\\\").replace('"', "'")
