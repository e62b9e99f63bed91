"""How many TLS handshakes a host may begin: each costs us about a millisecond, and whoever begins it nearly nothing."""

from __future__ import annotations

from collections import OrderedDict
from typing import Final

from epf_gcs.shares.allowance import Allowance
from epf_gcs.shares.holder import group_of, is_this_computer

PER_S: Final = 10.0
AT_ONCE: Final = 300.0
"""Of one host. A class behind one address opens six connections for each of its pages."""
ALL_PER_S: Final = 50.0
ALL_AT_ONCE: Final = 1000.0
MOST_REMEMBERED: Final = 4096


class Handshakes:
    """Owned by the event loop; `now_s` is a steady clock's. This computer has no limit: who runs programs on it has
    cheaper ways to keep it busy."""

    def __init__(self) -> None:
        self._of: OrderedDict[str, Allowance] = OrderedDict()
        self._all = Allowance(ALL_PER_S, ALL_AT_ONCE)

    def begin(self, host: str, now_s: float) -> bool:
        """Whether this host may begin one more. Who is at the own limit takes nothing of the others'."""
        if is_this_computer(host):
            return True
        key = group_of(host)
        own = self._of.pop(key, None) or Allowance(PER_S, AT_ONCE)
        self._of[key] = own
        if len(self._of) > MOST_REMEMBERED:
            self._of.popitem(last=False)
        return own.take(now_s) and self._all.take(now_s)
