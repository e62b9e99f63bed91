"""A file of lines that only grows at its end and is cut at its start; written by a thread, for a disk may stall."""

from __future__ import annotations

import asyncio
import contextlib
import os
from collections import deque
from collections.abc import Callable, Iterable
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Final

from epf_gcs.errors import ErrorCode, GatewayError
from epf_gcs.flight.disk import replace_file

_DAMAGED: Final = ".damaged"


class LinesFile:
    """The newest `keep` lines of something. `report` hears of a disk that refuses, on the event loop.

    `code` and `what` are the error's code and what its sentence calls the file.
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
        # One thread, so that lines stand in the order in which they were given. Lines of the file as it is now:
        # known to that thread alone once it runs.
        self._thread = ThreadPoolExecutor(1, thread_name_prefix=path.stem)
        self._lines: deque[bytes] = deque(maxlen=keep)
        self._on_disk = 0
        self._is_torn = False

    def read(self) -> list[bytes]:
        """The lines as they are on the disk, oldest first; for the start. Raises OSError."""
        try:
            data = self._path.read_bytes()
        except FileNotFoundError:
            return []
        lines = data.splitlines()
        self._on_disk = len(lines)
        self._is_torn = not data.endswith(b"\n")
        return lines

    def begin_with(self, lines: Iterable[bytes], *, damaged: bool) -> None:
        """Go on from these lines; a file that holds others too is kept aside and written anew."""
        self._lines.extend(lines)
        if damaged:
            self._submit(self._set_aside)
        elif self._is_torn or self._on_disk > self._keep:
            self._submit(self._rewrite)

    def append(self, line: bytes) -> None:
        """One more line; returns at once."""
        self._submit(lambda: self._append(line))

    def close(self) -> None:
        """Wait until all is written."""
        self._thread.shutdown()

    def _submit(self, work: Callable[[], None]) -> None:
        with contextlib.suppress(RuntimeError):  # after the end nothing is written any more
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
            with contextlib.suppress(RuntimeError):  # the loop may have ended meanwhile
                self._loop.call_soon_threadsafe(self._report, failure)

    def _append(self, line: bytes) -> None:
        self._lines.append(line)
        if self._on_disk >= 2 * self._keep:
            self._rewrite()
            return
        with self._path.open("ab") as file:
            file.write(line + b"\n")
            file.flush()
            os.fsync(file.fileno())
        self._on_disk += 1

    def _set_aside(self) -> None:
        self._path.replace(self._path.with_name(self._path.name + _DAMAGED))
        self._rewrite()

    def _rewrite(self) -> None:
        replace_file(self._path, b"".join(line + b"\n" for line in self._lines))
        self._on_disk = len(self._lines)
