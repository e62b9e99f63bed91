"""A vehicle can be made twice: two that fly at the same time, at different times of day, know nothing of each other."""

from __future__ import annotations

from epf_gcs.codec.encode import encode_telemetry
from epf_gcs.error_log import ErrorLog
from epf_gcs.vehicle.vehicle import Vehicle
from tests.support.outlet import KeptOutlet


class SetClock:
    """The time that a test says."""

    def __init__(self, at_s: float) -> None:
        self.at_s = at_s

    def now_s(self) -> float:
        return self.at_s

    def steady_s(self) -> float:
        return self.at_s


class Flown:
    """A vehicle with a clock and an outlet of its own."""

    def __init__(self, begin_s: float) -> None:
        self.clock = SetClock(begin_s)
        self.outlet = KeptOutlet()
        self.vehicle = Vehicle(self.clock, self.outlet, ErrorLog(), lambda _: 0.02)

    def hear(self, roll_deg: float) -> None:
        self.clock.at_s += 0.02
        self.vehicle.board.on_bytes(encode_telemetry("ahrs", 90.0, 0.0, roll_deg))

    def rolls(self) -> list[tuple[float, float]]:
        return [(round(t_s, 3), values["roll_deg"]) for topic, t_s, values in self.outlet.samples if topic == "ahrs"]


def test_two_vehicles_do_not_disturb_each_other() -> None:
    live, replayed = Flown(1_000_000.0), Flown(500.0)
    for step in range(50):
        live.hear(step)
        replayed.hear(-step)
        replayed.vehicle.board.on_bytes(b"\x00noise\x00")
    assert live.rolls() == [(round(1_000_000.0 + 0.02 * (step + 1), 3), step) for step in range(50)]
    assert [roll for _, roll in replayed.rolls()] == [-step for step in range(50)]
    assert live.vehicle.board.damage["noise"] == 0
    assert replayed.vehicle.board.damage["noise"] > 0
    assert live.vehicle.telemetry.is_live("ahrs")
    live.clock.at_s += 60.0
    assert not live.vehicle.telemetry.is_live("ahrs")
    assert replayed.vehicle.telemetry.is_live("ahrs"), "its own clock says that no time has passed"


def test_the_same_bytes_at_the_same_times_say_the_same() -> None:
    first, second = Flown(7.0), Flown(7.0)
    for step in range(20):
        first.hear(step)
    for step in range(20):
        second.hear(step)
    assert first.outlet.samples == second.outlet.samples
