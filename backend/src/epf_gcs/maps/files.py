"""Names in the maps' folder: what a file is by its name, its id in the interface, and which names are taken."""

from __future__ import annotations

import hashlib
import re
from collections.abc import Callable
from pathlib import Path
from typing import Final, NamedTuple

from epf_gcs.errors import InvalidInputError
from epf_gcs.formats.xml_tree import plain
from epf_gcs.maps.layer import LayerFormat
from epf_gcs.maps.mesh_files import LAYER_JSON
from epf_gcs.maps.open_files import Stamp

RASTERS: Final = frozenset[LayerFormat]({"geotiff", "hgt"})
"""Formats of heights, which must be converted to terrain tiles to be shown."""

_FORMATS: Final[dict[str, LayerFormat]] = {
    ".mbtiles": "mbtiles",
    ".pmtiles": "pmtiles",
    ".tif": "geotiff",
    ".tiff": "geotiff",
    ".hgt": "hgt",
    ".zip": "quantized_mesh",
    ".field": "field",
}
FIELD_SETS: Final[tuple[LayerFormat, ...]] = ("field", "field_relief", "field_vector", "field_terrain")
"""What the file of a field may hold: pictures, the relief, roads and the terrain. Each is a layer of its own."""

_LONGEST_NAME_BYTES: Final = 120
_NOT_IN_NAMES: Final = re.compile(r'[/\\:*?"<>|]')
_NOT_IN_IDS: Final = re.compile(r"[^a-z0-9]+")


class MapFile(NamedTuple):
    """A file, or a folder of terrain. `inside`: the raster in an archive."""

    id: str
    path: Path
    format: LayerFormat
    size_bytes: int
    stamp: Stamp
    inside: str | None = None


def safe_name(name: str) -> str:
    """The name, if it is valid on every system and holds no path. Raises InvalidInputError with what is accepted."""
    cleaned = _NOT_IN_NAMES.sub("_", plain(name)).strip(" .")
    if not cleaned or len(cleaned.encode()) > _LONGEST_NAME_BYTES:
        raise InvalidInputError(
            "map_name_invalid",
            f"The file's name is empty or longer than {_LONGEST_NAME_BYTES} bytes: give it another.",
            limit=_LONGEST_NAME_BYTES,
        )
    if Path(cleaned).suffix.lower() not in _FORMATS:
        raise InvalidInputError(
            "map_kind_unknown",
            f"'{cleaned}' is no map file: MBTiles, PMTiles, GeoTIFF (.tif), .hgt, terrain in a .zip and prepared "
            "fields (.field) are taken.",
            name=cleaned,
        )
    return cleaned


def id_of(name: str) -> str:
    """The id of the file with this name: readable, and different for each name."""
    words = _NOT_IN_IDS.sub("-", name.lower()).strip("-")[:40].strip("-")
    return f"{words or 'map'}-{hashlib.blake2s(name.encode(), digest_size=4).hexdigest()}"


def sets_of(file: MapFile) -> list[MapFile]:
    """The layers that a file may have: one, except for a field's."""
    if file.format != "field":
        return [file]
    return [
        file._replace(id=file.id + form.removeprefix("field").replace("_", "-"), format=form) for form in FIELD_SETS
    ]


InsideOf = Callable[[Path, Stamp], str | None]
"""The name of the one raster in an archive; None if the archive does not hold exactly one."""


def look_at(path: Path, inside_of: InsideOf) -> MapFile | None:
    """The kind of map at this path; None if it is not a map. `inside_of` reads archives. Raises OSError."""
    if path.name.startswith("."):
        return None
    if path.is_dir():
        return _look_at_folder(path)
    form = _FORMATS.get(path.suffix.lower())
    if form is None:
        return None
    about = path.stat()
    stamp = (about.st_size, about.st_mtime_ns)
    inside = None
    if form == "quantized_mesh":
        inside = inside_of(path, stamp)
        if inside is not None:
            form = "hgt" if inside.lower().endswith(".hgt") else "geotiff"
    return MapFile(id_of(path.name), path, form, about.st_size, stamp, inside)


def _look_at_folder(path: Path) -> MapFile | None:
    try:
        about = (path / LAYER_JSON).stat()
    except FileNotFoundError:
        return None
    return MapFile(id_of(path.name), path, "quantized_mesh", 0, (about.st_size, about.st_mtime_ns))


def folder_bytes(path: Path) -> int:
    """Total size of the files of a folder of terrain, in bytes. Raises OSError."""
    return sum(file.stat().st_size for file in path.rglob("*") if file.is_file())


def free_name(folder: Path, name: str) -> Path:
    """A path in this folder that is not taken: the name, or the name with a number."""
    path, number = folder / name, 2
    while path.exists():
        path = folder / f"{Path(name).stem}-{number}{Path(name).suffix}"
        number += 1
    return path
