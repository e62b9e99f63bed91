"""The shapes of commands, the HIL switches and the console."""

from __future__ import annotations

from typing import Literal

from pydantic import Field

from epf_gcs.contract.shapes import Input, Output


class Argument(Output):
    """One argument of a command. Where it has `names`, these may be sent in place of the number."""

    name: str
    unit: str
    minimum: float | None
    maximum: float | None
    default: float | None
    is_integer: bool
    names: dict[str, int]
    doc: str


class CommandInfo(Output):
    """A command; `supported` is null while no board is connected."""

    name: str
    id: int
    doc: str
    extension: bool
    supported: bool | None
    arguments: list[Argument]


class CommandList(Output):
    """All commands that may be sent."""

    commands: list[CommandInfo]


class CommandValue(Input):
    """Nothing, one number or name, a list in order, or an object by name."""

    value: float | str | list[float | str] | dict[str, float | str] | None = None


class HilInput(Input):
    """Any of them. With the stick from a gamepad, `gamepad` is its name for people."""

    source: Literal["joystick", "rc"] | None = None
    path: Literal["manual", "assisted"] | None = None
    stick: Literal["simulator", "gamepad"] | None = None
    gamepad: str = Field("gamepad", min_length=1, max_length=200)


class ConsoleLine(Input):
    """A line for the board; a line end is added."""

    text: str = Field(min_length=1, max_length=200, pattern=r"^[\x20-\x7e]+$")
