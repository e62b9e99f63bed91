"""The topics of a recording: what went over both lines, each way, and what came of another program's log."""

from __future__ import annotations

from typing import Final

BOARD_RECEIVED: Final = 1
BOARD_SENT: Final = 2
SIMULATOR_RECEIVED: Final = 3
SIMULATOR_SENT: Final = 4
TOPICS: Final = {
    BOARD_RECEIVED: "board/received",
    BOARD_SENT: "board/sent",
    SIMULATOR_RECEIVED: "simulator/received",
    SIMULATOR_SENT: "simulator/sent",
}
LOG_TABLE: Final = 5
ALL_TOPICS: Final = {**TOPICS, LOG_TABLE: "log/table"}
"""Those of this station's recordings, and that of another program's log: see `log_table.py`."""
# The board's line is a stream of bytes, whose reads may be put together. A datagram's two ends carry meaning.
STREAMS: Final = frozenset({BOARD_RECEIVED, BOARD_SENT})
