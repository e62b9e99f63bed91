"""What a station says to a vehicle without waiting for an answer."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from epf_gcs.contract.base import PageFacts


class Notice:
    """The base of all notices. One that cannot be read is dropped."""

    __slots__ = ()


@dataclass(frozen=True, slots=True)
class Pace(Notice):
    """How many times a second this listener looks at samples; 0: each is sent at once."""

    rate_hz: int


@dataclass(frozen=True, slots=True)
class StickSample(Notice):
    """A sample of a page's gamepad, as the page sent it."""

    client: str
    sample: Mapping[str, Any]


@dataclass(frozen=True, slots=True)
class StickRelease(Notice):
    """This page's stick is let go: its stream has ended, or it has lost control."""

    client: str


@dataclass(frozen=True, slots=True)
class ControlChange(Notice):
    """The page that has control, or that has just lost it and may come back (`kept`); None: nobody.

    `about` is told to the station again when it has been restarted.
    """

    client: str | None = None
    name: str | None = None
    about: PageFacts = field(default_factory=PageFacts)
    kept: bool = False


@dataclass(frozen=True, slots=True)
class SurroundingsReport(Notice):
    """All that is wrong with ground and fence now; what is not in it is over.

    `watched`: what a person wants to be warned of, "terrain" and "fence", or "unknown" where the choice cannot be read.
    `blind`: of those, what was seen until now and cannot be seen any more.
    """

    findings: list[Mapping[str, Any]]
    watched: list[str] = field(default_factory=list)
    blind: list[str] = field(default_factory=list)
