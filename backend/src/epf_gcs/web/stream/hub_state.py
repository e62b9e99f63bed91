"""The newest value of every topic, serialised at most once for all viewers."""

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
    """The newest sample of a topic; `text` is its JSON once somebody needed it."""

    topic: str
    t_s: float
    values: Values
    version: int
    text: bytes | None = None

    def json(self) -> bytes:
        """{"topic": ..., "t_s": ..., "values": {...}}, made once."""
        if self.text is None:
            self.text = b'{"topic":"%b","t_s":%.6f,"values":%b}' % (
                self.topic.encode(),
                self.t_s,
                orjson.dumps(self.values),
            )
        return self.text


class HubState:
    """Counts every sample with a version, so that each viewer knows by one number what it has seen."""

    def __init__(self) -> None:
        self.version = 0
        self.newest_s = 0.0
        self.keep_all = False
        self._newest: dict[str, Newest] = {}
        self._log: deque[Newest] = deque(maxlen=_LOG_SAMPLES)
        self._bodies: dict[int, bytes] = {}

    def put(self, topic: str, t_s: float, values: Values) -> None:
        """Take a new sample; the old one of this topic is forgotten."""
        self.version += 1
        sample = Newest(topic, t_s, values, self.version)
        self._newest[topic] = sample
        self.newest_s = t_s
        if self.keep_all:
            self._log.append(sample)
        if self._bodies:
            self._bodies.clear()

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
            changed = [sample.json() for sample in self._newest.values() if sample.version > version]
            body = self._bodies[version] = b",".join(changed)
        return body

    def every_since(self, version: int) -> tuple[bytes, int]:
        """JSON of every sample after `version`, and how many more there were than are still kept."""
        wanted = self.version - version
        kept = len(self._log)
        if wanted == 1 and kept:
            return self._log[-1].json(), 0
        samples = islice(self._log, max(0, kept - wanted), kept)
        return b",".join(sample.json() for sample in samples), max(0, wanted - kept)
