"""What a campaign found: how many flights are safe and how sure that is, which condition matters, the worst of them."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Final

import numpy as np
import pyarrow.parquet as pq

from epf_gcs.lab.conditions import GAIN, NAMES
from epf_gcs.lab.errors import LabError
from epf_gcs.lab.rows import PARQUET, WORST, Row
from epf_gcs.lab.truth import Column

FIGURE: Final = "near_rms_m"
"""What flights are ranked by, and what conditions are held against."""

# Two-sided 95 % of the normal distribution.
_Z: Final = 1.959964
# Fewer flights say nothing of a condition.
_LEAST: Final = 10
# A seed is not a condition: it only chooses the gusts.
_NOT_RANKED: Final = ("seed", "rate_hz")


@dataclass(frozen=True, slots=True)
class Share:
    """A share of flights, with the 95 % interval of Wilson's score, which also holds near 0 and 1."""

    count: int
    of: int

    @property
    def share(self) -> float:
        """0..1; NaN of nothing."""
        return self.count / self.of if self.of else math.nan

    def interval(self) -> tuple[float, float]:
        """The share of all such flights lies between these with 95 % certainty."""
        if not self.of:
            return 0.0, 1.0
        spread = _Z**2 / self.of
        middle = (self.share + spread / 2.0) / (1.0 + spread)
        half = _Z * math.sqrt(self.share * (1.0 - self.share) / self.of + spread / (4.0 * self.of)) / (1.0 + spread)
        return max(0.0, middle - half), min(1.0, middle + half)


@dataclass(frozen=True, slots=True)
class Effect:
    """How much a condition matters: rank correlation with `FIGURE`, -1..1, and the safe share at its low and high end
    (the lowest and highest third)."""

    name: str
    correlation: float
    low: Share
    high: Share


@dataclass(frozen=True, slots=True)
class Summary:
    """Of all rows of a campaign."""

    flights: int
    not_flown: int
    safe: Share
    effects: list[Effect]
    worst: list[Row]


def read_rows(folder: Path) -> list[Row]:
    """The rows of a finished campaign. Raises LabError where there are none."""
    path = folder / PARQUET
    if not path.is_file():
        raise LabError(f"{folder} holds no finished campaign: {PARQUET} is missing")
    rows: list[Row] = pq.read_table(path).to_pylist()
    return rows


def summary(rows: Sequence[Row]) -> Summary:
    """What they come to. A flight that could not be flown counts as neither safe nor unsafe."""
    flown = [row for row in rows if row["error"] is None]
    return Summary(
        len(rows), len(rows) - len(flown), _share(flown), sorted(_effects(flown), key=_weight), _worst(flown)
    )


@dataclass(frozen=True, slots=True)
class Comparison:
    """Two campaigns flight by flight. `better`, `worse`: how many flights are safe only in the second, only in the
    first; `change`: the mean of the second's figure less the first's, with its 95 % interval, over flights that both
    kept; `by_chance`: how likely so uneven a split of better and worse is if nothing changed."""

    pairs: int
    better: int
    worse: int
    by_chance: float
    change: float
    change_interval: tuple[float, float]


def compare(before: Sequence[Row], after: Sequence[Row]) -> Comparison:
    """Pair them by number. Raises LabError if the conditions of a pair differ: they were not the same flights."""
    others = {row["number"]: row for row in after}
    pairs = [(row, others[row["number"]]) for row in before if row["number"] in others]
    if not pairs:
        raise LabError("the two campaigns have no flight in common")
    for one, other in pairs:
        if any(one.get(name) != other.get(name) for name in (*NAMES, "faults")):
            raise LabError(f"flight {one['number']} was flown in other conditions: only equal ones can be compared")
    better = sum(other["is_safe"] and not one["is_safe"] for one, other in pairs)
    worse = sum(one["is_safe"] and not other["is_safe"] for one, other in pairs)
    both = [(one, other) for one, other in pairs if one["is_safe"] and other["is_safe"]]
    changes = np.array([other[FIGURE] - one[FIGURE] for one, other in both])
    mean = float(changes.mean()) if len(changes) else math.nan
    half = _Z * float(changes.std(ddof=1)) / math.sqrt(len(changes)) if len(changes) > 1 else math.nan
    return Comparison(len(pairs), better, worse, _by_chance(better, worse), mean, (mean - half, mean + half))


def _by_chance(better: int, worse: int) -> float:
    """Two-sided sign test, exact."""
    count, least = better + worse, min(better, worse)
    return min(1.0, 2.0 * sum(math.comb(count, k) for k in range(least + 1)) / 2.0**count)


def _share(rows: Sequence[Mapping[str, Any]]) -> Share:
    return Share(sum(bool(row["is_safe"]) for row in rows), len(rows))


def _effects(flown: Sequence[Row]) -> Iterator[Effect]:
    if len(flown) < _LEAST:
        return
    # A lost aircraft is further off than any that was kept.
    figure = np.array([math.inf if row[FIGURE] is None or not row["is_safe"] else row[FIGURE] for row in flown])
    names = [*(name for name in NAMES if name not in _NOT_RANKED), *(n for n in flown[0] if n.startswith(GAIN))]
    for name in names:
        values = [row[name] for row in flown]
        if len(set(values)) < 2 or not all(isinstance(value, int | float) for value in values):
            continue
        column = np.array(values, dtype=np.float64)
        order = np.argsort(column, kind="stable")
        third = len(flown) // 3
        low, high = ([flown[index] for index in part] for part in (order[:third], order[-third:]))
        yield Effect(name, _correlation(column, figure), _share(low), _share(high))


def _correlation(one: Column, other: Column) -> float:
    """Spearman's: of the ranks, so that a lost flight's infinity is only the last rank."""
    ranks, others = _ranks(one), _ranks(other)
    ranks, others = ranks - ranks.mean(), others - others.mean()
    size = math.sqrt(float(ranks @ ranks) * float(others @ others))
    return float(ranks @ others) / size if size else 0.0


def _ranks(values: Column) -> Column:
    """Equal values share the mean of their ranks."""
    _, inverse, counts = np.unique(values, return_inverse=True, return_counts=True)
    ends = np.cumsum(counts)
    ranks: Column = (ends - (counts - 1) / 2.0)[inverse]
    return ranks


def _weight(effect: Effect) -> float:
    return -abs(effect.correlation)


def _worst(flown: Sequence[Row]) -> list[Row]:
    def badness(row: Row) -> tuple[bool, bool, float]:
        figure = row[FIGURE]
        return row["lost_by"] is not None, not row["is_safe"], math.inf if figure is None else figure

    return sorted(flown, key=badness, reverse=True)[:WORST]
