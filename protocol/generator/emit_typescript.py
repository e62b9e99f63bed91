"""Model -> frontend/src/protocol/messages.gen.ts: topic types and the tables that the page shows."""

from __future__ import annotations

import json
from collections.abc import Iterable, Iterator, Mapping

from .model import Definition, Message, Row, Value, topics

NOTICE = (
    "// Made by protocol/generator (emit_typescript.py). "
    "Do not edit: change protocol/definition and run `make generate`."
)

TYPES: Mapping[str, str] = {"number": "number", "integer": "number", "boolean": "boolean", "text": "string"}

PRELUDE = """\
export interface FieldInfo {
  readonly kind: "number" | "integer" | "boolean" | "text";
  /** Unit of the value; "1" where it has none. */
  readonly unit: string;
  readonly minimum: number | null;
  readonly maximum: number | null;
  /** What a positive value means. */
  readonly sign: string;
  readonly doc: string;
  /** Meanings of an integer's values. */
  readonly names: Readonly<Record<string, number>>;
}

export interface CommandArgument {
  readonly name: string;
  readonly kind: "number" | "integer" | "boolean" | "text";
  readonly unit: string;
  readonly minimum: number | null;
  readonly maximum: number | null;
  readonly default: number | null;
  readonly names: Readonly<Record<string, number>>;
}

export interface CommandInfo {
  readonly id: number;
  readonly doc: string;
  readonly extension: boolean;
  readonly confirm: "none" | "heartbeat" | "frame" | "plan" | "read_back";
  readonly arguments: readonly CommandArgument[];
}

export interface ParameterInfo {
  readonly name: string;
  readonly group: "altitude" | "heading" | "rudder" | "speed";
  readonly setId: number;
  readonly isInteger: boolean;
  readonly default: number;
  readonly minimum: number;
  readonly maximum: number;
  readonly step: number;
  readonly doc: string;
}

export interface RouteWaypoint {
  readonly latitude_deg: number;
  readonly longitude_deg: number;
  readonly altitude_ft: number;
  readonly speed_kt: number;
}

export interface RouteInfo {
  readonly name: string;
  readonly title: string;
  readonly planName: number;
  readonly loop: boolean;
  readonly waypoints: readonly RouteWaypoint[];
}

export interface RowValueInfo {
  readonly index: number;
  readonly name: string;
  readonly unit: string;
  readonly doc: string;
}

export interface RowInfo {
  readonly id: number;
  readonly name: string;
  readonly doc: string;
  readonly sent: boolean;
  readonly values: readonly RowValueInfo[];
}
"""


def messages(definition: Definition) -> str:
    """The whole module."""
    return "\n".join(_module(definition)).rstrip("\n") + "\n"


def _module(definition: Definition) -> Iterator[str]:
    shown = topics(definition)
    yield NOTICE
    yield ""
    yield PRELUDE
    for message in shown:
        yield from _interface(message)
    yield '/** Newest values of every topic; null is "no data". */'
    yield "export interface Telemetry {"
    yield from (f"  readonly {message.name}: {_pascal(message.name)};" for message in shown)
    yield "}"
    yield ""
    yield "export type TopicName = keyof Telemetry;"
    yield ""
    yield from _array("TOPICS", "readonly TopicName[]", (json.dumps(message.name) for message in shown))
    yield "export const FIELDS: {"
    yield "  readonly [T in TopicName]: { readonly [F in keyof Telemetry[T]]: FieldInfo };"
    yield "} = {"
    for message in shown:
        yield f"  {message.name}: {{"
        yield from (f"    {value.name}: {_field(value)}," for value in message.values)
        yield "  },"
    yield "};"
    yield ""
    names = " | ".join(json.dumps(command.name) for command in definition.commands)
    yield f"export type CommandName = {names};"
    yield ""
    yield "export const COMMANDS: Readonly<Record<CommandName, CommandInfo>> = {"
    for command in definition.commands:
        yield f"  {command.name}: {_command(command)},"
    yield "};"
    yield ""
    parameters = " | ".join(json.dumps(p.name) for p in definition.parameters)
    yield f"export type ParameterName = {parameters};"
    yield ""
    yield from _array(
        "PARAMETERS",
        "readonly (ParameterInfo & { readonly name: ParameterName })[]",
        (
            _object(
                name=p.name,
                group=p.group,
                setId=p.set_id,
                isInteger=p.type == "i32",
                default=p.default,
                minimum=p.minimum,
                maximum=p.maximum,
                step=p.step,
                doc=p.doc,
            )
            for p in definition.parameters
        ),
    )
    yield from _array(
        "ROUTES",
        "readonly RouteInfo[]",
        (
            _object(
                name=route.name,
                title=route.title,
                planName=route.plan_name,
                loop=route.loop,
                waypoints=[vars(waypoint) for waypoint in route.waypoints],
            )
            for route in definition.routes
        ),
    )
    yield f"export type XplaneProfile = {' | '.join(json.dumps(p) for p in definition.datagram.profiles)};"
    yield ""
    yield "export const XPLANE_ROWS: Readonly<Record<XplaneProfile, readonly RowInfo[]>> = {"
    for profile in definition.datagram.profiles:
        yield f"  {profile}: ["
        yield from (f"    {_row(row, profile)}," for row in definition.rows)
        yield "  ],"
    yield "};"


def _interface(message: Message) -> Iterator[str]:
    yield f"/** {message.doc} */"
    yield f"export interface {_pascal(message.name)} {{"
    for value in message.values:
        unit = "" if value.unit == "1" else f" [{value.unit}]"
        sign = "" if value.sign == "none" else f" + {value.sign}."
        yield f"  /** {value.doc}{unit}{sign} */"
        yield f"  readonly {value.name}: {TYPES[value.kind]} | null;"
    yield "}"
    yield ""


def _field(value: Value) -> str:
    return _object(
        kind=value.kind,
        unit=value.unit,
        minimum=value.minimum,
        maximum=value.maximum,
        sign=value.sign,
        doc=value.doc,
        names=dict(value.names),
    )


def _command(command: Message) -> str:
    confirm = "none" if command.confirm is None else command.confirm.by
    return _object(
        id=command.id,
        doc=command.doc,
        extension=command.extension,
        confirm=confirm,
        arguments=[
            {
                "name": value.name,
                "kind": value.kind,
                "unit": value.unit,
                "minimum": value.minimum,
                "maximum": value.maximum,
                "default": value.default,
                "names": dict(value.names),
            }
            for value in command.values
        ],
    )


def _row(row: Row, profile: str) -> str:
    values = [
        {"index": value.index, "name": value.name, "unit": value.unit, "doc": value.doc}
        for value in row.profiles[profile]
    ]
    return _object(id=row.id, name=row.name, doc=row.doc, sent=row.sent, values=values)


def _array(name: str, type_name: str, entries: Iterable[str]) -> Iterator[str]:
    yield f"export const {name}: {type_name} = ["
    yield from (f"  {entry}," for entry in entries)
    yield "];"
    yield ""


def _object(**entries: object) -> str:
    """A one-line literal; names that are valid identifiers need no quotes."""
    return "{ " + ", ".join(f"{key}: {json.dumps(entry, ensure_ascii=False)}" for key, entry in entries.items()) + " }"


def _pascal(name: str) -> str:
    return "".join(part.capitalize() for part in name.split("_"))
