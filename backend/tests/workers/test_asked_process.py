"""A worker process that is asked: its start is no part of a request's time."""

from __future__ import annotations

import threading
from collections.abc import Iterator
from pathlib import Path

import pytest

from epf_gcs.workers.asked_process import AskedProcess

PROGRAM = """
import json, sys, time
from epf_gcs.workers.pipe import receive, send

time.sleep({starts_s})
send(sys.stdout.buffer, {{}})
while (message := receive(sys.stdin.buffer)) is not None:
    time.sleep(json.loads(message[0])["takes_s"])
    send(sys.stdout.buffer, json.loads(message[0]))
"""


@pytest.fixture
def slow_to_start(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[AskedProcess]:
    (tmp_path / "slow_to_start.py").write_text(PROGRAM.format(starts_s=0.6))
    monkeypatch.setenv("PYTHONPATH", str(tmp_path), prepend=":")
    process = AskedProcess("slow_to_start")
    ended = threading.Event()

    def watch() -> None:
        while not ended.wait(0.02):
            process.end_if_late()

    watching = threading.Thread(target=watch)
    watching.start()
    yield process
    ended.set()
    watching.join()
    process.end()


def test_a_slow_start_is_not_blamed_on_the_first_request(slow_to_start: AskedProcess) -> None:
    assert slow_to_start.ask({"takes_s": 0}, longest_s=0.5) == (b'{"takes_s":0}', b"")


def test_a_request_that_takes_too_long_ends_the_process_and_the_next_one_is_answered(
    slow_to_start: AskedProcess,
) -> None:
    assert slow_to_start.ask({"takes_s": 60}, longest_s=0.1) is None
    assert slow_to_start.ask({"takes_s": 0}, longest_s=5) == (b'{"takes_s":0}', b"")
