"""The ports of MAVLink's peers, and the station that they hear of: one that is lost is looked for again."""

from __future__ import annotations

import asyncio
import sys
import time
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from dataclasses import dataclass
from typing import Final

from epf_gcs.client import Station, StationError, StationLostError
from epf_gcs.mavlink.bridge import RATE_HZ, Bridge
from epf_gcs.mavlink.choice import Choice
from epf_gcs.mavlink.dialect import SYSTEM_ID, Message
from epf_gcs.mavlink.peers import Peer, Peers, TcpPeer, UdpPeers

_AGAIN_S: Final = 2.0
_OWN_COMPUTER: Final = "127.0.0.1"
_EVERYWHERE: Final = "0.0.0.0"  # noqa: S104 - with a signing key only


@dataclass(frozen=True, slots=True)
class Ports:
    """Where datagrams go from the start, where connections are taken, and the key that signs."""

    udp: tuple[str, int]
    tcp: tuple[str, int] | None = None
    signing_key: bytes | None = None


async def serve(url: str, key: str | None, choice: Choice, ports: Ports) -> str:
    """Serve until the station refuses this program, or a port cannot be opened: the sentence that says why."""
    loop = asyncio.get_running_loop()
    bridges: list[Bridge] = []

    def hear(peer: Peer, message: Message) -> None:
        for bridge in bridges:
            bridge.hear(peer, message)

    peers = Peers(hear, loop.time, ports.signing_key)
    try:
        async with _opened(peers, ports):
            print(
                f"MAVLink to {ports.udp[0]}:{ports.udp[1]}, system {SYSTEM_ID}, aircraft {choice.aircraft}.", flush=True
            )
            while True:
                refusal = await _follow(url, key, choice, peers, bridges)
                if refusal is not None:
                    return f"The station does not let this program in: {refusal}"
                await asyncio.sleep(_AGAIN_S)
    except OSError as error:
        return f"The port cannot be opened: {error}."


@asynccontextmanager
async def _opened(peers: Peers, ports: Ports) -> AsyncIterator[None]:
    """The ports, open inside. Raises OSError."""
    loop = asyncio.get_running_loop()
    # Who answers a program of this computer is on it too: nobody else is heard.
    here = _OWN_COMPUTER if ports.udp[0] == _OWN_COMPUTER else _EVERYWHERE
    datagrams, _ = await loop.create_datagram_endpoint(lambda: UdpPeers(peers, ports.udp), local_addr=(here, 0))
    try:
        if ports.tcp is None:
            yield
        else:
            async with await loop.create_server(lambda: TcpPeer(peers), *ports.tcp):
                yield
    finally:
        datagrams.close()
        # It is closed at the loop's next turn.
        await asyncio.sleep(0)


async def _follow(url: str, key: str | None, choice: Choice, peers: Peers, bridges: list[Bridge]) -> str | None:
    """Until the station is lost; a sentence if it lets nobody in. Meanwhile the peers hear nothing: nothing is live."""
    refusal = None
    try:
        async with Station(url, key, name="epf-mavlink", rate_hz=RATE_HZ, asks_for_control=True) as station:
            print(f"The station at {url} is there.", flush=True)
            bridges.append(Bridge(station, peers, choice, time.time()))
            await bridges[0].run()
    except* StationError as refusals:
        refusal = str(refusals.exceptions[0])
    except* StationLostError as lost:
        print(lost.exceptions[0], file=sys.stderr, flush=True)
    bridges.clear()
    return refusal
