"""What is used up and comes back with time: how much one holder has of it, and how much all together."""

from __future__ import annotations

import math
from collections import OrderedDict
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Final, NamedTuple

from epf_gcs.shares.allowance import Allowance
from epf_gcs.shares.holder import Holder, Standing

MOST_REMEMBERED: Final = 4096


class Rate(NamedTuple):
    """So much a second, and so much at once."""

    per_s: float
    at_once: float


UNLIMITED: Final = Rate(math.inf, math.inf)
NOTHING: Final = Rate(0.0, 0.0)


class Newcomers(NamedTuple):
    """The little that a stranger has before those who used more: of `each`, and of all of them `together`."""

    each: Rate
    together: Rate


@dataclass(frozen=True, slots=True)
class Flow:
    """A row of the table. `each`: of one holder of a standing; one that is left out has no limit. `together`: of all
    holders of that standing, who so take nothing of another's."""

    each: Mapping[Standing, Rate]
    together: Mapping[Standing, Rate]
    newcomers: Newcomers | None = None


class Meter:
    """What is left of one row. Owned by the event loop; `now_s` is a steady clock's."""

    def __init__(self, row: Flow) -> None:
        self.row = row
        self._own: OrderedDict[Holder, Allowance] = OrderedDict()
        self._first: OrderedDict[Holder, Allowance] = OrderedDict()
        self._together = {standing: Allowance(*rate) for standing, rate in row.together.items()}
        self._newcomers = None if row.newcomers is None else Allowance(*row.newcomers.together)

    def take(self, holder: Holder, now_s: float, count: float = 1.0) -> bool:
        """Use so much; False if the holder or all together have less. One at its own limit takes nothing of others."""
        each = self.row.each.get(holder.standing, UNLIMITED)
        if each != UNLIMITED and not _remembered(self._own, holder, each).take(now_s, count):
            return False
        if holder.standing == Standing.stranger and self._is_newcomer(holder, now_s, count):
            return True
        together = self._together.get(holder.standing)
        return together is None or together.take(now_s, count)

    def _is_newcomer(self, holder: Holder, now_s: float, count: float) -> bool:
        if self._newcomers is None or self.row.newcomers is None:
            return False
        first = _remembered(self._first, holder, self.row.newcomers.each)
        return first.take(now_s, count) and self._newcomers.take(now_s, count)


def _remembered(those: OrderedDict[Holder, Allowance], holder: Holder, rate: Rate) -> Allowance:
    """The allowance of a holder. The longest unused one is dropped: others who come renew nobody's."""
    allowance = those.get(holder)
    if allowance is None:
        allowance = those[holder] = Allowance(*rate)
        if len(those) > MOST_REMEMBERED:
            those.popitem(last=False)
    else:
        those.move_to_end(holder)
    return allowance
