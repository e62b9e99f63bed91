"""The simulator's socket: opened, closed with the controls handed back, and its traffic counted."""

from __future__ import annotations

import asyncio
from collections import Counter
from collections.abc import Callable
from dataclasses import asdict, dataclass
from typing import Any, Final, Literal

from epf_gcs.clock import Clock
from epf_gcs.errors import GatewayError, LinkError
from epf_gcs.flight.hil.hil import Hil
from epf_gcs.link.base import Tap
from epf_gcs.link.udp import UdpAddress, UdpCallbacks, UdpLink, open_udp
from epf_gcs.xplane.datagram import release_datagram

State = Literal["closed", "opening", "open", "lost"]
Profile = Literal["xp10", "xp12"]

_LOST_AFTER_S: Final = 1.0
_RETRY_S: Final = 1.0
# What X-Plane's network output was made for; the channel's use is shown in percent of it.
CHANNEL_BYTES_PER_S: Final = 73000


@dataclass(frozen=True, slots=True)
class SimulatorAddress:
    """Where the simulator is, and which generation of it."""

    receive_port: int
    send_host: str
    send_port: int
    profile: Profile

    @property
    def udp(self) -> UdpAddress:
        """The socket's part of it."""
        return UdpAddress(self.receive_port, self.send_host, self.send_port)

    def as_dict(self) -> dict[str, Any]:
        """Plain values."""
        return asdict(self)


class Simulator:
    """Owns the socket's life and hands its datagrams to the bridge."""

    def __init__(
        self,
        hil: Hil,
        clock: Clock,
        tap: Tap | None,
        report: Callable[[GatewayError], None],
        on_change: Callable[[], None],
    ) -> None:
        self._clock = clock
        self._hil = hil
        self._tap = tap
        self._report = report
        self._on_change = on_change
        self._link: UdpLink | None = None
        self._lock = asyncio.Lock()
        self._wake = asyncio.Event()
        self._last_datagram_s: float | None = None
        self.address: SimulatorAddress | None = None
        self.failure: GatewayError | None = None
        self.datagrams = 0
        self.bytes_in = 0
        self.dropped: Counter[str] = Counter()
        self.last_stranger_s: float | None = None

    @property
    def state(self) -> State:
        """closed; opening: listening and nothing heard yet; open: it sends; lost: it stopped, or the port is taken."""
        if self.address is None:
            return "closed"
        if self._link is None:
            return "lost" if self.failure is not None else "opening"
        if self._last_datagram_s is None:
            return "opening"
        return "open" if self._clock.steady_s() - self._last_datagram_s < _LOST_AFTER_S else "lost"

    async def open(self, address: SimulatorAddress) -> None:
        """Listen here in place of anywhere else. Raises LinkError; then everything is as it was."""
        async with self._lock:
            previous = self.address
            if previous is not None and self._link is not None and previous.receive_port == address.receive_port:
                self._shut()
                try:
                    link = await self._bind(address)
                except LinkError:
                    self._adopt(previous, await self._bind(previous))
                    raise
            else:
                link = await self._bind(address)
                self._shut()
            self._adopt(address, link)

    def want(self, address: SimulatorAddress) -> None:
        """Listen here as soon as it can be done; for the start, when nobody waits for an answer."""
        self.address = address
        self._wake.set()

    async def run(self) -> None:
        """Try again what was wanted at the start and could not be opened; runs as long as the gateway."""
        while True:
            await self._wake.wait()
            self._wake.clear()
            if not await self._listens():
                await asyncio.sleep(_RETRY_S)
                self._wake.set()

    async def close(self) -> None:
        """Hand the controls back and stop listening."""
        async with self._lock:
            self.address = None
            self.failure = None
            self._shut()
            self._on_change()

    def shut_down(self) -> None:
        """The gateway ends: hand the controls back. What was wanted stays wanted."""
        self._shut()

    async def _listens(self) -> bool:
        async with self._lock:
            wanted = self.address
            if wanted is None or self._link is not None:
                return True
            try:
                self._adopt(wanted, await self._bind(wanted))
            except LinkError as error:
                if self.failure is None:
                    self._report(error)
                self.failure = error
                self._on_change()
                return False
            return True

    async def _bind(self, address: SimulatorAddress) -> UdpLink:
        return await open_udp(address.udp, UdpCallbacks(self._on_datagram, self._on_stranger, self._tap))

    def _adopt(self, address: SimulatorAddress, link: UdpLink) -> None:
        self.address = address
        self.failure = None
        self._link = link
        self._last_datagram_s = None
        self._hil.begin(link, address.profile)
        self._on_change()

    def _shut(self) -> None:
        link, self._link = self._link, None
        if link is not None:
            link.send(release_datagram())
            link.close()
            self._hil.end()

    def _on_datagram(self, datagram: bytes) -> None:
        if self._hil.on_datagram(datagram):
            self._last_datagram_s = self._clock.steady_s()
            self.datagrams += 1
            self.bytes_in += len(datagram)
            return
        self.dropped["malformed"] += 1
        self._report(
            LinkError(
                "datagram_malformed",
                f"A datagram of {len(datagram)} bytes was dropped because it is not DATA and whole rows: "
                "check what is sent to this port.",
                bytes=len(datagram),
            )
        )

    def _on_stranger(self, host: str) -> None:
        self.dropped["stranger"] += 1
        self.last_stranger_s = self._clock.steady_s()
        configured = "" if self.address is None else self.address.send_host
        self._report(
            LinkError(
                "datagram_stranger",
                f"A datagram from {host} was dropped because the simulator is at {configured}: "
                "correct the simulator's address if it moved.",
                host=host,
                configured=configured,
            )
        )
