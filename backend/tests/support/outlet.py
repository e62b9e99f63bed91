"""An outlet that keeps everything sent to it."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

from epf_gcs.contract.events import Event
from tests.support.contract import as_told


class KeptOutlet:
    """Implements `epf_gcs.vehicle.outside.Outlet`."""

    def __init__(self) -> None:
        self.samples: list[tuple[str, float, Mapping[str, Any]]] = []
        self.events: list[Any] = []
        self.flushed = 0
        # What decodes the frames that wait; with `is_lazy` they wait until a test or a reader decodes them.
        self.is_lazy = False
        self.decode: Callable[[], None] | None = None

    def sample(self, topic: str, t_s: float, values: Mapping[str, Any]) -> None:
        self.samples.append((topic, t_s, values))

    def flush(self) -> None:
        self.flushed += 1

    def event(self, event: Event, /) -> None:
        self.events.append(as_told(event))

    def later(self, decode: Callable[[], None]) -> bool:
        self.decode = decode
        return self.is_lazy
