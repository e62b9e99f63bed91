"""One browser for whose replay there is no place: it hears why, and is let go after a while."""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from typing import Final

from epf_gcs.bus.definition import event_text
from epf_gcs.contract.events import ErrorEvent
from epf_gcs.errors import ConflictError
from epf_gcs.shares.places import Shortage
from epf_gcs.web.stream.socket import SocketConnection

LASTS_S: Final = 10.0
"""A page that is let go asks again, so that it is not done at once."""


class BusyReplay:
    """Implements `epf_gcs.web.stream.socket.Conversation`. `on_end` is called once, when the browser has gone."""

    def __init__(self, connection: SocketConnection, error: ConflictError, on_end: Callable[[], None]) -> None:
        self._connection = connection
        self._error = error
        self._on_end = on_end
        self._end: asyncio.TimerHandle | None = None

    def greet(self) -> None:
        """Say why."""
        event = ErrorEvent(self._error.code, self._error.detail, self._error.params)
        self._connection.send([event_text(event.NAME, 0.0, event)])
        self._end = asyncio.get_running_loop().call_later(LASTS_S, self._connection.end, "no place for a replay")

    def on_text(self, text: str) -> None:
        """There is nothing to be done."""

    def on_closed(self) -> None:
        """The browser disconnected."""
        if self._end is not None:
            self._end.cancel()
        self._on_end()


def replays_busy(shortage: Shortage) -> ConflictError:
    """Why there is no place."""
    most = shortage.most
    if shortage.of == "own":
        return ConflictError(
            "replays_own", f"You are replaying {most} recordings already: close one first.", limit=most
        )
    return ConflictError("replays_busy", f"{most} recordings are being replayed already: try again later.", limit=most)
