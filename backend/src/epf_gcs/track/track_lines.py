"""The unbroken lines of a flown track at one moment, unpacked block by block in any thread."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Final

import numpy as np

from epf_gcs.formats.kml import Position
from epf_gcs.formats.samples import Samples
from epf_gcs.track.track import ATTITUDE, POINT, UNKNOWN_HEADING, Block, Track

_DEG: Final = 1e-7


@dataclass(frozen=True, slots=True)
class Line:
    """The chosen points of one line, unpacked a block at a time; immutable, and may be iterated repeatedly."""

    blocks: list[Block]
    block_points: int
    t0_s: float
    chosen: range

    def positions(self) -> Iterator[Position]:
        """Latitude, longitude and altitude of each point."""
        for samples in self:
            yield from zip(
                samples.latitude_deg.tolist(), samples.longitude_deg.tolist(), samples.altitude_m.tolist(), strict=True
            )

    def __iter__(self) -> Iterator[Samples]:
        first = self.chosen.start // self.block_points
        last = self.chosen[-1] // self.block_points
        for number in range(first, last + 1):
            base = number * self.block_points
            ahead = base - self.chosen.start
            begin = self.chosen.start if ahead <= 0 else base + -ahead % self.chosen.step
            part = slice(begin - base, self.chosen.stop - base, self.chosen.step)
            yield _samples(self.blocks[number], self.t0_s, part)

    def span_s(self) -> tuple[float, float]:
        """Unix time of the first and of the last chosen point."""
        return self._t_s(self.chosen[0]), self._t_s(self.chosen[-1])

    def last(self) -> Samples:
        """Only the newest chosen point."""
        block, place = divmod(self.chosen[-1], self.block_points)
        return _samples(self.blocks[block], self.t0_s, slice(place, place + 1))

    def _t_s(self, index: int) -> float:
        block, place = divmod(index, self.block_points)
        return self.t0_s + float(np.frombuffer(self.blocks[block].points, POINT)["t_ms"][place]) * 1e-3


def lines_of(track: Track, most_points: int | None = None, since_s: float = -math.inf) -> list[Line]:
    """Each unbroken line of two points or more, from `since_s` (Unix time) on.

    With `most_points` the lines are thinned evenly; the newest point of each line always stays.
    """
    spans = track.spans(since_s)
    total = sum(end - start for start, end in spans)
    step = 1 if most_points is None else max(1, math.ceil(total / max(1, most_points)))
    blocks = track.blocks()
    return [Line(blocks, track.block_points, track.t0_s, _spread(start, end, step)) for start, end in spans]


def _spread(start: int, end: int, step: int) -> range:
    """Every `step`-th index, counted back from the newest point so that it stays; at least two points."""
    newest_first = range(end - 1, start - 1, -step)
    return newest_first[::-1] if len(newest_first) > 1 else range(start, end, end - 1 - start)


def _samples(block: Block, t0_s: float, part: slice) -> Samples:
    points = np.frombuffer(block.points, POINT)[part]
    attitudes = np.frombuffer(block.attitudes, ATTITUDE)[part]
    unknown = attitudes["heading_cdeg"] == UNKNOWN_HEADING
    return Samples(
        t0_s + points["t_ms"] * 1e-3,
        points["latitude_1e7deg"] * _DEG,
        points["longitude_1e7deg"] * _DEG,
        points["altitude_mm"] * 1e-3,
        *(np.where(unknown, np.nan, attitudes[name] * 1e-2) for name in ("heading_cdeg", "pitch_cdeg", "roll_cdeg")),
        *np.full((2, len(points)), np.nan),
    )
