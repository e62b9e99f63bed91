"""Opens a map file with the reader for its format, and sets the limits of the reading process."""

from __future__ import annotations

from pathlib import Path
from typing import Final

from epf_gcs.formats.zip_faults import ZIP_FAULTS
from epf_gcs.maps.field_set import FieldSet
from epf_gcs.maps.files import FIELD_SETS
from epf_gcs.maps.layer import LayerFormat, TileSource
from epf_gcs.maps.mbtiles import MbTiles
from epf_gcs.maps.mesh_files import MeshFiles, is_mesh_zip, only_raster
from epf_gcs.maps.pmtiles import PmTiles
from epf_gcs.system.limits import limit_memory, limit_time_from_now

TOO_COSTLY: Final = "it takes more memory or time than a map may"

_MOST_MEMORY_BYTES: Final = 700_000_000
_MOST_CPU_S: Final = 60


def open_source(path: Path, name: str, form: LayerFormat) -> TileSource:
    """Open a file of tiles. Raises GatewayError if it cannot be shown."""
    if form == "mbtiles":
        return MbTiles(path, name)
    if form in FIELD_SETS:
        return FieldSet(path, name, form.removeprefix("field").lstrip("_"))
    if form == "pmtiles":
        return PmTiles(path, name)
    return MeshFiles(path, name)


def raster_inside(path: Path) -> str | None:
    """The one raster of heights in an archive, the usual form of elevation models; None if there is not exactly one."""
    try:
        return None if is_mesh_zip(path) else only_raster(path)
    except ZIP_FAULTS:
        return None  # the reason is reported when the file is opened


def limit_reading() -> None:
    """Limit this process's memory for good."""
    limit_memory(_MOST_MEMORY_BYTES)


def limit_question() -> None:
    """Limit its processor time from now on; called anew before each request."""
    limit_time_from_now(_MOST_CPU_S)
