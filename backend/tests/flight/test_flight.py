"""How the parts of a flight are connected: what is told to the stations, and when."""

from __future__ import annotations

import asyncio
from pathlib import Path
from typing import Any, cast

import orjson
import pytest
import structlog

from epf_gcs import __version__
from epf_gcs.bus.channel import Channel
from epf_gcs.bus.definition import Client, Decoder, Kind, unpack_named
from epf_gcs.codec.encode import encode_telemetry
from epf_gcs.contract.base import PageFacts
from epf_gcs.contract.hello import ControlHolder
from epf_gcs.flight.flight import Flight
from epf_gcs.link.udp import UdpLink
from epf_gcs.vehicle.alarms import Alarm
from epf_gcs.vehicle.judges import Finding
from epf_gcs.vehicle.restart import Restart

pytestmark = pytest.mark.anyio


class Station:
    """A listener that keeps what it is sent."""

    unsent_bytes = 0

    def __init__(self, flight: Flight) -> None:
        self._decoder = Decoder()
        self.records: list[tuple[str, Any]] = []
        flight.outlet.add(self.channel)

    @property
    def channel(self) -> Channel:
        return cast("Channel", self)

    def send(self, data: bytes) -> None:
        for record in self._decoder.feed(data):
            if record.kind == Kind.EVENT:
                event = unpack_named(record.body)
                self.records.append((event.name, orjson.loads(event.text)["data"]))
            else:
                self.records.append((Kind(record.kind).name, orjson.loads(record.body)))

    def names(self) -> list[str]:
        return [name for name, _ in self.records]


async def a_moment() -> None:
    """Let what was planned for the next turn of the loop happen."""
    for _ in range(3):
        await asyncio.sleep(0)


async def test_changes_that_come_together_are_one_status_and_a_later_one_is_another(tmp_path: Path) -> None:
    flight = Flight(tmp_path, record=False)
    station = Station(flight)
    for _ in range(3):
        flight.changed()
    assert station.names() == []
    await a_moment()
    assert station.names() == ["STATUS"]
    assert station.records[0][1]["board"]["state"] == "closed"
    flight.changed()
    await a_moment()
    assert station.names() == ["STATUS", "STATUS"]


async def test_a_line_that_changes_is_told_with_the_status_before_anything_else(tmp_path: Path) -> None:
    flight = Flight(tmp_path, record=False)
    station = Station(flight)
    flight.on_line()
    assert station.names() == ["link", "STATUS"]
    assert station.records[0][1] == {"board": "closed", "simulator": "closed"}


async def test_a_board_that_started_anew_is_told_with_what_was_lost_by_it(tmp_path: Path) -> None:
    flight = Flight(tmp_path, record=False)
    station = Station(flight)
    flight.parameters._unstored = {"k_roll": None}
    flight.missions._known = {"flight": None}
    flight.on_restarted(Restart(1.0, 120))
    flight.on_restarted(Restart(2.0, None))
    assert station.records == [
        ("board_restarted", {"silent_s": None, "uptime_ms": 120, "parameters": ["k_roll"], "plans": ["flight"]}),
        ("board_restarted", {"silent_s": None, "uptime_ms": None, "parameters": [], "plans": []}),
    ]


async def test_bytes_of_the_board_may_wait_while_neither_a_simulator_nor_a_station_needs_each_at_once(
    tmp_path: Path,
) -> None:
    flight = Flight(tmp_path, record=False)
    assert flight.may_wait()
    station = Station(flight)
    assert not flight.may_wait(), "it wants each sample at once"
    flight.outlet.pace(station.channel, 10)
    assert flight.may_wait()
    flight.hil.link = cast("UdpLink", object())
    assert not flight.may_wait(), "the loop is closed"
    flight.hil.link = None
    assert flight.may_wait()


async def test_a_station_is_greeted_with_whose_controls_they_are_or_were_until_just_now(tmp_path: Path) -> None:
    flight = Flight(tmp_path, record=False)
    hello = flight._hello()
    assert (hello.version, hello.vehicle, hello.control) == (__version__, "live", None)
    assert hello.clock_offset_ns == flight.clock.offset_ns
    assert hello.status.board.state == "closed"
    ana = Client("c1", "Ana", PageFacts("session-a"))
    for holder, kept in ((ana, None), (None, ana)):
        flight.stick.control_changed(holder, kept)
        assert flight._hello().control == ControlHolder("c1", "Ana", PageFacts("session-a"))


async def test_a_board_that_moves_the_surfaces_of_a_simulator_flies(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    flight = Flight(tmp_path, record=False)
    states: list[str] = []
    monkeypatch.setattr(type(flight.simulator), "state", property(lambda _: states[-1]))
    for state, path, flies in (
        ("open", "assisted", True),
        ("open", "manual", False),
        ("lost", "assisted", False),
        ("closed", "assisted", False),
    ):
        states.append(state)
        flight.hil.path = path  # type: ignore[assignment]
        assert flight.flies() is flies


async def test_a_board_flies_as_long_as_one_of_its_autopilots_is_on(tmp_path: Path) -> None:
    flight = Flight(tmp_path, record=False)
    flight.telemetry.take("heartbeat", 1.0, {"autopilot": True, "autopilot_hil": False})
    assert flight.flies()


async def test_a_flight_begins_with_what_was_remembered(tmp_path: Path) -> None:
    before = Flight(tmp_path, record=False)
    assert before.hil.path == "manual"
    before.memory.update(hil_path="assisted", thresholds={"battery_low_v": 11.1})
    before.memory.close()
    flight = Flight(tmp_path, record=False)
    assert flight.hil.path == "assisted"
    assert flight.alarms.thresholds["battery_low_v"] == 11.1
    flight.alarms.choose({"hil_lost_s": 2.0})
    flight.memory.close()
    assert Flight(tmp_path, record=False).alarms.thresholds["hil_lost_s"] == 2.0


def last_s(flight: Flight) -> tuple[float | None, float | None]:
    return flight.hil.last_to_board_s, flight.hil.last_surfaces_s


async def test_a_test_of_the_board_that_has_the_line_leaves_the_loop_at_rest(tmp_path: Path) -> None:
    flight = Flight(tmp_path, record=False)
    flight.hil.last_to_board_s = flight.hil.last_surfaces_s = 1.0
    flight.on_ahrs_test()
    assert last_s(flight) == (1.0, 1.0), "it has not begun"
    flight.board.exclusive_user = flight.ahrs_test
    flight.on_ahrs_test()
    assert last_s(flight) == (None, None)


async def test_gains_of_a_board_that_opened_anew_or_whose_line_has_gone_are_not_known_any_more(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    flight = Flight(tmp_path, record=False)

    def known() -> bool:
        return any(held.value is not None for held in flight.parameters.held.values())

    def loaded() -> bool:
        flight.board.on_bytes(encode_telemetry("autopilot_parameters", *([1] * 17)))
        flight.telemetry.catch_up()
        return known()

    assert loaded()
    flight.on_opened()
    assert not known()
    assert loaded()
    flight.on_line()
    assert not known(), "the board is not open"
    assert loaded()
    monkeypatch.setattr(type(flight.board), "is_open", property(lambda _: True))
    flight.on_line()
    assert known(), "only the simulator's line has changed"


async def test_who_acknowledges_an_unconfirmed_gain_knows_of_it_and_of_another_alarm_does_not(tmp_path: Path) -> None:
    flight = Flight(tmp_path, record=False)
    station = Station(flight)
    flight.parameters.unconfirmed = ("k_roll",)
    flight.on_alarm("acknowledged", Alarm(Finding("battery_low", "warning", "It is low."), 1.0))
    assert list(flight.parameters.unconfirmed) == ["k_roll"]
    await a_moment()
    assert station.names() == ["STATUS"]
    flight.on_alarm("acknowledged", Alarm(Finding("parameter_not_confirmed", "warning", "k_roll."), 1.0))
    assert list(flight.parameters.unconfirmed) == []


async def test_an_alarm_is_in_the_log_with_its_words(tmp_path: Path) -> None:
    flight = Flight(tmp_path, record=False)
    flight.parameters.unconfirmed = ("k_roll",)
    with structlog.testing.capture_logs() as logged:
        flight.alarms.look(1.0)
        flight.alarms.acknowledge("parameter_not_confirmed")
        flight.alarms.look(2.0)
    assert [(line["event"], line["alarm"]) for line in logged] == [
        (f"alarm {news}", "parameter_not_confirmed") for news in ("came", "acknowledged", "went")
    ]
    assert "k_roll" in logged[0]["text"]
