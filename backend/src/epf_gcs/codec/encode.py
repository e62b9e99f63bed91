"""Messages -> bytes."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

from epf_gcs.codec.checksum import checksum
from epf_gcs.codec.frame import FROM_BOARD, TO_BOARD, Direction
from epf_gcs.codec.messages_gen import COMMANDS, END, TELEMETRY_BY_NAME
from epf_gcs.codec.tables import Message
from epf_gcs.codec.values import argument_fault


def frame_bytes(direction: Direction, message: Message, payload: bytes) -> bytes:
    """Wrap a payload into a frame of this direction. Its length is not checked against the message."""
    body = (direction.type_bit | message.id).to_bytes(4, "little") + payload
    return direction.header + body + checksum(body).to_bytes(4, "little") + END


def encode_command(name: str, *values: float) -> bytes:
    """Frame of a command. Raises ValueError for a wrong number of values or one outside its range."""
    command = COMMANDS[name]
    if len(values) != len(command.values):
        raise ValueError(f"{name} takes {len(command.values)} values, not {len(values)}")
    faults = [
        fault
        for value, given in zip(command.values, values, strict=True)
        if (fault := argument_fault(value, given)) is not None
    ]
    if faults:
        raise ValueError(f"{name}: {'; '.join(faults)}")
    return frame_bytes(TO_BOARD, command, command.struct.pack(*values))


def encode_telemetry(name: str, *values: float | bytes) -> bytes:
    """Frame as a board would send it, from raw wire values (see `Value.encoding`), which are not checked."""
    message = TELEMETRY_BY_NAME[name]
    return frame_bytes(FROM_BOARD, message, message.struct.pack(*values))


EMPTY_COMMANDS: Final[Mapping[str, bytes]] = {
    command.name: frame_bytes(TO_BOARD, command, b"") for command in COMMANDS.values() if not command.size
}
"""The frames of all commands without arguments, made once."""
