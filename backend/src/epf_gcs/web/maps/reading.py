"""Opens a map file with the reader for its format, and sets the limits of the reading process."""

from __future__ import annotations

import contextlib
from pathlib import Path
from typing import Final

from epf_gcs.formats.zip_faults import ZIP_FAULTS
from epf_gcs.web.maps.layer import LayerFormat, TileSource
from epf_gcs.web.maps.mbtiles import MbTiles
from epf_gcs.web.maps.mesh_files import MeshFiles, is_mesh_zip, only_raster
from epf_gcs.web.maps.pmtiles import PmTiles

TOO_COSTLY: Final = "it takes more memory or time than a map may"

_MOST_MEMORY_BYTES: Final = 700_000_000
_MOST_CPU_S: Final = 60


def open_source(path: Path, name: str, form: LayerFormat) -> TileSource:
    """Open a file of tiles. Raises GatewayError if it cannot be shown."""
    if form == "mbtiles":
        return MbTiles(path, name)
    if form == "pmtiles":
        return PmTiles(path, name)
    return MeshFiles(path, name)


def raster_inside(path: Path) -> str | None:
    """The one raster of heights in an archive, the usual form of elevation models; None if there is not exactly one."""
    try:
        return None if is_mesh_zip(path) else only_raster(path)
    except ZIP_FAULTS:
        return None  # the reason is reported when the file is opened


def limit_memory() -> None:
    """Limit this process's memory permanently, on systems that support it."""
    with contextlib.suppress(ImportError, ValueError, OSError):
        import resource  # noqa: PLC0415 - not on every system

        resource.setrlimit(resource.RLIMIT_AS, (_MOST_MEMORY_BYTES, _MOST_MEMORY_BYTES))


def limit_time() -> None:
    """Limit this process's CPU time from now on; called anew before each request.

    The system then ends the process even if the station that would kill it is gone.
    """
    with contextlib.suppress(ImportError, ValueError, OSError):
        import resource  # noqa: PLC0415 - not on every system

        used = resource.getrusage(resource.RUSAGE_SELF)
        until_s = int(used.ru_utime + used.ru_stime) + _MOST_CPU_S
        resource.setrlimit(resource.RLIMIT_CPU, (until_s, resource.getrlimit(resource.RLIMIT_CPU)[1]))
