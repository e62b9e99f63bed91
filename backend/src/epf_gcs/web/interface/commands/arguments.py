"""Convert the value of a command request to the command's arguments, or say why it is wrong."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from epf_gcs.codec.tables import Message, Value
from epf_gcs.codec.values import argument_fault


class ArgumentFault(ValueError):  # noqa: N818 - it names what is wrong, one sentence
    """Why a value is not valid for a command; `field` is the argument, empty if it concerns all of them."""

    def __init__(self, field: str, sentence: str) -> None:
        super().__init__(sentence)
        self.field = field
        self.sentence = sentence


def read_arguments(command: Message, given: Any) -> tuple[float, ...]:
    """Arguments in the order of the wire. Raises ArgumentFault.

    No arguments: None. One: a number, or one of its names. More: a list in order, or an object by name.
    """
    wanted = command.values
    if not wanted:
        if given is not None:
            raise ArgumentFault("", f"{command.name} takes no value.")
        return ()
    if isinstance(given, Mapping):
        return _by_name(command, given)
    items = given if isinstance(given, list) else [given]
    if given is None or len(items) != len(wanted):
        names = ", ".join(value.name for value in wanted)
        raise ArgumentFault("", f"{command.name} needs {len(wanted)} value{'s'[: len(wanted) > 1]}: {names}.")
    return tuple(_number(value, item) for value, item in zip(wanted, items, strict=True))


def _by_name(command: Message, given: Mapping[str, Any]) -> tuple[float, ...]:
    names = {value.name for value in command.values}
    for name in given:
        if name not in names:
            raise ArgumentFault(name, f"{command.name} has no value '{name}': it has {', '.join(sorted(names))}.")
    for name in sorted(names - set(given)):
        raise ArgumentFault(name, f"{command.name} needs the value '{name}'.")
    return tuple(_number(value, given[value.name]) for value in command.values)


def _number(value: Value, given: Any) -> float:
    if isinstance(given, str) and given in value.names:
        return value.names[given]
    if isinstance(given, bool) or not isinstance(given, int | float):
        known = f", or one of {', '.join(value.names)}" if value.names else ""
        raise ArgumentFault(value.name, f"{value.name} must be a number{known}.")
    try:
        fault = argument_fault(value, given)
    except OverflowError:
        fault = f"{value.name} is far too large"
    if fault is not None:
        raise ArgumentFault(value.name, f"{fault}.")
    return int(given) if value.kind == "integer" else given
