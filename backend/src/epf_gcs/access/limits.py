"""How much a caller may ask: requests, bytes of uploads, streams, as the table of shares says."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Iterator
from contextlib import contextmanager
from math import ceil
from typing import Final

from epf_gcs.access.caller import LOCAL_SESSION, Caller
from epf_gcs.errors import ConflictError, TooManyError
from epf_gcs.shares.holder import Holder, Standing, group_of
from epf_gcs.shares.places import Holdings
from epf_gcs.shares.rates import Meter
from epf_gcs.shares.table import SHARES, Shares

_HOUR_S: Final = 3600
_SOCKETS_S: Final = 10


def standing_of(caller: Caller) -> Standing:
    """Who goes first."""
    return Standing.own if caller.session == LOCAL_SESSION else Standing(caller.role)


def holder_of(caller: Caller) -> Holder:
    """This caller as a holder of shares: each session has its own, this computer has one."""
    return Holder(caller.session, standing_of(caller))


class CallerLimits:
    """Owned by the event loop. `steady_s` is a steady clock. Strangers count by host, others by session."""

    def __init__(self, steady_s: Callable[[], float], shares: Shares = SHARES) -> None:
        self._steady_s = steady_s
        self._requests = Meter(shares.requests)
        self._upload_bytes = Meter(shares.upload_bytes)
        self._uploads: Holdings[object] = Holdings(shares.uploads)
        self.streams: Holdings[Hashable] = Holdings(shares.streams)

    def request(self, caller: Caller | None, address: str, count: int = 1) -> None:
        """Count a request, or something that is worth so many. Raises TooManyError."""
        holder = Holder(group_of(address), Standing.stranger) if caller is None else holder_of(caller)
        if not self._requests.take(holder, self._steady_s(), count):
            wait_s = max(1, ceil(count / self._requests.row.each[holder.standing].per_s))
            raise TooManyError(
                "access_too_many_requests",
                f"More was asked than this station answers: try again in {wait_s} s.",
                retry_after_s=wait_s,
            )

    def upload(self, caller: Caller, size_bytes: int) -> None:
        """Count bytes of an upload. Raises TooManyError."""
        holder = holder_of(caller)
        if not self._upload_bytes.take(holder, self._steady_s(), size_bytes):
            most_gb = self._upload_bytes.row.each[holder.standing].at_once / 1e9
            raise TooManyError(
                "access_upload_limit",
                f"More was uploaded than this role may within an hour ({most_gb:.0f} GB): try again later.",
                limit_gb=most_gb,
                retry_after_s=_HOUR_S,
            )

    @contextmanager
    def one_upload(self, caller: Caller) -> Iterator[None]:
        """Count a file that is being received, while inside. Raises ConflictError."""
        upload = object()
        shortage = self._uploads.take(upload, holder_of(caller))
        if shortage is not None:
            raise ConflictError(
                "map_imports_busy",
                f"{shortage.most} files are being received already: wait for one of them, or cancel it.",
                limit=shortage.most,
            )
        try:
            yield
        finally:
            self._uploads.leave(upload)

    def open_stream(self, stream: Hashable, caller: Caller) -> None:
        """Count a stream until `close_stream`. Raises TooManyError."""
        shortage = self.streams.take(stream, holder_of(caller))
        if shortage is not None:
            where = "This browser has" if shortage.of == "own" else "Others have"
            raise TooManyError(
                "access_too_many_requests",
                f"{where} {shortage.most} streams open already: close one first.",
                retry_after_s=_SOCKETS_S,
            )

    def close_stream(self, stream: Hashable) -> None:
        """A stream is closed. Idempotent."""
        self.streams.leave(stream)
