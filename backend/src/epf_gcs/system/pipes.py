"""Reading a pipe for no longer than a time."""

from __future__ import annotations

import os
import queue
import select
import sys
import threading
from typing import Final

_MANY: Final = 4096

if sys.platform == "win32":

    class PipeReader:
        """Reads in a thread, for only sockets can be waited for there. Whoever made it closes the pipe."""

        def __init__(self, descriptor: int) -> None:
            self._descriptor = descriptor
            self._read: queue.SimpleQueue[bytes] = queue.SimpleQueue()
            threading.Thread(target=self._run, name="pipe", daemon=True).start()

        def within(self, most_s: float) -> bytes | None:
            """What came, empty once the other end is closed; None if nothing came within this time."""
            try:
                return self._read.get(timeout=most_s)
            except queue.Empty:
                return None

        def _run(self) -> None:
            data = b"."
            while data:
                try:
                    data = os.read(self._descriptor, _MANY)
                except OSError:  # closed here
                    data = b""
                self._read.put(data)

else:

    class PipeReader:
        """Whoever made it closes the pipe."""

        def __init__(self, descriptor: int) -> None:
            self._descriptor = descriptor

        def within(self, most_s: float) -> bytes | None:
            """What came, empty once the other end is closed; None if nothing came within this time."""
            if not select.select([self._descriptor], [], [], most_s)[0]:
                return None
            return os.read(self._descriptor, _MANY)
