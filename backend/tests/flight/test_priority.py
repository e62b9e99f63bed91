"""The flight process takes the best priority that the system gives, and says which."""

from __future__ import annotations

import os
import subprocess
import sys

import pytest

from epf_gcs.flight import priority

_SAY_ALL = """
import os, threading
from epf_gcs.flight.priority import go_first
told = go_first()
found = []
def look():
    found.append((os.sched_getscheduler(0) == os.SCHED_RR, os.getpriority(os.PRIO_PROCESS, 0) < 0))
look()
thread = threading.Thread(target=look)
thread.start()
thread.join()
expected = {"real-time": [(True, False)] * 2, "raised": [(False, True)] * 2, "normal": [(False, False)] * 2}[told]
assert found == expected, (told, found)
"""


def _refuse(*_: object) -> None:
    raise PermissionError


def test_what_it_says_is_what_the_process_and_its_threads_have() -> None:
    subprocess.run([sys.executable, "-c", _SAY_ALL], check=True, timeout=20)


def test_without_the_permission_for_real_time_it_is_raised(monkeypatch: pytest.MonkeyPatch) -> None:
    asked: list[int] = []
    monkeypatch.setattr(os, "sched_setscheduler", _refuse)
    monkeypatch.setattr(os, "setpriority", lambda _which, _who, niceness: asked.append(niceness))
    assert priority.go_first() == "raised"
    assert asked[0] < 0


def test_without_any_permission_it_flies_at_normal_priority(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(os, "sched_setscheduler", _refuse)
    monkeypatch.setattr(os, "setpriority", _refuse)
    assert priority.go_first() == "normal"
