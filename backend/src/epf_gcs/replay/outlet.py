"""What leaves a replay: the newest sample of each topic at the viewer's rate, or every sample while it can follow."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Protocol

from epf_gcs.contract.base import Values
from epf_gcs.contract.events import Event

Sample = tuple[str, float, Values]


class Sink(Protocol):
    """Takes what viewers shall see; the bus's `Broadcast` is one."""

    def sample(self, topic: str, t_s: float, values: Any) -> None:
        """A sample; sent with the next `flush`."""

    def flush(self) -> None:
        """Send the samples."""

    def event(self, event: Event, /) -> None:
        """Something happened."""


class ReplayOutlet:
    """Implements `epf_gcs.vehicle.outside.Outlet`. Silent until `is_open`; `every`: no sample is left out."""

    def __init__(self, sink: Sink) -> None:
        self._sink = sink
        self._newest: dict[str, Sample] = {}
        self._all: list[Sample] = []
        self.is_open = False
        self.every = False
        # Samples given away that the viewer has not been sent yet; only counted with `every`.
        self.under_way = 0

    @property
    def waiting(self) -> int:
        """Samples that the next `give` sends."""
        return len(self._all)

    def sample(self, topic: str, t_s: float, values: Values) -> None:
        """Keep a sample until the next `give`."""
        if not self.is_open:
            return
        if self.every:
            self._all.append((topic, t_s, values))
        else:
            self._newest[topic] = (topic, t_s, values)

    def flush(self) -> None:
        """Nothing: the replay's own pace says when samples are given."""

    def event(self, event: Event, /) -> None:
        """Pass it on, after the samples before it."""
        if self.is_open:
            self.give()
            self._sink.event(event)

    def later(self, decode: Callable[[], None]) -> bool:
        """A replay decodes at the moment that it has reached."""
        return False

    def give(self) -> None:
        """Send what was kept, in the order of its time."""
        samples = self._all or sorted(self._newest.values(), key=_time)
        if not samples:
            return
        for sample in samples:
            self._sink.sample(*sample)
        if self.every:
            self.under_way += len(samples)
        self._sink.flush()
        self.drop()

    def drop(self) -> None:
        """Forget what was kept: the replay is at another moment."""
        self._newest = {}
        self._all = []


class Silence:
    """An outlet of nothing, for the vehicle that only makes key frames."""

    def sample(self, topic: str, t_s: float, values: Values) -> None:
        """Nothing."""

    def flush(self) -> None:
        """Nothing."""

    def event(self, event: Event, /) -> None:
        """Nothing."""

    def later(self, decode: Callable[[], None]) -> bool:
        """A key frame may be made at any moment."""
        return False


def _time(sample: Sample) -> float:
    return sample[1]
