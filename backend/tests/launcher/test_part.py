"""The gateway's two processes are started again when they die or hang; one that refuses ends the gateway."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import threading
from collections.abc import Iterator
from contextlib import contextmanager, redirect_stderr
from pathlib import Path

import pytest

from epf_gcs.launcher import part as part_module
from epf_gcs.launcher.part import Part
from epf_gcs.watchdog import REFUSED
from tests.support.waiting import DEADLINE_S, eventually


class Kept:
    """A part that runs a small program, and the thread that keeps it running."""

    def __init__(self, folder: Path, program: str, again: str | None = None) -> None:
        self.starts = folder / "starts"
        self._pipe = os.pipe()
        self.stopping = threading.Event()
        self.refusal: int | None = None
        self.part = Part("tried", self._command(program), self._command(again or program), self._pipe[0])
        self.thread = threading.Thread(target=self._run, daemon=True)

    def _command(self, program: str) -> list[str]:
        note = f"with open({str(self.starts)!r}, 'a') as file: file.write('x')"
        return [sys.executable, "-c", f"import sys, time\n{note}\n{program}"]

    def _run(self) -> None:
        self.refusal = self.part.keep_running(self.stopping)

    def count(self) -> int:
        return len(self.starts.read_text()) if self.starts.exists() else 0

    def runs(self, starts: int) -> None:
        eventually(lambda: self.count() == starts, f"start number {starts}")

    def stop(self) -> None:
        self.stopping.set()
        self.part.end(by_force=True)
        self.thread.join(DEADLINE_S)
        for end in self._pipe:
            os.close(end)


@pytest.fixture
def kept(tmp_path: Path, request: pytest.FixtureRequest) -> Iterator[Kept]:
    made = Kept(tmp_path, *request.param)
    made.thread.start()
    yield made
    made.stop()


@pytest.mark.parametrize("kept", [("sys.exit(2)",), ("sys.exit(1)",)], indirect=True)
def test_one_that_refuses_to_start_at_all_is_not_started_again(kept: Kept) -> None:
    kept.thread.join(DEADLINE_S)
    assert kept.refusal in (1, 2)
    assert kept.count() == 1


@pytest.mark.parametrize("kept", [("time.sleep(1000)",)], indirect=True)
def test_one_that_is_killed_is_started_again_each_time(kept: Kept) -> None:
    for starts in (1, 2):
        kept.runs(starts)
        kept.part.end(by_force=True)
    kept.runs(3)
    assert kept.refusal is None


def test_one_that_fails_after_it_has_lived_is_started_again(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(part_module, "_LIVED_S", 0.0)
    kept = Kept(tmp_path, "sys.exit(1)", "time.sleep(1000)")
    kept.thread.start()
    kept.runs(2)
    assert kept.refusal is None
    kept.stop()


def test_one_that_refuses_says_so_however_long_its_start_took(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(part_module, "_LIVED_S", 0.0)
    kept = Kept(tmp_path, f"sys.exit({REFUSED})")
    kept.thread.start()
    kept.thread.join(DEADLINE_S)
    assert (kept.refusal, kept.count()) == (REFUSED, 1)
    kept.stop()


def test_a_board_of_the_environment_is_not_opened_again_in_flight(tmp_path: Path) -> None:
    """The launcher alone reads that variable: a flight process that is started again opens what was open."""
    program = "from epf_gcs.launcher.part import environment; print('GCS_BOARD' in environment())"
    environment = {**os.environ, "GCS_BOARD": "tcp://another:1"}
    said = subprocess.run([sys.executable, "-c", program], env=environment, capture_output=True, check=True)
    assert said.stdout == b"False\n"


@contextmanager
def watched(name: str, command: list[str]) -> Iterator[Part]:
    """A real process of the gateway, which may be silent for a second."""
    alive, held = os.pipe()
    stopping = threading.Event()
    part = Part(name, command, command, alive, silent_s=1.5)
    thread = threading.Thread(target=part.keep_running, args=(stopping,), daemon=True)
    thread.start()
    try:
        yield part
    finally:
        stopping.set()
        part.end(by_force=True)
        thread.join(DEADLINE_S)
        os.close(alive)
        os.close(held)


def pid_of(part: Part) -> int | None:
    return None if part.process is None else part.process.pid


@contextmanager
def errors_in(path: Path) -> Iterator[None]:
    """What this process and those that it starts write as errors goes to a file, which can be read meanwhile."""
    kept = os.dup(2)
    with path.open("a") as file, redirect_stderr(file):
        os.dup2(file.fileno(), 2)
        try:
            yield
        finally:
            os.dup2(kept, 2)
            os.close(kept)


@pytest.mark.parametrize("name", ["flight", "web"])
def test_one_that_hangs_without_dying_is_killed_and_started_again(name: str, tmp_path: Path) -> None:
    word = {"flight": "flying", "web": "listening"}[name]
    errors = tmp_path / "errors.txt"

    def said(what: str) -> int:
        return errors.read_text().count(f"event={what} ")

    port = ["--port", "0"] if name == "web" else []
    command = [sys.executable, "-m", f"epf_gcs.{name}", "--data-dir", str(tmp_path / "data"), "--with-parent", *port]
    with errors_in(errors), watched(name, command) as part:
        eventually(lambda: said(word) == 1, "it runs")
        first = pid_of(part)
        assert first is not None
        os.kill(first, signal.SIGSTOP)
        eventually(lambda: said(word) == 2, "it runs again")
        assert pid_of(part) != first
    assert errors.read_text().count(f"the {name} process hangs and is killed") == 1
