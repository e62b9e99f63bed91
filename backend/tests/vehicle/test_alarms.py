"""Alarms from coming to going: told, acknowledged, kept."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

import pytest

from epf_gcs.contract.alarm_ids import AlarmId
from epf_gcs.contract.events import Event
from epf_gcs.errors import GatewayError, InvalidInputError, NotFoundError
from epf_gcs.vehicle.alarms import Alarm, Alarms
from epf_gcs.vehicle.judges import Finding, Level
from epf_gcs.vehicle.thresholds import THRESHOLDS
from tests.support.contract import as_told
from tests.support.outlet import KeptOutlet

pytestmark = pytest.mark.anyio

BATTERY = {"field": "battery_low_v", "minimum": 0.0, "maximum": 60.0}


class Told(KeptOutlet):
    """An outlet that remembers its events."""

    def __init__(self) -> None:
        super().__init__()
        self.events: list[tuple[str, bool, bool]] = []

    def event(self, event: Event, /) -> None:
        kind, data = as_told(event)
        assert kind == "alarm"
        self.events.append((data["id"], data["active"], data["acknowledged"]))


class World:
    """What is wrong, as the test says."""

    def __init__(self, kept: Mapping[str, Any] | None = None) -> None:
        self.wrong: list[Finding] = []
        self.limits: list[Mapping[str, float]] = []
        self.chosen: list[dict[str, float]] = []
        self.outlet = Told()
        self.kept: list[Alarm] = []
        self.heard: list[tuple[str, str]] = []
        self.alarms = Alarms(
            self._watch,
            self.outlet,
            kept or {},
            self.chosen.append,
            on_past=self.kept.append,
            on_news=lambda news, alarm: self.heard.append((news, alarm.finding.id)),
        )

    def _watch(self, limits: Mapping[str, float]) -> list[Finding]:
        self.limits.append(limits)
        return self.wrong

    def goes_wrong(self, *names: AlarmId, level: Level = "warning") -> None:
        self.wrong = [Finding(name, level, f"{name}.") for name in names]


async def test_an_alarm_is_told_once_when_it_comes_and_once_when_it_goes() -> None:
    world = World()
    assert not world.alarms.look(1.0)
    world.goes_wrong("battery_low")
    assert [world.alarms.look(t_s) for t_s in (2.0, 3.0)] == [True, False]
    assert [alarm.since_s for alarm in world.alarms.active] == [2.0]
    world.goes_wrong()
    assert [world.alarms.look(t_s) for t_s in (4.0, 5.0)] == [True, False]
    assert [(alarm.finding.id, alarm.until_s) for alarm in world.alarms.active] == [("battery_low", 4.0)]
    (past,) = world.alarms.past
    assert (past.finding.id, past.since_s, past.until_s, past.acknowledged) == ("battery_low", 2.0, 4.0, False)
    assert world.outlet.events == [("battery_low", True, False), ("battery_low", False, False)]


async def test_an_alarm_that_recovered_stays_listed_until_somebody_has_seen_it() -> None:
    world = World()
    world.goes_wrong("battery_low")
    world.alarms.look(1.0)
    world.goes_wrong()
    world.alarms.look(2.0)
    (recovered,) = world.alarms.active
    assert (recovered.since_s, recovered.until_s, recovered.acknowledged) == (1.0, 2.0, False)
    known = world.alarms.acknowledge("battery_low")
    assert (known.until_s, known.acknowledged) == (2.0, True)
    assert world.alarms.active == []
    assert world.alarms.past == [known]
    assert world.kept == [recovered, known]
    assert world.outlet.events[-1] == ("battery_low", False, True)
    assert world.heard == [("came", "battery_low"), ("went", "battery_low"), ("acknowledged", "battery_low")]


async def test_who_acknowledges_what_is_acknowledged_hears_that_it_is_and_nothing_is_told_again() -> None:
    world = World()
    world.goes_wrong("battery_low")
    world.alarms.look(1.0)
    world.goes_wrong()
    world.alarms.look(2.0)
    known = world.alarms.acknowledge("battery_low")
    told, kept = list(world.outlet.events), list(world.kept)
    assert world.alarms.acknowledge("battery_low") == known
    assert (world.outlet.events, world.kept, world.alarms.past) == (told, kept, [known])


async def test_an_alarm_that_was_acknowledged_before_it_went_is_not_listed_any_more() -> None:
    world = World()
    world.goes_wrong("battery_low")
    world.alarms.look(1.0)
    world.alarms.acknowledge("battery_low")
    world.goes_wrong()
    world.alarms.look(2.0)
    assert world.alarms.active == []
    (past,) = world.alarms.past
    assert world.kept == [past]
    assert (past.until_s, past.acknowledged) == (2.0, True)


async def test_an_alarm_that_comes_again_stands_for_the_one_that_recovered() -> None:
    world = World()
    for t_s, names in ((1.0, ["battery_low"]), (2.0, []), (3.0, ["battery_low"])):
        world.goes_wrong(*names)  # type: ignore[arg-type]
        world.alarms.look(t_s)
    assert [(alarm.since_s, alarm.until_s) for alarm in world.alarms.active] == [(3.0, None)]
    assert [(alarm.since_s, alarm.until_s) for alarm in world.alarms.past] == [(1.0, 2.0)]


async def test_how_often_an_alarm_came_is_counted_until_somebody_acknowledges_it() -> None:
    world = World()

    def comes_and_goes(*at_s: float) -> int:
        for t_s in at_s:
            world.goes_wrong("battery_low")
            world.alarms.look(t_s)
            world.goes_wrong()
            world.alarms.look(t_s + 0.5)
        (alarm,) = world.alarms.active
        return alarm.state.count

    assert comes_and_goes(1.0, 2.0, 3.0) == 3
    world.alarms.acknowledge("battery_low")
    assert comes_and_goes(4.0) == 1
    again = World()
    again.alarms.restore([alarm.state for alarm in world.alarms.active])
    again.goes_wrong("battery_low")
    again.alarms.look(5.0)
    assert again.alarms.active[0].count == 2


async def test_what_an_earlier_start_left_is_the_beginning_of_the_history() -> None:
    world = World()
    before = Alarm(Finding("cpu_high", "warning", "91 %."), 1.0, until_s=2.0)
    alarms = Alarms(lambda _: world.wrong, world.outlet, {}, world.chosen.append, past=[before])
    assert alarms.active == []
    world.goes_wrong("battery_low")
    alarms.look(3.0)
    world.goes_wrong()
    alarms.look(4.0)
    assert [alarm.finding.id for alarm in alarms.past] == ["battery_low", "cpu_high"]


async def test_an_alarm_keeps_its_beginning_and_shows_its_newest_words() -> None:
    world = World()
    world.wrong = [Finding("cpu_high", "warning", "91 %.", {"percent": 91})]
    world.alarms.look(1.0)
    world.wrong = [Finding("cpu_high", "warning", "95 %.", {"percent": 95})]
    assert not world.alarms.look(2.0)
    (alarm,) = world.alarms.active
    assert (alarm.since_s, alarm.finding.text) == (1.0, "95 %.")


async def test_the_oldest_is_first_and_of_the_past_the_newest() -> None:
    world = World()
    world.goes_wrong("hil_lost")
    world.alarms.look(1.0)
    world.goes_wrong("heartbeat_lost", "hil_lost")
    world.alarms.look(2.0)
    assert [alarm.finding.id for alarm in world.alarms.active] == ["hil_lost", "heartbeat_lost"]
    world.goes_wrong("heartbeat_lost")
    world.alarms.look(3.0)
    world.goes_wrong()
    world.alarms.look(4.0)
    assert [alarm.finding.id for alarm in world.alarms.past] == ["heartbeat_lost", "hil_lost"]


async def test_an_acknowledged_alarm_stays_until_it_goes_and_is_new_when_it_comes_again() -> None:
    world = World()
    world.goes_wrong("battery_low")
    world.alarms.look(1.0)
    assert world.alarms.acknowledge("battery_low").acknowledged
    world.alarms.acknowledge("battery_low")
    assert world.heard == [("came", "battery_low"), ("acknowledged", "battery_low")], "told once"
    assert not world.alarms.look(2.0)
    assert [alarm.acknowledged for alarm in world.alarms.active] == [True]
    world.goes_wrong()
    world.alarms.look(3.0)
    world.goes_wrong("battery_low")
    world.alarms.look(4.0)
    assert [alarm.acknowledged for alarm in world.alarms.active] == [False]
    assert [alarm.acknowledged for alarm in world.alarms.past] == [True]
    assert world.outlet.events == [
        ("battery_low", True, False),
        ("battery_low", True, True),
        ("battery_low", False, True),
        ("battery_low", True, False),
    ]


async def test_an_alarm_that_becomes_worse_is_new_to_whoever_knew_the_milder_one() -> None:
    world = World()
    world.goes_wrong("gps_lost")
    world.alarms.look(1.0)
    world.alarms.acknowledge("gps_lost")
    world.goes_wrong("gps_lost", level="critical")
    assert world.alarms.look(2.0)
    assert [(alarm.since_s, alarm.acknowledged) for alarm in world.alarms.active] == [(1.0, False)]
    assert world.outlet.events[-1] == ("gps_lost", True, False)
    assert len(world.outlet.events) == 3
    world.alarms.acknowledge("gps_lost")
    world.goes_wrong("gps_lost", level="warning")
    assert not world.alarms.look(3.0)
    assert [alarm.acknowledged for alarm in world.alarms.active] == [True], "milder is nothing new"


@pytest.mark.parametrize("name", ["battery_low", "no_such_alarm", ""])
async def test_what_is_not_active_cannot_be_acknowledged(name: str) -> None:
    with pytest.raises(NotFoundError) as refused:
        World().alarms.acknowledge(name)
    assert refused.value.code == "alarm_not_active"
    assert refused.value.params == {"alarm": name}


async def test_only_the_newest_two_hundred_are_kept() -> None:
    world = World()
    for t_s in range(500):
        world.goes_wrong(*(("battery_low",) if t_s % 2 == 0 else ()))
        world.alarms.look(float(t_s))
        if t_s == 250:
            world.alarms.acknowledge("battery_low")
        if t_s == 451:
            assert world.alarms.acknowledge("battery_low").until_s == 451.0
    assert [alarm.since_s for alarm in world.alarms.past] == [float(t_s) for t_s in range(498, 98, -2)]
    assert [alarm.since_s for alarm in world.alarms.past if alarm.acknowledged] == [450.0, 250.0]


async def test_chosen_limits_are_used_and_kept() -> None:
    world = World({"battery_low_v": 11.1, "hil_lost_s": 1000})
    world.alarms.look(1.0)
    assert world.limits[-1]["battery_low_v"] == 11.1
    assert world.limits[-1]["hil_lost_s"] == 0.5, "one that is not allowed is the default"
    world.alarms.choose({"cpu_high_percent": 80})
    world.alarms.look(2.0)
    assert world.limits[-1] == world.chosen[-1] == world.alarms.thresholds
    assert (world.limits[-1]["cpu_high_percent"], world.limits[-1]["battery_low_v"]) == (80, 11.1)


@pytest.mark.parametrize(
    ("wrong", "kind", "code", "params"),
    [
        ({"battery_low_v": 61.0}, InvalidInputError, "threshold_out_of_range", BATTERY | {"value": 61.0}),
        ({"battery_low_v": math.inf}, InvalidInputError, "threshold_out_of_range", BATTERY | {"value": math.inf}),
        ({"battery_high_v": 1.0}, NotFoundError, "threshold_unknown", {"field": "battery_high_v"}),
    ],
)
async def test_one_wrong_limit_and_none_is_changed(
    wrong: dict[str, float], kind: type[GatewayError], code: str, params: dict[str, object]
) -> None:
    world = World()
    with pytest.raises(kind) as refused:
        world.alarms.choose({"cpu_high_percent": 80, **wrong})
    assert (refused.value.code, refused.value.params) == (code, params)
    assert world.alarms.thresholds == {threshold.name: threshold.default for threshold in THRESHOLDS}
    assert world.chosen == []


async def test_what_recovered_is_listed_by_its_beginning_among_what_is_wrong() -> None:
    world = World()
    for t_s, names in ((1.0, ["cpu_high"]), (2.0, ["gps_lost"]), (3.0, ["gps_lost", "hil_lost"])):
        world.goes_wrong(*names)  # type: ignore[arg-type]
        world.alarms.look(t_s)
    assert [alarm.finding.id for alarm in world.alarms.active] == ["cpu_high", "gps_lost", "hil_lost"]


async def test_alarms_go_on_from_a_kept_list_and_what_is_known_is_not_told_again() -> None:
    before, after = World(), World()
    for world in (before, after):
        world.wrong = [Finding("cpu_high", "warning", "91 %.", {"percent": 91}), Finding("gps_lost", "critical", "No.")]
    before.alarms.look(1.0)
    before.alarms.acknowledge("cpu_high")
    for world in (before, after):
        world.wrong = world.wrong[:1]
    before.alarms.look(2.0)
    after.goes_wrong("hil_lost")
    after.alarms.look(2.0)
    after.wrong = before.wrong
    after.outlet.events.clear()
    after.alarms.restore(alarm.state for alarm in before.alarms.active)
    assert after.alarms.active == before.alarms.active
    assert not after.alarms.look(3.0)
    assert after.alarms.active == before.alarms.active
    assert after.outlet.events == []
    assert after.alarms.acknowledge("gps_lost").until_s == 2.0
    assert [alarm.finding.id for alarm in after.alarms.active] == ["cpu_high"]
