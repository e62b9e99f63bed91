"""Log lines of a flight: links, alarms, recordings, the disk; one line for each event, limited in rate."""

from __future__ import annotations

import contextlib
from collections.abc import Callable
from typing import Any, Final, Literal

import structlog

from epf_gcs.contract.base import LinkState
from epf_gcs.contract.status import AlarmState
from epf_gcs.errors import GatewayError

_log = structlog.get_logger("flight")

Level = Literal["info", "warning", "error"]
# An event that repeats faster than this is logged once, with the number of repetitions.
_QUIET_S: Final = 10.0


def say(level: Level, event: str, **values: Any) -> None:
    """Write one log line. A failing log, as on a full disk, must not end the caller."""
    with contextlib.suppress(OSError):
        getattr(_log, level)(event, **values)


class FlightLog:
    """Called on the flight's loop; `steady_s` is a monotonic clock."""

    def __init__(self, steady_s: Callable[[], float]) -> None:
        self._steady_s = steady_s
        self._said_s: dict[tuple[str, ...], float] = {}
        self._unsaid: dict[tuple[str, ...], int] = {}
        self._links: dict[str, LinkState] = {}

    def link(self, name: str, state: LinkState, target: str | None, failure: GatewayError | None) -> None:
        """Log a link's state if it changed."""
        before = self._links.get(name, "closed")
        self._links[name] = state
        if state == before or state == "opening":
            # "opening" after "lost" still counts as lost, so that "open" is logged as reopened.
            self._links[name] = before if before == "lost" and state == "opening" else state
            return
        event = {"closed": "link closed", "open": "link reopened" if before == "lost" else "link opened"}
        reason = {} if failure is None else {"reason": failure.detail}
        level: Level = "warning" if state == "lost" else "info"
        self._once(level, event.get(state, "link lost"), (name,), {"link": name, "target": target, **reason})

    def alarm(self, event: Literal["came", "went", "acknowledged"], alarm: AlarmState) -> None:
        """Log an alarm that came (or became worse), went, or was acknowledged."""
        is_bad = event == "came" and alarm.level == "critical"
        level: Level = "error" if is_bad else "warning" if event == "came" else "info"
        self._once(level, f"alarm {event}", (alarm.id,), {"alarm": alarm.id, "text": alarm.text})

    def board_restarted(self, uptime_ms: int | None) -> None:
        """Log that the board restarted while its link stayed open."""
        self._once("warning", "board restarted", (), {"uptime_ms": uptime_ms})

    def _once(self, level: Level, event: str, key: tuple[str, ...], values: dict[str, Any]) -> None:
        now_s = self._steady_s()
        key = (event, *key)
        if now_s - self._said_s.get(key, -_QUIET_S) < _QUIET_S:
            self._unsaid[key] = self._unsaid.get(key, 0) + 1
            return
        self._said_s[key] = now_s
        unsaid = self._unsaid.pop(key, 0)
        say(level, event, **values, **({"unsaid": unsaid} if unsaid else {}))
