"""Where the station's data lie unless the user says otherwise, and whether a station is using them."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Final

from platformdirs import user_data_path

from epf_gcs.product import source_tree

if sys.platform != "win32":
    import fcntl

# Locked by the flight process for as long as it runs.
_LOCK: Final = ".lock"
DEFAULT: Final = "data in a source tree, else this user's place for data"
"""The same in words, for help texts."""


def data_folder() -> Path:
    """`data` in a source tree; else the place that this system has for a user's data, never where one stands."""
    tree = source_tree()
    return user_data_path("epf-gcs", appauthor=False) if tree is None else tree / "data"


def is_in_use(data: Path) -> bool:
    """Whether a flight process has the folder. Raises OSError."""
    try:
        with (data / _LOCK).open("rb") as lock:
            if sys.platform != "win32":
                fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except FileNotFoundError:
        return False
    except BlockingIOError:
        return True
    return False
