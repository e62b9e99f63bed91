"""Files that a program made, whose names hold the time."""

from __future__ import annotations

from pathlib import Path


def the_one_like(folder: Path, pattern: str) -> Path:
    """The only file of this pattern."""
    (found,) = folder.glob(pattern)
    return found
