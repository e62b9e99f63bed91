"""An outlet that keeps everything sent to it."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any


class KeptOutlet:
    """Implements `epf_gcs.vehicle.outside.Outlet`."""

    def __init__(self) -> None:
        self.samples: list[tuple[str, float, Mapping[str, Any]]] = []
        self.events: list[Any] = []
        self.flushed = 0

    def sample(self, topic: str, t_s: float, values: Mapping[str, Any]) -> None:
        self.samples.append((topic, t_s, values))

    def flush(self) -> None:
        self.flushed += 1

    def event(self, kind: str, data: Mapping[str, Any]) -> None:
        self.events.append((kind, data))
