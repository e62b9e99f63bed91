"""The flown track of an indexed flight, cleaned, in a file of its own: writers of tracks read it in pieces, repeatedly.

What is left out: samples without a fix, repeats of the last place (a receiver that sends one place several times), and
single points that nobody can have flown to. The track is broken into lines where data are missing or the aircraft was
put elsewhere. So no two points of a line share a millisecond, and no step is faster than was flown (see `pace.py`).
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from itertools import pairwise
from pathlib import Path
from typing import Any, BinaryIO, Final, Literal, NamedTuple

import numpy as np
import numpy.typing as npt
import pyarrow as pa

from epf_gcs.flights.export.pace import pace, steps_m
from epf_gcs.flights.export.spread import Rows, Times, spread
from epf_gcs.flights.export.stretch import ROWS, Stretch, times_of
from epf_gcs.formats.samples import Samples
from epf_gcs.units import M_PER_FT, MPS_PER_KT

Source = Literal["flight", "hil"]

# As for the track that is drawn live: see `track/track.py`.
LONGEST_GAP_S: Final = 10.0
"""A longer silence breaks a track."""
_FASTEST_M_S: Final = 350.0
_LEAST_JUMP_M: Final = 100.0
# A receiver sends at least every other second: a place that changed was reached in no longer time than this.
_LONGEST_STEP_S: Final = 2.0
_ATTITUDE_AGE_NS: Final = 1_000_000_000
_COLUMNS: Final = len(Samples._fields)
_T = 0


class _Where(NamedTuple):
    """The columns of a position, the factor of the altitude to metres, speed (kt) and course over the ground, and the
    columns of the attitude with their topic."""

    topic: str
    place: tuple[str, str, str]
    to_m: float
    motion: tuple[str, str]
    attitude_topic: str
    attitude: tuple[str, str, str]


WHERE: Final[dict[Source, _Where]] = {
    "flight": _Where(
        "gps",
        ("latitude_deg", "longitude_deg", "altitude_m"),
        1.0,
        ("speed_kt", "heading_deg"),
        "ahrs",
        ("yaw_deg", "pitch_deg", "roll_deg"),
    ),
    "hil": _Where(
        "simulator",
        ("latitude_deg", "longitude_deg", "altitude_msl_ft"),
        M_PER_FT,
        ("ground_speed_kt", "horizontal_path_deg"),
        "simulator",
        ("true_heading_deg", "pitch_deg", "roll_deg"),
    ),
}
TOPICS: Final = tuple(dict.fromkeys(name for one in WHERE.values() for name in (one.topic, one.attitude_topic)))
"""Of these topics the tracks are made."""


@dataclass(frozen=True)
class FlownLine:
    """One unbroken line of at least two points; may be iterated repeatedly."""

    path: Path
    first: int
    end: int

    def __iter__(self) -> Iterator[Samples]:
        with self.path.open("rb") as file:
            for begin in range(self.first, self.end, ROWS):
                yield _read(file, begin, min(self.end, begin + ROWS))

    def span_s(self) -> tuple[float, float]:
        """Unix time of the first and of the last point."""
        with self.path.open("rb") as file:
            first, last = (float(_read(file, at, at + 1).t_s[0]) for at in (self.first, self.end - 1))
        return first, last


def flown_lines(stretch: Stretch, source: Source, aside: Path) -> list[FlownLine]:
    """The lines of the real flight or of the simulator's; empty where there is no position. Raises OSError."""
    where = WHERE[source]
    if where.topic not in stretch.topics:
        return []
    path = aside / f"{source}.track"
    with path.open("wb") as file:
        track = _Track(file)
        for t_ns, rows in _with_attitude(stretch, where):
            track.take(t_ns, rows)
        track.end_line()
    pace(path, track.lines)
    return [FlownLine(path, first, end) for first, end in track.lines]


def attitudes(stretch: Stretch, source: Source) -> Iterator[tuple[Times, Rows]]:
    """Times and rows of heading, pitch and roll (deg) where all three are known."""
    return spread(_attitudes(stretch, WHERE[source]))


def _attitudes(stretch: Stretch, where: _Where) -> Iterator[tuple[Times, Rows]]:
    for batch in stretch.batches(where.attitude_topic, ["t_ns", *where.attitude]):
        rows = np.stack([_numbers(batch, name) for name in where.attitude], axis=1)
        good = np.isfinite(rows).all(axis=1)
        yield times_of(batch)[good], rows[good]


@dataclass
class _Track:
    """Cleans points and writes them, as rows of `Samples`."""

    file: BinaryIO
    lines: list[tuple[int, int]] = field(default_factory=list)
    _first: int = 0
    _count: int = 0
    _heard_ns: int | None = None
    _last: Rows | None = None

    def take(self, t_ns: Times, rows: Rows) -> None:
        """Points in the order of the line; rows of shape (n, 9), whose times are not set yet."""
        if not len(t_ns):
            return
        rows[:, _T] = np.round(t_ns / 1e6) / 1e3
        breaks = np.zeros(len(rows), dtype=bool)
        elapsed_ns = np.diff(t_ns, prepend=t_ns[0] if self._heard_ns is None else self._heard_ns)
        breaks |= (elapsed_ns > LONGEST_GAP_S * 1e9) | (elapsed_ns < 0)
        self._heard_ns = int(t_ns[-1])
        for first, end in _between(np.flatnonzero(breaks), len(rows)):
            if breaks[first]:
                self.end_line()
            self._unbroken(rows[first:end])

    def end_line(self) -> None:
        """What follows is another line."""
        if self._count - self._first > 1:
            self.lines.append((self._first, self._count))
        self._first, self._last = self._count, None

    def _unbroken(self, rows: Rows) -> None:
        while len(rows):
            if self._last is not None:
                rows = np.concatenate((self._last[None], rows))
            rows = rows[_moved(rows)]
            put = np.flatnonzero(jumps(rows)) + 1
            end = int(put[0]) if len(put) else len(rows)
            kept = _flyable(rows[:end])
            new = kept if self._last is None else kept[1:]
            self.file.write(np.ascontiguousarray(new, dtype="<f8").tobytes())
            self._count += len(new)
            self._last = kept[-1]
            if end == len(rows):
                return
            self.end_line()
            rows = rows[end:]


def _moved(rows: Rows) -> npt.NDArray[np.bool_]:
    """Without the repeats of a place."""
    moved = np.ones(len(rows), dtype=bool)
    moved[1:] = (rows[1:, 1:4] != rows[:-1, 1:4]).any(axis=1)
    return moved


def jumps(rows: Rows) -> Any:
    """Whether each step of rows that begin with time [s], latitude and longitude [deg] is one that is not flown: the
    aircraft was put elsewhere. Shape (n - 1,)."""
    distance_m = steps_m(rows)
    elapsed_s = np.minimum(np.diff(rows[:, _T]), _LONGEST_STEP_S)
    return (distance_m > _LEAST_JUMP_M) & (distance_m > _FASTEST_M_S * elapsed_s)


def _flyable(rows: Rows) -> Rows:
    """Without points that share a millisecond with the one before them, or lie further than can be flown since it."""
    while len(rows) > 1:
        elapsed_s = np.diff(rows[:, _T])
        bad = (elapsed_s < 0.5e-3) | (steps_m(rows) > _FASTEST_M_S * elapsed_s)
        if not bad.any():
            break
        # Only the first of neighbours goes: what follows it is judged from the point that stays.
        first = bad.copy()
        first[1:] &= ~bad[:-1]
        rows = rows[np.concatenate(([True], ~first))]
    return rows


def _between(edges: npt.NDArray[np.intp], count: int) -> list[tuple[int, int]]:
    places = [0, *(edge for edge in edges.tolist() if edge), count]
    return list(pairwise(places))


def _read(file: BinaryIO, first: int, end: int) -> Samples:
    file.seek(first * _COLUMNS * 8)
    rows = np.frombuffer(file.read((end - first) * _COLUMNS * 8), "<f8").reshape(-1, _COLUMNS)
    return Samples(*(np.ascontiguousarray(rows[:, index]) for index in range(_COLUMNS)))


def _with_attitude(stretch: Stretch, where: _Where) -> Iterator[tuple[Times, Rows]]:
    """Times and rows of `Samples` (their time is 0) of all samples with a position."""
    points = spread(_points(stretch, where))
    if where.attitude_topic == where.topic:
        yield from points
        return
    attitudes = _Attitudes(stretch, where)
    for t_ns, rows in points:
        rows[:, 4:7] = attitudes.at(t_ns)
        yield t_ns, rows


def _points(stretch: Stretch, where: _Where) -> Iterator[tuple[Times, Rows]]:
    own = where.attitude if where.attitude_topic == where.topic else ()
    with_fix = ["fix", "valid"] if where.topic == "gps" else []
    for batch in stretch.batches(where.topic, ["t_ns", *where.place, *own, *where.motion, *with_fix]):
        rows = np.zeros((batch.num_rows, _COLUMNS))
        rows[:, 4:7] = np.nan
        for index, name in enumerate((*where.place, *own), 1):
            rows[:, index] = _numbers(batch, name)
        rows[:, 3] *= where.to_m
        rows[:, 7] = _numbers(batch, where.motion[0]) * MPS_PER_KT
        rows[:, 8] = _numbers(batch, where.motion[1])
        good = np.isfinite(rows[:, 1:4]).all(axis=1)
        if with_fix:
            good &= (_numbers(batch, "fix") > 0.0) & (_numbers(batch, "valid") == 1.0)
        if own:
            rows[~np.isfinite(rows[:, 4:7]).all(axis=1), 4:7] = np.nan
        yield times_of(batch)[good], rows[good]


class _Attitudes:
    """The attitude at moments that only go on: the newest sample, if it is no older than a second."""

    def __init__(self, stretch: Stretch, where: _Where) -> None:
        self._t_ns = np.empty(0, dtype=np.int64)
        self._rows = np.empty((0, 3))
        self._more = spread(_attitudes(stretch, where))
        if where.attitude_topic not in stretch.topics:
            self._more = iter(())

    def at(self, t_ns: Times) -> Rows:
        """Heading, pitch and roll (n, 3); NaN where there is none."""
        found = np.full((len(t_ns), 3), np.nan)
        if not len(t_ns):
            return found
        while not len(self._t_ns) or self._t_ns[-1] < t_ns[-1]:
            more = next(self._more, None)
            if more is None:
                break
            self._t_ns = np.concatenate((self._t_ns, more[0]))
            self._rows = np.concatenate((self._rows, more[1]))
        if len(self._t_ns):
            places = np.searchsorted(self._t_ns, t_ns, side="right") - 1
            known = (places >= 0) & (t_ns - self._t_ns[places] <= _ATTITUDE_AGE_NS)
            found[known] = self._rows[places[known]]
            old = int(np.searchsorted(self._t_ns, t_ns[-1] - _ATTITUDE_AGE_NS))
            self._t_ns, self._rows = self._t_ns[old:], self._rows[old:]
        return found


def _numbers(batch: pa.RecordBatch, name: str) -> npt.NDArray[np.float64]:
    column: npt.NDArray[np.float64] = batch.column(name).cast(pa.float64()).to_numpy(zero_copy_only=False)
    return column
