"""Runs the programs of this project as separate processes."""

from __future__ import annotations

import contextlib
import os
import re
import signal
import subprocess
import sys
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from tests.support.waiting import DEADLINE_S, eventually

BOARD = Path(__file__).parents[3] / "firmware" / "build" / "posix" / "epf-board"


class Program:
    """A child process; its stderr is kept."""

    def __init__(self, arguments: list[str]) -> None:
        environment = {name: value for name, value in os.environ.items() if not name.startswith("GCS_")}
        self.process = subprocess.Popen(arguments, stderr=subprocess.PIPE, stdout=subprocess.DEVNULL, env=environment)
        self.said = ""
        self._reader = threading.Thread(target=self._read, daemon=True)
        self._reader.start()

    def wait_for_words(self, pattern: str) -> str:
        """Wait until the pattern appears in its output; returns the first group."""
        eventually(lambda: re.search(pattern, self.said) is not None, f"'{pattern}' in: {self.said}")
        found = re.search(pattern, self.said)
        return found.group(1) if found is not None and found.groups() else ""

    def end(self, how: signal.Signals = signal.SIGTERM) -> int:
        """Send a signal and wait for the process to end; returns its exit code."""
        if self.process.poll() is None:
            self.process.send_signal(how)
        code = self.process.wait(DEADLINE_S)
        self._reader.join(DEADLINE_S)
        if self.process.stderr is not None:
            self.process.stderr.close()
        return code

    def _read(self) -> None:
        stream = self.process.stderr
        assert stream is not None
        for line in iter(stream.readline, b""):
            self.said += line.decode(errors="replace")


def children_of(pid: int) -> list[int]:
    """Process numbers of what a process started, in whichever of its threads."""
    found: list[int] = []
    for children in Path(f"/proc/{pid}/task").glob("*/children"):
        # A thread may end between the listing and the reading.
        with contextlib.suppress(FileNotFoundError, ProcessLookupError):
            found += [int(child) for child in children.read_text().split()]
    return found


def words_of(pid: int) -> list[str]:
    """The command line of a process; empty if it has ended."""
    try:
        return Path(f"/proc/{pid}/cmdline").read_bytes().decode().split("\0")
    except (FileNotFoundError, ProcessLookupError):
        return []


def sockets_of(pid: int) -> set[str]:
    """The open sockets of a process, as the system names them: `socket:[inode]`."""
    links: set[str] = set()
    for entry in Path(f"/proc/{pid}/fd").iterdir():
        # A file may be closed between the listing and the reading.
        with contextlib.suppress(FileNotFoundError):
            links.add(str(entry.readlink()))
    return {link for link in links if link.startswith("socket:")}


@contextmanager
def gateway_process(data_dir: Path, *arguments: str) -> Iterator[Program]:
    """`epf-gcs` on a free port."""
    program = Program(
        [sys.executable, "-m", "epf_gcs.launcher.gateway", "--port", "0", "--data-dir", str(data_dir), *arguments]
    )
    try:
        yield program
    finally:
        program.end(signal.SIGKILL)


@contextmanager
def board_process(path: Path, *arguments: str) -> Iterator[Program]:
    """The firmware itself on a pseudo-terminal."""
    assert BOARD.exists(), "build the board first: make -C firmware board"
    program = Program([str(BOARD), "--pty", str(path), *arguments])
    try:
        eventually(path.is_symlink, "the board makes its pseudo-terminal")
        yield program
    finally:
        program.end(signal.SIGTERM)
