"""A campaign's results, one row for each flight: kept line by line as they come, and as Parquet once all are there."""

from __future__ import annotations

import math
import os
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from io import FileIO
from pathlib import Path
from typing import Any, Final, Self

import msgspec
import orjson

from epf_gcs.disk import replace_file, sync_folder
from epf_gcs.lab.campaign import Campaign, Order
from epf_gcs.lab.conditions import GAIN, USUAL
from epf_gcs.lab.errors import LabError
from epf_gcs.lab.faults import told
from epf_gcs.lab.flight import FIGURES, Flight

PARQUET: Final = "flights.parquet"
CAMPAIGN: Final = "campaign.toml"
WORST: Final = 10
"""So many flights of a campaign are shown and recorded."""
_JOURNAL: Final = "flights.jsonl"
_FINGERPRINT: Final = "campaign.sha256"

Row = dict[str, Any]

_OUTCOME: Final[Mapping[str, Callable[[Flight], Any]]] = {
    "waypoints": lambda flight: len(flight.route.waypoints),
    **FIGURES,
    "lost_at_s": lambda flight: None if flight.upset is None else flight.upset.time_s,
    "lost_by": lambda flight: None if flight.upset is None else flight.upset.cause,
}


def row(order: Order, flight: Flight | None, error: str | None = None) -> Row:
    """Conditions, gains and figures of one flight, by the names of Parquet's columns: the same in every row, with None
    for what there is none of. `error`: why it was not flown."""
    conditions = {**USUAL, **order.conditions}
    return {
        "number": order.number,
        **{name: _told(conditions[name], type(usual)) for name, usual in USUAL.items()},
        **{f"{GAIN}{name}": _told(value, float) for name, value in order.gains.items()},
        "faults": told(order.faults),
        "is_safe": flight is not None and flight.is_safe,
        **{name: None if flight is None else _number(read(flight)) for name, read in _OUTCOME.items()},
        "error": error,
    }


class Results:
    """A folder of one campaign's results. A flight that is in it is not flown again."""

    def __init__(self, folder: Path, campaign: Campaign) -> None:
        """Raises LabError if the folder holds another campaign, or cannot be written."""
        self._folder = folder
        self._campaign = campaign
        try:
            folder.mkdir(parents=True, exist_ok=True)
            self._claim()
            self.rows = {kept["number"]: kept for kept in _whole_lines(folder / _JOURNAL)}
            self._journal: FileIO = (folder / _JOURNAL).open("ab", buffering=0)
        except OSError as error:
            raise LabError(f"{folder} cannot be written: {error.strerror}") from error

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self._journal.close()

    def missing(self) -> Iterator[int]:
        """Numbers of the flights that are still to be flown."""
        return (number for number in range(self._campaign.flights) if number not in self.rows)

    def add(self, flown: Row) -> None:
        """Keep a flight. Raises LabError if the disk does not take it."""
        line = orjson.dumps(flown) + b"\n"
        with self._going_on():
            # A disk that fills up takes a part of the line without an error, and refuses the next.
            while line:
                line = line[self._journal.write(line) :]
        self.rows[flown["number"]] = flown

    def finish(self) -> Path:
        """All flights in order as Parquet; returns its path. The same rows give the same bytes. Raises LabError if the
        disk does not take it."""
        import pyarrow as pa  # noqa: PLC0415 - takes a second, and a campaign that is cut short needs none of it
        import pyarrow.parquet as pq  # noqa: PLC0415

        ordered = [self.rows[number] for number in sorted(self.rows)]
        path, unfinished = self._folder / PARQUET, self._folder / f"{PARQUET}.part"
        with self._going_on():
            os.fsync(self._journal.fileno())
            pq.write_table(pa.Table.from_pylist(ordered), unfinished, compression="zstd")
            unfinished.replace(path)
            sync_folder(self._folder)
        return path

    @contextmanager
    def _going_on(self) -> Iterator[None]:
        """What is written in it can be written later, by the same command."""
        try:
            yield
        except OSError as error:
            why = error.strerror or error
            raise LabError(f"{self._folder} takes no more: {why}. Make room, and give the command again.") from error

    def _claim(self) -> None:
        mark = self._folder / _FINGERPRINT
        if mark.exists():
            if mark.read_text(encoding="ascii").strip() != self._campaign.fingerprint:
                raise LabError(f"{self._folder} holds the flights of another campaign: choose another folder")
            return
        replace_file(self._folder / CAMPAIGN, self._campaign.text.encode())
        replace_file(mark, f"{self._campaign.fingerprint}\n".encode("ascii"))


def _whole_lines(path: Path) -> Iterator[Row]:
    """What was kept; a line that a power cut left half is cut off, so that the next begins a line of its own."""
    if not path.exists():
        return
    data = path.read_bytes()
    whole = data[: data.rfind(b"\n") + 1]
    if len(whole) < len(data):
        os.truncate(path, len(whole))
    for line in whole.splitlines():
        try:
            kept = orjson.loads(line)
        except orjson.JSONDecodeError:
            continue
        if isinstance(kept, dict) and isinstance(kept.get("number"), int):
            yield kept


def _told(value: object, kind: type) -> Any:
    """None for a value that its column cannot hold."""
    try:
        return _number(msgspec.convert(value, kind))
    except msgspec.ValidationError:
        return None


def _number(value: Any) -> Any:
    """None for a number that is not finite, as of a figure of nothing."""
    return None if isinstance(value, float) and not math.isfinite(value) else value
