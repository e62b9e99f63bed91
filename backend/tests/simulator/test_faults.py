"""Faults while the simulator flies: the truth is what it was, and what is sent of it is what is wrong."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace

import pytest

from epf_gcs.contract.simulator_faults import (
    KINDS,
    MOST_FAULTS,
    Fault,
    FaultOrder,
    OrderedFault,
    WindState,
    not_carried,
)
from epf_gcs.simulator.simulation import Simulation, SimulationOptions
from epf_gcs.simulator.state import FlightState
from epf_gcs.xplane.datagram import Eight, Surfaces, parse, surfaces_datagram

SPEED, CLIMB, RATES, ATTITUDE, PATH, PLACE = 3, 4, 16, 17, 18, 20
CARRIED = [(place, kind) for place, kinds in KINDS.items() for kind in kinds if not_carried(place, kind) is None]


class Flown:
    """A simulation whose datagrams are kept; nobody commands it."""

    def __init__(self) -> None:
        self.crashes: list[str] = []
        self.simulation = Simulation(SimulationOptions(), self.crashes.append)
        self._serial = 0

    def order(self, **order: object) -> None:
        self._serial += 1
        self.simulation.obey(FaultOrder(self._serial, **order))  # type: ignore[arg-type]

    def begin(self, place: str, kind: str, strength: float | None = None, **times: float) -> str:
        name = f"{place}.{kind} {self._serial}"
        fault = Fault(place, kind, times.get("start_s", 0.0), times.get("length_s"), strength)
        self.order(begin=OrderedFault(name, fault))
        return name

    def frame(self) -> list[bytes]:
        """What reaches the station of the next frame."""
        self.simulation.advance()
        self.simulation.send()
        return self.simulation.arrived(self.simulation.time_s)

    def rows(self) -> dict[int, Eight]:
        (datagram,) = self.frame()
        return dict(parse(datagram) or [])

    def frames(self, count: int) -> list[bytes]:
        return [datagram for _ in range(count) for datagram in self.frame()]

    @property
    def truth(self) -> FlightState:
        return self.simulation.state

    @property
    def reported(self) -> dict[str, tuple[float, float | None, int]]:
        report = self.simulation.faults.report(self.simulation.time_s)
        return {one.id: (one.begins_in_s, one.ends_in_s, one.frames) for one in report.faults}


@pytest.fixture
def flown() -> Iterator[Flown]:
    there = Flown()
    yield there
    assert not there.crashes


def test_a_wrong_sensor_is_wrong_in_its_rows_alone_and_the_truth_flies_on(flown: Flown) -> None:
    flown.begin("pitot", "bias", 20.0)
    flown.begin("barometer", "bias", -300.0)
    rows, truth = flown.rows(), flown.truth
    assert rows[SPEED][0] == pytest.approx(truth.airspeed_indicated_kt + 20.0, abs=1e-3)
    assert rows[PLACE][5] == pytest.approx(truth.altitude_indicated_ft - 300.0, abs=0.1)
    assert rows[PLACE][2] == pytest.approx(truth.altitude_ft, abs=0.1)
    assert rows[ATTITUDE][:2] == pytest.approx((truth.pitch_deg, truth.roll_deg), abs=1e-3)


def test_each_sensor_is_wrong_in_the_rows_that_the_board_is_told_from(flown: Flown) -> None:
    for place in ("gyro", "attitude", "gps"):
        flown.begin(place, "bias")
    rows, truth = flown.rows(), flown.truth
    assert abs(rows[RATES][0] - truth.q_rad_s) == pytest.approx(0.03, abs=1e-5)
    assert abs(rows[ATTITUDE][0] - truth.pitch_deg) == pytest.approx(3.0, abs=1e-4)
    north_m = (rows[PLACE][0] - truth.latitude_deg) * 111_195.0
    east_m = (rows[PLACE][1] - truth.longitude_deg) * 111_195.0 * math.cos(math.radians(truth.latitude_deg))
    assert math.hypot(north_m, east_m) == pytest.approx(30.0, abs=1.0)


def test_a_fault_begins_when_it_was_asked_to_and_lasts_as_long(flown: Flown) -> None:
    name = flown.begin("pitot", "bias", 20.0, start_s=0.1, length_s=0.2)
    off = [round(flown.rows()[SPEED][0] - flown.truth.airspeed_indicated_kt) for _ in range(20)]
    assert off == [0] * 4 + [20] * 10 + [0] * 6
    assert flown.reported[name] == pytest.approx((-0.3, -0.1, 10))


def test_what_is_over_is_reported_for_some_seconds_and_then_forgotten(flown: Flown) -> None:
    flown.begin("pitot", "bias", length_s=0.1)
    flown.frames(100)
    assert len(flown.reported) == 1
    flown.frames(100)
    assert flown.reported == {}


def test_a_jammed_surface_stays_where_it_was_whatever_is_commanded(flown: Flown) -> None:
    commanded = surfaces_datagram(Surfaces(0.1, 0.0, 0.0, 0.7))
    other = surfaces_datagram(Surfaces(-0.1, 0.0, 0.0, 0.7))
    assert commanded is not None
    assert other is not None
    flown.simulation.receive(commanded)
    flown.frames(20)
    flown.begin("elevator", "jammed")
    flown.frame()
    flown.simulation.receive(other)
    flown.frames(20)
    assert flown.truth.surfaces.elevator == pytest.approx(0.1, abs=0.01)
    flown.order(ends_all=True)
    flown.frames(20)
    assert flown.truth.surfaces.elevator == pytest.approx(-0.1, abs=0.01)


def test_an_engine_that_is_out_gives_no_thrust_though_the_lever_stands(flown: Flown) -> None:
    before_kt = flown.truth.airspeed_indicated_kt
    lever = flown.rows()[25][0]
    flown.begin("engine", "out")
    flown.frames(250)
    assert flown.truth.surfaces.throttle == 0.0
    assert flown.rows()[25][0] == pytest.approx(lever)
    assert flown.truth.airspeed_indicated_kt < before_kt


def test_a_pause_repeats_the_last_rows_and_the_flight_goes_on_from_there(flown: Flown) -> None:
    (last,) = flown.frame()
    truth = flown.truth
    flown.begin("simulator", "pause", length_s=0.2)
    assert flown.frames(9) == [last] * 9
    assert flown.truth == truth
    assert flown.frames(1) != [last]


def test_a_silent_simulator_sends_nothing_and_stands(flown: Flown) -> None:
    truth = flown.truth
    flown.begin("simulator", "silent", length_s=0.2)
    assert flown.frames(9) == []
    assert flown.truth == truth
    assert len(flown.frames(5)) == 5


def test_a_cut_line_carries_nothing_either_way_while_the_aircraft_flies_on(flown: Flown) -> None:
    command = surfaces_datagram(Surfaces(0.0, 0.0, 0.0, 1.0))
    assert command is not None
    place = flown.truth.latitude_deg
    flown.begin("line", "cut", length_s=0.4)
    flown.simulation.receive(command)
    assert flown.frames(19) == []
    assert flown.simulation.inputs.controls().throttle != 1.0
    assert flown.truth.latitude_deg != place


def test_a_delayed_line_says_when_its_next_datagram_is_due_and_lets_all_go_at_its_end(flown: Flown) -> None:
    flown.begin("line", "delay", 100.0, length_s=0.3)
    assert flown.frames(5) == []
    assert flown.simulation.next_due_s == pytest.approx(0.12)
    assert len(flown.frames(10)) == 10 - 1 + 6
    assert flown.simulation.next_due_s is None


def test_wind_that_is_set_in_flight_moves_the_aircraft_over_the_ground(flown: Flown) -> None:
    flown.frame()
    before_kt = flown.truth.speed_ground_kt
    flown.order(wind=WindState(flown.truth.heading_deg, 10.0))
    flown.frame()
    assert flown.simulation.faults.report(0.0).wind.speed_kt == 10.0
    assert flown.truth.airspeed_true_kt - flown.truth.speed_ground_kt == pytest.approx(10.0, abs=0.5)
    flown.order(wind=WindState(0.0, 0.0))
    flown.frame()
    assert flown.truth.speed_ground_kt == pytest.approx(before_kt, abs=1.0)


def test_a_gust_is_strongest_in_its_middle_and_leaves_the_wind_as_it_was(flown: Flown) -> None:
    flown.order(wind=WindState(flown.truth.heading_deg, 5.0))
    name = flown.begin("wind", "gust", 20.0, length_s=1.0)
    blown = []
    for _ in range(60):
        flown.frame()
        blown.append(flown.truth.airspeed_true_kt - flown.truth.speed_ground_kt)
    assert max(blown) == pytest.approx(25.0, abs=1.0)
    assert blown.index(max(blown)) == pytest.approx(25, abs=2)
    assert blown[-1] == pytest.approx(5.0, abs=0.5)
    assert flown.reported[name][2] == 49


def test_turbulence_can_be_switched_on_and_off(flown: Flown) -> None:
    def shaking() -> float:
        rolls = []
        for _ in range(250):
            flown.frame()
            rolls.append(flown.truth.p_rad_s)
        return max(rolls) - min(rolls)

    calm = shaking()
    flown.order(wind=WindState(0.0, 0.0, "severe"))
    rough = shaking()
    assert rough > 10.0 * calm


def test_wind_set_in_flight_still_blows_after_a_crash() -> None:
    flown = Flown()
    flown.order(wind=WindState(29.4, 12.0))
    command = surfaces_datagram(Surfaces(-1.0, 0.0, 0.0, 1.0))
    assert command is not None
    flown.simulation.receive(command)
    while not flown.crashes:
        flown.frame()
    flown.frame()
    assert flown.truth.airspeed_true_kt - flown.truth.speed_ground_kt == pytest.approx(12.0, abs=1.0)


@pytest.mark.parametrize(("place", "kind"), CARRIED)
def test_every_fault_that_can_be_asked_for_is_shown_to_be_there(place: str, kind: str) -> None:
    flown = Flown()
    strength = {"slow": 0.01, "jammed": 0.2, "reversed": None}.get(kind, KINDS[place][kind].usual)
    name = flown.begin(place, kind, strength if KINDS[place][kind].unit else None, length_s=0.6)
    for frame in range(25):
        moving = surfaces_datagram(Surfaces(0.01 * frame, 0.01 * frame, 0.01 * frame, 0.9))
        assert moving is not None
        flown.simulation.receive(moving)
        flown.frame()
    assert flown.reported[name][2] > 0


@pytest.mark.parametrize(("place", "kind"), [("gyro", "dropout"), ("line", "flipped"), ("board", "reset")])
def test_a_fault_that_the_rows_cannot_carry_is_not_begun(flown: Flown, place: str, kind: str) -> None:
    flown.begin(place, kind)
    assert flown.reported == {}


def test_an_order_that_comes_twice_begins_one_fault(flown: Flown) -> None:
    order = FaultOrder(1, begin=OrderedFault("a", Fault("gyro", "bias", 0.0)))
    flown.simulation.obey(order)
    flown.frames(3)
    flown.simulation.obey(replace(order, serial=2))
    assert list(flown.reported) == ["a"]


def test_there_is_an_end_to_how_many_faults_are_flown_at_once(flown: Flown) -> None:
    for number in range(MOST_FAULTS + 5):
        flown.order(begin=OrderedFault(str(number), Fault("gyro", "bias", 60.0)))
    assert len(flown.reported) == MOST_FAULTS


def test_one_fault_is_ended_alone_and_one_that_waits_never_begins(flown: Flown) -> None:
    wrong, waiting, other = (
        flown.begin("gyro", "bias"),
        flown.begin("gps", "bias", start_s=5.0),
        flown.begin("gps", "bias"),
    )
    flown.frame()
    flown.order(end=wrong)
    flown.order(end=waiting)
    assert set(flown.reported) == {wrong, other}
    assert flown.reported[wrong][1] == 0.0
    flown.order(ends_all=True)
    rows = flown.rows()
    assert rows[PLACE][0] == pytest.approx(flown.truth.latitude_deg, abs=1e-5)


def test_the_same_orders_at_the_same_frames_give_the_same_bytes() -> None:
    def bytes_of() -> list[bytes]:
        flown = Flown()
        for place, kind in (("gyro", "noise"), ("gps", "jump"), ("line", "loss"), ("line", "jitter")):
            flown.order(begin=OrderedFault(place + kind, Fault(place, kind, 0.1)))
        return flown.frames(100)

    assert bytes_of() == bytes_of()
