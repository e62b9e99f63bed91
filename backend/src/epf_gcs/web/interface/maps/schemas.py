"""The shapes of maps: layers, imports, online sources."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

from pydantic import Field

from epf_gcs.contract.maps import MapProblem
from epf_gcs.contract.shapes import Input, Output
from epf_gcs.maps.layer import Datum, LayerFormat, LayerKind
from epf_gcs.maps.sources import MAX_LIMIT_BYTES


@dataclass(frozen=True, slots=True)
class MapLayer(MapProblem):
    """A layer that can be chosen, or says why it cannot.

    Of terrain alone: `datum`, what its heights count from, the sea (orthometric) or the ellipsoid; None: not known, and
    taken for the sea until somebody chooses. `datum_stated`: the set says it itself. `geoid_m`: how high the sea is
    above the ellipsoid in its middle.
    """

    id: str
    name: str
    kind: LayerKind
    format: LayerFormat
    west_deg: float
    south_deg: float
    east_deg: float
    north_deg: float
    minimum_zoom: int
    maximum_zoom: int
    attribution: str
    bytes: int
    datum: Datum | None
    datum_stated: bool
    geoid_m: float | None


class DatumInput(Input):
    """What a set's heights count from: the sea (orthometric), or the ellipsoid WGS 84."""

    datum: Datum


class MapLayers(Output):
    """All layers; `folder` is where their files live."""

    folder: str
    layers: list[MapLayer]


class OnlineSourceInput(Input):
    """A source of pictures. `url` has {z}, {x} and {y}, each once; its owner's terms are the operator's to keep."""

    id: Annotated[str, Field(pattern=r"^[a-z0-9-]{1,32}$")]
    name: Annotated[str, Field(min_length=1, max_length=80)]
    url: Annotated[str, Field(min_length=10, max_length=500, examples=["https://example.org/{z}/{x}/{y}.png"])]
    attribution: Annotated[str, Field(max_length=200)]
    maximum_zoom: Annotated[int, Field(ge=0, le=24)] = 19


class OnlineInput(Input):
    """What the operator chooses."""

    enabled: bool
    limit_bytes: Annotated[int, Field(ge=0, le=MAX_LIMIT_BYTES)]
    sources: Annotated[list[OnlineSourceInput], Field(max_length=20)]


@dataclass(frozen=True, slots=True)
class OnlineSource(MapProblem):
    """A source, and whether it gives anything now. Its layer has the id `online-` and this one."""

    id: str
    name: str
    url: str
    attribution: str
    maximum_zoom: int


class OnlineState(Output):
    """Online sources: off by default, and nothing is asked for then."""

    enabled: bool
    limit_bytes: int
    cached_bytes: int
    sources: list[OnlineSource]
