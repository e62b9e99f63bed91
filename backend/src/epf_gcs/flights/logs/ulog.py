"""PX4's ULog, read by pyulog."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any, Final

import numpy as np
from pyulog import ULog

from epf_gcs.flights.logs.log import Log, Piece, cut, guarded
from epf_gcs.flights.logs.naming import field_names, topic_names
from epf_gcs.recordings.log_table import MOST_FIELDS

_TIME: Final = "timestamp"
_CLOCKS: Final = ("sensor_gps", "vehicle_gps_position")
_UTC: Final = "time_utc_usec"


def read(path: Path) -> Log:
    """Raises InvalidInputError."""
    with path.open("rb") as file:
        found = guarded(lambda: ULog(file))
    ahead_us = _ahead_us(found.data_list)
    log = Log("ulog", _pieces(found.data_list, ahead_us or 0), is_dated=ahead_us is not None)
    if found.file_corruption:
        log.said.append("Some of this log was damaged and is left out.")
    if found.dropouts:
        lost_ms = sum(one.duration for one in found.dropouts)
        log.said.append(f"Its recorder lost {lost_ms / 1000:.1f} s in {len(found.dropouts)} pieces.")
    return log


def _ahead_us(topics: list[Any]) -> int | None:
    """What turns the board's time into Unix time; None where no receiver knew it."""
    for clock in _CLOCKS:
        for one in topics:
            utc = np.asarray(one.data.get(_UTC, ()) if one.name == clock else ())
            known = np.flatnonzero(utc > 0)
            if len(known):
                return int(utc[known[0]]) - int(one.data[_TIME][known[0]])
    return None


def _pieces(topics: list[Any], ahead_us: int) -> Iterator[Piece]:
    names = topic_names()
    for number, one in enumerate(topics):
        fields = [name for name, column in one.data.items() if name != _TIME and column.dtype.kind in "fiub"]
        if _TIME not in one.data or not fields:
            continue
        fields_here = field_names()
        topic = names.new(one.name if one.multi_id == 0 else f"{one.name}_{one.multi_id}")
        units = {fields_here.new(name): "1" for name in fields[:MOST_FIELDS]}
        t_ns = (one.data[_TIME].astype(np.int64) + ahead_us) * 1000
        for table in cut(topic, units, t_ns, [one.data[name] for name in fields[:MOST_FIELDS]]):
            yield Piece(table, number / len(topics))
