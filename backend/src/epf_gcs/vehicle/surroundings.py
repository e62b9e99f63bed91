"""Alarms of ground and fence. What they are judged by, the heights, is not known here: others say what they see, and
what they do not say again soon is over."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Final

from epf_gcs.vehicle.alarm_ids import AlarmId
from epf_gcs.vehicle.judges import Finding, Level

LASTS_S: Final = 2.0
"""A finding that is not said again for so long ends: whoever said it has gone."""
_MOST: Final = 8
_MOST_S: Final = 600.0

_LEVELS: Final[dict[str, tuple[AlarmId, Level]]] = {
    "terrain_ahead": ("terrain_ahead", "critical"),
    "fence_left": ("fence_left", "critical"),
    "fence_ahead": ("fence_ahead", "warning"),
}
_WHAT: Final = frozenset({"terrain", "fence", "ceiling"})
_AIRCRAFT: Final = frozenset({"flight", "hil"})


class ToldSurroundings:
    """Takes what the station sees; only what has a known form counts."""

    def __init__(self) -> None:
        self._found: list[Finding] = []
        self._said_s = 0.0

    def take(self, said: Sequence[Any], now_s: float) -> None:
        """All that is seen at `now_s` of a monotonic clock: {id, aircraft, what, in_s}. What is not in it is over."""
        self._found = [found for one in said[:_MOST] if (found := _finding(one)) is not None]
        self._said_s = now_s

    def look(self, now_s: float) -> list[Finding]:
        """What is wrong at `now_s`."""
        return self._found if now_s - self._said_s <= LASTS_S else []


def _finding(said: Any) -> Finding | None:
    match said:
        case {"id": str(name), "aircraft": str(aircraft), "what": str(what), "in_s": float() | int() as in_s}:
            known = _LEVELS.get(name)
            if known is None or what not in _WHAT or aircraft not in _AIRCRAFT or not 0 <= in_s <= _MOST_S:
                return None
            alarm, level = known
            seconds = round(in_s)
            return Finding(alarm, level, _sentence(alarm, what, seconds), {"aircraft": aircraft, "what": what})
    return None


def _sentence(alarm: AlarmId, what: str, seconds: int) -> str:
    border = "ceiling" if what == "ceiling" else "border"
    if alarm == "terrain_ahead":
        return f"Ground ahead on the present track, in {seconds} s: climb or turn."
    if alarm == "fence_left":
        return f"The aircraft is beyond the fence's {border}: bring it back."
    return f"The present track leaves the fence at its {border}, in {seconds} s: turn."
