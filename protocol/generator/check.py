"""Rules that a JSON schema cannot express: sizes, unique ids and names, references between the files."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Sequence

from .model import Definition, DefinitionError, Message, Value

WORD = 4
EXTENSION_FROM = 0x100


def check(definition: Definition) -> None:
    """Raise DefinitionError at the first contradiction."""
    for message in (*definition.messages, *definition.commands):
        _check_message(message)
    for what, messages in (("message", definition.messages), ("command", definition.commands)):
        _unique(f"{what} id", [message.id for message in messages])
        _unique(f"{what} name", [message.name for message in messages])
    _check_confirmations(definition)
    used = {command.id for command in definition.commands}
    clash = used & set(definition.unused_command_ids)
    if clash:
        raise DefinitionError(f"command ids {sorted(clash)} are unused by deployed boards and stay unused")
    for parameter in definition.parameters:
        if not parameter.minimum <= parameter.default <= parameter.maximum:
            raise DefinitionError(f"parameter {parameter.name}: default outside its range")
    _unique("row id", [row.id for row in definition.rows])
    for row in definition.rows:
        for profile, values in row.profiles.items():
            _unique(f"index in row {row.id} {profile}", [value.index for value in values])
            if any(value.index >= definition.datagram.values_per_row for value in values):
                raise DefinitionError(f"row {row.id}: index beyond the record")
    _check_routes(definition)


def _check_message(message: Message) -> None:
    size = sum(slot.size for slot in message.slots)
    if size != message.size:
        raise DefinitionError(f"{message.name}: fields are {size} bytes, size says {message.size}")
    if size % WORD:
        raise DefinitionError(f"{message.name}: {size} bytes are not whole 32-bit words")
    if message.extension != (message.id >= EXTENSION_FROM):
        raise DefinitionError(f"{message.name}: extensions, and only they, have ids from 0x100")
    _unique(f"value of {message.name}", [value.name for value in message.values])
    for value in message.values:
        _check_value(message, value)


def _check_value(message: Message, value: Value) -> None:
    where = f"{message.name}.{value.name}"
    if value.minimum is not None and value.maximum is not None and value.minimum >= value.maximum:
        raise DefinitionError(f"{where}: range is empty")
    if value.minimum is not None and value.minimum < 0 and value.kind == "number" and value.sign == "none":
        raise DefinitionError(f"{where}: can be negative, so it must say what positive means")
    if value.absent is not None and _is_in_range(value, value.absent):
        raise DefinitionError(f"{where}: {value.absent} cannot mean no data, it is inside the range")
    for name, number in value.names.items():
        if not _is_in_range(value, number):
            raise DefinitionError(f"{where}: named value {name} is outside the range")


def _is_in_range(value: Value, number: float) -> bool:
    return value.minimum is not None and value.maximum is not None and value.minimum <= number <= value.maximum


def _check_confirmations(definition: Definition) -> None:
    messages = {message.name: message for message in definition.messages}
    flags = {value.name for value in messages["heartbeat"].values}
    for command in definition.commands:
        confirm = command.confirm
        if confirm is None:
            raise DefinitionError(f"{command.name}: a command needs a confirm rule")
        unknown = set(confirm.flags) - flags
        if unknown:
            raise DefinitionError(f"{command.name}: heartbeat has no flag {sorted(unknown)}")
        if (confirm.by == "heartbeat") != bool(confirm.flags):
            raise DefinitionError(f"{command.name}: flags go with the rule heartbeat, and only with it")
        if (confirm.by in ("frame", "plan")) != bool(confirm.message):
            raise DefinitionError(f"{command.name}: a message goes with the rules frame and plan")
        if confirm.message and confirm.message not in messages:
            raise DefinitionError(f"{command.name}: no message {confirm.message}")
        if (confirm.by == "plan") != bool(confirm.move):
            raise DefinitionError(f"{command.name}: a move goes with the rule plan, and only with it")


def _check_routes(definition: Definition) -> None:
    commands = {command.id: command for command in definition.commands}
    for route in definition.routes:
        if route.load_id not in commands or commands[route.load_id].name != f"hil_load_{route.name}":
            raise DefinitionError(f"route {route.name}: command {route.load_id} does not load it")
        for waypoint in route.waypoints:
            if not (-90 <= waypoint.latitude_deg <= 90 and -180 <= waypoint.longitude_deg <= 180):
                raise DefinitionError(f"route {route.name}: {waypoint} is not on the earth")
    _unique("route", [route.name for route in definition.routes])
    _unique("route number", [route.plan_name for route in definition.routes])


def _unique(what: str, things: Sequence[object] | Iterable[object]) -> None:
    twice = [thing for thing, count in Counter(things).items() if count > 1]
    if twice:
        raise DefinitionError(f"{what} {twice[0]} is there twice")
