"""The path an aircraft has flown: every new position with its attitude, for any length of flight in bounded memory.

Points are stored in the format in which they are sent: readers share immutable blocks, and the event loop copies and
formats nothing.
"""

from __future__ import annotations

import math
import struct
from itertools import pairwise
from typing import Final, NamedTuple

import numpy as np

from epf_gcs.earth import M_PER_DEG

MAX_POINTS: Final = 720_000
"""Four hours of a simulator's 50 Hz. Each time the limit is reached, every second point of the older half is dropped;
the newest 360,000 points are always complete."""

Position = tuple[float, float, float]
"""Latitude and longitude in degrees, altitude in metres above mean sea level."""
Attitude = tuple[float, float, float]
"""Heading (0..360, from true north), pitch (nose up positive) and roll (right wing down positive) in degrees."""

POINT: Final = np.dtype(
    [("t_ms", "<u4"), ("latitude_1e7deg", "<i4"), ("longitude_1e7deg", "<i4"), ("altitude_mm", "<i4")]
)
"""One point: milliseconds since the track's `t0_s`, and the position. 1e-7 deg is about a centimetre."""
ATTITUDE: Final = np.dtype([("heading_cdeg", "<u2"), ("pitch_cdeg", "<i2"), ("roll_cdeg", "<i2")])
"""A point's attitude in hundredths of a degree; axes and signs as in `Attitude`."""
UNKNOWN_HEADING: Final = 0xFFFF
"""The heading of a point whose attitude is unknown because its data was stale."""

_POINT: Final = struct.Struct("<Iiii")
_ATTITUDE: Final = struct.Struct("<Hhh")
_NO_ATTITUDE: Final = _ATTITUDE.pack(UNKNOWN_HEADING, 0, 0)
_BLOCK_POINTS: Final = 4096
_MAX_U32: Final = 0xFFFFFFFF
_MAX_I32: Final = 0x7FFFFFFF

# A longer gap between two points interrupts the track: another route was loaded, or the receiver lost its fix.
_LONGEST_GAP_S: Final = 10.0
_FASTEST_M_S: Final = 350.0
_LEAST_JUMP_M: Final = 100.0


class Block(NamedTuple):
    """Consecutive points and their attitudes, packed."""

    points: bytes
    attitudes: bytes


class Track:
    """Positions in the order of time, in several pieces if the track was interrupted.

    `t0_s`: the Unix time that the points' times count from. `epoch` changes whenever points that readers may already
    have are changed or renumbered; a reader that continues by index must then start over.
    """

    def __init__(
        self, t0_s: float = 0.0, epoch: int = 0, max_points: int = MAX_POINTS, block_points: int = _BLOCK_POINTS
    ) -> None:
        self.t0_s = t0_s
        self.epoch = epoch & _MAX_U32
        self._max_points = max_points
        self.block_points = block_points
        self._sealed: list[Block] = []
        self._points = bytearray()
        self._attitudes = bytearray()
        # Index of the first point of each piece.
        self._starts: list[int] = []
        self._last: tuple[float, Position] | None = None

    def __len__(self) -> int:
        return len(self._sealed) * self.block_points + len(self._points) // POINT.itemsize

    @property
    def newest_s(self) -> float | None:
        """Unix time of the newest point; None without one."""
        return None if self._last is None else self._last[0]

    def add(self, t_s: float, position: Position, attitude: Attitude | None = None) -> None:
        """Add a position at this Unix time; an unchanged position adds no point."""
        last = self._last
        if last is not None and position == last[1]:
            return
        if last is None or _is_interrupted(last, t_s, position):
            self._starts.append(len(self))
        self._last = (t_s, position)
        latitude_deg, longitude_deg, altitude_m = position
        self._points += _POINT.pack(
            min(max(0, round((t_s - self.t0_s) * 1000.0)), _MAX_U32),
            _i32(latitude_deg * 1e7),
            _i32(longitude_deg * 1e7),
            _i32(altitude_m * 1000.0),
        )
        self._attitudes += _NO_ATTITUDE if attitude is None else _packed(attitude)
        if len(self._points) >= self.block_points * POINT.itemsize:
            self._seal()

    def append(self, later: Track) -> None:
        """Append a later track, as a separate piece."""
        before = len(self)
        shift_ms = round((later.t0_s - self.t0_s) * 1000.0)
        for block in later.blocks():
            points = np.frombuffer(block.points, POINT).copy()
            points["t_ms"] = np.clip(points["t_ms"].astype(np.int64) + shift_ms, 0, _MAX_U32)
            self._points += points.tobytes()
            self._attitudes += block.attitudes
            while len(self._points) >= self.block_points * POINT.itemsize:
                self._seal()
        self._starts += [before + start for start in later._starts]
        self._last = later._last or self._last
        self._changed()

    def restore(self, points: bytes, attitudes: bytes) -> None:
        """Load packed points of an earlier run into an empty track; the gaps show where its pieces begin."""
        found = np.frombuffer(points, POINT)
        north_m = np.diff(found["latitude_1e7deg"].astype(np.float64)) * 1e-7 * M_PER_DEG
        east_deg = (np.diff(found["longitude_1e7deg"].astype(np.float64)) * 1e-7 + 180.0) % 360.0 - 180.0
        east_m = east_deg * M_PER_DEG * np.cos(np.radians(found["latitude_1e7deg"][:-1] * 1e-7))
        elapsed_s = np.diff(found["t_ms"].astype(np.float64)) * 1e-3
        fastest_m = np.maximum(_LEAST_JUMP_M, _FASTEST_M_S * elapsed_s)
        breaks = (elapsed_s > _LONGEST_GAP_S) | (np.hypot(north_m, east_m) > fastest_m)
        self._starts = [0, *(np.flatnonzero(breaks) + 1).tolist()]
        self._points += points
        self._attitudes += attitudes
        while len(self._points) >= self.block_points * POINT.itemsize:
            self._seal()
        newest = found[-1]
        self._last = (
            self.t0_s + float(newest["t_ms"]) * 1e-3,
            (
                float(newest["latitude_1e7deg"]) * 1e-7,
                float(newest["longitude_1e7deg"]) * 1e-7,
                float(newest["altitude_mm"]) * 1e-3,
            ),
        )

    def blocks(self, after: int = 0) -> list[Block]:
        """All points from this index on; the blocks do not change when the track does."""
        whole, rest = divmod(min(max(0, after), len(self)), self.block_points)
        found = [*self._sealed[whole:], Block(bytes(self._points), bytes(self._attitudes))]
        first = found[0]
        found[0] = Block(first.points[rest * POINT.itemsize :], first.attitudes[rest * ATTITUDE.itemsize :])
        return found

    def spans(self, since_s: float = -math.inf) -> list[tuple[int, int]]:
        """Start and end index (exclusive) of each piece with at least two points, from `since_s` (Unix time) on."""
        first = self._first_since(since_s)
        spans = [(max(start, first), end) for start, end in pairwise((*self._starts, len(self)))]
        return [(start, end) for start, end in spans if end - start > 1]

    def _seal(self) -> None:
        """Turn the newest points into an immutable block."""
        points, attitudes = self.block_points * POINT.itemsize, self.block_points * ATTITUDE.itemsize
        self._sealed.append(Block(bytes(self._points[:points]), bytes(self._attitudes[:attitudes])))
        del self._points[:points]
        del self._attitudes[:attitudes]
        if len(self) + self.block_points > self._max_points:
            self._thin()

    def _thin(self) -> None:
        """Drop every second point of the older half, in whole blocks, for this runs on the event loop."""
        count = len(self._sealed) // 4 * 2
        old, kept = self._sealed[:count], self._sealed[count:]
        self._sealed = [_halved(first, second) for first, second in zip(old[::2], old[1::2], strict=True)] + kept
        half = count * self.block_points
        moved = [(start + 1) // 2 if start < half else start - half // 2 for start in self._starts]
        self._starts = [start for index, start in enumerate(moved) if moved[index + 1 : index + 2] != [start]]
        self._changed()

    def _changed(self) -> None:
        self.epoch = (self.epoch + 1) & _MAX_U32

    def _first_since(self, since_s: float) -> int:
        """Index of the first point at or after `since_s` (Unix time)."""
        since_ms = (since_s - self.t0_s) * 1000.0
        low, high = 0, len(self)
        while low < high:
            middle = (low + high) // 2
            low, high = (middle + 1, high) if self._t_ms(middle) < since_ms else (low, middle)
        return low

    def _t_ms(self, index: int) -> int:
        block, place = divmod(index, self.block_points)
        points = self._points if block == len(self._sealed) else self._sealed[block].points
        return int.from_bytes(points[place * POINT.itemsize : place * POINT.itemsize + 4], "little")


def _packed(attitude: Attitude) -> bytes:
    heading_deg, pitch_deg, roll_deg = attitude
    return _ATTITUDE.pack(
        round(heading_deg % 360.0 * 100.0) % 36000,
        round((pitch_deg + 180.0) % 360.0 * 100.0) - 18000,
        round((roll_deg + 180.0) % 360.0 * 100.0) - 18000,
    )


def _halved(first: Block, second: Block) -> Block:
    """Every second point of both."""
    points = np.frombuffer(first.points + second.points, POINT)[::2]
    attitudes = np.frombuffer(first.attitudes + second.attitudes, ATTITUDE)[::2]
    return Block(points.tobytes(), attitudes.tobytes())


def _is_interrupted(last: tuple[float, Position], t_s: float, position: Position) -> bool:
    elapsed_s = t_s - last[0]
    latitude_deg, longitude_deg, _ = last[1]
    north_m = (position[0] - latitude_deg) * M_PER_DEG
    # The short way across the 180 degree meridian.
    east_deg = (position[1] - longitude_deg + 180.0) % 360.0 - 180.0
    east_m = east_deg * M_PER_DEG * math.cos(math.radians(latitude_deg))
    moved_m = math.hypot(north_m, east_m)
    return elapsed_s > _LONGEST_GAP_S or moved_m > max(_LEAST_JUMP_M, _FASTEST_M_S * elapsed_s)


def _i32(value: float) -> int:
    return min(max(-_MAX_I32, round(value)), _MAX_I32)
