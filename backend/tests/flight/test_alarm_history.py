"""The alarms of earlier starts."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from epf_gcs.errors import GatewayError
from epf_gcs.flight.alarm_history import AlarmHistory
from epf_gcs.vehicle.alarms import Alarm
from epf_gcs.vehicle.judges import Finding
from tests.support.waiting import eventually_async

pytestmark = pytest.mark.anyio

LOW = Alarm(Finding("battery_low", "critical", "10.1 V.", {"volts": 10.1}), since_s=1.5, until_s=2.5)


def a_history(path: Path) -> tuple[AlarmHistory, list[GatewayError]]:
    reported: list[GatewayError] = []
    return AlarmHistory(path, reported.append), reported


async def test_past_alarms_are_there_after_a_restart_as_they_were_last(tmp_path: Path) -> None:
    path = tmp_path / "deep" / "alarms.jsonl"
    history, reported = a_history(path)
    assert history.past == []
    other = replace(LOW, since_s=3.0, until_s=4.0)
    for alarm in (LOW, other, replace(LOW, acknowledged=True)):
        history.keep(alarm)
    history.close()
    again, _ = a_history(path)
    assert again.past == [replace(LOW, acknowledged=True), other]
    again.close()
    assert reported == []


async def test_the_newest_two_hundred_are_kept(tmp_path: Path) -> None:
    path = tmp_path / "alarms.jsonl"
    history, _ = a_history(path)
    for index in range(900):
        history.keep(replace(LOW, since_s=float(index), until_s=float(index) + 0.5))
    history.close()
    again, _ = a_history(path)
    assert [alarm.since_s for alarm in again.past] == [float(index) for index in range(700, 900)]
    again.close()


async def test_lines_that_make_no_sense_are_told_and_kept_aside(tmp_path: Path) -> None:
    path = tmp_path / "alarms.jsonl"
    history, _ = a_history(path)
    history.keep(LOW)
    history.close()
    content = path.read_bytes() + b"rubbish\n" + b'{"id": "no_such_alarm"}\n'
    path.write_bytes(content)
    again, reported = a_history(path)
    assert again.past == [LOW]
    assert [error.code for error in reported] == ["alarms_unreadable"]
    again.close()
    (aside,) = path.parent.glob("alarms.jsonl.damaged-*")
    assert aside.read_bytes() == content
    assert len(path.read_bytes().splitlines()) == 1


async def test_a_disk_that_refuses_is_reported(tmp_path: Path) -> None:
    path = tmp_path / "alarms.jsonl"
    path.mkdir()
    history, reported = a_history(path)
    history.keep(LOW)
    await eventually_async(lambda: len(reported) == 2, "both are reported")
    history.close()
    assert [error.code for error in reported] == ["alarms_unreadable", "alarms_not_written"]
    assert "The history of the alarms could not be kept" in reported[1].detail


async def test_the_newest_two_hundred_are_kept_where_all_of_them_were_acknowledged(tmp_path: Path) -> None:
    path = tmp_path / "alarms.jsonl"
    history, _ = a_history(path)
    for index in range(450):
        alarm = replace(LOW, since_s=float(index), until_s=float(index) + 0.5)
        history.keep(alarm)
        history.keep(replace(alarm, acknowledged=True))
    history.close()
    again, _ = a_history(path)
    assert [alarm.since_s for alarm in again.past] == [float(index) for index in range(250, 450)]
    assert all(alarm.acknowledged for alarm in again.past)
    again.close()


async def test_a_warning_is_a_warning_after_a_restart(tmp_path: Path) -> None:
    path = tmp_path / "alarms.jsonl"
    history, _ = a_history(path)
    mild = replace(LOW, finding=replace(LOW.finding, level="warning"))
    history.keep(mild)
    history.close()
    again, _ = a_history(path)
    assert again.past == [mild]
    again.close()
