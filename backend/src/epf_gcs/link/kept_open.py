"""Keep one device or socket open: open it, notice its loss, back off, open it again, close it.

The only place that retries. How to open it, and what to do with it, is passed in as `Handling`.
"""

from __future__ import annotations

import asyncio
import contextlib
import time
from collections.abc import Awaitable, Callable
from dataclasses import dataclass
from typing import Final, Generic, Protocol, Self, TypeVar

from epf_gcs.errors import GatewayError, LinkError
from epf_gcs.link.failures import unexpected_error

# Quick at first, for a plug with a loose contact; then once a second, which costs an idle machine next to nothing.
_FIRST_RETRY_S: Final = 0.1
_LAST_RETRY_S: Final = 1.0
# A link that lasted less than this counts as failed to open: a peer that hangs up at once is retried with pauses.
_LASTED_S: Final = 1.0


class Address(Protocol):
    """The address of what is to be kept open."""

    @property
    def name(self) -> str:
        """The short name for messages."""

    def same_device(self, other: Self) -> bool:
        """Whether both are the same device, so that one must be closed before the other is opened."""


A = TypeVar("A", bound=Address)
L = TypeVar("L")


async def _stays(address: A) -> A:
    return address


async def _nothing(_: object) -> None:
    """The default of `settle`: nothing to do."""


async def _wait(event: asyncio.Event, at_most_s: float) -> None:
    with contextlib.suppress(TimeoutError):
        async with asyncio.timeout(at_most_s):
            await event.wait()


@dataclass(frozen=True, slots=True)
class LinkHandlers(Generic[A, L]):
    """How to open a link, and what to do when its state changes.

    `find`: the present address of the wanted device; called before each automatic attempt, not before `KeptOpen.open`.
    `begin`: the link is open, use it. `settle`: slower work after `begin`. `end`: leave the other side in order, then
    close. `gone`: the link was lost and is already closed. `report`: the reason of a failure. `changed`: the state may
    have changed.
    """

    open: Callable[[A], Awaitable[L]]
    begin: Callable[[A, L], None]
    end: Callable[[L], None]
    gone: Callable[[], None]
    report: Callable[[GatewayError], None]
    changed: Callable[[], None]
    find: Callable[[A], Awaitable[A]] = _stays
    settle: Callable[[A], Awaitable[None]] = _nothing


class KeptOpen(Generic[A, L]):
    """Keeps one link open. `address` is the wanted one, None after a close; `link` is the open one, None if not open.

    `failure` is why it is not open, None if nothing failed; `reopened` counts the links that `run` opened.
    """

    def __init__(
        self,
        handling: LinkHandlers[A, L],
        now_s: Callable[[], float] = time.monotonic,
        wait: Callable[[asyncio.Event, float], Awaitable[None]] = _wait,
    ) -> None:
        self._do = handling
        self._now_s = now_s
        self._wait = wait
        self._lock = asyncio.Lock()
        self._wake = asyncio.Event()
        self._pause_s = 0.0
        self._opened_s = 0.0
        self.address: A | None = None
        self.link: L | None = None
        self.failure: GatewayError | None = None
        self.reopened = 0

    async def open(self, address: A) -> None:
        """Open this in place of any other. Raises LinkError; then the former address stays wanted.

        If both are the same device, the old link is closed first; if opening then fails, `run` opens the old one again.
        """
        async with self._lock:
            previous = self.address
            if previous is not None and self.link is not None and previous.same_device(address):
                self._let_go()
                try:
                    link = await self._try(address)
                except BaseException:
                    self._call()
                    raise
            else:
                link = await self._try(address)
                self._let_go()
            self._adopt(address, link)
            await self._do.settle(address)

    def want(self, address: A) -> None:
        """Have `run` open this as soon as possible; for the start of the program, when nobody waits for an answer."""
        self.address = address
        self._call()

    async def close(self) -> None:
        """Close the link and keep it closed."""
        async with self._lock:
            self.address = None
            self.failure = None
            self._let_go()
            self._do.changed()

    def shut_down(self) -> None:
        """The program ends: close the link, but keep the wanted address."""
        self._let_go()

    def lose(self, error: LinkError) -> None:
        """The open link was lost and has closed itself."""
        self.link = None
        self._do.gone()
        self.failure = error
        lasted = self._now_s() - self._opened_s >= _LASTED_S
        self._pause_s = 0.0 if lasted else self._longer_pause_s
        self._do.report(error)
        self._do.changed()
        self._wake.set()

    async def run(self) -> None:
        """Open the wanted link whenever it is not open, until cancelled. May be run again after an exception."""
        while True:
            self._wake.clear()
            if self.address is None or self.link is not None:
                await self._wake.wait()
                continue
            if self._pause_s:
                # A newly wanted address ends the pause.
                await self._wait(self._wake, self._pause_s)
            await self._reopen()

    @property
    def _longer_pause_s(self) -> float:
        return min(_LAST_RETRY_S, max(_FIRST_RETRY_S, 2.0 * self._pause_s))

    def _call(self) -> None:
        """Make `run` open it at once."""
        self._pause_s = 0.0
        self._wake.set()

    async def _reopen(self) -> None:
        async with self._lock:
            wanted = self.address
            if wanted is None or self.link is not None:
                return
            try:
                address = await self._find(wanted)
                link = await self._try(address)
            except LinkError as error:
                self._pause_s = self._longer_pause_s
                is_news = self.failure is None
                self.failure = error
                if is_news:
                    self._do.report(error)
                    self._do.changed()
                return
            self._adopt(address, link)
            self.reopened += 1
            await self._do.settle(address)

    async def _find(self, wanted: A) -> A:
        try:
            return await self._do.find(wanted)
        except Exception as error:
            raise unexpected_error(wanted.name, error) from error

    async def _try(self, address: A) -> L:
        """Open it once. Every exception becomes a LinkError, so that nothing ends the retries."""
        try:
            return await self._do.open(address)
        except LinkError:
            raise
        except Exception as error:
            raise unexpected_error(address.name, error) from error

    def _adopt(self, address: A, link: L) -> None:
        self.address = address
        self.failure = None
        self.link = link
        self._opened_s = self._now_s()
        try:
            self._do.begin(address, link)
        except BaseException:
            # A programming error in `begin`: the caller of `run` logs it and runs it again, which reopens the link.
            self._let_go()
            self._pause_s = _LAST_RETRY_S
            self._wake.set()
            raise
        self._do.changed()

    def _let_go(self) -> None:
        link, self.link = self.link, None
        if link is not None:
            self._do.end(link)


class KeepsOpen(Generic[A, L]):
    """The base of whoever keeps one link open: it makes `_kept`, and others see and do this with it."""

    _kept: KeptOpen[A, L]

    @property
    def address(self) -> A | None:
        """What the operator wants open; None after a close."""
        return self._kept.address

    @property
    def failure(self) -> GatewayError | None:
        """Why the link is not open."""
        return self._kept.failure

    async def open(self, address: A) -> None:
        """Open this in place of any other. Raises LinkError; then what was wanted stays wanted."""
        await self._kept.open(address)

    async def run(self) -> None:
        """Open again whatever is wanted and not open; runs as long as the gateway."""
        await self._kept.run()

    def shut_down(self) -> None:
        """The gateway ends: leave the other side in order. What was wanted stays wanted."""
        self._kept.shut_down()
