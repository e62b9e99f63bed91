"""Faults are ordered from the embedded simulator, seen by everybody and noted, and refused with another simulator."""

from __future__ import annotations

from collections.abc import AsyncIterator, Mapping
from pathlib import Path
from typing import Any

import pytest

from epf_gcs.bus.definition import Asker
from epf_gcs.bus.vehicle_end import Broadcast
from epf_gcs.contract.events import Event, FaultEvent, WindEvent
from epf_gcs.contract.requests import BeginFault, EndFault, Request, SetWind
from epf_gcs.contract.simulator_faults import (
    Fault,
    FaultOrder,
    FaultReport,
    FlownFault,
    SimulatedFaults,
    WindState,
    datagram,
    noted_faults,
    read_datagram,
)
from epf_gcs.errors import ConflictError, InvalidInputError, NotFoundError, UnavailableError
from epf_gcs.flight.flight import Flight
from epf_gcs.flight.hil import simulator_faults
from epf_gcs.flight.hil.simulator import SimulatorAddress
from epf_gcs.flight.hil.simulator_faults import SimulatorFaultControl
from tests.support.embedded import embedded_simulator
from tests.support.ports import free_udp_port
from tests.support.waiting import eventually_async

pytestmark = pytest.mark.anyio
BY = Asker(None)


@pytest.fixture
def told(monkeypatch: pytest.MonkeyPatch) -> list[Event]:
    events: list[Event] = []
    monkeypatch.setattr(Broadcast, "event", lambda _, event: events.append(event))
    return events


@pytest.fixture
async def station(tmp_path: Path, told: list[Event]) -> AsyncIterator[Flight]:
    flight = Flight(tmp_path, record=False)
    async with flight.running():
        yield flight


async def ask(flight: Flight, request: Request[Any]) -> Any:
    return await flight._requests[type(request)](request, BY)


def flown(flight: Flight) -> SimulatedFaults | None:
    return flight.status().simulator.faults


async def joined(flight: Flight, port: int, station_port: int) -> None:
    await flight.lines.open_simulator(SimulatorAddress(station_port, "127.0.0.1", port, "xp10"))
    await eventually_async(lambda: flown(flight) is not None, "the simulator answers orders")


def states(told: list[Event]) -> list[tuple[str, str]]:
    return [(one.state, f"{one.place}.{one.kind}") for one in told if isinstance(one, FaultEvent)]


async def test_a_fault_is_begun_seen_and_ended_by_one_request_each(station: Flight, told: list[Event]) -> None:
    station_port = free_udp_port()
    with embedded_simulator(station_port) as port:
        await joined(station, port, station_port)
        begun = await ask(station, BeginFault("pitot", "bias", strength=8.0))
        assert (begun.place, begun.kind, begun.strength, begun.unit, begun.ends_s) == ("pitot", "bias", 8.0, "kt", None)
        now = flown(station)
        assert now is not None
        assert [one.id for one in now.faults] == [begun.id]
        assert states(told) == [("begun", "pitot.bias")]
        await ask(station, BeginFault("gps", "drift", start_s=600.0))
        assert len(states(told)) == 1, "what waits has not begun"
        assert (await ask(station, EndFault())).faults == []
        assert states(told) == [("begun", "pitot.bias"), ("ended", "pitot.bias")]
        with pytest.raises(NotFoundError, match="it has ended"):
            await ask(station, EndFault(begun.id))


async def test_a_fault_ends_by_itself_and_the_event_says_in_how_many_frames_it_showed(
    station: Flight, told: list[Event]
) -> None:
    station_port = free_udp_port()
    with embedded_simulator(station_port) as port:
        await joined(station, port, station_port)
        await ask(station, BeginFault("barometer", "bias", start_s=0.1, length_s=0.2))
        await eventually_async(lambda: len(states(told)) == 2, "it begins and ends")
        assert states(told) == [("begun", "barometer.bias"), ("ended", "barometer.bias")]
        ended = told[-1]
        assert isinstance(ended, FaultEvent)
        assert ended.frames == pytest.approx(10, abs=1)


async def test_a_silence_that_was_ordered_ends_no_fault(station: Flight, told: list[Event]) -> None:
    station_port = free_udp_port()
    with embedded_simulator(station_port) as port:
        await joined(station, port, station_port)
        await ask(station, BeginFault("gyro", "bias"))
        await ask(station, BeginFault("simulator", "silent", length_s=30.0))
        await eventually_async(lambda: station.simulator.state == "lost", "its rows stay away")
        assert states(told) == [("begun", "gyro.bias"), ("begun", "simulator.silent")]
        assert len((await ask(station, EndFault())).faults) == 0


async def test_the_wind_is_set_and_told(station: Flight, told: list[Event]) -> None:
    station_port = free_udp_port()
    with embedded_simulator(station_port) as port:
        await joined(station, port, station_port)
        blown = await ask(station, SetWind(250.0, 15.0, "moderate"))
        assert blown.wind == WindState(250.0, 15.0, "moderate")
        assert [one for one in told if isinstance(one, WindEvent)] == [WindEvent(250.0, 15.0, "moderate")]


async def test_closing_the_simulators_port_ends_its_faults_at_once(station: Flight, told: list[Event]) -> None:
    station_port = free_udp_port()
    with embedded_simulator(station_port) as port:
        await joined(station, port, station_port)
        await ask(station, BeginFault("gyro", "bias"))
        await station.lines.close_simulator()
        assert flown(station) is None
        assert states(told) == [("begun", "gyro.bias"), ("ended", "gyro.bias")]


async def test_a_simulator_that_is_gone_takes_no_orders_and_its_faults_have_ended(
    station: Flight, told: list[Event]
) -> None:
    station_port = free_udp_port()
    with embedded_simulator(station_port) as port:
        await joined(station, port, station_port)
        await ask(station, BeginFault("gyro", "bias"))
    await eventually_async(lambda: flown(station) is None, "it is missed")
    assert states(told) == [("begun", "gyro.bias"), ("ended", "gyro.bias")]
    with pytest.raises(ConflictError, match="none is in the loop"):
        await ask(station, EndFault())


@pytest.mark.parametrize(
    ("request_", "code"),
    [
        (BeginFault("gyro", "dropout"), "fault_not_carried"),
        (BeginFault("gyro", "jammed"), "fault_out_of_range"),
        (BeginFault("pitot", "bias", strength=900.0), "fault_out_of_range"),
        (BeginFault("gyro", "stuck", strength=1.0), "fault_out_of_range"),
        (BeginFault("gyro", "bias"), "faults_no_simulator"),
        (EndFault(), "faults_no_simulator"),
        (SetWind(0.0, 10.0, "none"), "faults_no_simulator"),
    ],
)
async def test_what_cannot_be_flown_is_refused_in_words(station: Flight, request_: Request[Any], code: str) -> None:
    with pytest.raises((ConflictError, InvalidInputError)) as refused:
        await ask(station, request_)
    assert refused.value.code == code


class Outlet:
    def __init__(self) -> None:
        self.events: list[Event] = []

    def event(self, event: Event) -> None:
        self.events.append(event)


class Moment:
    """A clock in the test's hand."""

    def __init__(self) -> None:
        self.s = 1000.0

    def now_s(self) -> float:
        return self.s

    def steady_s(self) -> float:
        return self.s


class Deaf:
    """A simulator that reports, and obeys no order."""

    def __init__(self) -> None:
        self.orders: list[FaultOrder] = []
        self.known: list[Mapping[str, object]] = []
        self.moment = Moment()
        self.faults = SimulatorFaultControl(
            self._take,
            Outlet(),  # type: ignore[arg-type]
            self.moment,  # type: ignore[arg-type]
            self.known.append,
            lambda: None,
        )

    def _take(self, data: bytes) -> None:
        order = read_datagram(data, FaultOrder)
        assert order is not None
        self.orders.append(order)

    def report(self, wind: WindState, *faults: FlownFault) -> None:
        self.faults.on_datagram(datagram(FaultReport(0, wind, faults)))


async def test_an_order_is_sent_again_until_it_is_obeyed_and_then_given_up(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(simulator_faults, "_TRY_S", 0.01)
    deaf = Deaf()
    deaf.report(WindState())
    with pytest.raises(UnavailableError, match="does not answer"):
        await deaf.faults.begin(Fault("gyro", "bias", 0.0))
    assert len(deaf.orders) == simulator_faults._TRIES
    assert len({order.begin.id for order in deaf.orders if order.begin is not None}) == 1


async def test_a_simulator_that_says_nothing_of_faults_is_sent_no_order() -> None:
    deaf = Deaf()
    await deaf.faults._look()
    deaf.faults.on_datagram(b"EPFS?")
    with pytest.raises(ConflictError, match="none is in the loop"):
        await deaf.faults.blow(WindState(90.0, 5.0))
    assert deaf.orders == []


async def test_the_recording_knows_what_is_flown_and_a_replay_reads_it_back() -> None:
    deaf = Deaf()
    deaf.report(WindState(90.0, 5.0), FlownFault("a", Fault("gps", "jump", 5.0, 20.0), -1.0, 19.0, 50))
    now = deaf.faults.flown
    assert now is not None
    assert [(one.begins_s, one.ends_s, one.strength) for one in now.faults] == [(999.0, 1019.0, 100.0)]
    assert noted_faults(deaf.known[-1]) == now
    deaf.faults.on_datagram(None)
    assert noted_faults(deaf.known[-1]) is None


async def test_a_simulator_is_gone_when_it_has_said_nothing_for_five_seconds() -> None:
    deaf = Deaf()
    deaf.report(WindState())
    deaf.moment.s += 4.9
    await deaf.faults._look()
    assert deaf.faults.flown is not None
    deaf.moment.s += 0.2
    await deaf.faults._look()
    assert deaf.faults.flown is None


@pytest.mark.parametrize("content", [{}, {"flown": 3}, {"flown": {"faults": [{"id": 1}], "wind": {}}}])
async def test_a_strangers_note_of_faults_says_nothing(content: Mapping[str, object]) -> None:
    assert noted_faults(content) is None
