"""Hosts from which somebody has shown a key lately: their connections and handshakes go before those of strangers."""

from __future__ import annotations

from collections import OrderedDict
from typing import Final

from epf_gcs.shares.holder import THIS_COMPUTER, Holder, Standing, host_of

FORGOTTEN_S: Final = 12 * 3600.0
"""A day on the airfield."""
_MOST: Final = 4096


class KnownHosts:
    """`now_s` is a steady clock's. Owned by the event loop."""

    def __init__(self) -> None:
        self._shown: OrderedDict[str, tuple[Standing, float]] = OrderedDict()

    def note(self, address: str, standing: Standing, now_s: float) -> None:
        """Somebody of this standing has shown a key from this address."""
        host = host_of(address)
        known, shown_s = self._shown.pop(host, (Standing.stranger, now_s))
        is_better = standing >= known or now_s - shown_s > FORGOTTEN_S
        self._shown[host] = (standing, now_s) if is_better else (known, shown_s)
        if len(self._shown) > _MOST:
            self._shown.popitem(last=False)

    def holder(self, address: str, now_s: float) -> Holder:
        """The host of this address as a holder of shares."""
        host = host_of(address)
        if host == THIS_COMPUTER:
            return Holder(host, Standing.own)
        standing, shown_s = self._shown.get(host, (Standing.stranger, now_s))
        return Holder(host, standing if now_s - shown_s <= FORGOTTEN_S else Standing.stranger)
