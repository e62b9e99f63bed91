"""The topics that a board describes itself, beside the built-in ones."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final, Literal

from epf_gcs.contract.base import Shape

OWN_TYPE_WORDS: Final = range(0x1000, 0x10000)
"""The type words of own topics' frames."""
OwnFieldType = Literal["f32", "i32", "u32", "flag", "enum", "f64", "i16", "u16", "i8", "u8"]


@dataclass(frozen=True, slots=True)
class OwnFieldDefinition(Shape):
    """A quantity of an own topic. The integer of the wire times `scale`, and both limits, are in `unit`; of an enum
    they are places of `choices` from 0. `sign` says what positive means."""

    name: str
    type: OwnFieldType
    unit: str
    scale: float
    minimum: float
    maximum: float
    choices: tuple[str, ...]
    sign: str


@dataclass(frozen=True, slots=True)
class OwnTopicDefinition(Shape):
    """One own topic: what its frames hold, in order, and how often (ms) the board means to send them."""

    row: int
    type_word: int
    name: str
    period_ms: int
    doc: str
    fields: tuple[OwnFieldDefinition, ...]
