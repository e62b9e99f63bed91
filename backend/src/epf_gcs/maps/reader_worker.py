"""Reads untrusted map files in a separate process with limits. `python -m epf_gcs.maps.reader_worker`.

Requests come on stdin, answers go to stdout; each is a head of JSON and then bytes (`workers/pipe.py`). A request
that runs out of memory or time ends this process, and the next request starts another.
"""

from __future__ import annotations

import os
import signal
import sys
from pathlib import Path
from typing import BinaryIO, Final, get_args

import msgspec

from epf_gcs.errors import GatewayError
from epf_gcs.formats.quantized_mesh_datum import above_sea
from epf_gcs.formats.quantized_mesh_reading import read_grid
from epf_gcs.maps import faults
from epf_gcs.maps.layer import Description, LayerFormat, Tile
from epf_gcs.maps.open_files import OpenFiles
from epf_gcs.maps.reader_requests import DescribeRequest, ForgetRequest, GridRequest, InsideRequest, MapReply, Request
from epf_gcs.maps.reading import limit_question, limit_reading, open_source, raster_inside
from epf_gcs.workers.lines import ToldFault
from epf_gcs.workers.pipe import receive, send

OUT_OF_MEMORY: Final = 3


def main() -> None:
    """Answer requests until stdin is closed."""
    # Ctrl-C in a terminal reaches all its processes: ignore it here, the station ends this one.
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    limit_reading()
    try:
        send(sys.stdout.buffer, MapReply())
        serve(sys.stdin.buffer, sys.stdout.buffer)
    except MemoryError:
        os._exit(OUT_OF_MEMORY)


def serve(requests: BinaryIO, answers: BinaryIO) -> None:
    """Answer one request after the other. Raises MemoryError."""
    opened = OpenFiles()
    while (message := receive(requests)) is not None:
        limit_question()
        send(answers, *_answer(opened, msgspec.json.decode(message[0], type=Request)))
    opened.close()


def _answer(opened: OpenFiles, asked: Request) -> tuple[MapReply, bytes]:
    try:
        return _found(opened, asked)
    except GatewayError as error:
        return MapReply(ToldFault.of(error)), b""
    except (OSError, ValueError, ArithmeticError, LookupError, TypeError, RecursionError) as error:
        fault = faults.damaged(asked.name or Path(asked.path).name, str(error) or type(error).__name__)
        return MapReply(ToldFault.of(fault)), b""


def _found(opened: OpenFiles, asked: Request) -> tuple[MapReply, bytes]:
    path = Path(asked.path)
    if isinstance(asked, InsideRequest):
        return MapReply(inside=raster_inside(path)), b""
    if isinstance(asked, ForgetRequest):
        for form in get_args(LayerFormat):
            opened.forget(_key(path, form))
        return MapReply(), b""
    with opened.reading(
        _key(path, asked.format), asked.stamp, lambda: open_source(path, asked.name, asked.format)
    ) as source:
        if isinstance(asked, DescribeRequest):
            return MapReply(description=source.description), b""
        tile = source.tile(*asked.place)
    if tile is None:
        return MapReply(), b""
    if asked.datum == "ellipsoidal" and source.description.kind == "terrain":
        tile = _above_sea(tile, source.description, *asked.place)
    if isinstance(asked, GridRequest):
        return MapReply(), read_grid(tile.data)
    return MapReply(media_type=tile.media_type, encoding=tile.encoding), tile.data


def _above_sea(tile: Tile, description: Description, zoom: int, column: int, row: int) -> Tile:
    """All heights leave this process above the sea: nobody else converts them."""
    from_south = row if description.scheme == "tms" else (1 << zoom) - 1 - row
    is_mercator = description.projection == "EPSG:3857"
    return Tile(above_sea(tile.data, zoom, column, from_south, is_mercator=is_mercator), tile.media_type)


def _key(path: Path, form: str) -> str:
    """The same file may be open for each of its sets of tiles."""
    return f"{form} {path}"


if __name__ == "__main__":
    main()
