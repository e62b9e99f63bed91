"""The flight process takes the best priority that the system gives, and says which."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

from epf_gcs.system import priority
from tests.support.waiting import DEADLINE_S

_SAY_ALL = """
import os, threading
from epf_gcs.system.priority import go_first
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

_REPAIR = """
import os, sys, threading
from pathlib import Path
from epf_gcs.system.priority import go_first
from epf_gcs.flight.recording.repair import repair_all
def mine():
    return os.sched_getscheduler(0), os.getpriority(os.PRIO_PROCESS, threading.get_native_id())
go_first()
before, found = mine(), []
def look():
    found.append(mine())
    return False
thread = threading.Thread(target=repair_all, args=([Path(sys.argv[1])], look))
thread.start()
thread.join()
assert found[0] == (os.SCHED_OTHER, 19), found
assert mine() == before, "the thread that flies keeps its own"
"""

_SLOW_DOWN = """
import os, subprocess, sys
from epf_gcs.system.priority import slow_down
other = subprocess.Popen([sys.executable, "-c", "input()"], stdin=subprocess.PIPE)
def niceness():
    return os.getpriority(os.PRIO_PROCESS, other.pid)
before = niceness()
slow_down(other.pid, 2)
assert niceness() == min(before + 2, 19), (before, niceness())
slow_down(other.pid)
assert niceness() == 19
other.communicate(b"end\\n")
"""

_CORES = """
import os, subprocess, sys, threading
from epf_gcs.system.priority import leave_flight_core, take_own_core
allowed = set(sys.argv[2:])
os.sched_setaffinity(0, {int(core) for core in allowed})
{"flight": take_own_core, "web": leave_flight_core}[sys.argv[1]]()
found = []
thread = threading.Thread(target=lambda: found.append(os.sched_getaffinity(0)))
thread.start()
thread.join()
look = "import os; print(*sorted(os.sched_getaffinity(0)))"
started = subprocess.run([sys.executable, "-c", look], check=True, capture_output=True, text=True)
assert started.stdout.split() == [str(core) for core in sorted(found[0])]
print(started.stdout)
"""


def _cores_of(part: str, allowed: set[int]) -> set[int]:
    command = [sys.executable, "-c", _CORES, part, *map(str, allowed)]
    said = subprocess.run(command, check=True, timeout=DEADLINE_S, capture_output=True, text=True).stdout
    return set(map(int, said.split()))


def test_flight_and_web_never_share_a_core_where_there_are_two() -> None:
    cores = os.sched_getaffinity(0)
    flight, web = _cores_of("flight", cores), _cores_of("web", cores)
    assert flight | web == cores, "no core is left unused"
    assert len(cores) == 1 or (len(flight) == 1 and not flight & web)


def test_on_a_single_core_both_use_it() -> None:
    only = {min(os.sched_getaffinity(0))}
    assert _cores_of("flight", only) == _cores_of("web", only) == only


def _refuse(*_: object) -> None:
    raise PermissionError


@pytest.mark.usefixtures("true_priority")
def test_what_it_says_is_what_the_process_and_its_threads_have() -> None:
    subprocess.run([sys.executable, "-c", _SAY_ALL], check=True, timeout=DEADLINE_S)


@pytest.mark.usefixtures("true_priority")
def test_the_repair_of_old_recordings_gives_way_to_everything(tmp_path: Path) -> None:
    subprocess.run([sys.executable, "-c", _REPAIR, str(tmp_path / "absent.mcap")], check=True, timeout=DEADLINE_S)


@pytest.mark.usefixtures("true_priority")
def test_another_process_is_slowed_down_by_so_much() -> None:
    subprocess.run([sys.executable, "-c", _SLOW_DOWN], check=True, timeout=DEADLINE_S)


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
