"""Who may command. One operator at a time; everybody else watches."""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from typing import Final

from epf_gcs.bus.definition import Client
from epf_gcs.errors import ConflictError, NotFoundError

# Control survives a reload of the page or a short network failure.
_GRACE_S: Final = 5.0


class Control:
    """First come, first served; the operator releases it, or loses it some seconds after the connection is lost."""

    def __init__(
        self, loop: asyncio.AbstractEventLoop, on_change: Callable[[Client | None], None], *, grace_s: float = _GRACE_S
    ) -> None:
        self._loop = loop
        self._on_change = on_change
        self._grace_s = grace_s
        self._connected: dict[str, Client] = {}
        self._timer: asyncio.TimerHandle | None = None
        self.holder: Client | None = None

    def is_connected(self, client_id: str) -> bool:
        """Whether a live connection has this id."""
        return client_id in self._connected

    def name_of(self, client_id: str) -> str | None:
        """The browser's name as other viewers see it; None if no connected browser has this id."""
        client = self._connected.get(client_id)
        return None if client is None else client.name

    def restore(self, holder: Client) -> None:
        """Give control to the browser that had it before a restart of the web process; it must reconnect in time."""
        if self.holder is None and not self._connected:
            self._give(holder)
            self._timer = self._loop.call_later(self._grace_s, self._grace_over)

    def connect(self, client: Client) -> None:
        """Add a browser: it gets control if nobody has it, or if it had control until just now."""
        self._connected[client.id] = client
        if self.holder is None or self.holder.id == client.id:
            self._give(client)

    def disconnect(self, client: Client) -> None:
        """Remove a browser. If it had control, it keeps it for `grace_s`."""
        self._connected.pop(client.id, None)
        if self.holder is not None and self.holder.id == client.id:
            self._timer = self._loop.call_later(self._grace_s, self._grace_over)

    def take(self, client_id: str) -> Client:
        """Give control to this browser. Raises NotFoundError if not connected, ConflictError if another has it."""
        client = self._connected.get(client_id)
        if client is None:
            raise NotFoundError(
                "client_unknown",
                f"No browser with the id '{client_id}' is on the stream: open the stream and use the id of its hello.",
                client=client_id,
            )
        self.check(client_id)
        self._give(client)
        return client

    def release(self, client_id: str) -> None:
        """Release control. Raises ConflictError if another browser has it."""
        if self.holder is None:
            return
        self.check(client_id)
        self._give(None)

    def check(self, client_id: str | None) -> None:
        """Raise ConflictError unless this caller may command now; without an id only while nobody has control."""
        holder = self.holder
        if holder is None or holder.id == client_id:
            return
        raise ConflictError(
            "control_held",
            f"{holder.name} has control: ask for it to be released there, or wait until that page is closed.",
            client=holder.id,
            name=holder.name,
        )

    def _grace_over(self) -> None:
        # The browser connected longest is next, so that a single page that reconnects with a new id gets control again.
        self._give(next(iter(self._connected.values()), None))

    def _give(self, client: Client | None) -> None:
        if self._timer is not None:
            self._timer.cancel()
            self._timer = None
        changed = client != self.holder
        self.holder = client
        if changed:
            self._on_change(client)
