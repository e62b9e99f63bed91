"""How a part says that something has happened, without knowing who listens."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Protocol


class Say(Protocol):
    """Send an event to every page: its kind and its plain values."""

    def __call__(self, kind: str, data: Mapping[str, Any], /) -> None:
        """Say it now."""
