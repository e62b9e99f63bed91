"""The frames of the last release: ids, types and order of fields that must not change, for stations are deployed."""

from __future__ import annotations

import json
from typing import Any

from .model import Definition, Message


def snapshot(definition: Definition) -> dict[str, Any]:
    """What a peer depends on: each frame's id, and the type, name and order of its fields."""
    return {
        "to_pc": {message.name: _wire(message) for message in definition.messages},
        "to_board": {command.name: _wire(command) for command in definition.commands},
    }


def text(definition: Definition) -> str:
    """The snapshot as the file protocol/released.json."""
    return json.dumps(snapshot(definition), indent=1) + "\n"


def breaks(definition: Definition, released: dict[str, Any]) -> list[str]:
    """One sentence for each released frame that changed or is missing; new frames are allowed."""
    present = snapshot(definition)
    found = []
    for direction, frames in released.items():
        for name, wire in frames.items():
            now = present[direction].get(name)
            if now is None:
                found.append(f"{direction} {name} was released and is gone")
            elif now != wire:
                found.append(f"{direction} {name} was released as {wire} and is now {now}")
    return found


def _wire(message: Message) -> dict[str, Any]:
    fields = [f"{slot.type} {slot.name}" + (f" x {slot.count}" if slot.count > 1 else "") for slot in message.slots]
    return {"id": message.id, "fields": fields}
