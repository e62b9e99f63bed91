"""Who may command. One operator at a time; everybody else watches."""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from dataclasses import dataclass
from typing import Final

from epf_gcs.errors import ConflictError, NotFoundError

# A page that is loaded again, or a hiccup of the network, keeps control.
_GRACE_S: Final = 5.0


@dataclass(frozen=True, slots=True)
class Client:
    """A browser on the stream. `name` is what others are shown."""

    id: str
    name: str


class Control:
    """First come, first served; the operator gives it back, or loses it some seconds after the connection."""

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
        """A live connection has this id."""
        return client_id in self._connected

    def name_of(self, client_id: str) -> str | None:
        """What others are shown of this browser; None where none has this id."""
        client = self._connected.get(client_id)
        return None if client is None else client.name

    def restore(self, holder: Client) -> None:
        """This browser had control before the web process started, and keeps it where it comes back in time."""
        if self.holder is None and not self._connected:
            self._give(holder)
            self._timer = self._loop.call_later(self._grace_s, self._grace_over)

    def connect(self, client: Client) -> None:
        """A browser came: it gets control where nobody has it, or where it was its own a moment ago."""
        self._connected[client.id] = client
        if self.holder is None or self.holder.id == client.id:
            self._give(client)

    def disconnect(self, client: Client) -> None:
        """A browser went. If it had control, that is kept for it a little while."""
        self._connected.pop(client.id, None)
        if self.holder is not None and self.holder.id == client.id:
            self._timer = self._loop.call_later(self._grace_s, self._grace_over)

    def take(self, client_id: str) -> Client:
        """Control for this browser. Raises ConflictError while another has it."""
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
        """Give control back. Raises ConflictError where this browser does not have it."""
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
        # Whoever has watched longest is next, so that a lone page that came back under a new id is not stuck.
        self._give(next(iter(self._connected.values()), None))

    def _give(self, client: Client | None) -> None:
        if self._timer is not None:
            self._timer.cancel()
            self._timer = None
        changed = client != self.holder
        self.holder = client
        if changed:
            self._on_change(client)
