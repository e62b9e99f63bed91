"""Whether a board that opens within one link is the one that was there, or has started anew and forgotten all."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Final

from epf_gcs.codec.values import Json
from epf_gcs.vehicle.wanted import STREAM_FLAGS

# The board counts whole milliseconds, the line delays what it says, and its quartz is off by a hundredth of a percent.
_SLACK_S: Final = 0.5
_DRIFT: Final = 0.001
# From here on its count begins again, below nothing.
_UPTIME_WRAPS_MS: Final = 2**31


@dataclass(frozen=True, slots=True)
class Restart:
    """The board started anew: its gains, plans and modes are those of its card. `uptime_ms` where it tells."""

    t_s: float
    uptime_ms: int | None


class BoardRestart:
    """Told of what the session sees within one link; times are those of one steady clock, `t_s` is Unix time.

    An extended board tells how long it has been up: less than it must be means that it started anew. A deployed
    board tells nothing. There the sign is that it was silent and opened anew, unless what it sent before is still
    switched on: then it was only the line that failed. What `heartbeat` is meant below: its values, as last heard.
    """

    def __init__(self) -> None:
        self._streams_before: frozenset[str] | None = None
        self._has_spoken_text = False
        # When the board must have started, by its own account.
        self._started_s: float | None = None

    def link_opened(self) -> None:
        """Another link, perhaps to another board: nothing is known of it."""
        self._streams_before = None
        self._started_s = None

    def fell_silent(self, heartbeat: Mapping[str, Json]) -> None:
        """The heartbeat of an open board stopped, and the dialogue begins anew."""
        self._streams_before = _streams(heartbeat)
        self._has_spoken_text = False

    def heard_text(self) -> None:
        """The board sent a line of text while the dialogue was being opened: it is in text mode, as after its start."""
        self._has_spoken_text = True

    def opened(
        self, steady_s: float, t_s: float, uptime_ms: int | None, heartbeat: Mapping[str, Json]
    ) -> Restart | None:
        """The dialogue is open; `uptime_ms` is None for a legacy board. Returns the restart that this shows."""
        before, self._streams_before = self._streams_before, None
        if uptime_ms is None:
            is_as_before = bool(before) and before is not None and before <= _streams(heartbeat)
            is_restart = before is not None and (self._has_spoken_text or not is_as_before)
            return Restart(t_s, None) if is_restart else None
        started_s = steady_s - uptime_ms / 1000.0
        before_s, self._started_s = self._started_s, started_s
        if before_s is None or (steady_s - before_s) * 1000.0 >= _UPTIME_WRAPS_MS:
            return None
        slack_s = _SLACK_S + _DRIFT * (steady_s - before_s)
        return Restart(t_s, uptime_ms) if started_s - before_s > slack_s else None


def _streams(heartbeat: Mapping[str, Json]) -> frozenset[str]:
    """Those that are on. A board that started anew has none."""
    return frozenset(flag for flag in STREAM_FLAGS.values() if flag is not None and heartbeat.get(flag) is True)
