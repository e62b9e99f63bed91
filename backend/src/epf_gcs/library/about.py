"""What people say of a flight: one small JSON file beside the recording, the only place where it is kept."""

from __future__ import annotations

from dataclasses import asdict, dataclass, field, fields
from pathlib import Path
from typing import Any, Self

import orjson

from epf_gcs.disk import KeptFile


@dataclass(slots=True)
class About:
    """`marks` were set after the flight: {"id", "t_ns", "text", "by"}, those of the recording itself with the words
    they were given later, or {"id", "hidden": true} where they were removed. `deleted_s`: when it went to the bin.
    `came_damaged`: what was wrong with the file that was imported, a sentence; empty if nothing was."""

    title: str = ""
    tags: list[str] = field(default_factory=list)
    notes: str = ""
    pinned: bool = False
    imported: bool = False
    marks: list[dict[str, Any]] = field(default_factory=list)
    deleted_s: float | None = None
    came_damaged: str = ""

    @property
    def is_empty(self) -> bool:
        """Whether nobody said anything."""
        return self == About()

    def as_json(self) -> bytes:
        """The content of the file."""
        return orjson.dumps(asdict(self), option=orjson.OPT_INDENT_2)

    @classmethod
    def from_json(cls, text: bytes) -> Self:
        """Read it. Raises ValueError where it is no such file; fields of a newer version are left out."""
        found = orjson.loads(text)
        if not isinstance(found, dict):
            raise ValueError("it is no JSON object")
        about = cls()
        for one in fields(cls):
            value = found.get(one.name, getattr(about, one.name))
            if one.name != "deleted_s" and type(value) is not type(getattr(about, one.name)):
                raise ValueError(f"{one.name} is of another kind")
            setattr(about, one.name, value)
        if not all(isinstance(tag, str) for tag in about.tags) or not all(_is_mark(mark) for mark in about.marks):
            raise ValueError("a tag or mark is of another kind")
        return about


def _is_mark(mark: Any) -> bool:
    return isinstance(mark, dict) and isinstance(mark.get("id"), str)


def read_about(path: Path) -> About:
    """What is said of a flight; nothing where there is no file. One that cannot be read is kept aside.

    Raises OSError.
    """
    return _file(path).read_or_set_aside(lambda _: None) or About()


def write_about(path: Path, about: About) -> None:
    """Replace the file at once, so that a power cut leaves the old or the new one. Raises OSError."""
    if not about.is_empty:
        path.parent.mkdir(parents=True, exist_ok=True)
    _file(path).write(None if about.is_empty else about)


def _file(path: Path) -> KeptFile[About]:
    return KeptFile(path, About.from_json, About.as_json)
