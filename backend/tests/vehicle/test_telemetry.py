"""The heard on the topics."""

from __future__ import annotations

from dataclasses import asdict

import pytest

from epf_gcs.clock import Clock
from epf_gcs.vehicle.telemetry import Telemetry
from tests.support.outlet import KeptOutlet

pytestmark = pytest.mark.anyio


class SetClock(Clock):
    """A clock that stands where it is put."""

    def __init__(self) -> None:
        super().__init__()
        self.at_s = 1000.0

    def now_s(self) -> float:
        return self.at_s


class Heard:
    def __init__(self) -> None:
        self.clock = SetClock()
        self.period_s = 0.1
        self.telemetry = Telemetry(KeptOutlet(), self.clock, lambda _: self.period_s)

    def hear(self, topic: str, count: int, every_s: float) -> None:
        for _ in range(count):
            self.clock.at_s += every_s
            self.telemetry.take(topic, self.clock.at_s, {"n": 1})


async def test_a_topic_is_live_for_three_periods() -> None:
    heard = Heard()
    assert not heard.telemetry.is_live("ahrs")
    heard.hear("ahrs", 10, 0.1)
    heard.clock.at_s += 0.29
    assert heard.telemetry.is_live("ahrs")
    assert not heard.telemetry.snapshot()["ahrs"].stale
    heard.clock.at_s += 0.02
    assert not heard.telemetry.is_live("ahrs")
    assert heard.telemetry.snapshot()["ahrs"].stale
    assert heard.telemetry.snapshot()["ahrs"].age_s == pytest.approx(0.31)


async def test_an_answer_that_was_asked_for_does_not_grow_stale() -> None:
    heard = Heard()
    heard.hear("autopilot_parameters", 3, 0.1)
    heard.clock.at_s += 3600.0
    assert not heard.telemetry.snapshot()["autopilot_parameters"].stale
    assert heard.telemetry.stale_after_s("autopilot_parameters") is None


async def test_a_slower_task_makes_its_topics_live_longer_at_once() -> None:
    heard = Heard()
    heard.hear("ahrs", 10, 0.1)
    heard.hear("gps", 10, 0.1)
    heard.period_s = 10.0
    heard.telemetry.rate_changed("set_parameter_task_rate")
    assert heard.telemetry.stale_after_s("ahrs") == pytest.approx(30.0)
    assert heard.telemetry.stale_after_s("gps") == pytest.approx(0.3)


async def test_a_topic_that_nobody_commands_is_measured() -> None:
    heard = Heard()
    heard.hear("simulator", 1, 0.02)
    assert heard.telemetry.stale_after_s("simulator") is None
    heard.hear("simulator", 10, 0.5)
    assert heard.telemetry.stale_after_s("simulator") == pytest.approx(1.5)


async def test_the_summary_of_a_topic_is_its_count_rate_age_and_limit() -> None:
    heard = Heard()
    heard.hear("ahrs", 9, 0.3)
    heard.clock.at_s += 0.12345
    assert heard.telemetry.age_s("ahrs") == pytest.approx(0.12345)
    heard.telemetry.take("gps", heard.clock.at_s, {"n": 1}, ("altitude_m",))
    summary = heard.telemetry.summary()
    assert asdict(summary["ahrs"]) == {
        "count": 9,
        "rate_hz": 3.33,
        "age_s": 0.123,
        "stale_after_s": pytest.approx(0.9),
        "implausible": {},
    }
    assert (summary["gps"].count, summary["gps"].age_s, summary["gps"].rate_hz) == (1, 0.0, 0.0)
    assert summary["gps"].implausible == {"altitude_m": 1}


async def test_what_was_never_heard_has_no_age() -> None:
    heard = Heard()
    assert heard.telemetry.age_s("ahrs") is None
    assert heard.telemetry.newest("ahrs") is None
    assert heard.telemetry.stale_after_s("ahrs") is None


async def test_what_the_emulation_showed_is_no_data_at_once_and_what_is_heard_later_counts_anew() -> None:
    outlet, clock = KeptOutlet(), SetClock()
    telemetry = Telemetry(outlet, clock, lambda _: 0.1)
    telemetry.take("gps", clock.at_s, {"latitude_deg": 27.9})
    telemetry.take("xplane_rows", clock.at_s, {"rows": {"3": [1.0] * 8}})
    outlet.samples.clear()
    flushed = outlet.flushed
    clock.at_s += 0.05
    telemetry.blank()
    assert outlet.samples == [("gps", 1000.05, {"latitude_deg": None}), ("xplane_rows", 1000.05, {"rows": {}})]
    assert outlet.flushed > flushed
    assert telemetry.newest("gps") == {"latitude_deg": None}
    assert not telemetry.is_live("gps")
    assert (telemetry.snapshot(), telemetry.summary()) == ({}, {})
    telemetry.take("gps", clock.at_s, {"latitude_deg": 28.0})
    assert telemetry.snapshot()["gps"].values == {"latitude_deg": 28.0}
    assert telemetry.summary()["gps"].count == 1


async def test_each_topic_is_expected_as_often_as_its_own_task_was_told() -> None:
    periods_s = {"set_parameter_task_rate": 1.0, "set_fms_task_rate": 2.0, "set_servos_task_rate": 4.0}
    telemetry = Telemetry(KeptOutlet(), SetClock(), periods_s.__getitem__)
    for topic, period_s in (("ahrs", 1.0), ("gps", 2.0), ("servos_in", 4.0)):
        telemetry.take(topic, 1000.0, {})
        assert telemetry.commanded_s(topic) == period_s
        assert telemetry.stale_after_s(topic) == 3 * period_s
    assert telemetry.commanded_s("simulator") is None
