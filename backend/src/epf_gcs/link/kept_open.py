"""Keep one thing of a kind open: open it, notice its loss, back off, open it again, close it.

The only place that retries. What is opened, and what is done with it, comes in from outside.
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

# Quick at first, for a plug that only wobbled; then once a second, which nobody notices on an idle machine.
_FIRST_RETRY_S: Final = 0.1
_LAST_RETRY_S: Final = 1.0
# What was lost sooner than this counts as not opened: a peer that hangs up at once is not asked without a pause.
_LASTED_S: Final = 1.0


class Address(Protocol):
    """What is to be open."""

    @property
    def name(self) -> str:
        """How a sentence names it."""

    def same_device(self, other: Self) -> bool:
        """Whether opening one needs the other closed."""


A = TypeVar("A", bound=Address)
L = TypeVar("L")


async def _stays(address: A) -> A:
    return address


async def _nothing(_: object) -> None:
    """Nothing is left to do."""


async def _wait(event: asyncio.Event, at_most_s: float) -> None:
    with contextlib.suppress(TimeoutError):
        async with asyncio.timeout(at_most_s):
            await event.wait()


@dataclass(frozen=True, slots=True)
class Handling(Generic[A, L]):
    """What is done with what is opened.

    `find`: where the wanted one is now; asked before each attempt but the operator's own. `begin`: it is open, use it.
    `settle`: what may take its time after `begin`. `end`: leave the other side as it should be, and close.
    `gone`: it was lost and is closed already. `report` hears why; `changed`: the state may be another now.
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
    """Made once for each line. `address` is what is wanted, None after a close; `link` is what is open.

    `failure` is why it is not open, None while nothing failed; `reopened` counts what `run` opened.
    """

    def __init__(
        self,
        handling: Handling[A, L],
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
        """Open this in place of any other. Raises LinkError; then what was wanted stays wanted.

        Where it is the same device as before, that is closed first; if opening then fails, `run` opens it again.
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
        """Open this as soon as it can be done; for the start, when nobody waits for an answer."""
        self.address = address
        self._call()

    async def close(self) -> None:
        """Let it go and stay closed."""
        async with self._lock:
            self.address = None
            self.failure = None
            self._let_go()
            self._do.changed()

    def shut_down(self) -> None:
        """The program ends: let it go. What was wanted stays wanted."""
        self._let_go()

    def lose(self, error: LinkError) -> None:
        """What is open was lost, and closed itself."""
        self.link = None
        self._do.gone()
        self.failure = error
        lasted = self._now_s() - self._opened_s >= _LASTED_S
        self._pause_s = 0.0 if lasted else self._longer_pause_s
        self._do.report(error)
        self._do.changed()
        self._wake.set()

    async def run(self) -> None:
        """Open whatever is wanted and not open; runs as long as the program. May be run again after a fault."""
        while True:
            self._wake.clear()
            if self.address is None or self.link is not None:
                await self._wake.wait()
                continue
            if self._pause_s:
                # A new wish does not wait for the end of the pause.
                await self._wait(self._wake, self._pause_s)
            await self._reopen()

    @property
    def _longer_pause_s(self) -> float:
        return min(_LAST_RETRY_S, max(_FIRST_RETRY_S, 2.0 * self._pause_s))

    def _call(self) -> None:
        """Have `run` open it at once."""
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
        """Open it once. Whatever goes wrong is a LinkError: no fault of a name or of the system ends the retries."""
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
            # A fault of ours: whoever runs this logs it and runs it again, and then it is opened anew.
            self._let_go()
            self._pause_s = _LAST_RETRY_S
            self._wake.set()
            raise
        self._do.changed()

    def _let_go(self) -> None:
        link, self.link = self.link, None
        if link is not None:
            self._do.end(link)
