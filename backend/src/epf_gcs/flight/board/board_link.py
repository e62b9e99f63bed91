"""The board's link: kept open, found again if the same device gets a new name, and handed to the board."""

from __future__ import annotations

import asyncio
from collections.abc import Awaitable, Callable
from dataclasses import replace
from typing import Literal

from epf_gcs.codec.session import SessionState
from epf_gcs.errors import GatewayError
from epf_gcs.flight.clock.line_clock import LineClock
from epf_gcs.link.address import EMULATION, LinkAddress
from epf_gcs.link.base import Link, LinkCallbacks, Tap
from epf_gcs.link.kept_open import KeepsOpen, KeptOpen, LinkHandlers
from epf_gcs.link.open import open_link
from epf_gcs.link.ports import find_identity, find_path
from epf_gcs.vehicle.board import Board

State = Literal["closed", "opening", "open", "lost"]


class Supervisor(KeepsOpen[LinkAddress, Link]):
    """Owns the link's life. `identity` names the USB device behind it, wherever it is plugged in."""

    def __init__(
        self,
        board: Board,
        clock: LineClock,
        tap: Tap,
        *,
        report: Callable[[GatewayError], None],
        on_change: Callable[[], None],
        may_wait: Callable[[], bool],
        open_link: Callable[[LinkAddress], Awaitable[Link]] = open_link,
    ) -> None:
        self._board = board
        self._tap = tap
        self._on_bytes = clock.decoding(board.on_bytes)
        self._on_change = on_change
        self._others_may_wait = may_wait
        self._identify: Callable[[str], str | None] = find_identity
        self._locate: Callable[[str], str | None] = find_path
        self.identity: str | None = None
        self._kept = KeptOpen(
            LinkHandlers(
                open=open_link,
                begin=self._begin,
                end=self._end,
                gone=board.detach,
                report=report,
                changed=on_change,
                find=self._find,
                settle=self._learn_identity,
            )
        )

    def find_devices_by(self, identify: Callable[[str], str | None], locate: Callable[[str], str | None]) -> None:
        """Replace the search by USB serial number: `identify` maps path to identity, `locate` identity to path."""
        self._identify = identify
        self._locate = locate

    @property
    def reopened(self) -> int:
        """How often the link was reopened automatically."""
        return self._kept.reopened

    @property
    def state(self) -> State:
        """closed: nobody wants it; opening: no answer of the board yet; open: it answers; lost: trying again."""
        if self.address is None:
            return "closed"
        if self._kept.link is None:
            return "lost" if self.failure is not None else "opening"
        if self._board.is_open or self._board.exclusive_user is not None:
            return "open"
        silent = self._board.session.state is SessionState.OPENING and self._board.session.heartbeat_s is not None
        return "lost" if silent else "opening"

    def want(self, address: LinkAddress, identity: str | None) -> None:
        """Open this link as soon as it is there; for the start, when nobody waits for an answer."""
        self.identity = identity
        self._kept.want(address)

    async def close(self) -> None:
        """Leave the board quiet, let the link go and stay closed."""
        await self._kept.close()
        self.identity = None

    async def _find(self, wanted: LinkAddress) -> LinkAddress:
        """The address to open: the same device may have come back under another name."""
        if wanted.scheme != "serial" or self.identity is None:
            return wanted
        path = await asyncio.to_thread(self._locate, self.identity)
        return wanted if path is None else replace(wanted, target=path)

    async def _learn_identity(self, address: LinkAddress) -> None:
        """Look up the identity of the device behind the port; in a thread, for that reads a hundred files."""
        self.identity = None
        if address.scheme != "serial":
            return
        try:
            self.identity = await asyncio.to_thread(self._identify, address.target)
        except OSError:
            # The link works without an identity; it is then found again only under the same name.
            return
        self._on_change()

    def _begin(self, address: LinkAddress, link: Link) -> None:
        is_emulated = address == EMULATION
        # Emulated bytes are never recorded, and have the time at which they are made.
        on_bytes, tap = (self._board.on_bytes, None) if is_emulated else (self._on_bytes, self._tap)
        board = self._board
        waits = LinkCallbacks(on_bytes, self._kept.lose, tap, board.missing_bytes, self._may_wait, board.together)
        link.start(waits)
        self._board.attach(link, is_emulated=is_emulated, target=address.url, deliver=link.deliver)

    def _may_wait(self) -> bool:
        return self._board.may_wait() and self._others_may_wait()

    def _end(self, link: Link) -> None:
        self._board.say_goodbye()
        link.close()
        self._board.detach()
