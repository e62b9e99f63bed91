"""What survives a restart, and what a bad disk does to it."""

from __future__ import annotations

from pathlib import Path

import orjson
import pytest

from epf_gcs.errors import GatewayError
from epf_gcs.flight.memory import Memory, Remembered
from epf_gcs.vehicle.wanted import Wanted


def a_memory(path: Path) -> tuple[Memory, list[GatewayError]]:
    reported: list[GatewayError] = []
    return Memory(path, reported.append), reported


def test_everything_is_there_after_a_restart(tmp_path: Path) -> None:
    path = tmp_path / "deep" / "state.json"
    memory, reported = a_memory(path)
    assert memory.now == Remembered()
    wanted = Wanted().after("ahrs_on", ()).after("set_fms_task_rate", (200,)).after("control_source", (1,))
    memory.update(board_url="tcp://h:1", board_identity="0403:6001:A", hil_path="assisted", wanted=wanted)
    memory.update(thresholds={"battery_low_v": 11.1})
    memory.update(simulator={"receive_port": 1, "send_host": "127.0.0.1", "send_port": 2, "profile": "xp12"})
    again, _ = a_memory(path)
    assert again.now == memory.now
    assert again.now.wanted == wanted
    assert reported == []


@pytest.mark.parametrize("content", [b"", b"rubbish", b"[]", b"{}", b'{"board_url": 1', b"\xff\xfe"])
def test_a_file_that_makes_no_sense_is_reported_and_forgotten(tmp_path: Path, content: bytes) -> None:
    path = tmp_path / "state.json"
    path.write_bytes(content)
    memory, reported = a_memory(path)
    assert memory.now == Remembered()
    assert [error.code for error in reported] == ["memory_unreadable"]
    memory.update(board_url="tcp://h:1")
    assert a_memory(path)[0].now.board_url == "tcp://h:1"


def test_a_disk_that_refuses_is_reported_and_nothing_else_changes(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    memory, reported = a_memory(tmp_path / "file" / "state.json")
    reported.clear()
    memory.update(board_url="tcp://h:1")
    assert memory.now.board_url == "tcp://h:1"
    assert [error.code for error in reported] == ["memory_not_written"]


def test_nothing_is_written_where_nothing_changed(tmp_path: Path) -> None:
    path = tmp_path / "state.json"
    memory, _ = a_memory(path)
    memory.update(board_url=None)
    assert not path.exists()


def test_a_file_of_a_version_without_alarm_thresholds_is_read(tmp_path: Path) -> None:
    path = tmp_path / "state.json"
    memory, _ = a_memory(path)
    memory.update(board_url="tcp://h:1")
    values = orjson.loads(path.read_bytes())
    del values["thresholds"]
    path.write_bytes(orjson.dumps(values))
    again, reported = a_memory(path)
    assert again.now == memory.now
    assert reported == []
