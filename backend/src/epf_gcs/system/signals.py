"""The signals that politely end a program: of a terminal, of a service manager, of a window that is closed."""

from __future__ import annotations

import asyncio
import signal
import sys
from collections.abc import Callable
from typing import Final

if sys.platform == "win32":
    # The parent's request comes as SIGBREAK: other signals cannot be sent there.
    POLITE: Final = (signal.SIGINT, signal.SIGTERM, signal.SIGBREAK)
    # The main thread does not hear them while it waits for another one.
    HEARD_WITHIN_S: Final[float | None] = 0.5
else:
    POLITE: Final = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)
    HEARD_WITHIN_S: Final[float | None] = None


def on_polite_end(heard: Callable[[], None], loop: asyncio.AbstractEventLoop) -> None:
    """Call `heard` on the loop for each of them. From the main thread."""
    for number in POLITE:
        try:
            loop.add_signal_handler(number, heard)
        except NotImplementedError:  # Windows
            signal.signal(number, lambda *_: loop.call_soon_threadsafe(heard))
