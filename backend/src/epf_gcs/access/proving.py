"""Holds keys against hashes in one thread of its own with a short queue: the event loop never pays for it."""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from math import ceil
from typing import Final, TypeVar

from epf_gcs.access.guessing import GuessLimiter
from epf_gcs.errors import TooManyError

MOST_WAITING: Final = 16
_BUSY_S: Final = 2

T = TypeVar("T")


class KeyVerifier:
    """Owned by the event loop. `steady_s` is a steady clock."""

    def __init__(self, steady_s: Callable[[], float]) -> None:
        self._steady_s = steady_s
        self._thread = ThreadPoolExecutor(1, "keys")
        self._waiting = 0
        self.guessing = GuessLimiter()

    def close(self) -> None:
        """End the thread. Blocks until what it does is done."""
        self._thread.shutdown(cancel_futures=True)

    async def attempt(self, address: str, work: Callable[[], T | None]) -> T | None:
        """The result of `work`, which holds a key of this address against a hash; None where it is wrong.

        Raises TooManyError if this address, or all together, tried too often.
        """
        if self._waiting >= MOST_WAITING:
            raise _too_many(_BUSY_S)
        wait_s = self.guessing.begin(address, self._steady_s())
        if wait_s > 0:
            raise _too_many(ceil(wait_s))
        result = await self.run(work)
        if result is not None:
            self.guessing.succeeded(address)
        return result

    async def run(self, work: Callable[[], T]) -> T:
        """Run something of the disk or the hashes in the same thread, without a limit: for those who are in."""
        self._waiting += 1
        try:
            return await asyncio.get_running_loop().run_in_executor(self._thread, work)
        finally:
            self._waiting -= 1


def _too_many(retry_after_s: int) -> TooManyError:
    return TooManyError(
        "access_too_many_tries",
        f"Too many wrong keys were tried: try again in {retry_after_s} s.",
        retry_after_s=retry_after_s,
    )
