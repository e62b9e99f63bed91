"""The file of a field: SQLite with the tables of MBTiles, once for each thing that can be shown, and a manifest.

Pictures are in `tiles` and `metadata`, so that every program that reads MBTiles shows them; what is made of the heights
is in tables of the same form with a name before it. The manifest has length and SHA-256 of every tile. The same tiles
make the same bytes.
"""

from __future__ import annotations

import hashlib
import os
import sqlite3
from collections.abc import Iterator
from contextlib import closing
from dataclasses import asdict
from pathlib import Path
from typing import Final, NamedTuple
from urllib.parse import quote

import orjson

from epf_gcs.contract.maps import FieldProof
from epf_gcs.disk import sync_folder
from epf_gcs.errors import GatewayError, InvalidInputError
from epf_gcs.fields.order import Order, Place
from epf_gcs.maps.confined_sqlite import confine
from epf_gcs.maps.field_set import VECTOR

END: Final = ".field"
SECTIONS: Final = ("", "relief_", "terrain_")
"""What stands before the names of the tables; before those of roads, which not every file has, VECTOR."""

_TILES: Final = "(zoom_level INTEGER, tile_column INTEGER, tile_row INTEGER, tile_data BLOB)"
_PER_COMMIT: Final = 500
_NOTES: Final = "field"


class Section(NamedTuple):
    """One thing that can be shown. `south`: whether its rows count from the south, as in the file."""

    prefix: str
    metadata: dict[str, str]
    tiles: Iterator[tuple[Place, bytes]]
    south: bool = False


def write_pack(path: Path, order: Order, sections: list[Section]) -> None:
    """Write the file, synced to the disk. Raises OSError, sqlite3.Error."""
    path.unlink(missing_ok=True)
    with closing(sqlite3.connect(path)) as file:
        file.executescript(
            "PRAGMA page_size = 4096; PRAGMA journal_mode = OFF; PRAGMA synchronous = OFF;"
            "CREATE TABLE manifest (section TEXT, zoom_level INTEGER, tile_column INTEGER, tile_row INTEGER,"
            " length INTEGER, sha256 BLOB);"
        )
        has_vector = any(section.prefix == VECTOR for section in sections)
        for prefix in (*SECTIONS, VECTOR) if has_vector else SECTIONS:
            file.executescript(
                f"CREATE TABLE {prefix}metadata (name TEXT, value TEXT);"
                f"CREATE TABLE {prefix}tiles {_TILES};"
                f"CREATE UNIQUE INDEX {prefix}place ON {prefix}tiles (zoom_level, tile_column, tile_row);"
            )
        for section in sections:
            _write_section(file, section)
        file.execute(
            f"INSERT INTO metadata VALUES ('{_NOTES}', ?)",  # noqa: S608
            (orjson.dumps({"version": 1, "order": order, "proof": _digest(file)}).decode(),),
        )
        file.commit()
    with path.open("rb") as written:
        os.fsync(written.fileno())
    sync_folder(path.parent)


def prove(path: Path, name: str) -> FieldProof:
    """Compare every tile of a file, which may be a stranger's, with its manifest. Raises InvalidInputError."""
    try:
        with closing(sqlite3.connect(f"file:{quote(str(path.absolute()))}?mode=ro&immutable=1", uri=True)) as file:
            confine(file)
            return _compared(file, name)
    except (sqlite3.Error, ValueError, TypeError, KeyError) as error:
        raise _not_whole(name, str(error) or type(error).__name__) from error


def _write_section(file: sqlite3.Connection, section: Section) -> None:
    prefix = section.prefix
    file.executemany(f"INSERT INTO {prefix}metadata VALUES (?, ?)", section.metadata.items())  # noqa: S608
    for number, (place, data) in enumerate(section.tiles):
        row = place.row if section.south else (1 << place.zoom) - 1 - place.row
        key = (place.zoom, place.column, row)
        file.execute(f"INSERT INTO {prefix}tiles VALUES (?, ?, ?, ?)", (*key, data))  # noqa: S608
        told = (prefix, *key, len(data), hashlib.sha256(data).digest())
        file.execute("INSERT INTO manifest VALUES (?, ?, ?, ?, ?, ?)", told)
        if number % _PER_COMMIT == 0:
            file.commit()
    file.commit()


def _digest(file: sqlite3.Connection) -> FieldProof:
    digest, tiles, total_bytes = hashlib.sha256(), 0, 0
    for section, zoom, column, row, length, sha in file.execute("SELECT * FROM manifest"):
        digest.update(f"{section} {zoom}/{column}/{row} {length} {bytes(sha).hex()}\n".encode())
        tiles, total_bytes = tiles + 1, total_bytes + int(length)
    return FieldProof(tiles, total_bytes, digest.hexdigest())


def _compared(file: sqlite3.Connection, name: str) -> FieldProof:
    (notes,) = file.execute("SELECT value FROM metadata WHERE name = ?", (_NOTES,)).fetchone() or (None,)
    if notes is None:
        raise _not_whole(name, "no manifest")
    said = orjson.loads(notes)["proof"]
    found = _digest(file)
    if asdict(found) != said:
        raise _not_whole(name, "the manifest is not the one it was made with")
    told = {tuple(row[:4]): (row[4], bytes(row[5])) for row in file.execute("SELECT * FROM manifest")}
    named = "SELECT count(*) FROM sqlite_master WHERE type = 'table' AND name = ?"
    (has_vector,) = file.execute(named, (f"{VECTOR}tiles",)).fetchone()
    for prefix in (*SECTIONS, VECTOR) if has_vector else SECTIONS:
        for zoom, column, row, data in file.execute(f"SELECT * FROM {prefix}tiles"):  # noqa: S608
            expected = told.pop((prefix, zoom, column, row), None)
            if expected != (len(data), hashlib.sha256(data).digest()):
                raise _not_whole(name, f"{prefix}{zoom}/{column}/{row}")
    if told:
        raise _not_whole(name, f"{len(told)} tiles are missing")
    return found


def _not_whole(name: str, why: str) -> GatewayError:
    return InvalidInputError(
        "field_not_whole",
        f"'{name}' is not whole ({why}): remove it and prepare the field again, or import it again.",
        name=name,
        why=why[:200],
    )
