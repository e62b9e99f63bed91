"""Prepares one field, in a process of its own with limits. `python -m epf_gcs.fields.worker`.

Its first line on stdin says what to do (`Work`). It prints a line of JSON for each step (`FieldLine`), and one with the
problem if it fails. It ends when stdin is closed, so that it never outlives the station, and can be killed at any
moment: what has arrived is kept.
"""

from __future__ import annotations

import asyncio
import errno
import gzip
import os
import shutil
import sqlite3
import sys
import threading
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Final

import httpx
import msgspec

from epf_gcs.errors import ConflictError, GatewayError
from epf_gcs.fields.fetching import USER_AGENT, Fetcher, Pace
from epf_gcs.fields.order import Order, Part, Place
from epf_gcs.fields.pack import Section, prove, write_pack
from epf_gcs.fields.part_file import PartFile
from epf_gcs.fields.progress import Progress
from epf_gcs.fields.work import FieldProgress, Prove, Work
from epf_gcs.maps.field_set import VECTOR
from epf_gcs.maps.imports import RESERVE_BYTES
from epf_gcs.maps.outside import Consent, OutsideTransport
from epf_gcs.system.limits import limit_memory
from epf_gcs.system.priority import be_nice
from epf_gcs.workers.lines import tell, tell_fault

ORDER: Final = "order.json"
ARRIVED: Final = "arrived.sqlite"
PACK: Final = "pack.field"

_MOST_MEMORY_BYTES: Final = 4_000_000_000
_MOST_TRIES: Final = 3
_LOOK_AT_DISK_EVERY: Final = 50

Say = Callable[[FieldProgress], None]


def main() -> int:
    """Do what the first line says."""
    be_nice()
    limit_memory(_MOST_MEMORY_BYTES)
    asked = msgspec.json.decode(sys.stdin.buffer.readline(), type=Work)
    threading.Thread(target=_end_with_the_station, daemon=True).start()
    try:
        if isinstance(asked, Prove):
            tell({"proof": prove(Path(asked.path), asked.name)})
        else:
            prepare(Path(asked.folder), Consent(asked.servers), Pace(), lambda progress: tell({"progress": progress}))
            tell({"is_done": True})
    except GatewayError as error:
        tell_fault(error)
        return 1
    return 0


def prepare(folder: Path, consent: Consent, pace: Pace, say: Say) -> None:
    """Fetch what is missing of the order in this folder, make the rest, and write PACK, which is whole then.

    Raises GatewayError with what somebody has to correct.
    """
    order = Order.from_json((folder / ORDER).read_bytes())
    try:
        _prepare(folder, order, consent, pace, say)
    except sqlite3.Error as error:
        is_full = "full" in str(error)
        raise disk_full(order.name, folder) if is_full else not_written(order.name, str(error)) from error
    except OSError as error:
        if error.errno == errno.ENOSPC:
            raise disk_full(order.name, folder) from error
        raise not_written(order.name, error.strerror or str(error)) from error


def _prepare(folder: Path, order: Order, consent: Consent, pace: Pace, say: Say) -> None:
    arrived = PartFile(folder / ARRIVED)
    try:
        for _ in range(_MOST_TRIES):
            _fetch(folder, order, arrived, consent, pace, say)
            if _makes(folder, order, arrived, say):
                return
        raise _damaged(order)
    finally:
        arrived.close()


def _fetch(folder: Path, order: Order, arrived: PartFile, consent: Consent, pace: Pace, say: Say) -> None:
    progress = Progress(order, arrived, say)
    _check_room(order, folder)

    async def all_parts() -> None:
        transport = OutsideTransport(consent)
        headers = {"User-Agent": USER_AGENT}
        # Told also while nothing comes: the last piece before a silence, and how long it lasts.
        telling = asyncio.create_task(progress.run())
        try:
            async with httpx.AsyncClient(
                headers=headers, timeout=pace.silence_s, follow_redirects=False, transport=transport
            ) as client:
                for part in order.parts:
                    await _fetch_part(folder, order, part, arrived, client, progress, pace)
        finally:
            telling.cancel()

    asyncio.run(all_parts())
    progress.tell(now=True)


async def _fetch_part(
    folder: Path,
    order: Order,
    part: Part,
    arrived: PartFile,
    client: httpx.AsyncClient,
    progress: Progress,
    pace: Pace,
) -> None:
    known = arrived.known(part.kind)
    count = 0

    def keep(place: Place, data: bytes) -> None:
        nonlocal count
        count += 1
        if count % _LOOK_AT_DISK_EVERY == 0 or part.is_of_degrees:
            _check_room(order, folder)
        arrived.put(part.kind, place, data)
        progress.came(part.kind, len(data))

    left: Iterator[Place] = (place for place in part.places(order.area) if place not in known)
    await Fetcher(part, client, keep, progress.waits, pace).fetch(left)


def _makes(folder: Path, order: Order, arrived: PartFile, say: Say) -> bool:
    """Write the pack and prove it; False if a piece has to be fetched again."""
    heights = next((part for part in order.parts if part.kind == "heights"), None)
    raster, terrain = folder / "heights.tif", folder / "terrain.mbtiles"
    sections = [_as_it_came(order, part, arrived) for part in order.parts if part.kind != "heights"]
    if heights is not None:
        # Its libraries are loaded for heights alone, and their absence is told.
        try:
            from epf_gcs.fields import making  # noqa: PLC0415
        except ImportError as error:
            raise not_written(order.name, str(error)) from error
        try:
            making.write_raster(heights, order, arrived, raster)
        except making.BadPieceError as error:
            arrived.drop("heights", error.place)
            return False
        making.make_terrain(raster, terrain, lambda percent: say(FieldProgress("making", percent)))
        zooms = making.relief_zooms(heights)
        metadata = {**_metadata(order, heights), "minzoom": str(zooms[0]), "maxzoom": str(zooms[-1]), "format": "png"}
        sections.append(Section("relief_", metadata, making.relief(raster, order, heights)))
        metadata = {**_metadata(order, heights), "format": "quantized-mesh-1.0"}
        sections.append(Section("terrain_", metadata, making.terrain_tiles(terrain), south=True))
    say(FieldProgress("proving"))
    try:
        write_pack(folder / PACK, order, sections)
    except ValueError:
        # A piece that is not what arrived any more: a worn card. All of them are looked at by their hashes.
        _drop_changed(order, arrived)
        return False
    prove(folder / PACK, order.name)
    for rest in (raster, terrain):
        rest.unlink(missing_ok=True)
    return True


def _as_it_came(order: Order, part: Part, arrived: PartFile) -> Section:
    """Pictures, or roads with gzip. Raises ConflictError if the source has none."""
    if arrived.arrived(part.kind).bytes == 0:
        raise _nothing_there(part)
    if part.kind == "imagery":
        return Section("", _imagery_metadata(order, part), arrived.pieces("imagery"))
    metadata = {**_metadata(order, part), "format": "pbf", "type": "overlay"}
    return Section(VECTOR, metadata, _packed(arrived.pieces("vector")))


def _drop_changed(order: Order, arrived: PartFile) -> None:
    for part in order.parts:
        for place in arrived.changed(part.kind):
            arrived.drop(part.kind, place)


def _metadata(order: Order, part: Part) -> dict[str, str]:
    return {
        "name": order.name,
        "attribution": part.attribution,
        "bounds": ",".join(f"{value:.6f}" for value in order.area.bounds),
        "minzoom": str(part.minimum_zoom),
        "maxzoom": str(part.maximum_zoom),
    }


def _imagery_metadata(order: Order, part: Part) -> dict[str, str]:
    return {**_metadata(order, part), "format": "jpg", "type": "baselayer"}


def _packed(pieces: Iterator[tuple[Place, bytes]]) -> Iterator[tuple[Place, bytes]]:
    """With gzip, as vector tiles are sent; the same tile makes the same bytes."""
    return ((place, gzip.compress(data, mtime=0)) for place, data in pieces)


def _check_room(order: Order, folder: Path) -> None:
    if shutil.disk_usage(folder).free < RESERVE_BYTES:
        raise disk_full(order.name, folder)


def disk_full(name: str, folder: Path) -> GatewayError:
    """The error for a disk without room beyond what recordings need."""
    free_mb = shutil.disk_usage(folder).free // 1_000_000
    return ConflictError(
        "map_disk_full",
        f"'{name}' does not fit: {free_mb} MB are free, and {RESERVE_BYTES // 1_000_000} MB of them are kept for "
        "recordings. Free the disk.",
        name=name,
        free_mb=free_mb,
        reserve_mb=RESERVE_BYTES // 1_000_000,
    )


def not_written(name: str, why: str) -> GatewayError:
    """The error for a folder that is gone or cannot be written."""
    return ConflictError(
        "field_not_written",
        f"'{name}' could not be written ({why}): see that the maps' folder is there and may be written, then go on.",
        name=name,
        why=why[:200],
    )


def _damaged(order: Order) -> GatewayError:
    """Pieces came again and again that cannot be read, or that the disk changed."""
    part = next((part for part in order.parts if part.kind == "heights"), order.parts[0])
    return ConflictError(
        "field_source_wrong",
        f"'{part.name}' answers with something else than whole tiles (damaged): check its address and its terms, then "
        "go on.",
        name=part.name,
        why="damaged",
    )


def _nothing_there(part: Part) -> GatewayError:
    return ConflictError(
        "field_source_empty",
        f"'{part.name}' has nothing of this area: choose another source, or another level.",
        name=part.name,
    )


def _end_with_the_station() -> None:
    while sys.stdin.buffer.read(1):
        time.sleep(0.01)
    os._exit(2)


if __name__ == "__main__":
    sys.exit(main())
