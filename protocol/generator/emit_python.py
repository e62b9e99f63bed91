"""Model -> backend/src/epf_gcs/codec/messages_gen.py: tables of the types of codec/tables.py."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from .model import Confirm, Definition, Message, Row, Value

NOTICE = (
    "# Made by protocol/generator (emit_python.py). Do not edit: change protocol/definition and run `make generate`."
)

IMPORTS = """\
from __future__ import annotations

from collections.abc import Mapping
from math import nan
from struct import Struct
from types import MappingProxyType
from typing import Final

from epf_gcs.codec.tables import Confirm, Message, Parameter, Route, Row, RowValue, Value, Waypoint
"""


def messages(definition: Definition) -> str:
    """The whole module."""
    return "\n".join(_module(definition)).rstrip("\n") + "\n"


def _module(definition: Definition) -> Iterator[str]:
    frame = definition.frame
    datagram = definition.datagram
    yield NOTICE
    yield '"""The wire\'s tables: every message, command, parameter, simulator row and route."""'
    yield ""
    yield IMPORTS
    yield from [
        f"TO_PC_HEADER: Final = {frame.to_pc_header!r}",
        f"TO_BOARD_HEADER: Final = {frame.to_board_header!r}",
        f"END: Final = {frame.end!r}",
        f"TO_PC_TYPE_BIT: Final = 0x{1 << frame.to_pc_type_bit:08X}",
        f"FORBIDDEN_TYPE_BITS: Final = 0x{sum(1 << bit for bit in frame.forbidden_type_bits):08X}",
        f"OPEN_BINARY_MODE: Final = {frame.open_binary_mode.encode()!r}",
        "",
        f"DATAGRAM_MAGIC: Final = {datagram.magic.encode()!r}",
        f"TAG_FROM_SIMULATOR: Final = 0x{datagram.tag_from_simulator:02X}",
        f"TAG_TO_SIMULATOR: Final = 0x{datagram.tag_to_simulator:02X}",
        f"VALUES_PER_ROW: Final = {datagram.values_per_row}",
        f"NO_VALUE: Final = {datagram.no_value!r}",
        f"RECEIVE_PORT: Final = {datagram.receive_port}",
        f"SEND_PORT: Final = {datagram.send_port}",
        f"PROFILES: Final = {datagram.profiles!r}",
        "",
    ]
    yield "_MESSAGES: Final = ("
    for message in definition.messages:
        yield from _message(message)
    yield ")"
    yield "TELEMETRY: Final[Mapping[int, Message]] = MappingProxyType({m.id: m for m in _MESSAGES})"
    yield "TELEMETRY_BY_NAME: Final[Mapping[str, Message]] = MappingProxyType({m.name: m for m in _MESSAGES})"
    yield ""
    yield "_COMMANDS: Final = ("
    for command in definition.commands:
        yield from _message(command)
    yield ")"
    yield "COMMANDS: Final[Mapping[str, Message]] = MappingProxyType({c.name: c for c in _COMMANDS})"
    yield "COMMANDS_BY_ID: Final[Mapping[int, Message]] = MappingProxyType({c.id: c for c in _COMMANDS})"
    yield ""
    yield "PARAMETERS: Final[tuple[Parameter, ...]] = ("
    for p in definition.parameters:
        yield (
            f"    Parameter({p.name!r}, {p.group!r}, {p.set_id}, {p.type == 'i32'}, {p.minimum!r}, {p.maximum!r}, "
            f"{p.step!r}, {p.default!r}, {p.doc!r}),"
        )
    yield ")"
    yield ""
    for profile in datagram.profiles:
        yield f"_ROWS_{profile.upper()}: Final = ("
        for row in definition.rows:
            yield from _row(row, profile)
        yield ")"
    yield "XPLANE_ROWS: Final[Mapping[str, Mapping[int, Row]]] = MappingProxyType("
    pairs = ", ".join(
        f'"{profile}": MappingProxyType({{r.id: r for r in _ROWS_{profile.upper()}}})' for profile in datagram.profiles
    )
    yield f"    {{{pairs}}}"
    yield ")"
    yield ""
    yield "ROUTES: Final[Mapping[str, Route]] = MappingProxyType("
    yield "    {"
    for route in definition.routes:
        yield (
            f"        {route.name!r}: Route({route.name!r}, {route.title!r}, {route.plan_name}, {route.load_id}, "
            f"{route.loop}, {route.doc!r}, ("
        )
        for w in route.waypoints:
            yield (f"            Waypoint({w.latitude_deg!r}, {w.longitude_deg!r}, {w.altitude_ft!r}, {w.speed_kt!r}),")
        yield "        )),"
    yield "    }"
    yield ")"


def _message(message: Message) -> Iterator[str]:
    yield "    Message("
    yield f"        id={_id(message)}, name={message.name!r}, doc={message.doc!r},"
    yield f"        source={message.source!r}, extension={message.extension}, topic={message.topic},"
    yield f'        struct=Struct("{message.struct_format}"),'
    if message.values:
        yield "        values=("
        for value in message.values:
            yield f"            {_value(value)},"
        yield "        ),"
    if message.confirm is not None:
        yield f"        confirm={_confirm(message.confirm)},"
    if message.parameter:
        yield f"        parameter={message.parameter!r},"
    yield "    ),"


def _id(message: Message) -> str:
    return f"0x{message.id:X}" if message.extension else str(message.id)


def _value(value: Value) -> str:
    parts = [repr(value.name), repr(value.kind), str(value.slot), repr(value.encoding), repr(value.doc)]
    optional: Mapping[str, object] = {
        "unit": value.unit if value.unit != "1" else None,
        "minimum": value.minimum,
        "maximum": value.maximum,
        "sign": value.sign if value.sign != "none" else None,
        "bit": value.bit,
        "absent": value.absent,
        "default": value.default,
        "letters": value.letters,
    }
    parts += [f"{key}={entry!r}" for key, entry in optional.items() if entry is not None]
    if value.names:
        parts.append(f"names=MappingProxyType({dict(value.names)!r})")
    return f"Value({', '.join(parts)})"


def _confirm(confirm: Confirm) -> str:
    parts = [repr(confirm.by)]
    if confirm.flags:
        parts.append(f"flags=MappingProxyType({dict(confirm.flags)!r})")
    if confirm.message:
        parts.append(f"message={confirm.message!r}")
    if confirm.move:
        parts.append(f"move={confirm.move!r}")
    return f"Confirm({', '.join(parts)})"


def _row(row: Row, profile: str) -> Iterator[str]:
    yield f"    Row({row.id}, {row.name!r}, {row.doc!r}, {row.sent}, ("
    for v in row.profiles[profile]:
        yield (
            f"        RowValue({v.index}, {v.name!r}, {v.unit!r}, {v.minimum!r}, {v.maximum!r}, {v.sign!r}, {v.doc!r}),"
        )
    yield "    )),"
