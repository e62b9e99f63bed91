"""The simulator's socket: opened, closed with the controls handed back, and its traffic counted."""

from __future__ import annotations

import asyncio
from collections import Counter
from collections.abc import Callable
from dataclasses import asdict, dataclass
from typing import Any, Final, Literal

from epf_gcs.codec.messages_gen import XPLANE_ROWS
from epf_gcs.contract.simulator_faults import MAGIC as REPORT_MAGIC
from epf_gcs.errors import GatewayError, LinkError
from epf_gcs.flight.clock.line_clock import LineClock
from epf_gcs.flight.hil.hil import Hil
from epf_gcs.link.base import Tap
from epf_gcs.link.kept_open import KeepsOpen, KeptOpen, LinkHandlers
from epf_gcs.link.udp import UdpAddress, UdpCallbacks, UdpLink, open_udp
from epf_gcs.repeating import Repeating
from epf_gcs.xplane.datagram import parse, release_datagram
from epf_gcs.xplane.output import output_datagrams

State = Literal["closed", "opening", "open", "lost"]
Profile = Literal["xp10", "xp12"]

_LOST_AFTER_S: Final = 1.0
# X-Plane answers nothing: it is told again until its rows come, and again after it was started anew.
_TELL_EVERY_S: Final = 1.0
# The rate X-Plane's network output is designed for; the channel's load is shown in percent of it.
CHANNEL_BYTES_PER_S: Final = 73000


@dataclass(frozen=True, slots=True)
class SimulatorAddress:
    """Where the simulator is, and which generation of it. `tells_rows`: X-Plane is told which rows to send, and where.

    Without it, X-Plane's user has ticked them in its data output.
    """

    receive_port: int
    send_host: str
    send_port: int
    profile: Profile
    tells_rows: bool = False

    @property
    def name(self) -> str:
        """The simulator's name in messages to people."""
        return f"UDP port {self.receive_port}"

    def same_device(self, other: SimulatorAddress) -> bool:
        """Whether the two use the same port, so that one must be closed to open the other."""
        return self.receive_port == other.receive_port

    @property
    def udp(self) -> UdpAddress:
        """The address of its socket."""
        return UdpAddress(self.receive_port, self.send_host, self.send_port)

    def as_dict(self) -> dict[str, Any]:
        """Plain values."""
        return asdict(self)


class Simulator(KeepsOpen[SimulatorAddress, UdpLink]):
    """Owns the socket's life and hands its datagrams to the bridge."""

    def __init__(
        self,
        hil: Hil,
        clock: LineClock,
        tap: Tap,
        report: Callable[[GatewayError], None],
        on_change: Callable[[], None],
    ) -> None:
        self._clock = clock
        self._hil = hil
        self._tap = tap
        self._decode = clock.decoding(hil.on_datagram)
        self._report = report
        self._last_datagram_s: float | None = None
        # What the embedded simulator says of its faults; None: nobody says anything any more.
        self.on_report: Callable[[bytes | None], None] = lambda _: None
        self.datagrams = 0
        self.bytes_in = 0
        self.dropped: Counter[str] = Counter()
        self.last_stranger_s: float | None = None
        self.last_stranger: str | None = None
        self._telling = Repeating(asyncio.get_running_loop(), "rows asked of X-Plane", self._tell_rows, _TELL_EVERY_S)
        self._kept = KeptOpen(
            LinkHandlers(
                open=self._bind,
                begin=self._begin,
                end=self._end,
                gone=hil.end,
                report=report,
                changed=on_change,
            )
        )

    @property
    def is_listening(self) -> bool:
        """Whether the socket is open."""
        return self._kept.link is not None

    @property
    def pinned(self) -> str | None:
        """Host and port of the sender that is heard."""
        link = self._kept.link
        return None if link is None else link.pinned

    @property
    def state(self) -> State:
        """closed; opening: listening and nothing heard yet; open: it sends; lost: it stopped, or the port is taken."""
        if self.address is None:
            return "closed"
        if self._kept.link is None:
            return "lost" if self.failure is not None else "opening"
        if self._last_datagram_s is None:
            return "opening"
        return "open" if self._clock.steady_s() - self._last_datagram_s < _LOST_AFTER_S else "lost"

    def want(self, address: SimulatorAddress) -> None:
        """Listen here as soon as it can be done; for the start, when nobody waits for an answer."""
        self._kept.want(address)

    def order(self, datagram: bytes) -> None:
        """Send it, if the socket is open. Only the embedded simulator knows what an order is."""
        if self._kept.link is not None:
            self._kept.link.send(datagram)

    async def close(self) -> None:
        """Hand the controls back and stop listening."""
        await self._kept.close()

    async def _bind(self, address: SimulatorAddress) -> UdpLink:
        callbacks = UdpCallbacks(self._on_datagram, self._on_strangers, self._tap, _is_of_a_simulator)
        return await open_udp(address.udp, callbacks)

    def _begin(self, address: SimulatorAddress, link: UdpLink) -> None:
        self._last_datagram_s = None
        self._hil.begin(link, address.profile)
        if address.tells_rows:
            self._telling.arm()

    def _tell_rows(self) -> float | None:
        """Have X-Plane send its rows here, unless it does; None where that is its user's matter."""
        link, address = self._kept.link, self.address
        if link is None or address is None or not address.tells_rows:
            return None
        own_host = link.own_host
        if own_host is not None and (self.state != "open" or self._hil.missing_rows):
            for datagram in output_datagrams(own_host, link.receive_port, XPLANE_ROWS[address.profile]):
                link.send(datagram)
        return _TELL_EVERY_S

    def _end(self, link: UdpLink) -> None:
        self._telling.cancel()
        link.send(release_datagram())
        link.close()
        self._hil.end()
        self.on_report(None)

    def _on_datagram(self, datagram: bytes) -> None:
        if self._decode(datagram):
            self._last_datagram_s = self._clock.steady_s()
            self.datagrams += 1
            self.bytes_in += len(datagram)
            return
        if datagram.startswith(REPORT_MAGIC):
            self.on_report(datagram)
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

    def _on_strangers(self, sender: str, count: int) -> None:
        self.dropped["stranger"] += count
        self.last_stranger_s = self._clock.steady_s()
        self.last_stranger = sender
        configured = self.pinned or ("" if self.address is None else self.address.send_host)
        self._report(
            LinkError(
                "datagram_stranger",
                f"A datagram from {sender} was dropped because the simulator is at {configured}: "
                "correct the simulator's address if it moved.",
                host=sender,
                configured=configured,
            )
        )


def _is_of_a_simulator(datagram: bytes) -> bool:
    return parse(datagram) is not None
