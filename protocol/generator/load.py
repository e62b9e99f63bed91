"""Definition files -> checked model. Every contradiction is a DefinitionError with one clear sentence."""

from __future__ import annotations

import json
import math
import tomllib
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any

from . import schema
from .check import check
from .model import (
    UNIT_SUFFIXES,
    Confirm,
    Datagram,
    Definition,
    DefinitionError,
    Frame,
    Message,
    Parameter,
    Route,
    Row,
    RowValue,
    Slot,
    Value,
    Waypoint,
)

FILES = ("telemetry", "commands", "parameters", "xplane", "routes")
COMMAND_SOURCE = "header, capture; chapter, table 2"

Table = Mapping[str, Any]


def load(folder: Path) -> Definition:
    """Read and check the definition in `folder` (which also holds ../definition.schema.json)."""
    rules = json.loads((folder.parent / "definition.schema.json").read_text("utf-8"))
    texts = {name: (folder / f"{name}.toml").read_text("utf-8") for name in FILES}
    return parse(texts, rules)


def parse(texts: Mapping[str, str], rules: Table) -> Definition:
    """The pure part of `load`: the texts of the five files -> the checked model."""
    tables = {name: tomllib.loads(texts[name]) for name in FILES}
    for name, table in tables.items():
        schema.validate(table, rules["properties"][name], rules, name)
    parameters = tuple(_parameter(table) for table in tables["parameters"]["parameter"])
    commands = _commands(tables["commands"], parameters, tables["parameters"]["source"])
    definition = Definition(
        frame=_frame(tables["telemetry"]["frame"]),
        messages=_messages(tables["telemetry"], parameters, commands),
        commands=commands,
        parameters=parameters,
        datagram=_datagram(tables["xplane"]["datagram"]),
        rows=tuple(_row(table, tables["xplane"]["datagram"]) for table in tables["xplane"]["row"]),
        routes=tuple(_route(table) for table in tables["routes"]["route"]),
        unused_command_ids=tuple(tables["commands"]["unused_ids"]),
    )
    check(definition)
    return definition


def suffixed(name: str, unit: str) -> str:
    """The one spelling of a quantity: its name and its unit."""
    suffix = UNIT_SUFFIXES[unit]
    return f"{name}_{suffix}" if suffix else name


def _frame(table: Table) -> Frame:
    return Frame(
        to_pc_header=bytes.fromhex(table["to_pc_header"]),
        to_board_header=bytes.fromhex(table["to_board_header"]),
        end=bytes.fromhex(table["end"]),
        to_pc_type_bit=table["to_pc_type_bit"],
        forbidden_type_bits=tuple(table["forbidden_type_bits"]),
        open_binary_mode=table["open_binary_mode"],
    )


def _messages(table: Table, parameters: Iterable[Parameter], commands: Iterable[Message]) -> tuple[Message, ...]:
    field_tables = {message["name"]: message.get("fields") for message in table["message"]}
    by_name = {command.name: command for command in commands}
    made = []
    for message in table["message"]:
        origin = message.get("fields_of", message["name"])
        if origin == "parameters":
            slots, values = _fields([_parameter_field(p) for p in parameters])
        elif origin.startswith("command "):
            command = by_name[origin.removeprefix("command ")]
            slots, values = command.slots, command.values
        else:
            absent_nan = message.get("absent") == "nan"
            slots, values = _fields(field_tables[origin] or [], absent_nan=absent_nan)
        made.append(_message(message, slots, values, table_source=message.get("source", "")))
    return tuple(made)


def _commands(table: Table, parameters: Iterable[Parameter], parameter_source: str) -> tuple[Message, ...]:
    made = []
    for command in table["command"]:
        slots, values = _fields(command.get("fields", []))
        confirm = dict(command["confirm"])
        made.append(
            _message(
                command,
                slots,
                values,
                table_source=command.get("source", COMMAND_SOURCE),
                confirm=Confirm(
                    by=confirm.pop("by"),
                    message=confirm.pop("message", ""),
                    move=confirm.pop("move", ""),
                    flags=confirm,
                ),
            )
        )
    for parameter in parameters:
        slots, values = _fields([_parameter_field(parameter, name="value")])
        made.append(
            Message(
                name=f"set_{parameter.name}",
                id=parameter.set_id,
                size=4,
                doc=f"Set the parameter {parameter.name}.",
                source=parameter_source,
                extension=False,
                topic=False,
                slots=slots,
                values=values,
                confirm=Confirm(by="read_back"),
                parameter=parameter.name,
            )
        )
    return tuple(sorted(made, key=lambda message: message.id))


def _message(
    table: Table,
    slots: tuple[Slot, ...],
    values: tuple[Value, ...],
    table_source: str,
    confirm: Confirm | None = None,
) -> Message:
    return Message(
        name=table["name"],
        id=table["id"],
        size=table.get("size", 0),
        doc=table["doc"],
        source=table_source,
        extension=table.get("extension", False),
        topic=table.get("topic", confirm is None),
        slots=slots,
        values=values,
        confirm=confirm,
    )


def _parameter_field(parameter: Parameter, name: str = "") -> Table:
    return {
        "name": name or parameter.name,
        "type": parameter.type,
        "unit": "1",
        "range": [parameter.minimum, parameter.maximum],
        "default": parameter.default,
        "sign": "none",
        "doc": parameter.doc,
    }


def _fields(tables: Iterable[Table], *, absent_nan: bool = False) -> tuple[tuple[Slot, ...], tuple[Value, ...]]:
    """Fields -> the slots of the wire and the values in them. A value's `slot` counts single wire values."""
    slots: list[Slot] = []
    values: list[Value] = []
    position = 0
    for table in tables:
        encoding = table.get("encoding", "plain")
        count = table.get("count", 1)
        wire_name = table["name"]
        if encoding == "plain":
            wire_name = suffixed(wire_name, table.get("unit", "1"))
        slots.append(Slot(wire_name, table["type"], count, table["doc"], encoding, table.get("values", {})))
        values.extend(_values(table, encoding, count, position, absent_nan=absent_nan))
        position += count
    return tuple(slots), tuple(values)


def _values(table: Table, encoding: str, count: int, position: int, *, absent_nan: bool) -> list[Value]:
    minimum, maximum = table.get("range", (None, None))
    if encoding == "bits":
        return [
            Value(bit["name"], "boolean", position, "bit", bit["doc"], "1", minimum, maximum, bit=bit["bit"])
            for bit in table["bits"]
        ]
    if encoding == "flag":
        return [Value(table["name"], "boolean", position, "flag", table["doc"], "1", 0, 1)]
    if encoding == "ascii_flag":
        letters = (table["letters"]["true"], table["letters"]["false"])
        return [Value(table["name"], "boolean", position, encoding, table["doc"], letters=letters)]
    if encoding == "text":
        return [Value(table["name"], "text", position, encoding, table["doc"])]
    missing = {"unit", "sign", "range"} - set(table)
    if missing:
        raise DefinitionError(f"field {table['name']}: {', '.join(sorted(missing))} missing")
    kind = "number" if table["type"] in ("f32", "f64") else "integer"
    return [
        Value(
            name=suffixed(table["name"] if count == 1 else f"{table['name']}_{i}", table["unit"]),
            kind=kind,
            slot=position + i,
            encoding=encoding,
            doc=table["doc"],
            unit=table["unit"],
            minimum=minimum,
            maximum=maximum,
            sign=table["sign"],
            absent=table.get("absent", math.nan if absent_nan and kind == "number" else None),
            default=table.get("default"),
            names=table.get("values", {}),
        )
        for i in range(count)
    ]


def _parameter(table: Table) -> Parameter:
    minimum, maximum = table["range"]
    return Parameter(
        name=table["name"],
        group=table["group"],
        set_id=table["set_id"],
        type=table["type"],
        default=table["default"],
        minimum=minimum,
        maximum=maximum,
        step=table["step"],
        doc=table["doc"],
    )


def _datagram(table: Table) -> Datagram:
    return Datagram(
        magic=table["magic"],
        tag_from_simulator=table["tag_from_simulator"],
        tag_to_simulator=table["tag_to_simulator"],
        values_per_row=table["values_per_row"],
        no_value=table["no_value"],
        receive_port=table["receive_port"],
        send_port=table["send_port"],
        profiles=tuple(table["profiles"]),
    )


def _row(table: Table, datagram: Table) -> Row:
    other = table.get("profiles", {})
    unknown = set(other) - set(datagram["profiles"])
    if unknown:
        raise DefinitionError(f"row {table['id']}: profile {sorted(unknown)} is not in [datagram]")
    return Row(
        id=table["id"],
        name=table["name"],
        doc=table["doc"],
        sent=table.get("sent", False),
        profiles={
            profile: tuple(_row_value(value) for value in other.get(profile, table["values"]))
            for profile in datagram["profiles"]
        },
    )


def _row_value(table: Table) -> RowValue:
    minimum, maximum = table["range"]
    name = suffixed(table["name"], table["unit"])
    return RowValue(table["index"], name, table["unit"], minimum, maximum, table["sign"], table["doc"])


def _route(table: Table) -> Route:
    return Route(
        name=table["name"],
        title=table["title"],
        plan_name=table["plan_name"],
        load_id=table["load_id"],
        loop=table["loop"],
        doc=table["doc"],
        waypoints=tuple(Waypoint(*numbers) for numbers in table["waypoints"]),
    )
