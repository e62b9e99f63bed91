"""What is read of a map file, in whichever process: the right reader for its format, and what a request may cost."""

from __future__ import annotations

import contextlib
import zipfile
from pathlib import Path
from typing import Final

from epf_gcs.web.maps.layer import LayerFormat, TileSource
from epf_gcs.web.maps.mbtiles import MbTiles
from epf_gcs.web.maps.mesh_files import MeshFiles, is_mesh_zip, only_raster
from epf_gcs.web.maps.pmtiles import PmTiles

TOO_COSTLY: Final = "it takes more memory or time than a map may"

_MOST_MEMORY_BYTES: Final = 700_000_000
_MOST_CPU_S: Final = 60


def open_source(path: Path, name: str, form: LayerFormat) -> TileSource:
    """Open a file of tiles. Raises GatewayError where it cannot be shown."""
    if form == "mbtiles":
        return MbTiles(path, name)
    if form == "pmtiles":
        return PmTiles(path, name)
    return MeshFiles(path, name)


def raster_inside(path: Path) -> str | None:
    """The one raster of heights in an archive, which is how elevation models are handed out; None where it is none."""
    try:
        return None if is_mesh_zip(path) else only_raster(path)
    except (OSError, zipfile.BadZipFile, ValueError, NotImplementedError):
        return None  # the reason is found out, and said, when it is opened


def limit_memory() -> None:
    """For this process, for ever, where the system can."""
    with contextlib.suppress(ImportError, ValueError, OSError):
        import resource  # noqa: PLC0415 - not on every system

        resource.setrlimit(resource.RLIMIT_AS, (_MOST_MEMORY_BYTES, _MOST_MEMORY_BYTES))


def limit_time() -> None:
    """From now on this process may work this long: asked for again before each request.

    It ends by itself then, also where nobody is left who would end it.
    """
    with contextlib.suppress(ImportError, ValueError, OSError):
        import resource  # noqa: PLC0415 - not on every system

        used = resource.getrusage(resource.RUSAGE_SELF)
        until_s = int(used.ru_utime + used.ru_stime) + _MOST_CPU_S
        resource.setrlimit(resource.RLIMIT_CPU, (until_s, resource.getrlimit(resource.RLIMIT_CPU)[1]))
