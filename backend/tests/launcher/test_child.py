"""Child processes: started, logged, stopped, also when they do not want to."""

import os
import signal
import sys
import time
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from epf_gcs.launcher.child import Child
from epf_gcs.launcher.errors import LaunchError
from tests.support.waiting import DEADLINE_S


def eventually(condition: Callable[[], bool]) -> None:
    """Wait for a condition; fail when it has not come true by the deadline."""
    deadline_s = time.monotonic() + DEADLINE_S
    while not condition():
        assert time.monotonic() < deadline_s, "waited in vain"
        time.sleep(0.01)


def exists(pid: int) -> bool:
    try:
        os.kill(pid, 0)
    except ProcessLookupError:
        return False
    # A zombie is gone; only its parent has not looked yet.
    return Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()[0] != "Z"


@pytest.fixture
def children(tmp_path: Path) -> Iterator[Callable[..., Child]]:
    made: list[Child] = []

    def make(code: str, name: str = "program") -> Child:
        child = Child(name, [sys.executable, "-u", "-c", code], tmp_path)
        made.append(child)
        return child

    yield make
    for child in made:
        child.stop(0.1)


def started(child: Child) -> Child:
    """Start it and wait until it has said something."""
    child.start()
    eventually(lambda: child.log_path.stat().st_size > 0)
    return child


def test_a_child_that_is_asked_to_stop_goes_by_itself(children: Callable[..., Child]) -> None:
    child = started(children("import time; print('up'); time.sleep(60)"))
    assert child.ended is None
    assert child.stop() is True
    assert child.ended == -signal.SIGTERM


def test_a_child_that_hangs_is_killed(children: Callable[..., Child]) -> None:
    code = "import signal, time; signal.signal(signal.SIGTERM, signal.SIG_IGN); print('up'); time.sleep(60)"
    child = started(children(code))
    assert child.stop(timeout_s=0.2) is False
    assert child.ended == -signal.SIGKILL


def test_what_a_child_has_started_goes_with_it(children: Callable[..., Child]) -> None:
    code = (
        "import subprocess, sys, time;"
        "p = subprocess.Popen([sys.executable, '-c', 'import signal, time;"
        " signal.signal(signal.SIGTERM, signal.SIG_IGN); time.sleep(60)']); print(p.pid); time.sleep(60)"
    )
    child = started(children(code))
    grandchild = int(child.log_path.read_text())
    assert exists(grandchild)
    child.stop()
    eventually(lambda: not exists(grandchild))


def test_the_end_of_its_log_can_be_shown(children: Callable[..., Child]) -> None:
    child = children("print('first'); [print('line', n) for n in range(50)]; raise SystemExit(3)")
    child.start()
    eventually(lambda: child.ended is not None)
    assert child.ended == 3
    assert child.last_lines().endswith("line 49")
    assert "first" not in child.last_lines()


def test_the_log_of_the_run_before_is_kept_under_another_name(children: Callable[..., Child], tmp_path: Path) -> None:
    for word in ("one", "two", "three"):
        child = children(f"print({word!r})")
        child.start()
        eventually(lambda child=child: child.ended is not None)  # type: ignore[misc]
    assert (tmp_path / "program.log").read_text() == "three\n"
    assert (tmp_path / "program.1.log").read_text() == "two\n"


def test_a_child_that_is_started_again_adds_to_its_log(children: Callable[..., Child], tmp_path: Path) -> None:
    child = children("print('up')")
    for _ in range(2):
        child.start()
        eventually(lambda: child.ended is not None)
    assert (tmp_path / "program.log").read_text() == "up\nup\n"


def test_a_program_that_is_not_there_is_named(tmp_path: Path) -> None:
    child = Child("board", ["/does/not/exist"], tmp_path)
    with pytest.raises(LaunchError, match=r"The board \(/does/not/exist\) cannot be started"):
        child.start()
    assert child.stop() is True


def test_the_children_end_when_the_launcher_is_killed(tmp_path: Path) -> None:
    code = (
        "import sys, time; from pathlib import Path; from epf_gcs.launcher.child import Child;"
        f"c = Child('program', [sys.executable, '-c', 'import time; time.sleep(60)'], Path({str(tmp_path)!r}));"
        "c.start(); print(c.pid, flush=True); time.sleep(60)"
    )
    launcher = Child("launcher", [sys.executable, "-u", "-c", code], tmp_path)
    started(launcher)
    grandchild = int(launcher.log_path.read_text())
    assert launcher.pid is not None
    os.kill(launcher.pid, signal.SIGKILL)
    eventually(lambda: not exists(grandchild))
    launcher.stop()


def test_a_log_that_grew_long_is_turned_over_while_the_program_writes(
    children: Callable[..., Child], tmp_path: Path
) -> None:
    go = tmp_path / "go"
    waiting = f"import time, os\nwhile not os.path.exists({str(go)!r}): time.sleep(0.01)\n"
    child = children(f"print('x' * 3000)\nprint('before')\n{waiting}print('after')\n")
    child.start()
    eventually(lambda: "before" in child.last_lines())
    child.turn_log_over(most_bytes=10_000)
    assert "before" in child.log_path.read_text(), "it is not long yet"
    child.turn_log_over(most_bytes=1000)
    older = tmp_path / "program.1.log"
    assert older.read_text().endswith("before\n")
    assert older.stat().st_size == 1000, "only the newest part is kept"
    go.touch()
    eventually(lambda: child.log_path.read_text() == "after\n")
