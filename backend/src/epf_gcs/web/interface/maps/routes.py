"""Maps: the layers that can be chosen, their tiles, and files that are sent in."""

from __future__ import annotations

from collections.abc import AsyncIterator
from typing import Annotated, Any, Final

import orjson
from fastapi import APIRouter, Path, Query, Request
from fastapi.responses import FileResponse, Response
from starlette.requests import ClientDisconnect

from epf_gcs.contract.maps import MapImport, problem_parts
from epf_gcs.contract.shapes import FILE, Answers, file_body
from epf_gcs.errors import ConflictError
from epf_gcs.geoid import geoid_m
from epf_gcs.maps.datum import DATUM_OF_FORMAT
from epf_gcs.maps.layer import VECTOR_TYPE, Datum, Description, Layer, Tile
from epf_gcs.maps.open_files import Stamp
from epf_gcs.web.interface.deps import MapsDep, OperatorDep
from epf_gcs.web.interface.maps.schemas import DatumInput, MapLayer, MapLayers
from epf_gcs.web.serving.problems import problem_response, problems, reading_problems

router = APIRouter(prefix="/map", tags=["maps"])

IMPORTS_PATH: Final = "/map/imports"
# A file replaced under the same name becomes visible within this time.
_CACHE: Final = "private, max-age=600"
_PICTURES: Final = ("image/png", "image/jpeg", "image/webp", VECTOR_TYPE)
_MESH: Final = "application/vnd.quantized-mesh"
_GONE: Final[Answers] = {
    204: {"description": "There is no tile here."},
    304: {"description": "The caller has it already."},
}

LayerId = Annotated[str, Path(pattern=r"^[a-z0-9-]{1,64}$", examples=["canarias-mbtiles-0a1b2c3d"])]
ImportId = Annotated[str, Path(pattern=r"^[0-9a-f]{12}$")]
Zoom = Annotated[int, Path(ge=0, le=30)]
Place = Annotated[int, Path(ge=0, le=(1 << 31) - 1)]
ForGood = Annotated[bool, Query(description="Delete the file; it cannot be restored.")]
ImportDatum = Annotated[
    Datum | None, Query(description="What its heights count from; none: as the file says, or to be chosen later.")
]
FileName = Annotated[str, Query(min_length=1, max_length=255, description="The file's name; its end says what it is.")]


@router.get("/layers", responses=reading_problems())
async def get_map_layers(maps: MapsDep) -> MapLayers:
    """What lies in the maps' folder; what cannot be shown says why."""
    layers = await maps.layers()
    return MapLayers(folder=str(maps.folder.path.absolute()), layers=[_layer(layer) for layer in layers])


@router.get(
    "/layers/{layer_id}/tiles/{zoom}/{column}/{row}",
    response_class=Response,
    responses={200: {"content": dict.fromkeys(_PICTURES, FILE)}, **_GONE, **reading_problems(404)},
)
async def get_map_tile(
    request: Request, maps: MapsDep, layer_id: LayerId, zoom: Zoom, column: Place, row: Place
) -> Response:
    """One picture, or one tile of roads, rivers and buildings (MVT); rows count from the north."""
    tile, stamp = await maps.picture(layer_id, zoom, column, row)
    if tile is None:
        # Do not let the browser cache a missing online tile: it may be there at the next request.
        is_online = maps.online.has(layer_id)
        return Response(status_code=204, headers={"Cache-Control": "no-cache" if is_online else _CACHE})
    return _tile_answer(request, tile, stamp)


@router.get("/layers/{layer_id}/terrain/layer.json", response_class=Response, responses=reading_problems(404))
async def get_terrain_contents(maps: MapsDep, layer_id: LayerId) -> Response:
    """What Cesium's terrain provider reads first."""
    found = await maps.description(layer_id)
    if found.kind != "terrain":
        return _no_terrain(layer_id)
    datum = await maps.datum(layer_id)
    contents: dict[str, Any] = {
        "tilejson": "2.1.0",
        "format": "quantized-mesh-1.0",
        # In the tiles' addresses: a browser keeps tiles, and another datum makes others.
        "version": f"1.0.0-{datum}",
        "scheme": found.scheme,
        "projection": found.projection,
        "tiles": ["{z}/{x}/{y}.terrain?v={version}"],
        "attribution": found.attribution,
        "bounds": list(found.bounds),
        "minzoom": found.minimum_zoom,
        "maxzoom": found.maximum_zoom,
        "extensions": list(found.extensions),
    }
    if found.available is not None:
        names = ("startX", "startY", "endX", "endY")
        contents["available"] = [[dict(zip(names, place, strict=True)) for place in level] for level in found.available]
    return Response(orjson.dumps(contents), media_type="application/json", headers={"Cache-Control": "no-cache"})


@router.get(
    "/layers/{layer_id}/terrain/{zoom}/{column}/{row}.terrain",
    response_class=Response,
    responses={
        200: {"content": {_MESH: FILE}},
        304: _GONE[304],
        **reading_problems(404),
    },
)
async def get_terrain_tile(
    request: Request, maps: MapsDep, layer_id: LayerId, zoom: Zoom, column: Place, row: Place
) -> Response:
    """One piece of terrain, quantized-mesh 1.0; rows as its layer.json counts them. Heights are above the sea."""
    tile, stamp = await maps.terrain(layer_id, zoom, column, row)
    if tile is None:
        return _no_terrain(layer_id)
    return _tile_answer(request, tile, stamp)


@router.put("/layers/{layer_id}/datum", responses=problems(404, 409))
async def choose_map_layer_datum(maps: MapsDep, layer_id: LayerId, chosen: DatumInput, _: OperatorDep) -> MapLayers:
    """Say what the heights of a set of terrain count from, where the set does not say it. It holds until the file
    changes."""
    await maps.choose_datum(layer_id, chosen.datum)
    return await get_map_layers(maps)


@router.delete("/layers/{layer_id}", responses=problems(404, 409))
async def remove_map_layer(maps: MapsDep, layer_id: LayerId, _: OperatorDep, *, for_good: ForGood = False) -> MapLayers:
    """Take a layer out of the list. Its file moves into the folder `removed` and can be restored; `for_good` deletes it
    with all its layers, and nothing of it is left."""
    await (maps.delete(layer_id) if for_good else maps.remove(layer_id))
    return await get_map_layers(maps)


@router.get(
    "/layers/{layer_id}/file",
    response_class=FileResponse,
    responses={200: {"content": {"application/octet-stream": FILE}}, **reading_problems(404)},
)
async def export_map_layer(maps: MapsDep, layer_id: LayerId) -> FileResponse:
    """The file of a layer, whole, for another station's import."""
    path = await maps.file_of(layer_id)
    return FileResponse(path, media_type="application/octet-stream", filename=path.name)


@router.post("/layers/{layer_id}/restore", responses=problems(404, 409))
async def restore_map_layer(maps: MapsDep, layer_id: LayerId, _: OperatorDep) -> MapLayers:
    """Bring a removed layer back."""
    await maps.restore(layer_id)
    return await get_map_layers(maps)


@router.post(
    "/imports",
    responses=problems(409),
    openapi_extra=file_body(),
)
async def import_map(
    request: Request, maps: MapsDep, name: FileName, _: OperatorDep, datum: ImportDatum = None
) -> MapImport:
    """Take a map file into the folder, whole or not at all. The answer comes when all of it is there; heights are being
    turned into terrain then. The event `map_import` tells how far it is."""
    length = request.headers.get("content-length", "")
    total_bytes = int(length) if length.isdecimal() else None
    one = await maps.imports.receive(name, total_bytes, _chunks(request, name), datum)
    return one.told


@router.get("/imports/{import_id}", responses=reading_problems(404))
async def get_map_import(maps: MapsDep, import_id: ImportId) -> MapImport:
    """How far an import is."""
    return maps.imports.get(import_id).told


@router.delete("/imports/{import_id}", responses=problems(404, 409))
async def cancel_map_import(maps: MapsDep, import_id: ImportId, _: OperatorDep) -> MapImport:
    """Cancel an import: nothing of the file is kept. One that is over stays as it is."""
    return (await maps.imports.cancel(import_id)).told


async def _chunks(request: Request, name: str) -> AsyncIterator[bytes]:
    try:
        async for chunk in request.stream():
            yield chunk
    except ClientDisconnect as error:
        raise ConflictError(
            "map_import_incomplete", f"'{name}' did not come whole: nothing of it was kept.", name=name
        ) from error


def _layer(layer: Layer) -> MapLayer:
    found: Description = layer.description
    bounds = found.bounds
    is_terrain = found.kind == "terrain" and layer.problem is None
    middle_deg = ((bounds.south_deg + bounds.north_deg) / 2, (bounds.west_deg + bounds.east_deg) / 2)
    return MapLayer(
        *problem_parts(layer.problem),
        id=layer.id,
        name=layer.name,
        kind=found.kind,
        format=layer.format,
        **found.bounds._asdict(),
        minimum_zoom=found.minimum_zoom,
        maximum_zoom=found.maximum_zoom,
        attribution=found.attribution,
        bytes=layer.size_bytes,
        datum=layer.datum,
        datum_stated=found.datum is not None or layer.format in DATUM_OF_FORMAT,
        geoid_m=round(float(geoid_m(*middle_deg)), 1) if is_terrain else None,
    )


def _tile_answer(request: Request, tile: Tile, stamp: Stamp) -> Response:
    tag = '"' + "-".join(f"{part:x}" for part in (*stamp, len(tile.data))) + '"'
    headers = {"Cache-Control": _CACHE, "ETag": tag}
    if request.headers.get("if-none-match") == tag:
        return Response(status_code=304, headers=headers)
    if tile.encoding is not None:
        headers["Content-Encoding"] = tile.encoding
    return Response(tile.data, media_type=tile.media_type, headers=headers)


def _no_terrain(layer_id: str) -> Response:
    """Answer 404 without counting an error: the globe requests terrain wherever the camera looks, also outside it."""
    detail = f"There is no terrain of '{layer_id}' here."
    return problem_response(404, "map_tile_missing", detail, {"layer": layer_id}, {"Cache-Control": _CACHE})
