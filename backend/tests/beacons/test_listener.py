"""X-Planes are found by their beacons, on the loopback."""

from __future__ import annotations

import asyncio
import contextlib
import socket
from collections.abc import AsyncIterator

import pytest

from epf_gcs.beacons import listener as listener_module
from epf_gcs.beacons.listener import BeaconListener
from epf_gcs.xplane.beacon import BEACON_GROUP, Beacon, parse_beacon
from tests.support.ports import free_udp_port
from tests.support.waiting import eventually_async
from tests.support.x_plane import XPlane, beacon

pytestmark = pytest.mark.anyio


class Clock:
    now_s = 100.0


@contextlib.asynccontextmanager
async def listening(clock: Clock, port: int) -> AsyncIterator[BeaconListener]:
    listener = BeaconListener(lambda: clock.now_s, port, lambda: ["127.0.0.1"])
    task = asyncio.create_task(listener.run())
    try:
        yield listener
    finally:
        task.cancel()
        await asyncio.wait([task])


async def test_each_generation_is_found_by_itself_and_gone_when_it_is_silent() -> None:
    clock, port = Clock(), free_udp_port()
    with XPlane(115502) as eleven, XPlane(120012) as twelve:
        async with listening(clock, port) as listener:

            def both_found() -> bool:
                eleven.say(port)
                twelve.say(port)
                return len(listener.look()) == 2

            await eventually_async(both_found, "both beacons")
            found = {one.beacon.profile: one for one in listener.look()}
            assert (found["xp10"].host, found["xp10"].beacon.port) == ("127.0.0.1", eleven.port)
            assert found["xp12"].beacon.port == twelve.port
            clock.now_s += 5.1
            assert listener.look() == []


async def test_a_flood_of_invented_beacons_is_kept_to_a_few_and_another_listener_may_be_there() -> None:
    clock, port = Clock(), free_udp_port()
    async with listening(clock, port) as listener, listening(clock, port) as other:
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as stranger:
            stranger.setsockopt(socket.IPPROTO_IP, socket.IP_MULTICAST_IF, socket.inet_aton("127.0.0.1"))

            def flooded() -> bool:
                for number in range(1, 40):
                    stranger.sendto(beacon(120012, number), (BEACON_GROUP, port))
                    stranger.sendto(b"BECN\0nonsense", (BEACON_GROUP, port))
                return bool(listener.look()) and bool(other.look())

            await eventually_async(flooded, "a beacon at both")
            await eventually_async(lambda: flooded() and len(listener.look()) == 16, "as many as are kept")


async def test_nothing_is_listened_to_unless_somebody_looks() -> None:
    clock, port = Clock(), free_udp_port()
    async with listening(clock, port) as listener:
        await asyncio.sleep(0)
        assert not is_taken(port)
        listener.look()
        await eventually_async(lambda: is_taken(port), "it listens")
        clock.now_s += 15.1
        await eventually_async(lambda: not is_taken(port), "it does not any more")


async def test_it_listens_on_after_a_beacon_that_met_a_fault(monkeypatch: pytest.MonkeyPatch) -> None:
    faults = [ZeroDivisionError]

    def faulty(datagram: bytes) -> Beacon | None:
        if faults:
            raise faults.pop()
        return parse_beacon(datagram)

    raised: list[object] = []
    asyncio.get_running_loop().set_exception_handler(lambda _, context: raised.append(type(context["exception"])))
    monkeypatch.setattr(listener_module, "parse_beacon", faulty)
    clock, port = Clock(), free_udp_port()
    with XPlane(120012) as x_plane:
        async with listening(clock, port) as listener:

            def is_found() -> bool:
                x_plane.say(port)
                return bool(listener.look())

            await eventually_async(is_found, "the next beacon")
    assert raised == [ZeroDivisionError]


def is_taken(port: int) -> bool:
    """Whether somebody has the port; whoever shares it says so, which this does not."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as probe:
        try:
            probe.bind((BEACON_GROUP, port))
        except OSError:
            return True
        return False
