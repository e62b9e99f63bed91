"""Small malicious map files that need more memory or time than allowed, to test that they are refused."""

from __future__ import annotations

import gzip
import sqlite3
import struct
import zipfile
from contextlib import closing
from pathlib import Path
from typing import Final

from tests.support.maps import png, write_mbtiles, write_pmtiles

_ROOT_PLACE: Final = 8  # offset in the header of the root directory's position and length

ENDLESS: Final = (
    "WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n) SELECT 0 AS zoom_level, 0 AS tile_column,"
    " 0 AS tile_row, x'00' AS tile_data FROM n WHERE i < 0"
)
# Yields no tile, but only after a search through a billion rows.
SLOW: Final = (
    "SELECT a.zoom_level, a.tile_column, a.tile_row, a.tile_data FROM kept a, many b, many c, many d"
    " WHERE b.i + c.i + d.i < 0"
)


def write_directory_bomb(path: Path, entries: int) -> Path:
    """A PMTiles whose root directory unpacks to this many entries, of a few bytes each."""
    write_pmtiles(path, {(0, 0, 0): png(1)})
    data = bytearray(path.read_bytes())
    directory = gzip.compress(_number(entries) + bytes(4 * entries))
    struct.pack_into("<QQ", data, _ROOT_PLACE, len(data), len(directory))
    path.write_bytes(bytes(data) + directory)
    return path


def write_view(path: Path, tiles: str, metadata: str | None = None, rows: int = 1000) -> Path:
    """An MBTiles whose tiles or metadata are views with these queries."""
    write_mbtiles(path, {(0, 0, 0): png(1)}, bounds="0,0,1,1", minzoom="0", maxzoom="1")
    with closing(sqlite3.connect(path)) as file:
        file.execute("ALTER TABLE tiles RENAME TO kept")
        file.execute("CREATE TABLE many (i INTEGER)")
        file.executemany("INSERT INTO many VALUES (?)", [(number,) for number in range(rows)])
        file.execute(f"CREATE VIEW tiles AS {tiles}")
        if metadata is not None:
            file.execute("DROP TABLE metadata")
            file.execute(f"CREATE VIEW metadata AS {metadata}")
        file.commit()
    return path


def write_lying_zip(path: Path, real_bytes: int, said_bytes: int) -> Path:
    """Terrain in a zip file whose layer.json is longer than its header states."""
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED, compresslevel=9) as archive:
        archive.writestr("layer.json", bytes(real_bytes))
    data = bytearray(path.read_bytes())
    for head, place in ((b"PK\x03\x04", 22), (b"PK\x01\x02", 24)):
        struct.pack_into("<I", data, data.rindex(head) + place, said_bytes)
    path.write_bytes(data)
    return path


def _number(value: int) -> bytes:
    found = bytearray()
    while value > 127:
        found.append(value & 127 | 128)
        value >>= 7
    return bytes((*found, value))
