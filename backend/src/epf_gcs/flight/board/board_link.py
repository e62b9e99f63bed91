"""The board's link: opened, lost, and opened again, also under a new name. The only place that retries it."""

from __future__ import annotations

import asyncio
from collections.abc import Awaitable, Callable
from typing import Final, Literal

from epf_gcs.codec.session import SessionState
from epf_gcs.errors import GatewayError, LinkError
from epf_gcs.link.address import EMULATION, LinkAddress
from epf_gcs.link.base import Link, LinkCallbacks, Tap
from epf_gcs.link.open import open_link
from epf_gcs.link.ports import find_identity, find_path
from epf_gcs.vehicle.board import Board

State = Literal["closed", "opening", "open", "lost"]

# Quick at first, for a plug that only wobbled; then once a second, which nobody notices on an idle machine.
_FIRST_RETRY_S: Final = 0.1
_LAST_RETRY_S: Final = 1.0


class Supervisor:
    """Owns the link's life. `address` is what the operator wants open; None after a close."""

    def __init__(
        self,
        board: Board,
        tap: Tap | None,
        report: Callable[[GatewayError], None],
        on_change: Callable[[], None],
        open_link: Callable[[LinkAddress], Awaitable[Link]] = open_link,
    ) -> None:
        self._board = board
        self._open_link = open_link
        self._tap = tap
        self._report = report
        self._on_change = on_change
        self._identify: Callable[[str], str | None] = find_identity
        self._locate: Callable[[str], str | None] = find_path
        self._link: Link | None = None
        self._lock = asyncio.Lock()
        self._wake = asyncio.Event()
        self.address: LinkAddress | None = None
        self.identity: str | None = None
        self.failure: GatewayError | None = None
        self.reopened = 0

    def find_devices_by(self, identify: Callable[[str], str | None], locate: Callable[[str], str | None]) -> None:
        """Know devices in another way than by their USB serial number: path -> identity, identity -> path."""
        self._identify = identify
        self._locate = locate

    @property
    def state(self) -> State:
        """closed: nobody wants it; opening: no answer of the board yet; open: it answers; lost: trying again."""
        if self.address is None:
            return "closed"
        if self._link is None:
            return "lost" if self.failure is not None else "opening"
        if self._board.is_open or self._board.guest is not None:
            return "open"
        silent = self._board.session.state is SessionState.OPENING and self._board.session.heartbeat_s is not None
        return "lost" if silent else "opening"

    async def open(self, address: LinkAddress) -> None:
        """Open this link in place of any other. Raises LinkError; then everything is as it was."""
        async with self._lock:
            previous = self.address
            if previous is not None and self._link is not None and previous.same_device(address):
                self._shut()
                try:
                    link = await self._open_link(address)
                except LinkError:
                    self._wake.set()
                    raise
            else:
                link = await self._open_link(address)
                self._shut()
            self.identity = None
            self._adopt(address, link)
            await self._learn_identity(address)

    def want(self, address: LinkAddress, identity: str | None) -> None:
        """Open this link as soon as it is there; for the start, when nobody waits for an answer."""
        self.address = address
        self.identity = identity
        self._wake.set()

    async def close(self) -> None:
        """Leave the board quiet, let the link go and stay closed."""
        async with self._lock:
            self.address = None
            self.identity = None
            self.failure = None
            self._shut()
            self._on_change()

    async def run(self) -> None:
        """Reopen whatever is wanted and not open; runs as long as the gateway."""
        while True:
            await self._wake.wait()
            self._wake.clear()
            retry_s = _FIRST_RETRY_S
            while self.address is not None and self._link is None:
                if await self._reopen():
                    break
                await asyncio.sleep(retry_s)
                retry_s = min(_LAST_RETRY_S, 2 * retry_s)

    def shut_down(self) -> None:
        """The gateway ends: leave the board quiet. What was wanted stays wanted."""
        self._shut()

    async def _reopen(self) -> bool:
        async with self._lock:
            wanted = self.address
            if wanted is None or self._link is not None:
                return True
            try:
                address = await self._present_address(wanted)
                link = await self._open_link(address)
            except LinkError as error:
                first = self.failure is None
                self.failure = error
                if first:
                    self._report(error)
                    self._on_change()
                return False
            self._adopt(address, link)
            self.reopened += 1
            await self._learn_identity(address)
            return True

    async def _present_address(self, wanted: LinkAddress) -> LinkAddress:
        """The same device may have come back under another name."""
        if wanted.scheme != "serial" or self.identity is None:
            return wanted
        path = await asyncio.to_thread(self._locate, self.identity)
        return wanted if path is None else LinkAddress("serial", path, baud=wanted.baud)

    async def _learn_identity(self, address: LinkAddress) -> None:
        """Who is behind the port; asked in a thread, for it reads a hundred files."""
        if address.scheme == "serial":
            self.identity = await asyncio.to_thread(self._identify, address.target)
            self._on_change()

    def _adopt(self, address: LinkAddress, link: Link) -> None:
        self.address = address
        self.failure = None
        self._link = link
        is_emulated = address == EMULATION
        # A recording is what happened; an example did not.
        link.start(LinkCallbacks(self._board.on_bytes, self._on_lost, None if is_emulated else self._tap))
        self._board.attach(link, is_emulated=is_emulated)
        self._on_change()

    def _shut(self) -> None:
        link, self._link = self._link, None
        if link is not None:
            self._board.say_goodbye()
            link.close()
            self._board.detach()

    def _on_lost(self, error: LinkError) -> None:
        self._link = None
        self._board.detach()
        self.failure = error
        self._report(error)
        self._on_change()
        self._wake.set()
