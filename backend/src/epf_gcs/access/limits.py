"""How much a caller may ask, by role: requests, bytes of uploads, streams. This computer itself has no limit here."""

from __future__ import annotations

from collections import Counter, OrderedDict
from collections.abc import Callable
from math import ceil
from typing import Final, NamedTuple

from epf_gcs.access.caller import LOCAL_SESSION, Caller
from epf_gcs.access.roles import Role
from epf_gcs.errors import TooManyError
from epf_gcs.shares.allowance import Allowance
from epf_gcs.shares.holder import Standing, group_of

MOST_REMEMBERED: Final = 4096
_HOUR_S: Final = 3600.0
_SOCKETS_S: Final = 10


class RoleLimits(NamedTuple):
    """Limits of a role. A globe asks for hundreds of tiles at once, hence the requests at once.

    A class behind one address loads the page's sixty files twenty times before anybody has entered.
    """

    requests_per_s: float
    requests_at_once: float
    upload_bytes_per_h: float
    sockets: int


STRANGERS: Final = RoleLimits(20.0, 2000.0, 0.0, 0)
OF_ROLE: Final[dict[Role, RoleLimits]] = {
    Role.viewer: RoleLimits(50.0, 3000.0, 0.0, 8),
    Role.operator: RoleLimits(100.0, 6000.0, 4e9, 16),
    Role.owner: RoleLimits(200.0, 12000.0, 16e9, 16),
}
UPLOADS_OF_ALL_BYTES_PER_H: Final = 32e9


def standing_of(caller: Caller) -> Standing:
    """Who goes first."""
    return Standing.own if caller.session == LOCAL_SESSION else Standing(caller.role)


class CallerLimits:
    """Owned by the event loop. `steady_s` is a steady clock. Strangers count by address, others by session."""

    def __init__(self, steady_s: Callable[[], float]) -> None:
        self._steady_s = steady_s
        self._requests: OrderedDict[str, Allowance] = OrderedDict()
        self._uploads: OrderedDict[str, Allowance] = OrderedDict()
        self._all_uploads = Allowance(UPLOADS_OF_ALL_BYTES_PER_H / _HOUR_S, UPLOADS_OF_ALL_BYTES_PER_H)
        self._sockets: Counter[str] = Counter()

    def request(self, caller: Caller | None, address: str) -> None:
        """Count a request. Raises TooManyError."""
        if caller is not None and caller.session == LOCAL_SESSION:
            return
        most = STRANGERS if caller is None else OF_ROLE[caller.role]
        key = group_of(address) if caller is None else caller.session
        allowance = _remembered(self._requests, key, most.requests_per_s, most.requests_at_once)
        if not allowance.take(self._steady_s()):
            wait_s = max(1, ceil(1.0 / most.requests_per_s))
            raise TooManyError(
                "access_too_many_requests",
                f"More was asked than this station answers: try again in {wait_s} s.",
                retry_after_s=wait_s,
            )

    def upload(self, caller: Caller, size_bytes: int) -> None:
        """Count bytes of an upload. Raises TooManyError."""
        if caller.session == LOCAL_SESSION:
            return
        most = OF_ROLE[caller.role].upload_bytes_per_h
        now_s = self._steady_s()
        own = _remembered(self._uploads, caller.session, most / _HOUR_S, most)
        if not own.take(now_s, size_bytes) or not self._all_uploads.take(now_s, size_bytes):
            raise TooManyError(
                "access_upload_limit",
                f"More was uploaded than this role may within an hour ({most / 1e9:.0f} GB): try again later.",
                limit_gb=most / 1e9,
                retry_after_s=int(_HOUR_S),
            )

    def socket_opened(self, caller: Caller) -> None:
        """Count a stream; `socket_closed` follows. Raises TooManyError."""
        most = OF_ROLE[caller.role].sockets
        if caller.session != LOCAL_SESSION and self._sockets[caller.session] >= most:
            raise TooManyError(
                "access_too_many_requests",
                f"This browser has {most} streams open already: close one first.",
                retry_after_s=_SOCKETS_S,
            )
        self._sockets[caller.session] += 1

    def socket_closed(self, caller: Caller) -> None:
        """A stream that was counted is closed."""
        self._sockets[caller.session] -= 1
        if self._sockets[caller.session] <= 0:
            del self._sockets[caller.session]


def _remembered(those: OrderedDict[str, Allowance], key: str, per_s: float, at_once: float) -> Allowance:
    """The allowance of a key. The longest unused one is dropped: others who come renew nobody's."""
    allowance = those.get(key)
    if allowance is None:
        allowance = those[key] = Allowance(per_s, at_once)
        if len(those) > MOST_REMEMBERED:
            those.popitem(last=False)
    else:
        those.move_to_end(key)
    return allowance
