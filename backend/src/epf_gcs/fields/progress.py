"""How far the fetching is: counts, rate and time left, told a few times a second."""

from __future__ import annotations

import time
from collections import deque
from collections.abc import Callable
from typing import Final

from epf_gcs.contract.flights import Fault
from epf_gcs.errors import GatewayError
from epf_gcs.fields.order import Kind, Order, estimate, made_bytes, mean_bytes
from epf_gcs.fields.part_file import PartFile, TileCounts
from epf_gcs.fields.work import FieldProgress
from epf_gcs.repeating import repeat

_TELL_EVERY_S: Final = 0.25
_RATE_OVER_S: Final = 20.0


class Progress:
    """Of one run; what arrived in earlier runs counts, but not for the rate."""

    def __init__(self, order: Order, arrived: PartFile, say: Callable[[FieldProgress], None]) -> None:
        self._say = say
        self._arrived: dict[Kind, TileCounts] = {part.kind: arrived.arrived(part.kind) for part in order.parts}
        self._total: dict[Kind, int] = dict.fromkeys(self._arrived, 0)
        for level in estimate(order):
            self._total[level.kind] += level.tiles
        self._mean: dict[Kind, float] = {part.kind: mean_bytes(part) for part in order.parts}
        self._made_bytes = made_bytes(order)
        self._marks: deque[tuple[float, int, int]] = deque()
        self._problem: GatewayError | None = None
        self._wait_until_s = 0.0
        self._retries = 0
        self._told_s = 0.0
        self.tell(now=True)

    def came(self, kind: Kind, length: int) -> None:
        """A piece arrived; length 0: the source has none there."""
        before = self._arrived[kind]
        self._arrived[kind] = TileCounts(before.pieces + 1, before.missing + (length == 0), before.bytes + length)
        self.tell()

    def waits(self, problem: GatewayError | None, wait_s: float) -> None:
        """Why nothing comes for so many seconds; None: something came again."""
        had = self._problem
        self._problem = problem
        self._wait_until_s = time.monotonic() + wait_s
        if problem is not None:
            self._retries += 1
        self.tell(now=(had is None) != (problem is None))

    async def run(self) -> None:
        """Tell it again and again, until cancelled."""
        await repeat(_TELL_EVERY_S, "the progress of a field", self.tell, at_once=True)

    def tell(self, *, now: bool = False) -> None:
        """Say it, unless that was a moment ago."""
        at_s = time.monotonic()
        if not now and at_s - self._told_s < _TELL_EVERY_S:
            return
        self._told_s = at_s
        pieces = sum(one.pieces for one in self._arrived.values())
        total_bytes = sum(one.bytes for one in self._arrived.values())
        self._marks.append((at_s, pieces, total_bytes))
        while at_s - self._marks[0][0] > _RATE_OVER_S:
            self._marks.popleft()
        since_s, first_pieces, first_bytes = self._marks[0]
        took_s = max(at_s - since_s, 1e-3)
        left = sum(self._total.values()) - pieces
        coming = pieces - first_pieces
        problem = self._problem
        self._say(
            FieldProgress(
                doing="fetching",
                tiles=pieces,
                tiles_total=sum(self._total.values()),
                tiles_missing=sum(one.missing for one in self._arrived.values()),
                bytes=total_bytes,
                bytes_total=self._expected_bytes(),
                bytes_per_s=round((total_bytes - first_bytes) / took_s),
                left_s=round(left * took_s / coming) if coming > 0 else None,
                retries=self._retries,
                waits_s=None if problem is None else max(0.0, round(self._wait_until_s - at_s, 1)),
                waits_for=None if problem is None else Fault.of(problem),
            )
        )

    def _expected_bytes(self) -> int:
        """With the mean of what arrived in place of the usual one, as soon as there are some pieces."""
        expected = 0.0
        for kind, arrived in self._arrived.items():
            mean = arrived.bytes / arrived.pieces if arrived.pieces >= 5 else self._mean[kind]
            expected += arrived.bytes + max(0, self._total[kind] - arrived.pieces) * mean
        return round(expected) + self._made_bytes
