"""What is to be brought: an area, and a source for each kind; and how much that will be, roughly."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Final, Literal, NamedTuple
from urllib.parse import urlsplit

import msgspec

from epf_gcs.errors import InvalidInputError
from epf_gcs.extras import MAPS
from epf_gcs.fields.area import MOST_TILES, Area, too_large
from epf_gcs.maps.outside import Consent, is_local_as_written
from epf_gcs.maps.sources import Source, local
from epf_gcs.workers.missing import missing

Kind = Literal["heights", "imagery", "vector"]
KINDS: Final[tuple[Kind, ...]] = ("heights", "imagery", "vector")

HIGHEST_ZOOM: Final = 19
MOST_DEGREE_BYTES: Final = 120_000_000
"""A file of one square degree of heights; a tile's limit is `layer.MAX_TILE_BYTES`."""

_TILE: Final = re.compile(r"\{[zxys]\}")
_TILE_PLACES: Final = ("{z}", "{x}", "{y}")
_DEGREE_PLACES: Final = ("{latitude}", "{longitude}")
# Means of public sources; corrected by what arrives.
_MEAN_BYTES: Final[dict[Kind, int]] = {"heights": 60_000, "imagery": 18_000, "vector": 35_000}
_MEAN_DEGREE_BYTES: Final = 38_000_000
# What is made of one tile of heights: terrain for the globe and a shaded relief.
_MADE_BYTES: Final = 150_000
# Their rules forbid to fetch more than what somebody looks at.
_FORBIDS: Final = ("openstreetmap.org", "openstreetmap.fr", "opentopomap.org")


class Place(NamedTuple):
    """One piece of a part: a tile (rows from the north); or a square degree with zoom -1, its longitude and latitude of
    the south-western corner."""

    zoom: int
    column: int
    row: int


@dataclass(frozen=True, slots=True)
class Part:
    """One kind and its source. `url`: has {z}, {x} and {y}; heights may have {latitude} and {longitude} instead, which
    become N28 and W016. Vector tiles are of the form MVT (.mvt, .pbf). Heights of tiles are PNG of the form Terrarium,
    of one level: `maximum_zoom`."""

    kind: Kind
    name: str
    url: str
    attribution: str
    minimum_zoom: int
    maximum_zoom: int

    @property
    def is_of_degrees(self) -> bool:
        """Whether its pieces are files of a square degree (GeoTIFF)."""
        return "{latitude}" in self.url

    def address(self, place: Place) -> str:
        """The URL of one piece."""
        if self.is_of_degrees:
            latitude = f"{'N' if place.row >= 0 else 'S'}{abs(place.row):02d}"
            longitude = f"{'E' if place.column >= 0 else 'W'}{abs(place.column):03d}"
            return self.url.replace("{latitude}", latitude).replace("{longitude}", longitude)
        values = {"{z}": place.zoom, "{x}": place.column, "{y}": place.row, "{s}": "a"}
        return _TILE.sub(lambda match: str(values[match[0]]), self.url)

    def places(self, area: Area) -> Iterator[Place]:
        """Its pieces in this area, coarse levels first. Raises InvalidInputError if they are too many."""
        if self.is_of_degrees:
            yield from (Place(-1, int(column), int(row)) for column, row in area.degrees())
            return
        lowest = self.maximum_zoom if self.kind == "heights" else self.minimum_zoom
        for zoom in range(lowest, self.maximum_zoom + 1):
            yield from (Place(zoom, int(column), int(row)) for column, row in area.tiles(zoom))


@dataclass(frozen=True, slots=True)
class Order:
    """`name`: of the field, and of its file."""

    name: str
    area: Area
    parts: tuple[Part, ...]

    def as_json(self) -> bytes:
        """For its file."""
        return msgspec.json.encode(self)

    @staticmethod
    def from_json(text: bytes) -> Order:
        """The inverse. Raises ValueError."""
        return msgspec.json.decode(text, type=Order)


class Level(NamedTuple):
    """Pieces of one level of one kind; zoom -1: square degrees."""

    kind: Kind
    zoom: int
    tiles: int
    bytes: int


def estimate(order: Order) -> list[Level]:
    """What it will take, before anything is asked for. Raises InvalidInputError if it is too much."""
    levels: list[Level] = []
    for part in order.parts:
        counts: dict[int, int] = {}
        for place in part.places(order.area):
            counts[place.zoom] = counts.get(place.zoom, 0) + 1
            if sum(counts.values()) > MOST_TILES:
                raise too_large()
        levels += [Level(part.kind, zoom, count, count * mean_bytes(part)) for zoom, count in counts.items()]
    return levels


def mean_bytes(part: Part) -> int:
    """A usual size of one piece, before any is known."""
    return _MEAN_DEGREE_BYTES if part.is_of_degrees else _MEAN_BYTES[part.kind]


def made_bytes(order: Order) -> int:
    """What will be made of the heights, roughly: as large as that of tiles of level 12, whatever they come as."""
    heights = next((part for part in order.parts if part.kind == "heights"), None)
    if heights is None:
        return 0
    return len(order.area.tiles(12 if heights.is_of_degrees else heights.maximum_zoom)) * _MADE_BYTES


def check(order: Order, consent: Consent) -> None:
    """Raise InvalidInputError, or ConflictError if what makes terrain is not installed, unless this can be brought."""
    kinds = [part.kind for part in order.parts]
    if not kinds or len(set(kinds)) != len(kinds):
        raise InvalidInputError("field_no_parts", "Choose heights, pictures or roads, each from one source.")
    for part in order.parts:
        _check_part(part, consent)
    if "heights" in kinds and not MAPS.is_here:
        raise missing(MAPS)


def _check_part(part: Part, consent: Consent) -> None:
    scheme, host, port = _server(part.url)
    is_address = scheme in ("http", "https") and bool(host) and "{" not in host
    placed = [_TILE_PLACES] if part.kind != "heights" else [_TILE_PLACES, _DEGREE_PLACES]
    if not is_address or not any(all(part.url.count(one) == 1 for one in names) for names in placed):
        raise InvalidInputError(
            "map_source_invalid",
            f"The address of '{part.name}' is none of a map: it begins with https:// or http:// and has "
            "{z}, {x} and {y} in it, each once.",
            name=part.name,
        )
    if any(host == one or host.endswith(f".{one}") for one in _FORBIDS):
        raise InvalidInputError(
            "field_source_forbids",
            f"The rules of '{part.name}' ({host}) forbid fetching more than what is looked at: choose another source.",
            name=part.name,
            host=host,
        )
    if not consent.covers(scheme, host, port) and is_local_as_written(host):
        raise local(Source("field", part.name, part.url, part.attribution))
    if not 0 <= part.minimum_zoom <= part.maximum_zoom <= HIGHEST_ZOOM:
        raise InvalidInputError(
            "invalid_request", f"The levels of '{part.name}' go from 0 to {HIGHEST_ZOOM}.", field="parts"
        )


def _server(url: str) -> tuple[str, str, int | None]:
    """Scheme, host and port; empty if the URL is none."""
    try:
        parts = urlsplit(url)
        return parts.scheme, (parts.hostname or "").lower(), parts.port or None
    except ValueError:
        return "", "", None
