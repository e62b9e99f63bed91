"""What the gateway says on stderr: little, one line each, and nothing at all in a flight without trouble."""

from __future__ import annotations

import logging
import sys

import structlog


def set_up_logging(*, verbose: bool) -> None:
    """Everything to stderr, one line each; uvicorn's own log only where something is wrong."""
    level = logging.DEBUG if verbose else logging.INFO
    logging.basicConfig(
        level=level if verbose else logging.WARNING, stream=sys.stderr, format="%(levelname)s %(message)s"
    )
    structlog.configure(
        wrapper_class=structlog.make_filtering_bound_logger(level),
        processors=[
            structlog.processors.add_log_level,
            structlog.processors.TimeStamper(fmt="iso", utc=True),
            structlog.processors.format_exc_info,
            structlog.processors.LogfmtRenderer(key_order=["timestamp", "level", "event"]),
        ],
        logger_factory=lambda *_: structlog.PrintLogger(sys.stderr),
    )
