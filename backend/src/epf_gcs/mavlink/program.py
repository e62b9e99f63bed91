"""The ports of MAVLink's peers, and the station that they hear of: one that is lost is looked for again."""

from __future__ import annotations

import asyncio
import sys
import time
from dataclasses import dataclass
from socket import AF_INET
from typing import Final

from epf_gcs.client import Station, StationError, StationLostError
from epf_gcs.mavlink.bridge import RATE_HZ, Bridge
from epf_gcs.mavlink.choice import Choice
from epf_gcs.mavlink.dialect import SYSTEM_ID, Message
from epf_gcs.mavlink.peers import Peer, Peers, TcpPeer, UdpPeers

_AGAIN_S: Final = 2.0
_OWN_COMPUTER: Final = "127.0.0.1"


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
    # Who answers this computer's own station of others is on this computer too: nobody else is listened to.
    here = (_OWN_COMPUTER, 0) if ports.udp[0] == _OWN_COMPUTER else None
    try:
        await loop.create_datagram_endpoint(
            lambda: UdpPeers(peers, ports.udp), local_addr=here, remote_addr=None, family=0 if here else AF_INET
        )
        if ports.tcp is not None:
            await loop.create_server(lambda: TcpPeer(peers), *ports.tcp)
    except OSError as error:
        return f"The port cannot be opened: {error}."
    print(f"MAVLink to {ports.udp[0]}:{ports.udp[1]}, system {SYSTEM_ID}, aircraft {choice.aircraft}.", flush=True)
    while True:
        refusal = await _follow(url, key, choice, peers, bridges)
        if refusal is not None:
            return f"The station does not let this program in: {refusal}"
        await asyncio.sleep(_AGAIN_S)


async def _follow(url: str, key: str | None, choice: Choice, peers: Peers, bridges: list[Bridge]) -> str | None:
    """Until the station is lost; a sentence if it lets nobody in. Meanwhile the peers hear nothing: nothing is live."""
    refusal = None
    try:
        async with Station(url, key, name="epf-mavlink", rate_hz=RATE_HZ) as station:
            print(f"The station at {url} is there.", flush=True)
            bridges.append(Bridge(station, peers, choice, time.time()))
            await bridges[0].run()
    except* StationError as refusals:
        refusal = str(refusals.exceptions[0])
    except* StationLostError as lost:
        print(lost.exceptions[0], file=sys.stderr, flush=True)
    bridges.clear()
    return refusal
