"""The newest value of every topic, as text that all viewers share."""

from __future__ import annotations

from collections import deque
from collections.abc import Mapping
from dataclasses import dataclass
from itertools import islice
from typing import Any, Final

import orjson

# Half a second of the fastest line. A viewer of every sample that is further behind is told how many it missed.
_LOG_SAMPLES: Final = 256

Values = Mapping[str, Any]


@dataclass(slots=True)
class Newest:
    """The newest sample of a topic. `text` is JSON as viewers get it: {"topic": ..., "t_s": ..., "values": {...}}."""

    t_s: float
    text: bytes
    version: int
    _values: Values | None = None

    @property
    def values(self) -> Values:
        """The values, read from the text once somebody needs them."""
        if self._values is None:
            values: Values = orjson.loads(self.text)["values"]
            self._values = values
            return values
        return self._values


class HubState:
    """Counts every sample with a version, so that each viewer knows by one number what it has seen."""

    def __init__(self) -> None:
        self.version = 0
        self.newest_s = 0.0
        self.keep_all = False
        self._newest: dict[str, Newest] = {}
        self._log: deque[Newest] = deque(maxlen=_LOG_SAMPLES)
        self._bodies: dict[int, bytes] = {}

    def put(self, topic: str, t_s: float, text: bytes) -> Newest:
        """Take a new sample; the old one of this topic is forgotten."""
        self.version += 1
        sample = Newest(t_s, text, self.version)
        self._newest[topic] = sample
        self.newest_s = t_s
        if self.keep_all:
            self._log.append(sample)
        if self._bodies:
            self._bodies.clear()
        return sample

    def drop_log(self) -> None:
        """Nobody wants every sample any more."""
        self.keep_all = False
        self._log.clear()

    def samples(self) -> Mapping[str, Newest]:
        """All topics heard so far."""
        return self._newest

    def changed_since(self, version: int) -> bytes:
        """JSON of the newest sample of each topic that changed after `version`, separated by commas."""
        body = self._bodies.get(version)
        if body is None:
            changed = [sample.text for sample in self._newest.values() if sample.version > version]
            body = self._bodies[version] = b",".join(changed)
        return body

    def every_since(self, version: int) -> tuple[bytes, int]:
        """JSON of every sample after `version`, and how many more there were than are still kept."""
        wanted = self.version - version
        kept = len(self._log)
        if wanted == 1 and kept:
            return self._log[-1].text, 0
        samples = islice(self._log, max(0, kept - wanted), kept)
        return b",".join(sample.text for sample in samples), max(0, wanted - kept)
