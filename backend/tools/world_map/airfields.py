"""Airfields with runways and frequencies, and navigation aids, of OurAirports."""

from __future__ import annotations

import csv
import gzip
from collections import defaultdict
from collections.abc import Iterable
from pathlib import Path
from typing import Any, Final

from tools.world_map.cells import Cells

Row = dict[str, str]

PER_DEGREE: Final = 1e5
"""Ends of runways are whole hundred-thousandths of a degree, a metre, from the airfield's place."""

SIZES: Final = {
    "large_airport": 4,
    "medium_airport": 3,
    "small_airport": 2,
    "seaplane_base": 1,
    "balloonport": 0,
    "heliport": 0,
}
"""Weight of a kind among airfields; what is closed is left out."""
_KINDS: Final = {"seaplane_base": "S", "balloonport": "B", "heliport": "H"}

# The source writes surfaces in hundreds of ways: by the first word that is found.
_SURFACES: Final = (
    ("concrete", ("CON", "PEM", "BRI")),
    ("asphalt", ("ASP", "BIT", "MAC", "TAR", "SEAL", "PAVED", "COP")),
    ("grass", ("GRS", "GRA", "TURF", "SOD")),
    ("gravel", ("GVL", "GRVL", "GRE", "PIS", "COR", "LATER", "ROCK", "STONE")),
    ("water", ("WAT",)),
    ("snow", ("SNO", "ICE")),
    ("earth", ("EARTH", "DIRT", "SAND", "CLAY", "SOIL", "GROUND", "LOAM", "UNK-EARTH", "TER")),
)


def read_table(folder: Path, name: str) -> list[Row]:
    """The rows of one of the package's tables."""
    with gzip.open(folder / f"{name}.csv.gz", "rt", encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


def fill(cells: Cells, folder: Path, *, least: int, is_whole: bool) -> None:
    """Airfields of this weight and above: code, name, elevation in feet, kind, weight.

    Where `is_whole` also runways and frequencies.
    """
    runways, frequencies = _by_airport(read_table(folder, "runways")), _by_airport(read_table(folder, "frequencies"))
    for row in read_table(folder, "airports"):
        size = SIZES.get(row["type"], -1)
        if size < least:
            continue
        longitude_deg, latitude_deg = float(row["longitude_deg"]), float(row["latitude_deg"])
        thing: list[Any] = [
            row["gps_code"] or row["ident"],
            row["name"],
            _number(row["elevation_ft"]),
            _KINDS.get(row["type"], ""),
            size,
        ]
        if is_whole:
            open_ones = [runway for runway in runways[row["id"]] if runway["closed"] != "1"]
            thing += [
                [_runway(runway, longitude_deg, latitude_deg) for runway in open_ones],
                [_frequency(frequency) for frequency in frequencies[row["id"]] if frequency["frequency_mhz"]],
            ]
        cells.add_thing("airfields", longitude_deg, latitude_deg, thing)


def fill_navaids(cells: Cells, folder: Path) -> None:
    """Navigation aids: code, name, type, frequency in kHz, elevation in feet, channel of the DME."""
    for row in read_table(folder, "navaids"):
        longitude_deg, latitude_deg = float(row["longitude_deg"]), float(row["latitude_deg"])
        thing: list[Any] = [
            row["ident"],
            row["name"],
            row["type"],
            _number(row["frequency_khz"]),
            _number(row["elevation_ft"]),
            row["dme_channel"] or 0,
        ]
        cells.add_thing("navaids", longitude_deg, latitude_deg, thing)


def surface_of(text: str) -> str:
    """The kind of surface; empty where the source says nothing that is understood."""
    upper = text.upper()
    return next((name for name, words in _SURFACES if any(word in upper for word in words)), "")


def _runway(row: Row, longitude_deg: float, latitude_deg: float) -> list[Any]:
    """Numbers of both ends, length and width in feet, surface, lit, and how far east and north of the airfield both
    ends are: four numbers, or none.
    """
    ends = [row[key] for key in ("le_longitude_deg", "le_latitude_deg", "he_longitude_deg", "he_latitude_deg")]
    origin = (longitude_deg, latitude_deg) * 2
    places = [round((float(end) - at) * PER_DEGREE) for end, at in zip(ends, origin, strict=True)] if all(ends) else []
    size = [_number(row["length_ft"]), _number(row["width_ft"])]
    return [row["le_ident"], row["he_ident"], *size, surface_of(row["surface"]), int(row["lighted"] == "1"), places]


def _frequency(row: Row) -> list[Any]:
    """Type, description where it says more, MHz."""
    said = row["description"] if row["description"] != row["type"] else ""
    return [row["type"], said, float(row["frequency_mhz"])]


def _by_airport(rows: Iterable[Row]) -> defaultdict[str, list[Row]]:
    found: defaultdict[str, list[Row]] = defaultdict(list)
    for row in rows:
        found[row["airport_ref"]].append(row)
    return found


def _number(text: str) -> int | None:
    return round(float(text)) if text else None
