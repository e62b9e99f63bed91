"""What the log says of a flight, and that it is no flood."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import pytest
import structlog

from epf_gcs.contract.status import AlarmState
from epf_gcs.flight.memory import flight_log
from epf_gcs.flight.memory.flight_log import FlightLog, say
from epf_gcs.link.failures import lost_error

ALARM = AlarmState("battery_low", "critical", 0.0, None, "10.1 V.", {}, acknowledged=False)


class World:
    """A log whose time is the test's."""

    def __init__(self) -> None:
        self.now_s = 0.0
        self.log = FlightLog(lambda: self.now_s)


def events(logged: list[Any]) -> list[tuple[str, str]]:
    return [(line["log_level"], line["event"]) for line in logged]


def test_a_link_is_opened_lost_and_reopened_each_said_once() -> None:
    world = World()
    with structlog.testing.capture_logs() as logged:
        for state in ("opening", "open", "open", "lost", "opening", "lost", "opening", "open", "closed", "closed"):
            failure = lost_error("/dev/ttyUSB0", "unplugged") if state == "lost" else None
            world.log.link("board", state, "/dev/ttyUSB0", failure)
    assert events(logged) == [
        ("info", "link opened"),
        ("warning", "link lost"),
        ("info", "link reopened"),
        ("info", "link closed"),
    ]
    assert "unplugged" in logged[1]["reason"]
    assert {(line["link"], line["target"]) for line in logged} == {("board", "/dev/ttyUSB0")}
    assert not any("reason" in line for line in (logged[0], *logged[2:]))


def test_each_link_has_a_life_and_a_quiet_time_of_its_own() -> None:
    world = World()
    with structlog.testing.capture_logs() as logged:
        world.log.link("board", "open", "t", None)
        world.log.link("board", "lost", "t", None)
        world.log.link("simulator", "open", "u", None)
        world.log.link("simulator", "lost", "u", None)
    assert [(line["link"], line["event"]) for line in logged] == [
        ("board", "link opened"),
        ("board", "link lost"),
        ("simulator", "link opened"),
        ("simulator", "link lost"),
    ]


def test_a_plug_that_wobbles_is_said_once_in_ten_seconds_with_how_often() -> None:
    world = World()
    with structlog.testing.capture_logs() as logged:
        for _ in range(30):
            world.log.link("board", "open", "t", None)
            world.log.link("board", "lost", "t", None)
        world.now_s = 10.0
        world.log.link("board", "open", "t", None)
    assert events(logged) == [
        ("info", "link opened"),
        ("warning", "link lost"),
        ("info", "link reopened"),
        ("info", "link reopened"),
    ]
    assert logged[-1]["unsaid"] == 28


def test_what_was_said_is_said_again_from_ten_seconds_after_it_on() -> None:
    world = World()
    with structlog.testing.capture_logs() as logged:
        for world.now_s in (0.0, 4.0, 9.9, 10.0, 19.9, 20.1, 31.0):
            world.log.alarm("came", ALARM)
    assert [line.get("unsaid") for line in logged] == [None, 2, 1, None]


def test_a_quiet_alarm_does_not_make_another_one_quiet() -> None:
    world = World()
    with structlog.testing.capture_logs() as logged:
        world.log.alarm("came", ALARM)
        world.log.alarm("came", replace(ALARM, id="cpu_high"))
        world.log.board_restarted(None)
        world.log.board_restarted(None)
    assert [line.get("alarm") for line in logged] == ["battery_low", "cpu_high", None]


def test_alarms_come_go_and_are_acknowledged() -> None:
    world = World()
    with structlog.testing.capture_logs() as logged:
        world.log.alarm("came", ALARM)
        world.log.alarm("acknowledged", ALARM)
        world.log.alarm("went", ALARM)
        world.log.alarm("came", replace(ALARM, id="cpu_high", level="warning"))
        world.log.board_restarted(120)
    assert events(logged) == [
        ("error", "alarm came"),
        ("info", "alarm acknowledged"),
        ("info", "alarm went"),
        ("warning", "alarm came"),
        ("warning", "board restarted"),
    ]
    assert [line.get("text") for line in logged] == ["10.1 V."] * 4 + [None]
    assert logged[-1]["uptime_ms"] == 120


def test_a_log_that_cannot_be_written_ends_nobody(monkeypatch: pytest.MonkeyPatch) -> None:
    class Full:
        def error(self, *_: object, **__: object) -> None:
            raise OSError(28, "No space left on device")

    monkeypatch.setattr(flight_log, "_log", Full())
    say("error", "recording failed")
