"""Why a map file cannot be shown, in one sentence each; `name` is the file's."""

from __future__ import annotations

from epf_gcs.errors import InvalidInputError


def damaged(name: str, why: str) -> InvalidInputError:
    """The file is not what its name says, or incomplete."""
    return InvalidInputError(
        "map_file_damaged", f"'{name}' cannot be read ({why}): it is damaged or of another kind.", name=name, why=why
    )


def vector(name: str, found: str) -> InvalidInputError:
    """The file holds vector tiles, not pictures."""
    return InvalidInputError(
        "map_file_vector",
        f"'{name}' holds tiles of the kind '{found}', which are no pictures: export it with PNG, JPEG or WebP tiles.",
        name=name,
        found=found,
    )


def empty(name: str) -> InvalidInputError:
    """The file holds no tiles."""
    return InvalidInputError("map_file_empty", f"'{name}' holds no tiles: export it again.", name=name)


def no_layer_json(name: str) -> InvalidInputError:
    """Terrain without a layer.json."""
    return InvalidInputError(
        "map_file_no_layer_json",
        f"'{name}' has no layer.json that can be read: terrain comes with one beside its folders of levels.",
        name=name,
    )


def not_mesh(name: str, found: str) -> InvalidInputError:
    """Terrain in a format other than quantized-mesh."""
    return InvalidInputError(
        "map_file_not_mesh",
        f"'{name}' holds terrain of the format '{found}': only quantized-mesh-1.0 can be shown.",
        name=name,
        found=found,
    )


def no_place(name: str) -> InvalidInputError:
    """A raster without georeferencing."""
    return InvalidInputError(
        "map_raster_no_place",
        f"'{name}' does not say where on the Earth it is: a GeoTIFF needs a coordinate system and a place, an HGT file "
        "a name such as N28W016.hgt.",
        name=name,
    )


def not_height(name: str, bands: int) -> InvalidInputError:
    """A picture, not a raster of heights."""
    return InvalidInputError(
        "map_raster_not_height",
        f"'{name}' has {bands} bands and is a picture: heights are one band. Export pictures as MBTiles or PMTiles.",
        name=name,
        bands=bands,
    )


def converting(name: str, percent: int) -> InvalidInputError:
    """The raster is still being converted."""
    return InvalidInputError(
        "map_raster_converting",
        f"'{name}' is being turned into terrain ({percent} %): wait a little.",
        name=name,
        percent=percent,
    )


def not_converted(name: str, why: str) -> InvalidInputError:
    """The conversion failed."""
    return InvalidInputError(
        "map_raster_failed", f"'{name}' could not be turned into terrain ({why}).", name=name, why=why
    )
