"""What all types of the contract share, and the words that several of them use."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, ClassVar, Literal

Values = Mapping[str, Any]
"""The values of a topic's sample by name, as the wire's definition has them; None is no data."""
LinkState = Literal["closed", "opening", "open", "lost"]
ParamValue = str | float | bool | None
PlanName = Literal["flight", "hil"]
ControlSource = Literal["joystick", "rc"]
SurfacePath = Literal["manual", "assisted"]
"""Who moves the simulator's surfaces: the pilot's stick, or the board."""
StickSource = Literal["simulator", "gamepad"]
SimulatorProfile = Literal["xp10", "xp12"]
PageKind = Literal["local", "person", "program"]
"""A page of this computer, of a person, or a program."""
RoleName = Literal["viewer", "operator", "owner"]


@dataclass(frozen=True, slots=True)
class PageFacts:
    """What a station wants to be told again of a page with control when it has been restarted; nobody else reads it."""

    session: str = ""
    kind: PageKind = "person"
    number: int = 1


def _without_defaults(schema: dict[str, Any]) -> None:
    """A field that is always sent has no default for whoever reads it."""
    for field in schema.get("properties", {}).values():
        field.pop("default", None)


def numbers_of(params: Mapping[str, ParamValue]) -> dict[str, ParamValue]:
    """An error's values as the interface has them: a whole number is a number like others."""
    return {name: value if isinstance(value, str | bool | None) else float(value) for name, value in params.items()}


class Shape:
    """A value as it goes from the flight process to a page: a frozen dataclass whose defaults mean "not known".

    Plain dataclasses, because the flight process loads no pydantic; pydantic reads the configuration below where the
    interface describes and checks them: no unknown field, and every field is always sent.
    """

    __slots__ = ()
    __pydantic_config__: ClassVar[dict[str, Any]] = {
        "extra": "forbid",
        "json_schema_serialization_defaults_required": True,
        "json_schema_extra": _without_defaults,
    }
