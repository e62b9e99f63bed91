"""Places that are waited for: the highest standing goes first, then who has least, then who came first."""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from dataclasses import dataclass

from epf_gcs.shares.holder import Holder
from epf_gcs.shares.places import Holdings, Places


@dataclass(eq=False, slots=True)
class _Waiter:
    holder: Holder
    admitted: asyncio.Future[None]


class Turns:
    """Owned by the event loop."""

    def __init__(self, row: Places) -> None:
        self._at_work: Holdings[_Waiter] = Holdings(row)
        self._waiting: list[_Waiter] = []

    @asynccontextmanager
    async def turn(self, holder: Holder) -> AsyncIterator[None]:
        """Wait for a place, and have it inside."""
        waiter = _Waiter(holder, asyncio.get_running_loop().create_future())
        self._waiting.append(waiter)
        self._admit()
        try:
            await waiter.admitted
            yield
        finally:
            if waiter in self._waiting:
                self._waiting.remove(waiter)
            self._at_work.leave(waiter)
            self._admit()

    def _admit(self) -> None:
        """Give the free places to those who go first."""
        while (first := self._first()) is not None:
            self._waiting.remove(first)
            first.admitted.set_result(None)

    def _first(self) -> _Waiter | None:
        """The first that gets a place, which is taken then."""

        def order(waiter: _Waiter) -> tuple[int, int]:
            return -waiter.holder.standing, self._at_work.count(waiter.holder.key)

        waiting = (one for one in sorted(self._waiting, key=order) if not one.admitted.done())
        return next((one for one in waiting if self._at_work.take(one, one.holder) is None), None)
