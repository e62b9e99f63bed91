"""A key frame: what a playhead goes on from, as text."""

from __future__ import annotations

import json
from dataclasses import dataclass
from typing import Any

import msgspec

from epf_gcs.replay.judged import JudgedState
from epf_gcs.replay.known import KnownState
from epf_gcs.vehicle.vehicle import VehicleState


@dataclass(frozen=True, slots=True)
class PlayheadState:
    """A key frame: all that what comes next depends on. Unix times; `lines`: when the board's line was attached, and
    the first and the last command 50; `counts` and `rates` as the playhead has them."""

    t_ns: int
    tick_ns: int
    heard_ns: int
    frame_ns: int
    known: KnownState
    vehicle: VehicleState
    sent: list[Any]
    counts: tuple[int, int, int, int]
    rates: list[list[tuple[float, int]]]
    errors: dict[str, int]
    lines: tuple[float, float | None, float | None]
    judged: JudgedState | None

    def as_json(self) -> str:
        """The key frame's text. Values of a simulator may be no number, which JSON of others does not have."""
        return json.dumps(msgspec.to_builtins(self), separators=(",", ":"))

    @staticmethod
    def from_json(text: bytes) -> PlayheadState:
        """Read it back. Raises ValueError."""
        return msgspec.convert(json.loads(text), PlayheadState, str_keys=True)
