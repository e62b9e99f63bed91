"""How much each line brought in each second of the flight, and where the board's line was silent while it was open."""

from __future__ import annotations

from typing import Final

import numpy as np
import pyarrow as pa
from numpy.typing import NDArray

from epf_gcs.flights.convert import T_NS
from epf_gcs.recordings.topics import BOARD_RECEIVED, TOPICS

GAP_NS: Final = 1_000_000_000
_NS_PER_S: Final = 1_000_000_000
_NAMES: Final = {channel: f"{topic.replace('/', '_')}_bytes" for channel, topic in TOPICS.items()}
SCHEMA: Final = pa.schema([T_NS, *(pa.field(name, pa.int64(), metadata={"unit": "byte"}) for name in _NAMES.values())])


class Rates:
    """Told all messages in file order. `gaps`: from and to, Unix ns."""

    def __init__(self) -> None:
        self.gaps: list[tuple[int, int]] = []
        self._seconds: dict[int, dict[int, int]] = {}
        self._heard_ns: int | None = None

    def line_changed(self, *, is_open: bool, t_ns: int) -> None:
        """The board's line was opened or closed: silence counts from its opening."""
        self._heard_ns = t_ns if is_open else None

    def heard(self, channel: int, t_ns: NDArray[np.int64], length: NDArray[np.int64]) -> None:
        """Messages of one channel: times and sizes, both (n,) and not empty."""
        seconds = t_ns // _NS_PER_S
        first = int(seconds.min())
        if int(seconds.max()) - first < 10 * len(t_ns):
            sums = np.bincount(seconds - first, weights=length)
            for second in np.flatnonzero(sums).tolist():
                self._add(channel, first + second, int(sums[second]))
        else:  # a clock that jumped: as many entries as messages, not as seconds
            for second, size in zip(seconds.tolist(), length.tolist(), strict=True):
                self._add(channel, second, size)
        if channel != BOARD_RECEIVED:
            return
        known = t_ns if self._heard_ns is None else np.concatenate(([self._heard_ns], t_ns))
        for place in np.flatnonzero(np.diff(known) > GAP_NS).tolist():
            self.gaps.append((int(known[place]), int(known[place + 1])))
        self._heard_ns = int(t_ns[-1])

    def table(self) -> pa.Table:
        """Bytes of each direction by second; `t_ns` is the second's beginning."""
        seconds = sorted(self._seconds)
        columns = [
            pa.array([self._seconds[second].get(channel, 0) for second in seconds], pa.int64()) for channel in _NAMES
        ]
        return pa.Table.from_arrays(
            [pa.array([second * _NS_PER_S for second in seconds], pa.int64()), *columns], schema=SCHEMA
        )

    def _add(self, channel: int, second: int, size: int) -> None:
        sums = self._seconds.setdefault(second, {})
        sums[channel] = sums.get(channel, 0) + size
