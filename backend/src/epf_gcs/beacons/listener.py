"""Hears the beacons of X-Planes on this computer's networks, in the web process: a flood costs the flight nothing.

A beacon only says where a simulator may be. It is opened by a person, like one whose address was typed. Nothing is
listened to unless somebody looks.
"""

from __future__ import annotations

import asyncio
import contextlib
import ipaddress
import socket
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import Final

import structlog

from epf_gcs.repeating import Repeating
from epf_gcs.tls.identity import addresses_here
from epf_gcs.xplane.beacon import BEACON_GROUP, BEACON_PORT, Beacon, parse_beacon

log = structlog.get_logger("beacons")

# X-Plane says it once a second.
_GONE_AFTER_S: Final = 5.0
# Whoever looks for simulators asks every few seconds.
_LISTENS_S: Final = 15.0
_MOST: Final = 16
_LONGEST_BYTES: Final = 1024
# At most so many are read in a turn, and a turn comes so often: whoever sends more is not heard.
_A_TURN: Final = 64
_PAUSE_S: Final = 0.5
# Networks come and go: a laptop joins the field's while the station runs.
_JOIN_EVERY_S: Final = 10.0


@dataclass(frozen=True, slots=True)
class NearbySimulator:
    """An X-Plane that was heard within the last seconds, and the address that it was heard from."""

    host: str
    beacon: Beacon
    heard_s: float


class BeaconListener:
    """Listens for some seconds after each `look`. `port` and `addresses` are others in tests alone."""

    def __init__(
        self,
        now_s: Callable[[], float],
        port: int = BEACON_PORT,
        addresses: Callable[[], Iterable[str]] = addresses_here,
    ) -> None:
        self._now_s = now_s
        self._port = port
        self._addresses = addresses
        self._heard: dict[tuple[str, int], NearbySimulator] = {}
        self._joined: set[str] = set()
        self._join_at_s = 0.0
        self._door: socket.socket | None = None
        self._until_s = 0.0
        self._turns: Repeating | None = None

    def look(self) -> list[NearbySimulator]:
        """The simulators heard lately, by name and address; what comes from now on is in the next answer."""
        now_s = self._now_s()
        self._until_s = now_s + _LISTENS_S
        if self._turns is not None:
            self._turns.arm()
        lately = (one for one in self._heard.values() if now_s - one.heard_s <= _GONE_AFTER_S)
        return sorted(lately, key=lambda one: (one.beacon.name, one.host, one.beacon.port))

    async def run(self) -> None:
        """Listen when somebody looks, until cancelled."""
        self._turns = Repeating(asyncio.get_running_loop(), "beacons of simulators", self._turn, _PAUSE_S)
        try:
            await asyncio.Event().wait()
        finally:
            self._turns.stop()
            self._turns = None
            self._close()

    def _turn(self) -> float | None:
        now_s = self._now_s()
        if now_s > self._until_s:
            self._close()
            return None
        if self._door is None:
            self._open()
        if now_s >= self._join_at_s:
            self._join_at_s = now_s + _JOIN_EVERY_S
            self._join()
        self._read()
        return _PAUSE_S

    def _open(self) -> None:
        """Where the port cannot be had, that is logged, nothing is heard, and the next look tries again."""
        self._join_at_s = 0.0
        try:
            self._door = _door(self._port)
        except OSError as error:
            log.warning("beacons of simulators cannot be heard", reason=str(error))
            self._until_s = 0.0

    def _close(self) -> None:
        self._joined.clear()
        if self._door is not None:
            self._door.close()
            self._door = None

    def _join(self) -> None:
        """Hear the group on each network that this computer is in now."""
        for address in self._addresses():
            if self._door is None or address in self._joined:
                continue
            # An IPv6 address, or a network without groups, is left out, and asked again.
            with contextlib.suppress(OSError):
                membership = socket.inet_aton(BEACON_GROUP) + socket.inet_aton(address)
                self._door.setsockopt(socket.IPPROTO_IP, socket.IP_ADD_MEMBERSHIP, membership)
                self._joined.add(address)

    def _read(self) -> None:
        for _ in range(_A_TURN):
            try:
                if self._door is None:
                    return
                datagram, sender = self._door.recvfrom(_LONGEST_BYTES)
            except OSError:
                return
            beacon = parse_beacon(datagram)
            if beacon is not None:
                self._take(NearbySimulator(self._reached(str(sender[0])), beacon, self._now_s()))

    def _take(self, found: NearbySimulator) -> None:
        """Keep the newest of each; where there are too many, the one that was not heard for longest goes."""
        self._heard[found.host, found.beacon.port] = found
        if len(self._heard) > _MOST:
            del self._heard[min(self._heard, key=lambda key: self._heard[key].heard_s)]

    def _reached(self, host: str) -> str:
        """One on this computer is reached by the loopback, also when its networks go."""
        return "127.0.0.1" if ipaddress.ip_address(host).is_loopback or host in self._joined else host


def _door(port: int) -> socket.socket:
    """A socket that other programs on this computer, X-Plane's own tools among them, may have beside us."""
    door = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    try:
        door.setblocking(False)
        door.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        if hasattr(socket, "SO_REUSEPORT"):
            with contextlib.suppress(OSError):
                door.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEPORT, 1)
        # Only what is sent to the group: Windows alone does not know that.
        with contextlib.suppress(OSError):
            door.bind((BEACON_GROUP, port))
            return door
        door.bind(("", port))
    except BaseException:
        door.close()
        raise
    return door
