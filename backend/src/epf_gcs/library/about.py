"""What people say of a flight: one small JSON file beside the recording, the only place where it is kept."""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path

import msgspec

from epf_gcs.contract.flights import LogKind
from epf_gcs.disk import KeptFile


class KeptMark(msgspec.Struct, frozen=True, omit_defaults=True):
    """A mark that was set after the flight, at Unix time `t_s` and `at_s` seconds after the flight's start.

    `recorded`: it stands in the recording, which stays as it is; these are the words it was given later, or it is
    `hidden`.
    """

    id: str
    text: str = ""
    t_s: float | None = None
    at_s: float | None = None
    by: str | None = None
    recorded: bool = False
    hidden: bool = False


@dataclass(slots=True)
class About:
    """`deleted_s`: when it went to the bin. `came_damaged`: what was wrong with the file that was imported, a
    sentence; empty if nothing was. `log`: it is a log of another program, of this kind."""

    title: str = ""
    tags: list[str] = field(default_factory=list)
    notes: str = ""
    pinned: bool = False
    imported: bool = False
    marks: list[KeptMark] = field(default_factory=list)
    deleted_s: float | None = None
    came_damaged: str = ""
    log: LogKind | None = None

    @property
    def is_empty(self) -> bool:
        """Whether nobody said anything."""
        return self == About()

    def as_json(self) -> bytes:
        """The content of the file."""
        return msgspec.json.format(msgspec.json.encode(self))

    @staticmethod
    def from_json(text: bytes | str) -> About:
        """Read it. Raises ValueError where it is no such file; fields of a newer version are left out."""
        return msgspec.json.decode(text, type=About)


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
