"""Reads untrusted map files in a separate process with limits. `python -m epf_gcs.maps.reader_worker`.

Requests come on stdin, answers go to stdout; each is a head of JSON and then bytes (`worker_pipe`). A request
that runs out of memory or time ends this process, and the next request starts another.
"""

from __future__ import annotations

import os
import signal
import sys
from pathlib import Path
from typing import Any, BinaryIO, Final, get_args

from epf_gcs.errors import GatewayError
from epf_gcs.formats.quantized_mesh_reading import read_grid
from epf_gcs.maps import faults
from epf_gcs.maps.layer import LayerFormat, Tile, TileSource
from epf_gcs.maps.open_files import OpenFiles
from epf_gcs.maps.reading import limit_question, limit_reading, open_source, raster_inside
from epf_gcs.workers.pipe import receive, send

OUT_OF_MEMORY: Final = 3


def main() -> None:
    """Answer requests until stdin is closed."""
    # Ctrl-C in a terminal reaches all its processes: ignore it here, the station ends this one.
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    limit_reading()
    try:
        send(sys.stdout.buffer, {})
        serve(sys.stdin.buffer, sys.stdout.buffer)
    except MemoryError:
        os._exit(OUT_OF_MEMORY)


def serve(requests: BinaryIO, answers: BinaryIO) -> None:
    """Answer one request after the other. Raises MemoryError."""
    opened = OpenFiles()
    while (message := receive(requests)) is not None:
        limit_question()
        send(answers, *_answer(opened, message[0]))
    opened.close()


def _answer(opened: OpenFiles, asked: dict[str, Any]) -> tuple[dict[str, Any], bytes]:
    path = Path(asked["path"])
    try:
        match asked["do"]:
            case "inside":
                return {"inside": raster_inside(path)}, b""
            case "forget":
                for form in get_args(LayerFormat):
                    opened.forget(_key(path, form))
                return {}, b""
            case "describe":
                with opened.reading(
                    _key(path, asked["format"]), tuple(asked["stamp"]), lambda: _open(path, asked)
                ) as source:
                    return {"description": source.description.as_dict()}, b""
            case "grid":
                with opened.reading(
                    _key(path, asked["format"]), tuple(asked["stamp"]), lambda: _open(path, asked)
                ) as source:
                    tile = source.tile(*asked["place"])
                return {}, b"" if tile is None else read_grid(tile.data)
            case _:
                with opened.reading(
                    _key(path, asked["format"]), tuple(asked["stamp"]), lambda: _open(path, asked)
                ) as source:
                    tile = source.tile(*asked["place"])
                return ({}, b"") if tile is None else (_head(tile), tile.data)
    except GatewayError as error:
        return error.as_dict(), b""
    except (OSError, ValueError, ArithmeticError, LookupError, TypeError, RecursionError) as error:
        fault = faults.damaged(asked.get("name", path.name), str(error) or type(error).__name__)
        return fault.as_dict(), b""


def _key(path: Path, form: str) -> str:
    """The same file may be open for each of its sets of tiles."""
    return f"{form} {path}"


def _open(path: Path, asked: dict[str, Any]) -> TileSource:
    return open_source(path, asked["name"], asked["format"])


def _head(tile: Tile) -> dict[str, Any]:
    return {"media_type": tile.media_type, "encoding": tile.encoding}


if __name__ == "__main__":
    main()
