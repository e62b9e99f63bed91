"""A file of lines: appended at the end, the oldest dropped; written by a thread, for a disk may stall."""

from __future__ import annotations

import asyncio
import contextlib
import os
from collections import deque
from collections.abc import Callable, Iterable
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from epf_gcs.disk import open_log, replace_file, set_aside
from epf_gcs.errors import ErrorCode, GatewayError


class LinesFile:
    """Keeps the newest `keep` lines. `report` is called on the event loop when the disk refuses a write.

    `code` is that error's code; `what` names the file in its sentence.
    """

    def __init__(
        self,
        path: Path,
        keep: int,
        report: Callable[[GatewayError], None],
        *,
        code: ErrorCode = "journal_not_written",
        what: str = "journal",
    ) -> None:
        self._loop = asyncio.get_running_loop()
        self._path = path
        self._keep = keep
        self._report = report
        self._code: ErrorCode = code
        self._what = what
        # One thread, so that lines keep their order. Once it runs, only this thread uses the three fields below,
        # which mirror the file.
        self._thread = ThreadPoolExecutor(1, thread_name_prefix=path.stem)
        self._lines: deque[bytes] = deque(maxlen=keep)
        self._on_disk = 0
        self._is_torn = False

    def read(self) -> list[bytes]:
        """Read the lines from the disk, oldest first; only at the start. Raises OSError."""
        try:
            data = self._path.read_bytes()
        except FileNotFoundError:
            return []
        lines = data.splitlines()
        self._on_disk = len(lines)
        self._is_torn = not data.endswith(b"\n")
        return lines

    def begin_with(self, lines: Iterable[bytes], *, damaged: bool) -> None:
        """Continue from these readable lines. `damaged`: keep the old file under another name and write a new one."""
        self._lines.extend(lines)
        if damaged:
            self._submit(self._set_aside)
        elif self._is_torn or self._on_disk > self._keep:
            self._submit(self._rewrite)

    def append(self, line: bytes) -> None:
        """Append a line; returns at once."""
        self._submit(lambda: self._append(line))

    def close(self) -> None:
        """Wait until all lines are written."""
        self._thread.shutdown()

    def _submit(self, work: Callable[[], None]) -> None:
        with contextlib.suppress(RuntimeError):  # closed already: drop the line
            self._thread.submit(self._try, work)

    def _try(self, work: Callable[[], None]) -> None:
        try:
            self._path.parent.mkdir(parents=True, exist_ok=True)
            work()
        except OSError as error:
            failure = GatewayError(
                self._code,
                f"The {self._what} could not be kept in {self._path} ({error.strerror or error}): "
                "free the disk or correct its permissions, or it is lost at the next start.",
                path=str(self._path),
            )
            with contextlib.suppress(RuntimeError):  # the event loop may be closed already
                self._loop.call_soon_threadsafe(self._report, failure)

    def _append(self, line: bytes) -> None:
        self._lines.append(line)
        if self._on_disk >= 2 * self._keep:
            self._rewrite()
            return
        with open_log(self._path) as file:
            file.write(line + b"\n")
            file.flush()
            os.fsync(file.fileno())
        self._on_disk += 1

    def _set_aside(self) -> None:
        set_aside(self._path)
        self._rewrite()

    def _rewrite(self) -> None:
        replace_file(self._path, b"".join(line + b"\n" for line in self._lines))
        self._on_disk = len(self._lines)
