"""Alarms of ground and fence. What they are judged by, the heights, is not known here: others say what they see, and
when they say nothing any more, nobody watches."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, Final

from epf_gcs.contract.alarm_ids import AlarmId
from epf_gcs.vehicle.judges import Finding, Level

LASTS_S: Final = 1.5
"""The station says twice a second what it sees. Not heard for so long, nobody watches any more."""
START_S: Final = 15.0
"""The station may take so long to start beside this process."""
UNKNOWN: Final = "unknown"
"""What was to be watched cannot be read any more."""
_MOST: Final = 8
_MOST_S: Final = 600.0

_LEVELS: Final[dict[str, tuple[AlarmId, Level]]] = {
    "terrain_ahead": ("terrain_ahead", "critical"),
    "fence_left": ("fence_left", "critical"),
    "fence_ahead": ("fence_ahead", "warning"),
}
_WATCHED: Final = frozenset({"terrain", "fence"})
_WHAT: Final = frozenset({"terrain", "fence", "ceiling"})
_AIRCRAFT: Final = frozenset({"flight", "hil"})


class ToldSurroundings:
    """Takes what the station sees; only what has a known form counts.

    `watched`: what was to be watched before this process began, as `on_watched` was told; so that a station which does
    not come is noticed too. `now_s` is of a monotonic clock.
    """

    def __init__(
        self,
        watched: Sequence[str] = (),
        on_watched: Callable[[tuple[str, ...]], None] = lambda _: None,
        *,
        now_s: float = 0.0,
    ) -> None:
        self._found: list[Finding] = []
        self._watched = _known(watched)
        self._blind: tuple[str, ...] = ()
        self._on_watched = on_watched
        self._until_s = now_s + START_S

    def take(self, said: Sequence[Any], now_s: float, watched: Sequence[Any] = (), blind: Sequence[Any] = ()) -> None:
        """All that is seen at `now_s`: {id, aircraft, what, in_s}. What is not in it is over.

        `watched`: what a person wants to be warned of, "terrain" and "fence", or "unknown" where the choice cannot be
        read. `blind`: of those, what was seen until now and cannot be seen any more.
        """
        self._found = [found for one in said[:_MOST] if (found := _finding(one)) is not None]
        self._until_s = now_s + LASTS_S
        self._blind = _known(blind)
        if (known := _known(watched)) != self._watched:
            self._watched = known
            self._on_watched(known)

    def look(self, now_s: float) -> list[Finding]:
        """What is wrong at `now_s`; also that nobody watches what was to be watched, and what was known last."""
        if now_s > self._until_s:
            was_left = any(found.id == "fence_left" for found in self._found)
            return [_unwatched(self._watched, was_left=was_left)] if self._watched else []
        lost = (UNKNOWN,) if UNKNOWN in self._watched else self._blind
        return [*self._found, _unwatched(lost, was_left=False)] if lost else self._found


def _known(words: Sequence[Any]) -> tuple[str, ...]:
    return tuple(word for word in (*sorted(_WATCHED), UNKNOWN) if word in words)


def _unwatched(what: Sequence[str], *, was_left: bool) -> Finding:
    if UNKNOWN in what:
        text = "Ground and fence are not watched: the choice cannot be read. Choose it again."
    else:
        text = f"Not watched any more: {' and '.join(what)}. Keep clear by eye until this alarm has gone."
    if was_left:
        text += " When it was last watched, the aircraft was outside the fence."
    which = what[0] if len(what) == 1 else "both"
    return Finding("surroundings_unwatched", "critical", text, {"what": which, "was_left": was_left})


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
