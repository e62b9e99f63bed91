"""What a path leads to: the ground, the fence, its ceiling. Pure."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final, Literal

import numpy as np

from epf_gcs.surroundings.motion import Vector
from epf_gcs.surroundings.path import Path

WARN_S: Final = 30.0
AHEAD_S: Final = 38.0
"""How far the path is followed: the 30 s of warning, and the time that the estimate of the track lags behind."""
_END_S: Final = 10.0
# An ended warning must be over by more than the limit that raised it: by more than a receiver's altitude wanders.
_WIDER: Final = 1.25

What = Literal["terrain", "fence", "ceiling"]

# How long a threat must last to count. The margin under a ceiling is itself many seconds of climb: there is the time to
# see whether it is a climb or the lift of gusty air.
_RAISE_S: Final[dict[What, float]] = {"terrain": 1.0, "fence": 1.0, "ceiling": 4.0}


@dataclass(frozen=True, slots=True)
class Threat:
    """Reached `in_s` from now (0: already) at this place; `altitude_m` of the path there, above the sea."""

    what: What
    in_s: float
    latitude_deg: float
    longitude_deg: float
    altitude_m: float


class Steady:
    """Hysteresis: a threat counts when it lasted a moment, and is over when there was none for some seconds.

    `None` while nothing can be seen keeps it for the same seconds.
    """

    def __init__(self) -> None:
        self._since_s: float | None = None
        self._last_s = 0.0
        self._shown: Threat | None = None

    @property
    def shown(self) -> Threat | None:
        """The threat that counts now."""
        return self._shown

    def look(self, now_s: float, threat: Threat | None) -> Threat | None:
        """The threat that counts at `now_s`."""
        if threat is None:
            self._since_s = None
            if now_s - self._last_s >= _END_S:
                self._shown = None
            return self._shown
        if self._since_s is None:
            self._since_s = now_s
        if self._shown is not None or now_s - self._since_s >= _RAISE_S[threat.what] or threat.in_s == 0.0:
            self._shown = threat
        if self._shown is not None:
            self._last_s = now_s
        return self._shown

    def end(self) -> None:
        """No position, or not wanted any more: nothing may look live."""
        self._since_s = None
        self._shown = None


def limit(margin: float, *, is_shown: bool) -> float:
    """The margin, wider while the warning is shown, so that it does not come and go at its edge."""
    return margin * _WIDER if is_shown else margin


def first_below(path: Path, clearance_m: Vector, margin_m: float, what: What) -> Threat | None:
    """The first place of the path whose clearance is less than the margin. NaN, not known, is not less."""
    found = np.flatnonzero(clearance_m < margin_m)
    if found.size == 0:
        return None
    first = int(found[0])
    return Threat(
        what,
        float(path.after_s[first]),
        float(path.latitude_deg[first]),
        float(path.longitude_deg[first]),
        float(path.altitude_m[first]),
    )
