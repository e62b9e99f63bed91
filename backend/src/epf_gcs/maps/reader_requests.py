"""What the reader asks its workers, each a value, and the head of their answers."""

from __future__ import annotations

import msgspec

from epf_gcs.maps.layer import Datum, Description, LayerFormat
from epf_gcs.maps.open_files import Stamp
from epf_gcs.workers.pipe import ReplyHead


class InsideRequest(msgspec.Struct, frozen=True, tag_field="do", tag="inside"):
    """Which raster is in this archive?"""

    path: str
    name: str


class ForgetRequest(msgspec.Struct, frozen=True, tag_field="do", tag="forget"):
    """Close this file."""

    path: str
    name: str = ""


class LayerRequest(msgspec.Struct, frozen=True, tag_field="do"):
    """The base of those that read a layer's file."""

    path: str
    name: str
    format: LayerFormat
    stamp: Stamp


class DescribeRequest(LayerRequest, frozen=True, tag="describe"):
    """What is in it?"""


class TileRequest(LayerRequest, frozen=True, tag="tile"):
    """One tile; `place`: zoom, column and row, as `layer.TileSource` has them. `datum`: of the set's heights; the
    tile's are above the sea."""

    place: tuple[int, int, int]
    datum: Datum | None = None


class GridRequest(LayerRequest, frozen=True, tag="grid"):
    """The heights of one tile of terrain, above the sea."""

    place: tuple[int, int, int]
    datum: Datum | None = None


Request = InsideRequest | ForgetRequest | DescribeRequest | TileRequest | GridRequest


class MapReply(ReplyHead):
    """The head of an answer; the bytes after it are a tile's or a grid's, none where there is none."""

    description: Description | None = None
    inside: str | None = None
    media_type: str = ""
    encoding: str | None = None
