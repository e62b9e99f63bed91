"""The shapes of fields that are being prepared."""

from __future__ import annotations

from typing import Annotated

from pydantic import Field

from epf_gcs.contract.maps import FieldKind, PreparedField
from epf_gcs.contract.shapes import Input, Output
from epf_gcs.fields.order import HIGHEST_ZOOM

Level = Annotated[int, Field(ge=0, le=HIGHEST_ZOOM)]


class FieldPoint(Input):
    """A place."""

    latitude_deg: Annotated[float, Field(ge=-85, le=85)]
    longitude_deg: Annotated[float, Field(ge=-180, le=180)]


class FieldPart(Input):
    """One kind and where it comes from. `url` has {z}, {x} and {y} (heights: PNG of the form Terrarium, of the level
    `maximum_zoom`), or for heights {latitude} and {longitude}, which become N28 and W016 (GeoTIFF of a degree). Vector
    tiles are MVT."""

    kind: FieldKind
    name: Annotated[str, Field(min_length=1, max_length=80)]
    url: Annotated[str, Field(min_length=10, max_length=500)]
    attribution: Annotated[str, Field(max_length=300)]
    minimum_zoom: Level
    maximum_zoom: Level


class FieldInput(Input):
    """What is to be brought: all within `radius_m` of the line through the points; one point is a circle."""

    name: Annotated[str, Field(min_length=1, max_length=60)]
    points: Annotated[list[FieldPoint], Field(min_length=1, max_length=500)]
    radius_m: Annotated[float, Field(ge=100, le=200_000)]
    parts: Annotated[list[FieldPart], Field(min_length=1, max_length=3)]


class FieldOrderInput(FieldInput):
    """An order. `accepts_terms`: somebody has read the terms of the sources and keeps to them."""

    accepts_terms: bool


class FieldLevel(Output):
    """Tiles of one level of one kind; `zoom` is -1 for files of a square degree."""

    kind: FieldKind
    zoom: int
    tiles: int
    bytes: int


class FieldEstimate(Output):
    """What it will take. `made_bytes`: terrain and relief, which are made of the heights here."""

    levels: list[FieldLevel]
    tiles: int
    bytes: int
    made_bytes: int
    free_bytes: int


class FieldSource(Output):
    """A public source that may be chosen, and what its owner asks."""

    id: str
    kind: FieldKind
    name: str
    url: str
    attribution: str
    terms: str
    terms_url: str
    maximum_zoom: int
    usual_zoom: int


class FieldList(Output):
    """Fields under way, the oldest first, and sources to choose from."""

    fields: list[PreparedField]
    sources: list[FieldSource]
