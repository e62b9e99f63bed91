"""What people did: one line of JSON for each deed, only ever appended to, in the data folder.

`{"t_s", "name", "kind", "role", "address", "deed", "what", "result"}`. Nothing in the interface changes it. Full files
are put aside under a number and never deleted. Written and synced by a thread of its own.
"""

from __future__ import annotations

import asyncio
import contextlib
import errno
import os
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any, BinaryIO, Final

import orjson

from epf_gcs.access.caller import Caller
from epf_gcs.disk import open_log, sync_folder
from epf_gcs.errors import GatewayError
from epf_gcs.system.files import read_at

FILE: Final = "people.jsonl"
TURNED_OVER_BYTES: Final = 16_000_000
MOST_WAITING: Final = 2000
"""Lines that wait for the disk; beyond, the disk has failed, which is reported."""
_MOST_WHAT: Final = 500
_BLOCK: Final = 65536

Deed = dict[str, Any]


class DeedLog:
    """`note` is called on the event loop and does not wait; `newest` may take long."""

    def __init__(self, folder: Path, now_s: Callable[[], float], report: Callable[[GatewayError], None]) -> None:
        self._folder = folder
        self._path = folder / FILE
        self._now_s = now_s
        self._report = report
        self._thread = ThreadPoolExecutor(1, "people-log")
        self._lines: list[bytes] = []
        self._is_writing = False

    def close(self) -> None:
        """Write what waits. Blocks."""
        self._thread.submit(self._write, self._take()).result()
        self._thread.shutdown()

    def note(self, caller: Caller | None, address: str, deed: str, what: str, result: str) -> None:
        """One deed; `caller` None: a stranger."""
        if len(self._lines) >= MOST_WAITING:
            self._fail("the disk does not answer")
            return
        line = {
            "t_s": round(self._now_s(), 3),
            "name": "" if caller is None else caller.name,
            "kind": "stranger" if caller is None else caller.kind,
            "role": None if caller is None else caller.role.name,
            "address": address,
            "deed": deed,
            "what": what[:_MOST_WHAT],
            "result": result,
        }
        self._lines.append(orjson.dumps(line) + b"\n")
        if not self._is_writing:
            self._is_writing = True
            asyncio.get_running_loop().run_in_executor(self._thread, self._write, self._take()).add_done_callback(
                self._written
            )

    async def newest(self, before: int | None, limit: int, text: str) -> list[Deed]:
        """Up to `limit` deeds that have this text in them and stand before the one at `before`, newest first.

        Each says as `at` where it stands: its byte in all files together. Times can be the same, and go back. All that
        was noted before is among them.
        """
        loop = asyncio.get_running_loop()
        # What is being written, and what has waited for that.
        for _ in range(2):
            await loop.run_in_executor(self._thread, _nothing)
        return await loop.run_in_executor(None, lambda: list(self._search(before, limit, text.casefold())))

    def _take(self) -> bytes:
        lines, self._lines = self._lines, []
        return b"".join(lines)

    def _written(self, done: asyncio.Future[None]) -> None:
        self._is_writing = False
        error = done.exception()
        if error is not None:
            self._fail(getattr(error, "strerror", None) or type(error).__name__)
        elif self._lines:
            self._is_writing = True
            asyncio.get_running_loop().run_in_executor(self._thread, self._write, self._take()).add_done_callback(
                self._written
            )

    def _fail(self, why: str) -> None:
        self._report(
            GatewayError(
                "people_log_not_written",
                f"What people did could not be written to {self._path} ({why}): free the disk or correct its "
                "permissions.",
                path=str(self._path),
                why=why,
            )
        )

    def _write(self, data: bytes) -> None:
        if not data:
            return
        with open_log(self._path) as file:
            descriptor = file.fileno()
            size = os.fstat(descriptor).st_size
            # A power cut may have torn the last line: the next one does not continue it.
            is_torn = size > 0 and read_at(descriptor, 1, size - 1) != b"\n"
            whole = b"\n" + data if is_torn else data
            if os.write(descriptor, whole) != len(whole):
                raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))
            os.fsync(descriptor)
        if size == 0:
            sync_folder(self._folder)
        if size + len(data) > TURNED_OVER_BYTES:
            number = len(self._older()) + 1
            self._path.rename(self._folder / f"people.{number:04d}.jsonl")
            sync_folder(self._folder)

    def _older(self) -> list[Path]:
        return sorted(self._folder.glob("people.[0-9][0-9][0-9][0-9].jsonl"))

    def _search(self, before: int | None, limit: int, text: str) -> Iterator[Deed]:
        found = 0
        for at, line in self._lines_backwards():
            # A line that a power cut tore is left out.
            try:
                deed = orjson.loads(line)
            except orjson.JSONDecodeError:
                continue
            if before is not None and at >= before:
                continue
            if text and text not in line.decode("utf-8", "replace").casefold():
                continue
            yield {**deed, "at": at}
            found += 1
            if found >= limit:
                return

    def _lines_backwards(self) -> Iterator[tuple[int, bytes]]:
        """All lines with their places, the last one first."""
        with contextlib.ExitStack() as opened:
            files: list[BinaryIO] = []
            # The newest first: if it is put aside meanwhile, it is found among the older ones too, and left out there.
            with contextlib.suppress(FileNotFoundError):
                files.append(opened.enter_context(self._path.open("rb")))
            for path in reversed(self._older()):
                file: BinaryIO = opened.enter_context(path.open("rb"))
                if not files or not os.path.sameopenfile(files[0].fileno(), file.fileno()):
                    files.append(file)
            sizes = [file.seek(0, os.SEEK_END) for file in files]
            end = sum(sizes)
            for one, size in zip(files, sizes, strict=True):
                end -= size
                for at, line in _backwards(one, size):
                    yield end + at, line


def _backwards(file: BinaryIO, size: int) -> Iterator[tuple[int, bytes]]:
    """The lines of a file with their places, the last one first, without reading it whole."""
    start, rest = size, b""
    while start > 0:
        block = min(_BLOCK, start)
        start -= block
        file.seek(start)
        lines = (file.read(block) + rest).split(b"\n")
        rest = lines.pop(0)
        at = start + len(rest) + sum(len(line) + 1 for line in lines) + 1
        for line in reversed(lines):
            at -= len(line) + 1
            if line:
                yield at, line
    if rest:
        yield 0, rest


def _nothing() -> None:
    """A turn of the thread that writes: what was handed to it before is done."""
