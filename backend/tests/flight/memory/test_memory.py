"""What survives a restart, and what a bad disk does to it."""

from __future__ import annotations

import asyncio
import os
import threading
import time
from pathlib import Path

import orjson
import pytest
import structlog

from epf_gcs import disk
from epf_gcs.errors import GatewayError
from epf_gcs.flight.memory import memory as memory_module
from epf_gcs.flight.memory.memory import FlightMemory, Memory, _encode
from epf_gcs.vehicle.wanted import IntendedSettings
from tests.support.waiting import eventually, eventually_async


def a_memory(path: Path) -> tuple[Memory, list[GatewayError]]:
    reported: list[GatewayError] = []
    return Memory(path, reported.append), reported


def test_everything_is_there_after_a_restart(tmp_path: Path) -> None:
    path = tmp_path / "far" / "deep" / "state.json"
    memory, reported = a_memory(path)
    assert memory.now == FlightMemory()
    wanted = IntendedSettings().after("ahrs_on", ()).after("set_fms_task_rate", (200,)).after("control_source", (1,))
    memory.update(board_url="tcp://h:1", board_identity="0403:6001:A", hil_path="assisted", wanted=wanted)
    memory.update(thresholds={"battery_low_v": 11.1})
    memory.update(simulator={"receive_port": 1, "send_host": "127.0.0.1", "send_port": 2, "profile": "xp12"})
    memory.update(recording={"days": 30}, aircraft="Gavilán")
    memory.close()
    again, _ = a_memory(path)
    assert again.now == memory.now
    assert again.now.wanted == wanted
    assert reported == []


NO_PERIODS = orjson.dumps({**orjson.loads(_encode(FlightMemory())), "periods_ms": []})


@pytest.mark.parametrize("content", [b"", b"rubbish", b"[]", b"{}", b'{"board_url": 1', b"\xff\xfe", NO_PERIODS])
def test_a_file_that_makes_no_sense_is_reported_and_forgotten(tmp_path: Path, content: bytes) -> None:
    path = tmp_path / "state.json"
    path.write_bytes(content)
    reported: list[GatewayError] = []
    with structlog.testing.capture_logs() as logged:
        memory = Memory(path, reported.append, unix_s=lambda: 1_770_000_000.0)
    assert memory.now == FlightMemory()
    assert [error.code for error in reported] == ["memory_unreadable"]
    assert "(its content makes no sense)" in reported[0].detail
    assert "it is kept as state.json.damaged-20260202T024000Z." in reported[0].detail
    assert (tmp_path / "state.json.damaged-20260202T024000Z").read_bytes() == content
    assert [(line["event"], line["log_level"]) for line in logged] == [("settings unreadable", "warning")]
    memory.update(board_url="tcp://h:1")
    memory.close()
    assert a_memory(path)[0].now.board_url == "tcp://h:1"


def test_a_disk_that_refuses_is_reported_and_nothing_else_changes(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    memory, reported = a_memory(tmp_path / "file" / "state.json")
    (unread,) = reported
    assert "(Not a directory)" in unread.detail
    assert "it could not be kept aside." in unread.detail
    reported.clear()
    memory.update(board_url="tcp://h:1")
    memory.close()
    assert memory.now.board_url == "tcp://h:1"
    assert [error.code for error in reported] == ["memory_not_written"]
    assert "(File exists)" in reported[0].detail


def test_nothing_is_written_where_nothing_changed(tmp_path: Path) -> None:
    path = tmp_path / "state.json"
    memory, _ = a_memory(path)
    memory.update(board_url=None)
    memory.close()
    assert not path.exists()


@pytest.mark.parametrize("later", ["thresholds", "recording", "aircraft"])
def test_a_file_of_a_version_that_did_not_keep_it_yet_is_read(tmp_path: Path, later: str) -> None:
    path = tmp_path / "state.json"
    memory, _ = a_memory(path)
    memory.update(board_url="tcp://h:1")
    memory.close()
    values = orjson.loads(path.read_bytes())
    del values[later]
    path.write_bytes(orjson.dumps(values))
    again, reported = a_memory(path)
    assert again.now == memory.now
    assert reported == []


def test_a_path_of_control_that_nobody_knows_is_the_manual_one(tmp_path: Path) -> None:
    path = tmp_path / "state.json"
    path.write_bytes(orjson.dumps({**orjson.loads(_encode(FlightMemory())), "hil_path": "automatic"}))
    memory, reported = a_memory(path)
    assert memory.now == FlightMemory(hil_path="manual")
    assert reported == []


def test_what_is_remembered_is_on_the_disk_without_an_end(tmp_path: Path) -> None:
    path = tmp_path / "state.json"
    memory, _ = a_memory(path)
    memory.update(board_url="tcp://h:1")
    eventually(path.exists, "it is written")
    assert a_memory(path)[0].now.board_url == "tcp://h:1"
    memory.close()


def test_a_disk_that_stalls_stalls_nobody_and_the_newest_wins(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    written: list[bytes] = []
    stalled, goes_on = threading.Event(), threading.Event()

    def stall(path: Path, data: bytes) -> None:
        stalled.set()
        goes_on.wait()
        written.append(data)

    monkeypatch.setattr(disk, "replace_file", stall)
    memory, _ = a_memory(tmp_path / "state.json")
    memory.update(board_url="tcp://h:0")
    stalled.wait()
    for number in range(1, 100):
        memory.update(board_url=f"tcp://h:{number}")
    assert written == []
    goes_on.set()
    memory.close()
    assert [orjson.loads(data)["board_url"] for data in written] == ["tcp://h:0", "tcp://h:99"]


def test_the_file_and_its_folder_are_pushed_to_the_disk(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    pushed: list[str] = []
    push = os.fsync

    def note(descriptor: int) -> None:
        pushed.append(Path(f"/proc/self/fd/{descriptor}").readlink().name)
        push(descriptor)

    monkeypatch.setattr(os, "fsync", note)
    memory, _ = a_memory(tmp_path / "state.json")
    memory.update(board_url="tcp://h:1")
    memory.close()
    assert pushed == ["state.json.new", tmp_path.name]


@pytest.mark.anyio
async def test_on_a_loop_a_refusing_disk_is_reported_on_the_loop(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    heard: list[int] = []
    memory = Memory(tmp_path / "file" / "state.json", lambda _: heard.append(threading.get_ident()))
    heard.clear()
    memory.update(board_url="tcp://h:1")
    await eventually_async(lambda: bool(heard), "it is reported")
    assert heard == [threading.get_ident()]
    await asyncio.to_thread(memory.close)


def test_values_that_change_quickly_are_gathered_into_one_writing(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    written: list[bytes] = []
    monkeypatch.setattr(disk, "replace_file", lambda _path, data: written.append(data))
    monkeypatch.setattr(memory_module, "_GATHER_S", 3600.0)
    memory, _ = a_memory(tmp_path / "state.json")
    for number in range(50):
        memory.update(board_url=f"tcp://h:{number}")
        time.sleep(0)
    eventually(lambda: bool(memory._wake._waiters), "the thread waits for more")  # type: ignore[attr-defined]
    assert written == [], "more may come"
    memory.close()
    assert [orjson.loads(data)["board_url"] for data in written] == ["tcp://h:49"]


def test_after_its_end_nothing_is_written(tmp_path: Path) -> None:
    path = tmp_path / "state.json"
    memory, _ = a_memory(path)
    memory.update(board_url="tcp://h:1")
    memory.close()
    memory.update(board_url="tcp://h:2")
    memory.close()
    assert a_memory(path)[0].now.board_url == "tcp://h:1"
