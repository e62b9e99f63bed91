"""How large the bodies of requests may be."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class BodyLimits:
    """The largest body in bytes. `longer`: of paths whose routes take files. `streamed`: paths whose routes read the
    body themselves and limit it. `strangers_bytes`: of whoever shows no key; a name and a key need less."""

    most_bytes: int
    longer: Mapping[str, int]
    streamed: frozenset[str]
    strangers_bytes: int = 1024

    def of(self, path: str, *, is_strangers: bool) -> int:
        """The largest body that a request for this path may have."""
        return self.strangers_bytes if is_strangers else self.longer.get(path, self.most_bytes)
