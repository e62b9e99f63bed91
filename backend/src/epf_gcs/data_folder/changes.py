"""What changed from one format of the data folder to the next: small files in, small files out, nothing else touched.

Recordings are never rewritten here: readers keep reading what earlier versions wrote.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Final

Files = Mapping[str, bytes]
"""Contents by path below the data folder; a file that is not there is missing."""
Changed = Mapping[str, bytes | None]
"""Only what differs; None: the file goes."""


@dataclass(frozen=True, slots=True)
class Change:
    """From format `to - 1` to `to`. `make` is given those of `files` that are there, and gives back what differs.

    It must cope with contents that make no sense: their reader keeps them aside and says so.
    """

    to: int
    files: tuple[str, ...]
    make: Callable[[Files], Changed]


def _online_maps_apart(files: Files) -> Changed:
    """0.1.0 was one process and kept the choice of online maps with the flight's settings."""
    try:
        state = json.loads(files["state.json"])
        choice = state.pop("online")
    except (KeyError, ValueError, AttributeError, TypeError):
        return {}
    changed = {"state.json": _as_json(state)}
    if choice and "online-maps.json" not in files:
        changed["online-maps.json"] = _as_json(choice)
    return changed


def _as_json(value: object) -> bytes:
    return json.dumps(value, indent=2, ensure_ascii=False).encode()


CHANGES: Final = (Change(2, ("state.json", "online-maps.json"), _online_maps_apart),)
