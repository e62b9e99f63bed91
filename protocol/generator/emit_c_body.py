"""The bodies of the C pack and unpack functions: bytes one at a time, no buffer is ever cast to a structure."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from .model import TEXT_TYPES, TYPE_SIZES, Message, Slot

HELPERS = """\
uint16_t protocol_get_u16(const uint8_t* const in)
{
    return (uint16_t)((uint32_t)in[0] | ((uint32_t)in[1] << 8));
}

uint32_t protocol_get_u32(const uint8_t* const in)
{
    return (uint32_t)in[0] | ((uint32_t)in[1] << 8) | ((uint32_t)in[2] << 16) | ((uint32_t)in[3] << 24);
}

int32_t protocol_get_i32(const uint8_t* const in)
{
    return (int32_t)protocol_get_u32(in);
}

float protocol_get_f32(const uint8_t* const in)
{
    const uint32_t bits = protocol_get_u32(in);
    float value;
    memcpy(&value, &bits, sizeof value);
    return value;
}

double protocol_get_f64(const uint8_t* const in)
{
    const uint64_t bits = (uint64_t)protocol_get_u32(in) | ((uint64_t)protocol_get_u32(in + 4) << 32);
    double value;
    memcpy(&value, &bits, sizeof value);
    return value;
}

void protocol_put_u16(uint8_t* const out, const uint16_t value)
{
    out[0] = (uint8_t)(value & 0xFFu);
    out[1] = (uint8_t)(value >> 8);
}

void protocol_put_u32(uint8_t* const out, const uint32_t value)
{
    out[0] = (uint8_t)(value & 0xFFu);
    out[1] = (uint8_t)((value >> 8) & 0xFFu);
    out[2] = (uint8_t)((value >> 16) & 0xFFu);
    out[3] = (uint8_t)(value >> 24);
}

void protocol_put_i32(uint8_t* const out, const int32_t value)
{
    protocol_put_u32(out, (uint32_t)value);
}

void protocol_put_f32(uint8_t* const out, const float value)
{
    uint32_t bits;
    memcpy(&bits, &value, sizeof bits);
    protocol_put_u32(out, bits);
}

void protocol_put_f64(uint8_t* const out, const double value)
{
    uint64_t bits;
    memcpy(&bits, &value, sizeof bits);
    protocol_put_u32(out, (uint32_t)(bits & 0xFFFFFFFFu));
    protocol_put_u32(out + 4, (uint32_t)(bits >> 32));
}
"""

PUT = {
    "i8": "payload[{at}] = (uint8_t)values->{name};",
    "i16": "protocol_put_u16(payload + {at}, (uint16_t)values->{name});",
    "i32": "protocol_put_i32(payload + {at}, values->{name});",
    "u32": "protocol_put_u32(payload + {at}, values->{name});",
    "f32": "protocol_put_f32(payload + {at}, values->{name});",
    "f64": "protocol_put_f64(payload + {at}, values->{name});",
    **{text: f"memcpy(payload + {{at}}, values->{{name}}, {TYPE_SIZES[text]});" for text in sorted(TEXT_TYPES)},
}
GET = {
    "i8": "values->{name} = (int8_t)payload[{at}];",
    "i16": "values->{name} = (int16_t)protocol_get_u16(payload + {at});",
    "i32": "values->{name} = protocol_get_i32(payload + {at});",
    "u32": "values->{name} = protocol_get_u32(payload + {at});",
    "f32": "values->{name} = protocol_get_f32(payload + {at});",
    "f64": "values->{name} = protocol_get_f64(payload + {at});",
    **{text: f"memcpy(values->{{name}}, payload + {{at}}, {TYPE_SIZES[text]});" for text in sorted(TEXT_TYPES)},
}


def packers(messages: Iterable[tuple[str, Message]]) -> list[str]:
    """Helpers, then both functions of each (prefix, message)."""
    lines = [*HELPERS.splitlines(), ""]
    for prefix, message in messages:
        name = f"{prefix}_{message.name}"
        lines += [f"void {name}_pack(const {name}_t* const values, uint8_t* const payload)", "{"]
        lines += [f"    {line}" for line in _statements(message, PUT)]
        lines += ["}", "", f"void {name}_unpack({name}_t* const values, const uint8_t* const payload)", "{"]
        lines += [f"    {line}" for line in _statements(message, GET)]
        lines += ["}", ""]
    return lines


def _statements(message: Message, templates: dict[str, str]) -> Iterator[str]:
    at = 0
    for slot in message.slots:
        yield from _statement(slot, templates[slot.type], at)
        at += slot.size


def _statement(slot: Slot, template: str, at: int) -> Iterator[str]:
    if slot.count == 1:
        yield template.format(at=at, name=slot.name)
        return
    offset = f"{at}u + {TYPE_SIZES[slot.type]}u * i" if at else f"{TYPE_SIZES[slot.type]}u * i"
    yield f"for (uint32_t i = 0; i < {slot.count}u; i++)"
    yield "{"
    yield "    " + template.format(at=offset, name=f"{slot.name}[i]")
    yield "}"
