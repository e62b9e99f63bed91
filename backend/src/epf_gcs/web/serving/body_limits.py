"""How large the bodies of requests may be."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class BodyLimits:
    """The largest body in bytes. `longer`: of paths whose routes take files. `streamed`: paths whose routes read the
    body themselves and limit it."""

    most_bytes: int
    longer: Mapping[str, int]
    streamed: frozenset[str]
