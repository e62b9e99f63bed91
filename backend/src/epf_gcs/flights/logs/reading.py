"""Which program's log a file is, told by what is in it and not by its name; and the log."""

from __future__ import annotations

from pathlib import Path
from typing import Final

from epf_gcs.extras import LOGS
from epf_gcs.flights.logs import csv_log, mavlink_logs, mcap_log
from epf_gcs.flights.logs.log import Log
from epf_gcs.recordings.mcap_file import MAGIC
from epf_gcs.workers.missing import require

_HEAD_BYTES: Final = 1 << 16
_ULOG: Final = b"ULog\x01\x12\x35"


def read_log(path: Path) -> Log | None:
    """The log; None if it is of no kind that is known. Raises InvalidInputError, ConflictError, OSError."""
    with path.open("rb") as file:
        head = file.read(_HEAD_BYTES)
    if head.startswith(MAGIC):
        return mcap_log.read(path)
    is_tlog = mavlink_logs.is_tlog(head)
    if is_tlog or head.startswith((_ULOG, mavlink_logs.DATAFLASH)):
        require(LOGS)
    if head.startswith(_ULOG):
        from epf_gcs.flights.logs import ulog  # noqa: PLC0415 - an extra of the package

        return ulog.read(path)
    if head.startswith(mavlink_logs.DATAFLASH):
        return mavlink_logs.read_dataflash(path)
    if is_tlog:
        return mavlink_logs.read_tlog(path)
    return csv_log.read(path) if csv_log.looks_like(head) else None
