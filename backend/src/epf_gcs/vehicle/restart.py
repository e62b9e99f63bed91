"""Detect a restart of the board: after one it has forgotten what it was told."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Final

from epf_gcs.codec.values import Json
from epf_gcs.vehicle.wanted import STREAM_FLAGS

# Tolerances for the line's delay and for the board's quartz, which is off by a hundredth of a percent.
_SLACK_S: Final = 0.5
_DRIFT: Final = 0.001
# The board's uptime counter overflows to negative values here.
_UPTIME_WRAPS_MS: Final = 2**31


@dataclass(frozen=True, slots=True)
class Restart:
    """The board restarted: its gains, plans and modes are those of its card. `uptime_ms` is None for a legacy board."""

    t_s: float
    uptime_ms: int | None


class BoardRestart:
    """Detects restarts from what the session sees. `steady_s` is a steady clock's, `t_s` Unix time.

    An extended board reports its uptime: if that is shorter than the time since its known start, it has restarted, also
    if the link was lost meanwhile. A legacy board reports none. There a restart is assumed after a silence and a new
    opening within one link, unless it sent no text meanwhile and the streams that were on before (at least one) still
    are: then only the line had failed.
    `heartbeat`: the values of the last heartbeat.
    """

    def __init__(self) -> None:
        self._target = ""
        self._streams_before: frozenset[str] | None = None
        self._has_spoken_text = False
        # When the board started, computed from the uptime that it reported.
        self._started_s: float | None = None

    def link_opened(self, target: str) -> None:
        """A link to `target` was opened. To another than before, or one without a name, it is perhaps another board."""
        if not target or target != self._target:
            self._started_s = None
        self._target = target
        self._streams_before = None

    def fell_silent(self, heartbeat: Mapping[str, Json]) -> None:
        """The heartbeat of an open board stopped, and the dialogue is being opened again."""
        self._streams_before = _streams(heartbeat)
        self._has_spoken_text = False

    def heard_text(self) -> None:
        """The board sent a line of text while the dialogue was being opened: it is in text mode, as after its start."""
        self._has_spoken_text = True

    def opened(
        self, steady_s: float, t_s: float, uptime_ms: int | None, heartbeat: Mapping[str, Json]
    ) -> Restart | None:
        """The dialogue is open; `uptime_ms` is None for a legacy board. Returns the restart, None if there was none."""
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
    """The streams that are on; none after a restart."""
    return frozenset(flag for flag in STREAM_FLAGS.values() if flag is not None and heartbeat.get(flag) is True)
