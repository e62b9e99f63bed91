"""What a key frame keeps of a board."""

from __future__ import annotations

from typing import Any, NamedTuple


class BoardState(NamedTuple):
    """What the next bytes are decoded by, and all counts; of bytes and damage also those at the last tick or link."""

    session: list[Any]
    decoder: list[Any]
    was_open: bool
    frames: int
    bytes_in: tuple[int, int]
    damage: tuple[dict[str, int], dict[str, int]]
    statistics: list[Any]
