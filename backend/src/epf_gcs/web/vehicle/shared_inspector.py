"""One inspector answer shared by all viewers: the flight process is asked at most five times a second."""

from __future__ import annotations

import asyncio
from collections.abc import Awaitable, Callable
from typing import Any, Final

import orjson

_LASTS_S: Final = 0.2


class SharedInspector:
    """`ask` requests it from the flight process. Callers during a pending request share its answer."""

    def __init__(self, ask: Callable[[], Awaitable[Any]], steady_s: Callable[[], float]) -> None:
        self._ask = ask
        self._steady_s = steady_s
        self._lock = asyncio.Lock()
        self._text = b""
        self._made_s = -1e9

    async def text(self) -> bytes:
        """JSON, at most a fifth of a second old. Raises what the flight process raised."""
        async with self._lock:
            if self._steady_s() - self._made_s > _LASTS_S:
                self._text = orjson.dumps(await self._ask())
                self._made_s = self._steady_s()
            return self._text
