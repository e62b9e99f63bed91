"""What the gateway says on stderr: little, one line each, and nothing at all in a flight without trouble.

Of one kind of line there are a few in a minute, and then the number of those that were left out: a stranger who makes
mistakes on purpose must not fill the disk.
"""

from __future__ import annotations

import logging
import sys
import time
from collections.abc import Callable, MutableMapping
from typing import Any, Final

import structlog

LINES_PER_WINDOW: Final = 10
WINDOW_S: Final = 60.0
_MOST_KINDS: Final = 500
_MOST_LINE: Final = 4000


class Quota:
    """So many lines of a kind in each window. Told nothing but the kind; asks for the time."""

    def __init__(self, now_s: Callable[[], float] = time.monotonic, lines: int = LINES_PER_WINDOW) -> None:
        self._now_s = now_s
        self._lines = lines
        self._kinds: dict[str, tuple[float, int]] = {}

    def take(self, kind: str) -> int | None:
        """None: leave this line out. A number: say it, and that this many of its kind were left out before it."""
        now_s = self._now_s()
        begun_s, count = self._kinds.get(kind, (now_s, 0))
        if now_s - begun_s >= WINDOW_S:
            left_out = max(0, count - self._lines)
            self._kinds[kind] = (now_s, 1)
            return left_out
        if kind not in self._kinds and len(self._kinds) >= _MOST_KINDS:
            self._kinds = {key: value for key, value in self._kinds.items() if now_s - value[0] < WINDOW_S}
            if len(self._kinds) >= _MOST_KINDS:
                return None
        self._kinds[kind] = (begun_s, count + 1)
        return 0 if count < self._lines else None


class _QuotaFilter(logging.Filter):
    """The same for the lines of libraries: a kind is where in the code it is said."""

    def __init__(self, quota: Quota) -> None:
        super().__init__()
        self._quota = quota

    def filter(self, record: logging.LogRecord) -> bool:
        """Whether this line is said."""
        left_out = self._quota.take(f"{record.name}:{record.lineno}")
        if left_out:
            record.msg = f"{record.msg} (and {left_out} more of these)"
        return left_out is not None


def set_up_logging(*, verbose: bool) -> None:
    """Everything to stderr, one line each; uvicorn's own log only where something is wrong."""
    level = logging.DEBUG if verbose else logging.INFO
    quota = Quota()
    logging.basicConfig(
        level=level if verbose else logging.WARNING, stream=sys.stderr, format="%(levelname)s %(message)s"
    )
    for handler in logging.getLogger().handlers:
        for old in [one for one in handler.filters if isinstance(one, _QuotaFilter)]:
            handler.removeFilter(old)
        handler.addFilter(_QuotaFilter(quota))
    structlog.configure(
        wrapper_class=structlog.make_filtering_bound_logger(level),
        processors=[
            structlog.processors.add_log_level,
            _within(quota),
            structlog.processors.TimeStamper(fmt="iso", utc=True),
            structlog.processors.format_exc_info,
            _shorten,
            structlog.processors.LogfmtRenderer(key_order=["timestamp", "level", "event"]),
        ],
        logger_factory=lambda *_: structlog.PrintLogger(sys.stderr),
    )


def _within(quota: Quota) -> Callable[[object, str, MutableMapping[str, Any]], MutableMapping[str, Any]]:
    def drop_or_count(_logger: object, _method: str, line: MutableMapping[str, Any]) -> MutableMapping[str, Any]:
        left_out = quota.take(f"{line.get('level')}:{line.get('event')}")
        if left_out is None:
            raise structlog.DropEvent
        if left_out:
            line["left_out"] = left_out
        return line

    return drop_or_count


def _shorten(_logger: object, _method: str, line: MutableMapping[str, Any]) -> MutableMapping[str, Any]:
    """A path or a name that a stranger chose may be long."""
    for key, value in line.items():
        if isinstance(value, str) and len(value) > _MOST_LINE:
            line[key] = value[:_MOST_LINE] + "..."
    return line
