"""The event loop: one that watches sockets, on every system."""

from __future__ import annotations

import asyncio
import sys


def new_loop() -> asyncio.AbstractEventLoop:
    """A loop that tells when a socket can be read and written. On Windows it starts no programs: `threaded_loop.py`."""
    if sys.platform == "win32":
        # Its usual one knows no `add_reader`.
        return asyncio.SelectorEventLoop()
    try:
        import uvloop  # noqa: PLC0415 - not there on every system
    except ImportError:
        return asyncio.new_event_loop()
    return uvloop.new_event_loop()
