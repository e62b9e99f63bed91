"""Who has a board's line alone for a while."""

from __future__ import annotations

from typing import Protocol


class ExclusiveUser(Protocol):
    """The exclusive user of the line for a while, with a stream that does not consist of frames (the AHRS test)."""

    def on_bytes(self, data: bytes) -> None:
        """Bytes of the line."""

    def on_line_released(self) -> bytes:
        """End the exclusive use; returns the bytes that bring the board back to text mode."""
