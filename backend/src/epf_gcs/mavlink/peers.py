"""Who speaks MAVLink with this vehicle over UDP or TCP. Each has numbers of its own; one that does not read is left."""

from __future__ import annotations

import asyncio
import hashlib
from collections import deque
from collections.abc import Callable
from typing import Final, cast

from epf_gcs.mavlink.dialect import COMPONENT_ID, SYSTEM_ID, WIRE, Message

# A network may deliver a datagram twice, at once; a station that asks again numbers its question anew, and one that
# was started again numbers from the beginning.
_REMEMBERED_FRAMES: Final = 64
_TWICE_WITHIN_S: Final = 1.0
_MOST_PEERS: Final = 8
_SILENT_AFTER_S: Final = 30.0
_MOST_UNSENT_BYTES: Final = 65536


class Peer:
    """One of them. `send` packs; `hear` parses, drops what came twice and what this vehicle said itself."""

    def __init__(self, write: Callable[[bytes], None], signing_key: bytes | None) -> None:
        self.heard_s = 0.0
        self.damaged = 0
        self._write = write
        self._wire = WIRE.MAVLink(None, SYSTEM_ID, COMPONENT_ID)
        self._wire.robust_parsing = True
        if signing_key is not None:
            self._wire.signing.secret_key = signing_key
            self._wire.signing.sign_outgoing = True
        self._frames: deque[tuple[float, bytes]] = deque(maxlen=_REMEMBERED_FRAMES)

    def send(self, message: Message) -> None:
        """Send a message with this peer's next number."""
        self._write(bytes(message.pack(self._wire)))
        self._wire.seq = (self._wire.seq + 1) % 256

    def hear(self, data: bytes, now_s: float) -> list[Message]:
        """The new messages in these bytes, which came now."""
        heard = []
        for message in self._wire.parse_buffer(data) or ():
            if message.get_type() == "BAD_DATA":
                self.damaged += 1
            elif message.get_srcSystem() != SYSTEM_ID and self._is_new(message, now_s):
                heard.append(message)
        return heard

    def _is_new(self, message: Message, now_s: float) -> bool:
        frame = hashlib.sha256(bytes(message.get_msgbuf())).digest()
        if any(known == frame and now_s - heard_s < _TWICE_WITHIN_S for heard_s, known in self._frames):
            return False
        self._frames.append((now_s, frame))
        return True


class Peers:
    """All of them. `on_message` gets each message with the peer that sent it; `now_s` is a clock that never jumps."""

    def __init__(
        self, on_message: Callable[[Peer, Message], None], now_s: Callable[[], float], signing_key: bytes | None
    ) -> None:
        self._on_message = on_message
        self._now_s = now_s
        self._signing_key = signing_key
        self._peers: dict[object, Peer] = {}
        self._kept: set[object] = set()

    @property
    def count(self) -> int:
        """How many there are."""
        return len(self._peers)

    def send(self, message: Message) -> None:
        """Send it to everybody."""
        for peer in list(self._peers.values()):
            peer.send(message)

    def add(self, key: object, write: Callable[[bytes], None], *, kept: bool = False) -> None:
        """Somebody new; `kept`: it is sent to although it has said nothing."""
        if kept:
            self._kept.add(key)
        self._peers[key] = Peer(write, self._signing_key)
        self._peers[key].heard_s = self._now_s()

    def remove(self, key: object) -> None:
        """It is gone."""
        self._peers.pop(key, None)

    def hear(self, key: object, data: bytes, write: Callable[[bytes], None]) -> None:
        """Bytes of a peer; one that nobody knows yet is taken while there is room."""
        if key not in self._peers:
            self._forget_silent()
            if len(self._peers) >= _MOST_PEERS:
                return
            self.add(key, write)
        peer = self._peers[key]
        now_s = self._now_s()
        messages = peer.hear(data, now_s)
        if messages:
            peer.heard_s = now_s
        for message in messages:
            self._on_message(peer, message)

    def _forget_silent(self) -> None:
        silent_s = self._now_s() - _SILENT_AFTER_S
        for key, peer in list(self._peers.items()):
            if key not in self._kept and peer.heard_s < silent_s:
                del self._peers[key]


class UdpPeers(asyncio.DatagramProtocol):
    """A datagram is answered to where it came from; `target` hears this vehicle from the start."""

    def __init__(self, peers: Peers, target: tuple[str, int]) -> None:
        self._peers = peers
        self._target = target
        self._transport: asyncio.DatagramTransport | None = None

    def connection_made(self, transport: asyncio.BaseTransport) -> None:
        """The socket is open."""
        self._transport = cast(asyncio.DatagramTransport, transport)
        self._peers.add(self._target, self._writer(self._target), kept=True)

    def datagram_received(self, data: bytes, address: tuple[str, int]) -> None:
        """Somebody said something."""
        self._peers.hear(address, data, self._writer(address))

    def error_received(self, error: Exception) -> None:
        """Nobody listens there now: it may later."""

    def _writer(self, address: tuple[str, int]) -> Callable[[bytes], None]:
        def write(data: bytes) -> None:
            if self._transport is not None and not self._transport.is_closing():
                self._transport.sendto(data, address)

        return write


class TcpPeer(asyncio.Protocol):
    """One connection to this program's port."""

    def __init__(self, peers: Peers) -> None:
        self._peers = peers
        self._transport: asyncio.Transport | None = None

    def connection_made(self, transport: asyncio.BaseTransport) -> None:
        """It is open."""
        self._transport = cast(asyncio.Transport, transport)
        self._peers.add(self, self._write)

    def data_received(self, data: bytes) -> None:
        """It said something."""
        self._peers.hear(self, data, self._write)

    def connection_lost(self, error: Exception | None) -> None:
        """It is closed."""
        self._peers.remove(self)

    def _write(self, data: bytes) -> None:
        transport = self._transport
        if transport is None or transport.is_closing():
            return
        if transport.get_write_buffer_size() > _MOST_UNSENT_BYTES:
            # What it does not read now would be old when it does.
            transport.abort()
            return
        transport.write(data)
