"""Where the station that runs on a data folder listens: a small file in it, read by `epf-gcs invite`."""

from __future__ import annotations

import json
from contextlib import suppress
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Final

from epf_gcs.data_folder.lock import FLIGHT, PATIENCE_S, STATION, WEB, DataFolder, held, is_in_use, tighten
from epf_gcs.data_folder.place import data_folder, demonstration_folder
from epf_gcs.disk import KeptFile
from epf_gcs.errors import ConflictError

FILE: Final = "listening.json"


@dataclass(frozen=True, slots=True)
class Whereabouts:
    """`host` is what it listens on, `port` the one in use, never 0; `tls`: whether it is asked by https."""

    host: str
    port: int
    tls: bool


def leave(folder: Path, found: Whereabouts) -> None:
    """Write where we listen. Raises OSError; then what another run wrote is gone, if that can be."""
    try:
        _file(folder).write(found)
    except OSError:
        with suppress(OSError):
            (folder / FILE).unlink()
        raise


def take_back(folder: Path, found: Whereabouts) -> None:
    """Remove what `leave` wrote, unless another run has written since."""
    with suppress(OSError, ValueError):
        if _file(folder).read() == found:
            (folder / FILE).unlink()


def of_running(folder: Path) -> Whereabouts | None:
    """Where the station of this folder listens; None if none runs, or if it did not say so.

    A file that a killed one left does not count: the folder is then in nobody's use.
    """
    try:
        return _file(folder).read() if is_in_use(folder) else None
    except (OSError, ValueError):
        return None


def folder_meant() -> Path:
    """The folder of who names none: the station's own, or the demonstration's while that one alone runs."""
    own, other = data_folder(), demonstration_folder()
    return other if of_running(other) is not None and of_running(own) is None else own


def _file(folder: Path) -> KeptFile[Whereabouts]:
    return KeptFile(folder / FILE, _decode, lambda found: f"{json.dumps(asdict(found))}\n".encode())


def _decode(text: bytes) -> Whereabouts:
    found = json.loads(text)
    host, port, tls = found["host"], found["port"], found["tls"]
    if not isinstance(host, str) or type(port) is not int or not 0 < port < 1 << 16 or not isinstance(tls, bool):
        raise ValueError("it names no address")
    return Whereabouts(host, port, tls)


def held_by_launcher(path: Path, patience_s: float = PATIENCE_S) -> DataFolder:
    """The folder for a launcher, whose processes lock their own parts of it. Raises ConflictError if a station has any
    part: at once, with its port, where one runs; else after a short wait for one that is ending. Raises OSError."""
    try:
        station = held(path, 0.0 if of_running(path) else patience_s, STATION)
    except ConflictError as taken:
        running = of_running(path)
        if running is None:
            raise
        pid = taken.params["pid"]
        raise ConflictError(
            "data_folder_taken",
            f"The data folder {path} is in use by another epf-gcs (process {pid or 'unknown'}, TCP port "
            f"{running.port}): open its page, stop it, or start this one with another data folder.",
            path=str(path),
            pid=pid,
            port=running.port,
        ) from None
    try:
        for name in (FLIGHT, WEB):
            held(path, patience_s, name).release()
        tighten(path)
    except BaseException:
        station.release()
        raise
    return station
