"""Model -> protocol/REFERENCE.md: the printed tables for people."""

from __future__ import annotations

from collections.abc import Iterator

from .model import Confirm, Definition, Message, Slot, Value

NOTICE = (
    "<!-- Made by protocol/generator (emit_markdown.py). "
    "Do not edit: change protocol/definition and run `make generate`. -->"
)


def reference(definition: Definition) -> str:
    """The whole page."""
    return "\n".join(_page(definition)).rstrip("\n") + "\n"


def _page(definition: Definition) -> Iterator[str]:
    yield NOTICE
    yield "# Protocol reference"
    yield ""
    yield "Frame, checksum and session are in [README.md](README.md). All values are little-endian."
    yield 'Range is what is plausible: outside it a value is "no data" and is counted.'
    yield ""
    yield "## Board to PC"
    for message in definition.messages:
        yield from _message(message)
    yield from _commands(definition)
    yield from _parameters(definition)
    yield from _rows(definition)
    yield from _routes(definition)


def _commands(definition: Definition) -> Iterator[str]:
    yield ""
    yield "## PC to board"
    yield ""
    yield "Proof is what shows that a command was done on a board which does not acknowledge."
    yield ""
    yield "| type | name | payload bytes | meaning | proof |"
    yield "|---|---|---|---|---|"
    for command in definition.commands:
        proof = _proof(command.confirm or Confirm("none"))
        yield f"| {_id(command)} | {command.name} | {command.size} | {_cell(command.doc)} | {proof} |"
    yield ""
    unused = ", ".join(str(number) for number in definition.unused_command_ids)
    yield f"Types {unused} are unused by deployed boards and stay unused."
    for command in definition.commands:
        if command.values and not command.parameter:
            yield from _message(command)


def _parameters(definition: Definition) -> Iterator[str]:
    yield ""
    yield "## Parameters"
    yield ""
    yield "In the order of autopilot_parameters."
    yield ""
    yield "| parameter | group | set by | type | default | minimum | maximum | step | meaning |"
    yield "|---|---|---|---|---|---|---|---|---|"
    for p in definition.parameters:
        numbers = " | ".join(_number(number) for number in (p.default, p.minimum, p.maximum, p.step))
        yield f"| {p.name} | {p.group} | {p.set_id} | {p.type} | {numbers} | {_cell(p.doc)} |"


def _rows(definition: Definition) -> Iterator[str]:
    yield ""
    yield "## Simulator rows"
    for profile in definition.datagram.profiles:
        yield ""
        yield f"### Profile {profile}"
        yield ""
        yield "| row | index | name | unit | range | positive | meaning |"
        yield "|---|---|---|---|---|---|---|"
        for row in definition.rows:
            title = f"{row.id} {row.name}" + (" (also sent)" if row.sent else "")
            for value in row.profiles[profile]:
                span = f"{_number(value.minimum)}..{_number(value.maximum)}"
                yield (
                    f"| {title} | {value.index} | {value.name} | {value.unit} | {span} | {value.sign} | "
                    f"{_cell(value.doc)} |"
                )


def _routes(definition: Definition) -> Iterator[str]:
    yield ""
    yield "## Routes"
    for route in definition.routes:
        yield ""
        after = "loop" if route.loop else "hold the last waypoint"
        yield f"### {route.plan_name} {route.title} (command {route.load_id}, then {after})"
        yield ""
        yield route.doc
        yield ""
        yield "| waypoint | latitude deg | longitude deg | altitude ft | speed kt |"
        yield "|---|---|---|---|---|"
        for index, w in enumerate(route.waypoints):
            yield f"| {index} | {w.latitude_deg:.4f} | {w.longitude_deg:.4f} | {w.altitude_ft:g} | {w.speed_kt:g} |"


def _message(message: Message) -> Iterator[str]:
    kind = "extension, " if message.extension else ""
    yield ""
    yield f"### {_id(message)} {message.name}"
    yield ""
    yield f"{message.doc} ({kind}{message.size} bytes; source: {message.source})"
    yield ""
    yield "| offset | type | value | unit | range | positive | meaning |"
    yield "|---|---|---|---|---|---|---|"
    position = 0
    offset = 0
    for slot in message.slots:
        size = slot.size // slot.count
        for i in range(slot.count):
            for value in message.values:
                if value.slot == position:
                    yield _row(offset + i * size, slot, value)
            position += 1
        offset += slot.size


def _row(offset: int, slot: Slot, value: Value) -> str:
    span = ""
    if value.minimum is not None and value.maximum is not None and value.kind != "boolean":
        span = f"{_number(value.minimum)}..{_number(value.maximum)}"
    doc = value.doc
    if value.bit is not None:
        doc = f"Bit {value.bit}: {doc}"
    if value.names:
        doc += " " + ", ".join(f"{number} {name}" for name, number in value.names.items()) + "."
    if value.absent is not None:
        doc += f" {'NaN' if value.absent != value.absent else value.absent}: no data."
    return f"| {offset} | {slot.type} | {value.name} | {value.unit} | {span} | {value.sign} | {_cell(doc)} |"


def _proof(confirm: Confirm) -> str:
    if confirm.by == "heartbeat":
        flags = ", ".join(f"{name} = {str(value).lower()}" for name, value in confirm.flags.items())
        return f"heartbeat: {flags}"
    if confirm.by == "frame":
        return f"frame {confirm.message}"
    if confirm.by == "plan":
        return f"{confirm.message}: {confirm.move} waypoint"
    return {"read_back": "read back", "none": "none"}[confirm.by]


def _id(message: Message) -> str:
    return f"0x{message.id:X}" if message.extension else str(message.id)


def _number(number: float) -> str:
    """Enough digits for any 32-bit value, without trailing zeros."""
    return f"{number:.10g}"


def _cell(text: str) -> str:
    return text.replace("|", "\\|")
