"""Keeps flights to look at: a recording in a data folder of a station, a page beside it; of a campaign, the worst."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Final

import msgspec

from epf_gcs.disk import replace_file
from epf_gcs.lab.campaign import Campaign
from epf_gcs.lab.errors import LabError
from epf_gcs.lab.flight import Flight, Moment
from epf_gcs.lab.flying import fly_wanted
from epf_gcs.lab.page import write_page
from epf_gcs.lab.recording import Recorded, record

_STATION: Final = "station"
_LIST: Final = "recorded.json"


@dataclass(frozen=True, slots=True)
class Kept:
    """A flight that can be looked at."""

    recorded: Recorded

    @property
    def page(self) -> Path:
        """Its page."""
        return self.recorded.data_dir / "pages" / f"{self.recorded.id}.html"

    def lines(self) -> Iterator[str]:
        """Where it is, for a person."""
        yield f"  station  {self.recorded}"
        yield f"  page     {self.page.resolve().as_uri()}"


def keep(flight: Flight, data_dir: Path, title: str = "") -> Kept:
    """Record a flight, and write its page. Raises LabError."""
    kept = Kept(record(flight, data_dir, title))
    write_page(flight, kept.page, kept.recorded.link)
    return kept


def keep_worst(campaign: Campaign, folder: Path, count: int, library: Path | None = None) -> None:
    """Keep the worst flights of a finished campaign, each of them once. Raises LabError."""
    from epf_gcs.lab.summary import read_rows, summary  # noqa: PLC0415 - loads pyarrow

    kept = kept_worst(folder)
    for row in summary(read_rows(folder)).worst[:count]:
        number = row["number"]
        if number not in kept:
            order = campaign.order(number)
            flight = fly_wanted(campaign.route, order.conditions, order.gains, library, order.faults)
            kept[number] = keep(flight, folder / _STATION, f"{campaign.route.name} {number}")
            _write(folder, kept)


def kept_worst(folder: Path) -> dict[int, Kept]:
    """The kept flights of a campaign, by number."""
    try:
        found = msgspec.json.decode((folder / _LIST).read_bytes(), type=dict[int, tuple[str, Moment]])
    except (OSError, msgspec.DecodeError):
        return {}
    return {number: Kept(Recorded(folder / _STATION, *one)) for number, one in found.items()}


def _write(folder: Path, kept: dict[int, Kept]) -> None:
    listed: dict[int, Any] = {number: (one.recorded.id, one.recorded.moment) for number, one in kept.items()}
    try:
        replace_file(folder / _LIST, msgspec.json.encode(listed))
    except OSError as error:
        raise LabError(f"{folder} takes no more: {error.strerror or error}") from error
