"""The alarms of earlier starts."""

from __future__ import annotations

from dataclasses import asdict, replace
from pathlib import Path

import orjson
import pytest

from epf_gcs.errors import GatewayError
from epf_gcs.flight.state.alarm_history import AlarmHistory
from epf_gcs.vehicle.alarms import Alarm
from epf_gcs.vehicle.judges import Finding
from tests.support.waiting import eventually_async

pytestmark = pytest.mark.anyio

LOW = Alarm(Finding("battery_low", "critical", "10.1 V.", {"volts": 10.1}), since_s=1.5, until_s=2.5)


def _with(name: str, value: object) -> bytes:
    """The line of that alarm with another value."""
    return orjson.dumps(asdict(LOW.past_state) | {name: value})


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
    (error,) = reported
    assert (error.code, error.params) == (
        "alarms_unreadable",
        {"path": str(path), "reason": "2 of 3 lines make no sense"},
    )
    assert "(2 of 3 lines make no sense)" in error.detail
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
    assert reported[0].params["reason"] == "Is a directory"
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


async def test_alarms_that_began_together_and_one_that_began_again_are_all_there(tmp_path: Path) -> None:
    path = tmp_path / "alarms.jsonl"
    kept = [LOW, replace(LOW, finding=replace(LOW.finding, id="stick_lost")), replace(LOW, since_s=7.0, until_s=8.0)]
    history, _ = a_history(path)
    for alarm in kept:
        history.keep(alarm)
    history.close()
    again, _ = a_history(path)
    assert again.past == kept
    again.close()


@pytest.mark.parametrize(
    "line", [b"[]", b"7", b"null", b'{"params": []}', b"\xff", *(_with(name, None) for name in ("since_s", "until_s"))]
)
async def test_whatever_a_line_says_the_other_alarms_are_there(tmp_path: Path, line: bytes) -> None:
    path = tmp_path / "alarms.jsonl"
    path.write_bytes(line + b"\n" + orjson.dumps(asdict(LOW.past_state)) + b"\n")
    history, reported = a_history(path)
    assert history.past == [LOW]
    assert [error.params["reason"] for error in reported] == ["1 of 2 lines make no sense"]
    history.close()


async def test_of_a_line_that_another_program_changed_only_what_an_alarm_can_hold_is_taken(tmp_path: Path) -> None:
    path = tmp_path / "alarms.jsonl"
    odd = orjson.dumps(asdict(LOW.past_state) | {"since_s": 1, "params": {"volts": 10.1, "list": [1]}})
    changed = _with("acknowledged", "yes"), odd
    path.write_bytes(b"\n".join(changed) + b"\n")
    history, reported = a_history(path)
    assert history.past == [LOW, replace(LOW, since_s=1.0)]
    assert history.past[1].finding.params == {"volts": 10.1}
    assert reported == []
    history.close()
