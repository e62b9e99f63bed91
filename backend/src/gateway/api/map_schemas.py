"""The shapes of maps: layers, imports."""

from __future__ import annotations

from typing import Literal

from gateway.api.schemas import Output, ParamValue
from gateway.errors import ErrorCode


class MapProblem(Output):
    """`problem`: one English sentence, None where all is well; code and values are for a sentence in other words."""

    problem: str | None
    problem_code: ErrorCode | None
    problem_params: dict[str, ParamValue]


class MapLayer(MapProblem):
    """A layer that can be chosen, or says why it cannot."""

    id: str
    name: str
    kind: Literal["imagery", "terrain"]
    format: Literal["mbtiles", "pmtiles", "quantized_mesh", "geotiff", "hgt", "online"]
    west_deg: float
    south_deg: float
    east_deg: float
    north_deg: float
    minimum_zoom: int
    maximum_zoom: int
    attribution: str
    bytes: int


class MapLayers(Output):
    """All layers; `folder` is where their files live."""

    folder: str
    layers: list[MapLayer]


class MapImport(MapProblem):
    """A file on its way into the folder. `percent` of the receiving, then of the converting; `layer`: its id in the
    list once it is there."""

    id: str
    name: str
    state: Literal["receiving", "converting", "done", "failed"]
    bytes: int
    total_bytes: int | None
    percent: int | None
    layer: str | None
