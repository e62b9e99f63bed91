"""Files of ours are read by our own user alone."""

from __future__ import annotations

import os

_SHUT_OUT: int = 0o077


def write_private_files() -> None:
    """From now on every file and folder that this process or its children make is closed to all other users."""
    os.umask(_SHUT_OUT)
