"""Map layers and the sources of their tiles. Everything here may block: it is called from the maps' own threads."""

from __future__ import annotations

import html
import re
from dataclasses import dataclass
from typing import Final, Literal, NamedTuple, Protocol

from epf_gcs.errors import GatewayError

Datum = Literal["orthometric", "ellipsoidal"]
"""What heights count from: the sea (the geoid), or the ellipsoid WGS 84."""
LayerKind = Literal["imagery", "terrain", "vector"]
LayerFormat = Literal[
    "mbtiles",
    "pmtiles",
    "quantized_mesh",
    "geotiff",
    "hgt",
    "online",
    "field",
    "field_relief",
    "field_vector",
    "field_terrain",
]

MAX_TILE_BYTES: Final = 8_000_000
"""Larger ones are rejected: no real tile comes near."""

_MOST_CREDIT: Final = 300
_MARKUP: Final = re.compile(r"<[^<>]*>")
_GZIP: Final = b"\x1f\x8b"
_MESH_TYPE: Final = "application/vnd.quantized-mesh"
VECTOR_TYPE: Final = "application/vnd.mapbox-vector-tile"


class Bounds(NamedTuple):
    """What a layer covers."""

    west_deg: float = -180.0
    south_deg: float = -90.0
    east_deg: float = 180.0
    north_deg: float = 90.0


TilePlace = tuple[int, int, int]
"""Zoom, column and row, rows as `TileSource.tile` has them."""


class Tile(NamedTuple):
    """One tile as it is sent to the page. `encoding`: its compression (Content-Encoding), None if uncompressed."""

    data: bytes
    media_type: str
    encoding: str | None = None


class Range(NamedTuple):
    """A rectangle of tiles of one zoom level, both ends inclusive, rows counted from the south."""

    start_x: int
    start_y: int
    end_x: int
    end_y: int


@dataclass(frozen=True, slots=True)
class Description:
    """A layer's metadata. `available`: for terrain, the existing tiles of each level; `datum`: as its set states it."""

    title: str
    kind: LayerKind
    bounds: Bounds
    minimum_zoom: int
    maximum_zoom: int
    attribution: str
    scheme: Literal["tms", "slippyMap"] = "tms"
    projection: Literal["EPSG:4326", "EPSG:3857"] = "EPSG:4326"
    available: tuple[tuple[Range, ...], ...] | None = None
    extensions: tuple[str, ...] = ()
    datum: Datum | None = None


class TileSource(Protocol):
    """An opened file."""

    @property
    def description(self) -> Description:
        """The file's metadata."""

    def tile(self, zoom: int, column: int, row: int) -> Tile | None:
        """One tile; None if there is none. Rows from the north for imagery, in the file's own scheme for terrain.

        Raises GatewayError if the file cannot be read.
        """

    def close(self) -> None:
        """Close the file."""


@dataclass(frozen=True, slots=True)
class Layer:
    """One entry of the list. `problem`: why it cannot be shown, or that it is still being converted.

    `datum`: of terrain, as the set states it or as a person chose; None: not known.
    """

    id: str
    name: str
    format: LayerFormat
    description: Description
    size_bytes: int
    problem: GatewayError | None = None
    datum: Datum | None = None


UNKNOWN: Final = Description("", "imagery", Bounds(), 0, 0, "")
"""The description of a file that cannot be read."""


def checked_bounds(west_deg: float, south_deg: float, east_deg: float, north_deg: float) -> Bounds | None:
    """The bounds that a file states; None if they are not a valid rectangle on the Earth."""
    fits = -180 <= west_deg < east_deg <= 180 and -90 <= south_deg < north_deg <= 90
    return Bounds(west_deg, south_deg, east_deg, north_deg) if fits else None


def credit(said: object) -> str:
    """The attribution as plain text: files give it with HTML markup."""
    words = html.unescape(_MARKUP.sub("", str(said)))
    return " ".join(words.split())[:_MOST_CREDIT]


def picture(data: bytes) -> Tile | None:
    """A picture tile, its type taken from the first bytes; None if it is no picture."""
    media_type = _picture_type(data)
    return None if media_type is None or len(data) > MAX_TILE_BYTES else Tile(data, media_type)


def mesh(data: bytes) -> Tile | None:
    """A tile of terrain, with or without gzip."""
    if not data or len(data) > MAX_TILE_BYTES:
        return None
    return Tile(data, _MESH_TYPE, "gzip" if data.startswith(_GZIP) else None)


def vector(data: bytes) -> Tile | None:
    """A tile of roads, rivers and buildings, with or without gzip. The page's worker alone looks into it."""
    if not data or len(data) > MAX_TILE_BYTES:
        return None
    return Tile(data, VECTOR_TYPE, "gzip" if data.startswith(_GZIP) else None)


def _picture_type(data: bytes) -> str | None:
    if data.startswith(b"\x89PNG\r\n\x1a\n"):
        return "image/png"
    if data.startswith(b"\xff\xd8\xff"):
        return "image/jpeg"
    if data.startswith(b"RIFF") and data[8:12] == b"WEBP":
        return "image/webp"
    return None
