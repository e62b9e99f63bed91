"""A flight of the past as a viewer sees it, and what a viewer may ask of it without waiting for an answer."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final, Literal

from epf_gcs.contract.base import Shape
from epf_gcs.contract.notices import Notice

SLOWEST: Final = 0.01
FASTEST: Final = 100.0
"""The rates of play, times the real speed."""


@dataclass(frozen=True, slots=True)
class Playback(Shape):
    """Where a replay is. `at_s` and `loop` are seconds after the flight's start, `t_s` is Unix time.

    `jumps` counts the times it went elsewhere: values from before one are of no use.
    """

    flight: str
    at_s: float
    t_s: float
    state: Literal["playing", "paused", "ended"]
    rate: float
    loop: tuple[float, float] | None
    duration_s: float
    edge_s: float
    jumps: int


@dataclass(frozen=True, slots=True)
class Play(Notice):
    """Play on, at `rate` times the real pace; negative: backwards."""

    rate: float


@dataclass(frozen=True, slots=True)
class Pause(Notice):
    """Stand still."""


@dataclass(frozen=True, slots=True)
class Seek(Notice):
    """Go to this many seconds after the start."""

    at_s: float


@dataclass(frozen=True, slots=True)
class Step(Notice):
    """Go on by so many frames of the board; negative: back."""

    frames: int


@dataclass(frozen=True, slots=True)
class Loop(Notice):
    """Play this stretch again and again; without times: no longer."""

    from_s: float | None = None
    to_s: float | None = None


@dataclass(frozen=True, slots=True)
class Want(Notice):
    """The viewer's rate; 0: every sample."""

    rate_hz: int


@dataclass(frozen=True, slots=True)
class SampleCredit(Notice):
    """A viewer of every sample has been sent so many: the replay may go on."""

    count: int
