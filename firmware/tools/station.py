"""Frames for programs that talk to a board, built and found by the definition in protocol/ alone."""

from __future__ import annotations

import struct
import sys
from pathlib import Path

PROTOCOL = Path(__file__).resolve().parents[2] / "protocol"
sys.path.insert(0, str(PROTOCOL))

from generator.load import load  # noqa: E402 (the path to it stands above)

DEFINITION = load(PROTOCOL / "definition")
FRAME = DEFINITION.frame
COMMANDS = {command.name: command for command in DEFINITION.commands}
MESSAGES = {message.id: message for message in DEFINITION.messages}
OPEN_BINARY_MODE = FRAME.open_binary_mode.encode("ascii")


def checksum(body: bytes) -> int:
    """Return the number that makes the sum of all 32-bit words of type and payload 0."""
    return -sum(struct.unpack(f"<{len(body) // 4}I", body)) & 0xFFFFFFFF


def command_bytes(name: str, *values: float) -> bytes:
    """Return the frame of a command, its values in the order of the wire."""
    command = COMMANDS[name]
    body = struct.pack("<I", command.id) + struct.pack(command.struct_format, *values)
    return FRAME.to_board_header + body + struct.pack("<I", checksum(body)) + FRAME.end


class Listener:
    """Finds frames in the bytes that a board sends, in chunks of any size."""

    def __init__(self) -> None:
        self._held = b""

    def feed(self, chunk: bytes) -> list[str]:
        """Return the names of the frames that are complete now; damaged ones and text are skipped."""
        self._held += chunk
        names = []
        while (start := self._held.find(FRAME.to_pc_header)) >= 0:
            self._held = self._held[start:]
            body_at = len(FRAME.to_pc_header)
            if len(self._held) < body_at + 4:
                return names
            (word,) = struct.unpack_from("<I", self._held, body_at)
            message = MESSAGES.get(word ^ (1 << FRAME.to_pc_type_bit))
            size = body_at + 4 + (message.size if message else 0) + 4 + len(FRAME.end)
            if message and len(self._held) < size:
                return names
            body = self._held[body_at : size - 4 - len(FRAME.end)]
            tail = struct.pack("<I", checksum(body)) + FRAME.end
            if message and self._held[:size].endswith(tail):
                names.append(message.name)
                self._held = self._held[size:]
            else:
                self._held = self._held[body_at:]
        self._held = self._held[-len(FRAME.to_pc_header) + 1 :]
        return names
