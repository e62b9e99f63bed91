"""Model -> C11: structures, explicit little-endian packing, sizes, the parameter table and the routes."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from .emit_c_body import packers
from .model import TEXT_TYPES, TYPE_SIZES, Definition, Message, Slot

NOTICE = "// Made by protocol/generator (emit_c.py). Do not edit: change protocol/definition and run `make generate`."

C_TYPES = {
    "i8": "int8_t",
    "i16": "int16_t",
    "i32": "int32_t",
    "u32": "uint32_t",
    "f32": "float",
    "f64": "double",
    **dict.fromkeys(TEXT_TYPES, "char"),
}


def protocol_header(definition: Definition) -> str:
    """firmware/src/comms/protocol_gen.h"""
    return _text(_protocol_header(definition))


def protocol_source(definition: Definition) -> str:
    """firmware/src/comms/protocol_gen.c"""
    lines = [NOTICE, '#include "protocol_gen.h"', "", "#include <string.h>", ""]
    lines += packers(
        [("message", message) for message in definition.messages]
        + [("command", command) for command in definition.commands if _has_struct(command)]
    )
    lines += _size_table("telemetry", "MESSAGE", definition.messages)
    lines += _size_table("command", "COMMAND", definition.commands)
    return _text(lines)


def parameters_header(definition: Definition) -> str:
    """firmware/src/params/parameters_gen.h"""
    names = [f"    PARAMETER_{p.name.upper()} = {i}," for i, p in enumerate(definition.parameters)]
    return _text(
        [
            NOTICE,
            "#ifndef PARAMETERS_GEN_H",
            "#define PARAMETERS_GEN_H",
            "",
            "#include <stdbool.h>",
            "#include <stdint.h>",
            "",
            f"#define PARAMETER_COUNT {len(definition.parameters)}u",
            "",
            "/// Place of a parameter in the table and in the message autopilot_parameters.",
            "typedef enum",
            "{",
            *names,
            "} parameter_index_t;",
            "",
            "/// What is known of one parameter; its numbers have the unit that the control law gives it.",
            "typedef struct",
            "{",
            "    const char* name;",
            "    uint32_t set_command; ///< type of the command that sets it",
            "    bool is_integer;      ///< sent as i32, else as f32",
            "    float minimum;",
            "    float maximum;",
            "    float step;",
            "    float default_value;",
            "} parameter_definition_t;",
            "",
            "extern const parameter_definition_t parameter_definitions[PARAMETER_COUNT];",
            "",
            "#endif",
        ]
    )


def parameters_source(definition: Definition) -> str:
    """firmware/src/params/parameters_gen.c"""
    lines = [
        NOTICE,
        '#include "parameters_gen.h"',
        "",
        "const parameter_definition_t parameter_definitions[PARAMETER_COUNT] = {",
    ]
    for p in definition.parameters:
        integer = "true" if p.type == "i32" else "false"
        numbers = ", ".join(_float(x) for x in (p.minimum, p.maximum, p.step, p.default))
        lines.append(f'    {{"{p.name}", {p.set_id}u, {integer}, {numbers}}},')
    return _text([*lines, "};"])


def routes_header(definition: Definition) -> str:
    """firmware/src/navigation/routes_gen.h"""
    names = [f"    ROUTE_{route.name.upper()} = {route.plan_name}," for route in definition.routes]
    longest = max(len(route.waypoints) for route in definition.routes)
    return _text(
        [
            NOTICE,
            "#ifndef ROUTES_GEN_H",
            "#define ROUTES_GEN_H",
            "",
            "#include <stdbool.h>",
            "#include <stddef.h>",
            "#include <stdint.h>",
            "",
            f"#define ROUTE_COUNT {len(definition.routes)}u",
            f"#define ROUTE_WAYPOINTS_MAX {longest}u",
            "",
            "/// Number of a route, as board_status reports it.",
            "typedef enum",
            "{",
            *names,
            "} route_number_t;",
            "",
            "typedef struct",
            "{",
            "    double latitude_deg;  ///< WGS84, + north",
            "    double longitude_deg; ///< WGS84, + east",
            "    float altitude_ft;    ///< above mean sea level",
            "    float speed_kt;       ///< indicated",
            "} route_waypoint_t;",
            "",
            "typedef struct",
            "{",
            "    const char* name;      ///< identifier, for the shell",
            "    const char* title;     ///< as people write it",
            "    uint32_t load_command; ///< type of the command that loads it",
            "    bool loop;             ///< after the last waypoint comes the first",
            "    const route_waypoint_t* waypoints;",
            "    size_t count;",
            "} route_t;",
            "",
            "extern const route_t routes[ROUTE_COUNT]; ///< indexed by route_number_t",
            "",
            "#endif",
        ]
    )


def routes_source(definition: Definition) -> str:
    """firmware/src/navigation/routes_gen.c"""
    lines = [NOTICE, '#include "routes_gen.h"', ""]
    ordered = sorted(definition.routes, key=lambda route: route.plan_name)
    for route in ordered:
        lines.append(f"static const route_waypoint_t {route.name}_waypoints[] = {{")
        lines += [
            f"    {{{w.latitude_deg!r}, {w.longitude_deg!r}, {_float(w.altitude_ft)}, {_float(w.speed_kt)}}},"
            for w in route.waypoints
        ]
        lines += ["};", ""]
    lines.append("const route_t routes[ROUTE_COUNT] = {")
    for route in ordered:
        loop = "true" if route.loop else "false"
        lines.append(
            f'    {{"{route.name}", "{route.title}", {route.load_id}u, {loop}, '
            f"{route.name}_waypoints, {len(route.waypoints)}u}},"
        )
    return _text([*lines, "};"])


def _protocol_header(definition: Definition) -> Iterator[str]:
    frame = definition.frame
    forbidden = sum(1 << bit for bit in frame.forbidden_type_bits)
    yield from [
        NOTICE,
        "#ifndef PROTOCOL_GEN_H",
        "#define PROTOCOL_GEN_H",
        "",
        "#include <stdint.h>",
        "",
        "// Frame: header, type, payload, checksum, end; little-endian 32-bit words.",
        f"#define PROTOCOL_TO_PC_HEADER {_word(frame.to_pc_header)}    // as a little-endian word",
        f"#define PROTOCOL_TO_BOARD_HEADER {_word(frame.to_board_header)} // as a little-endian word",
        f"#define PROTOCOL_END {_word(frame.end)}             // as a little-endian word",
        f"#define PROTOCOL_TO_PC_TYPE_BIT 0x{1 << frame.to_pc_type_bit:08X}u  // set in every type word to the PC",
        f"#define PROTOCOL_FORBIDDEN_TYPE_BITS 0x{forbidden:08X}u // clear in every type word",
        "#define PROTOCOL_OVERHEAD 16u // bytes of a frame besides its payload",
        f'#define PROTOCOL_OPEN_BINARY_MODE "{frame.open_binary_mode.encode("unicode_escape").decode()}"',
        f"#define PROTOCOL_TELEMETRY_SIZE_MAX {max(m.size for m in definition.messages)}u",
        f"#define PROTOCOL_COMMAND_SIZE_MAX {max(c.size for c in definition.commands)}u",
        "",
        "/// Payload bytes of a type (without bit 31), or -1 for a type that does not exist.",
        "int32_t protocol_telemetry_size(uint32_t id);",
        "int32_t protocol_command_size(uint32_t id);",
        "",
        "/// Little-endian access, for words outside the structures below.",
        "uint16_t protocol_get_u16(const uint8_t* in);",
        "uint32_t protocol_get_u32(const uint8_t* in);",
        "int32_t protocol_get_i32(const uint8_t* in);",
        "float protocol_get_f32(const uint8_t* in);",
        "double protocol_get_f64(const uint8_t* in);",
        "void protocol_put_u16(uint8_t* out, uint16_t value);",
        "void protocol_put_u32(uint8_t* out, uint32_t value);",
        "void protocol_put_i32(uint8_t* out, int32_t value);",
        "void protocol_put_f32(uint8_t* out, float value);",
        "void protocol_put_f64(uint8_t* out, double value);",
        "",
        "// Board to PC.",
    ]
    for message in definition.messages:
        yield from _ids("MESSAGE", message)
    yield from ["", "// PC to board."]
    for command in definition.commands:
        yield from _ids("COMMAND", command)
    yield ""
    for message in definition.messages:
        yield from _structure("message", message)
    for command in definition.commands:
        if _has_struct(command):
            yield from _structure("command", command)
    yield "#endif"


def _ids(prefix: str, message: Message) -> Iterator[str]:
    name = f"{prefix}_{message.name.upper()}"
    number = f"0x{message.id:X}u" if message.extension else f"{message.id}u"
    yield f"#define {name}_ID {number}"
    yield f"#define {name}_SIZE {message.size}u"


def _structure(prefix: str, message: Message) -> Iterator[str]:
    name = f"{prefix}_{message.name}"
    yield from _constants(name, message)
    yield f"/// {message.doc}"
    yield "typedef struct"
    yield "{"
    for slot in message.slots:
        yield f"    {C_TYPES[slot.type]} {declared(slot)}; ///< {_comment(message, slot)}"
    yield f"}} {name}_t;"
    yield ""
    yield f"void {name}_pack(const {name}_t* values, uint8_t* payload);"
    yield f"void {name}_unpack({name}_t* values, const uint8_t* payload);"
    yield ""


def _constants(name: str, message: Message) -> Iterator[str]:
    """Macros for a field's named numbers and bits. No C enums: the fields have the wire's exact integer types."""
    for slot in message.slots:
        for label, number in slot.names.items():
            shown = f"({number})" if number < 0 else str(number)
            yield f"#define {name.upper()}_{slot.name.upper()}_{label.upper()} {shown}"
    for value in message.values:
        if value.bit is not None:
            yield f"#define {name.upper()}_BIT_{value.name.upper()} {1 << value.bit}"
        if value.kind == "integer" and value.absent is not None:
            yield f"#define {name.upper()}_{value.name.upper()}_ABSENT ({value.absent})"
        if message.confirm is not None and value.kind == "integer" and not value.names and not message.parameter:
            limits = {"MINIMUM": value.minimum, "MAXIMUM": value.maximum, "DEFAULT": value.default}
            for label, limit in limits.items():
                if limit is not None:
                    yield f"#define {name.upper()}_{value.name.upper()}_{label} {limit}"


def _comment(message: Message, slot: Slot) -> str:
    values = [value for value in message.values if message_slot(message, value.slot) is slot]
    first = values[0]
    if slot.encoding == "bits":
        return slot.doc + " " + " ".join(f"Bit {v.bit}: {v.doc}" for v in values)
    parts = [slot.doc]
    if slot.encoding == "plain" and first.unit != "1":
        parts.append(f"[{first.unit}]")
    if first.sign != "none":
        parts.append(f"+ {first.sign}.")
    return " ".join(parts)


def message_slot(message: Message, position: int) -> Slot:
    """The slot that holds the wire value at `position`, arrays counted one by one."""
    for slot in message.slots:
        if position < slot.count:
            return slot
        position -= slot.count
    raise IndexError(position)


def declared(slot: Slot) -> str:
    """The field's name as it is declared, with its array size."""
    if slot.type in TEXT_TYPES:
        return f"{slot.name}[{TYPE_SIZES[slot.type]}]"
    return f"{slot.name}[{slot.count}]" if slot.count > 1 else slot.name


def _has_struct(command: Message) -> bool:
    """Whether the command has a structure; not those that set a parameter, which the parameter table handles."""
    return command.size > 0 and not command.parameter


def _size_table(what: str, prefix: str, messages: Iterable[Message]) -> list[str]:
    """The function protocol_<what>_size as a switch over the known types."""
    lines = [f"int32_t protocol_{what}_size(const uint32_t id)", "{", "    switch (id)", "    {"]
    sizes: dict[int, list[Message]] = {}
    for message in messages:
        sizes.setdefault(message.size, []).append(message)
    for size, group in sorted(sizes.items()):
        lines += [f"    case {prefix}_{message.name.upper()}_ID:" for message in group]
        lines.append(f"        return {size};")
    return [*lines, "    default:", "        return -1;", "    }", "}", ""]


def _float(number: float) -> str:
    return f"{float(number)!r}f"


def _word(four: bytes) -> str:
    return f"0x{int.from_bytes(four, 'little'):08X}u"


def _text(lines: Iterable[str]) -> str:
    return "\n".join(lines).rstrip("\n") + "\n"
