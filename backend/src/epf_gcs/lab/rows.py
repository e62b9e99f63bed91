"""A campaign's results, one row for each flight: kept line by line as they come, and as Parquet once all are there."""

from __future__ import annotations

import os
from collections.abc import Iterator
from dataclasses import asdict
from io import FileIO
from pathlib import Path
from typing import Any, Final, Self

import orjson

from epf_gcs.disk import sync_folder
from epf_gcs.lab.campaign import Campaign, Order
from epf_gcs.lab.errors import LabError
from epf_gcs.lab.flight import Flight

PARQUET: Final = "flights.parquet"
CAMPAIGN: Final = "campaign.toml"
_JOURNAL: Final = "flights.jsonl"
_FINGERPRINT: Final = "campaign.sha256"

Row = dict[str, Any]


def row(order: Order, flight: Flight | None, error: str | None = None) -> Row:
    """Conditions, gains and figures of one flight, by the names of Parquet's columns. `error`: why it was not flown."""
    figures = None if flight is None else flight.figures
    upset = None if flight is None else flight.upset
    return {
        "number": order.number,
        **asdict(order.conditions),
        **{f"gains.{name}": value for name, value in order.gains.items()},
        "faults": " ".join(map(str, order.faults)),
        "is_safe": flight is not None and flight.is_safe,
        "waypoints": None if flight is None else len(flight.route.waypoints),
        "waypoints_reached": None if figures is None else figures.waypoints_reached,
        "captured_honestly": None if figures is None else figures.captured_honestly,
        "time_s": None if figures is None else _number(figures.time_s),
        "cross_track_rms_m": None if figures is None else _number(figures.cross_track.rms_m),
        "leg_rms_m": None if figures is None else _number(figures.leg.rms_m),
        "leg_largest_m": None if figures is None else _number(figures.leg.largest_m),
        "near_rms_m": None if figures is None else _number(figures.near.rms_m),
        "altitude_rms_ft": None if figures is None else _number(figures.altitude.settled.rms_ft),
        "altitude_largest_ft": None if figures is None else _number(figures.altitude.settled.largest_ft),
        "speed_rms_kt": None if figures is None else _number(figures.airspeed.settled.rms_kt),
        "lost_at_s": None if upset is None else upset.time_s,
        "lost_by": None if upset is None else upset.cause,
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
        try:
            self._journal.write(orjson.dumps(flown) + b"\n")
        except OSError as error:
            raise LabError(f"{self._folder} takes no more: {error.strerror}. Go on with the same command.") from error
        self.rows[flown["number"]] = flown

    def finish(self) -> Path:
        """All flights in order as Parquet; returns its path. The same rows give the same bytes."""
        import pyarrow as pa  # noqa: PLC0415 - takes a second, and a campaign that is cut short needs none of it
        import pyarrow.parquet as pq  # noqa: PLC0415

        os.fsync(self._journal.fileno())
        ordered = [self.rows[number] for number in sorted(self.rows)]
        path, unfinished = self._folder / PARQUET, self._folder / f"{PARQUET}.part"
        pq.write_table(pa.Table.from_pylist(ordered), unfinished, compression="zstd")
        unfinished.replace(path)
        sync_folder(self._folder)
        return path

    def _claim(self) -> None:
        mark = self._folder / _FINGERPRINT
        if mark.exists():
            if mark.read_text(encoding="ascii").strip() != self._campaign.fingerprint:
                raise LabError(f"{self._folder} holds the flights of another campaign: choose another folder")
            return
        (self._folder / CAMPAIGN).write_text(self._campaign.text, encoding="utf-8")
        mark.write_text(self._campaign.fingerprint + "\n", encoding="ascii")


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


def _number(value: float) -> float | None:
    """None for a figure of nothing."""
    return value if value == value else None
