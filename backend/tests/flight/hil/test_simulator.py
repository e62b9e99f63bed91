"""The simulator's socket: what is no datagram of it, and a port that is not free."""

from __future__ import annotations

import socket
from collections.abc import Mapping
from dataclasses import asdict
from pathlib import Path
from typing import Any

import pytest

from epf_gcs.bus.vehicle_end import Broadcast
from epf_gcs.contract.events import ErrorEvent, Event
from epf_gcs.contract.simulator_faults import FaultReport, WindState, datagram
from epf_gcs.errors import LinkError
from epf_gcs.flight.flight import Flight
from epf_gcs.flight.hil.simulator import Profile, SimulatorAddress
from epf_gcs.xplane.datagram import Record, build
from tests.support.waiting import eventually_async

pytestmark = pytest.mark.anyio


def taken_port() -> socket.socket:
    sock = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    sock.bind(("127.0.0.1", 0))
    return sock


def an_address(port: int, send_port: int = 49000) -> SimulatorAddress:
    return SimulatorAddress(port, "127.0.0.1", send_port, "xp10")


def free_port() -> int:
    with taken_port() as probe:
        return int(probe.getsockname()[1])


def state(station: Flight) -> str:
    return station.simulator.state


def errors_of(event: Event) -> list[dict[str, Any]]:
    return [asdict(event)] if isinstance(event, ErrorEvent) else []


async def test_rubbish_and_strangers_are_counted_and_told(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    told: list[Mapping[str, Any]] = []
    monkeypatch.setattr(Broadcast, "event", lambda _, event: told.extend(errors_of(event)))
    station = Flight(tmp_path, record=False)
    async with station.running():
        port = free_port()
        await station.lines.open_simulator(an_address(port))
        with taken_port() as sender:
            for datagram in (b"", b"DATA", b"DATA@", b"DATA@" + b"x" * 35, b"RREF,xxxx", b"x" * 1000):
                sender.sendto(datagram, ("127.0.0.1", port))
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as stranger:
            stranger.bind(("127.0.0.2", 0))
            stranger.sendto(b"DATA@" + b"\0" * 36, ("127.0.0.1", port))
        await eventually_async(lambda: sum(station.simulator.dropped.values()) == 7, "all are counted")
        assert station.simulator.dropped == {"malformed": 6, "stranger": 1}
        assert station.simulator.datagrams == 0
        assert state(station) == "opening"
        assert station.errors.counts == {"datagram_malformed": 6, "datagram_stranger": 1}
        assert station.simulator.bytes_in == 0
        assert station.simulator.last_stranger_s is not None
        malformed, foreign = sorted(told, key=lambda one: one["code"])
        assert "A datagram of 0 bytes was dropped" in malformed["detail"]
        assert malformed["params"] == {"bytes": 0}
        assert foreign["params"] == {"host": station.simulator.last_stranger, "configured": "127.0.0.1"}
        assert "because the simulator is at 127.0.0.1" in foreign["detail"]


async def test_what_the_simulator_says_of_its_faults_is_not_rubbish(tmp_path: Path) -> None:
    station = Flight(tmp_path, record=False)
    report = datagram(FaultReport(1, WindState(0.0, 0.0, "none"), ()))
    async with station.running():
        port = free_port()
        await station.lines.open_simulator(an_address(port))
        with taken_port() as relay:
            for sent in (report, b"rubbish"):
                relay.sendto(sent, ("127.0.0.1", port))
        await eventually_async(lambda: bool(station.simulator.dropped), "what comes after it is counted")
        assert station.simulator.dropped == {"malformed": 1}
        assert station.errors.counts == {"datagram_malformed": 1}


async def test_a_simulator_that_sent_nothing_for_a_second_is_lost(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    station = Flight(tmp_path, record=False)
    async with station.running():
        port = free_port()
        await station.lines.open_simulator(an_address(port))
        with taken_port() as sender:
            sender.sendto(build([Record(3, (0.0,) * 8)]), ("127.0.0.1", port))
            await eventually_async(lambda: station.simulator.datagrams == 1, "it is heard")
        heard_s = station.simulator._last_datagram_s
        assert heard_s is not None
        for later_s, expected in ((0.0, "open"), (0.9, "open"), (1.1, "lost")):
            monkeypatch.setattr(type(station.clock), "steady_s", lambda _, now_s=heard_s + later_s: now_s)
            assert state(station) == expected


async def test_a_simulator_that_is_opened_anew_counts_as_open_when_it_is_heard_again(tmp_path: Path) -> None:
    station = Flight(tmp_path, record=False)
    async with station.running():
        port = free_port()
        profiles: tuple[Profile, ...] = ("xp10", "xp12")
        for opened, profile in enumerate(profiles):
            await station.lines.open_simulator(SimulatorAddress(port, "127.0.0.1", 49000, profile))
            assert (state(station), station.hil.profile) == ("opening", profile)
            with taken_port() as sender:
                for _ in range(2):
                    sender.sendto(b"DATA@" + b"\0" * 36, ("127.0.0.1", port))
                await eventually_async(lambda n=2 * opened + 2: station.simulator.datagrams == n, "it is heard")  # type: ignore[misc]
            assert station.simulator._last_datagram_s is not None
        assert station.simulator.bytes_in == 4 * 41


async def test_many_strangers_are_counted_one_by_one_and_told_where_the_simulator_is(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    told: list[Mapping[str, Any]] = []
    monkeypatch.setattr(Broadcast, "event", lambda _, event: told.extend(errors_of(event)))
    station = Flight(tmp_path, record=False)
    async with station.running():
        port = free_port()
        await station.lines.open_simulator(an_address(port))
        with taken_port() as simulator, socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as other:
            other.bind(("127.0.0.2", 0))
            simulator.sendto(b"DATA@" + b"\0" * 36, ("127.0.0.1", port))
            await eventually_async(lambda: station.simulator.datagrams == 1, "the simulator is heard")
            pinned = f"127.0.0.1:{simulator.getsockname()[1]}"
            for _ in range(20):
                other.sendto(b"DATA@" + b"\0" * 36, ("127.0.0.1", port))
            await eventually_async(lambda: station.simulator.dropped["stranger"] == 20, "all are counted")
        assert told[0]["params"] == {"host": station.simulator.last_stranger, "configured": pinned}


async def test_a_taken_port_leaves_everything_as_it_was(tmp_path: Path) -> None:
    station = Flight(tmp_path, record=False)
    async with station.running():
        with taken_port() as other:
            with pytest.raises(LinkError, match="is taken by another program"):
                await station.lines.open_simulator(an_address(other.getsockname()[1]))
            assert state(station) == "closed"
            good = an_address(free_port())
            await station.lines.open_simulator(good)
            with pytest.raises(LinkError):
                await station.lines.open_simulator(an_address(other.getsockname()[1]))
            assert station.simulator.address == good
            assert state(station) == "opening"


async def test_the_same_port_can_be_opened_with_another_simulator(tmp_path: Path) -> None:
    station = Flight(tmp_path, record=False)
    async with station.running():
        port = free_port()
        await station.lines.open_simulator(an_address(port, 49000))
        await station.lines.open_simulator(an_address(port, 49010))
        assert station.simulator.address == an_address(port, 49010)
        with pytest.raises(LinkError):
            await station.lines.open_simulator(SimulatorAddress(port, "no.such.host.invalid", 49000, "xp10"))
        assert station.simulator.address == an_address(port, 49010)
        assert state(station) == "opening"


async def test_a_remembered_port_that_nobody_tried_to_open_yet_is_not_lost(tmp_path: Path) -> None:
    station = Flight(tmp_path, record=False)
    assert state(station) == "closed"
    station.simulator.want(an_address(49003))
    assert (state(station), station.simulator.is_listening, station.simulator.pinned) == ("opening", False, None)


async def test_a_remembered_port_that_is_taken_is_opened_when_it_is_free(tmp_path: Path) -> None:
    other = taken_port()
    first = Flight(tmp_path, record=False)
    first.memory.update(simulator=an_address(other.getsockname()[1]).as_dict())
    first.memory.close()
    station = Flight(tmp_path, record=False)
    async with station.running():
        await eventually_async(lambda: state(station) == "lost", "the port is missed")
        assert station.simulator.failure is not None
        assert station.simulator.failure.code == "port_taken"
        other.close()
        await eventually_async(lambda: state(station) == "opening", "it is opened when it is free")


async def test_an_old_port_that_cannot_be_had_back_at_once_is_had_when_it_is_free(tmp_path: Path) -> None:
    station = Flight(tmp_path, record=False)
    async with station.running():
        port = free_port()
        await station.lines.open_simulator(an_address(port))
        thief = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        told_end = station.hil.end

        def steal() -> None:
            station.hil.end = told_end  # type: ignore[method-assign]
            told_end()
            thief.bind(("127.0.0.1", port))

        station.hil.end = steal  # type: ignore[method-assign]
        with thief:
            with pytest.raises(LinkError):
                await station.lines.open_simulator(SimulatorAddress(port, "no.such.host.invalid", 49000, "xp10"))
            await eventually_async(lambda: state(station) == "lost", "the port is missed")
        with taken_port() as sender:

            def heard() -> bool:
                sender.sendto(b"DATA@" + b"\0" * 36, ("127.0.0.1", port))
                return state(station) == "open"

            await eventually_async(heard, "the old port is listened to again")


async def test_rows_of_another_program_on_the_simulators_machine_are_dropped_and_told(tmp_path: Path) -> None:
    station = Flight(tmp_path, record=False)
    async with station.running():
        port = free_port()
        await station.lines.open_simulator(an_address(port))
        with taken_port() as simulator, taken_port() as other:
            simulator.sendto(b"DATA@" + b"\0" * 36, ("127.0.0.1", port))
            await eventually_async(lambda: state(station) == "open", "the simulator is heard")
            other.sendto(b"DATA@" + b"\0" * 36, ("127.0.0.1", port))
            await eventually_async(lambda: station.simulator.dropped["stranger"] == 1, "the other is dropped")
            assert station.simulator.datagrams == 1
            assert station.simulator.pinned == f"127.0.0.1:{simulator.getsockname()[1]}"
            assert station.simulator.last_stranger == f"127.0.0.1:{other.getsockname()[1]}"


async def test_a_simulator_that_stops_is_lost_and_comes_back(tmp_path: Path) -> None:
    station = Flight(tmp_path, record=False)
    async with station.running():
        port = free_port()
        await station.lines.open_simulator(an_address(port))
        with taken_port() as sender:
            sender.sendto(b"DATA@" + b"\0" * 36, ("127.0.0.1", port))
            await eventually_async(lambda: state(station) == "open", "it is heard")
            await eventually_async(lambda: state(station) == "lost", "its silence is noticed")
            sender.sendto(b"DATA@" + b"\0" * 36, ("127.0.0.1", port))
            await eventually_async(lambda: state(station) == "open", "it is heard again")
