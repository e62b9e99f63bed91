"""Figures of the web process itself and of the disk, in addition to the flight's status."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field


@dataclass(frozen=True)
class Disk:
    """Of the data folder."""

    free_bytes: int
    total_bytes: int


@dataclass(frozen=True)
class WebFigures:
    """`answers`: number of answers by HTTP status. `refused`: connections and sockets over the limits, by kind."""

    answers: Mapping[int, int] = field(default_factory=dict)
    connections: int = 0
    sockets: int = 0
    refused: Mapping[str, int] = field(default_factory=dict)
