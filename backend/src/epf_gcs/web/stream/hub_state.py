"""The newest value of every topic, as text that all viewers share."""

from __future__ import annotations

from collections import deque
from collections.abc import Mapping
from dataclasses import dataclass
from itertools import islice
from typing import Final

import orjson

from epf_gcs.contract.base import Values

# Half a second of the fastest line. A viewer of every sample that is further behind gets the number it missed.
_LOG_SAMPLES: Final = 256


@dataclass(slots=True)
class Newest:
    """The newest sample of a topic. `text` is JSON as viewers get it: {"topic": ..., "t_s": ..., "values": {...}}."""

    t_s: float
    text: bytes
    version: int
    _values: Values | None = None

    @property
    def values(self) -> Values:
        """The values, parsed from the text at the first use."""
        if self._values is None:
            values: Values = orjson.loads(self.text)["values"]
            self._values = values
            return values
        return self._values


class HubState:
    """Numbers every sample with a version, so that one number tells what a viewer has been sent."""

    def __init__(self, log_samples: int = _LOG_SAMPLES) -> None:
        self.version = 0
        self.newest_s = 0.0
        self.keep_all = False
        self._newest: dict[str, Newest] = {}
        self._log: deque[Newest] = deque(maxlen=log_samples)
        self._bodies: dict[int, bytes] = {}

    def put(self, topic: str, t_s: float, text: bytes) -> Newest:
        """Take a new sample, in place of the topic's old one."""
        self.version += 1
        sample = Newest(t_s, text, self.version)
        self._newest[topic] = sample
        self.newest_s = t_s
        if self.keep_all:
            self._log.append(sample)
        if self._bodies:
            self._bodies.clear()
        return sample

    def clear(self) -> None:
        """Forget all samples: those that follow are of another moment."""
        self._newest.clear()
        self._log.clear()
        self._bodies.clear()
        self.newest_s = 0.0

    def drop_log(self) -> None:
        """Stop keeping every sample: no viewer wants them."""
        self.keep_all = False
        self._log.clear()

    def samples(self) -> Mapping[str, Newest]:
        """The newest sample of each topic received so far."""
        return self._newest

    def changed_since(self, version: int) -> bytes:
        """JSON of the newest sample of each topic that changed after `version`, separated by commas."""
        body = self._bodies.get(version)
        if body is None:
            changed = [sample.text for sample in self._newest.values() if sample.version > version]
            body = self._bodies[version] = b",".join(changed)
        return body

    def every_since(self, version: int) -> tuple[bytes, int]:
        """JSON of every sample after `version` that is still kept, and the number of those that are not."""
        wanted = self.version - version
        kept = len(self._log)
        if wanted == 1 and kept:
            return self._log[-1].text, 0
        samples = islice(self._log, max(0, kept - wanted), kept)
        return b",".join(sample.text for sample in samples), max(0, wanted - kept)
