"""What has arrived so far: an SQLite file that survives a kill and a power cut, piece by piece."""

from __future__ import annotations

import hashlib
import sqlite3
from collections.abc import Iterator
from pathlib import Path
from typing import Final, NamedTuple

from epf_gcs.fields.order import Kind, Place

_SCHEMA: Final = """
PRAGMA locking_mode = EXCLUSIVE;
PRAGMA journal_mode = WAL;
PRAGMA synchronous = NORMAL;
CREATE TABLE IF NOT EXISTS pieces (
    kind TEXT, zoom INTEGER, tile_column INTEGER, tile_row INTEGER, sha256 BLOB, data BLOB,
    PRIMARY KEY (kind, zoom, tile_column, tile_row)
);
"""
# Another worker that is just ending may still hold it.
_WAIT_S: Final = 20.0


class TileCounts(NamedTuple):
    """Counts of one kind. `missing`: the source has none there."""

    pieces: int
    missing: int
    bytes: int


class PartFile:
    """Owned by one process; the file is locked."""

    def __init__(self, path: Path) -> None:
        """Open or create it. Raises sqlite3.Error."""
        self._file = sqlite3.connect(path, isolation_level=None, timeout=_WAIT_S)
        self._file.executescript(_SCHEMA)

    def put(self, kind: Kind, place: Place, data: bytes) -> None:
        """Keep a piece; empty: the source has none there. Raises sqlite3.Error."""
        digest = hashlib.sha256(data).digest()
        self._file.execute("INSERT OR REPLACE INTO pieces VALUES (?, ?, ?, ?, ?, ?)", (kind, *place, digest, data))

    def drop(self, kind: Kind, place: Place) -> None:
        """Forget a piece, which then is fetched again. Raises sqlite3.Error."""
        self._file.execute(
            "DELETE FROM pieces WHERE kind = ? AND zoom = ? AND tile_column = ? AND tile_row = ?", (kind, *place)
        )

    def known(self, kind: Kind) -> set[Place]:
        """The pieces that need not be asked for again."""
        found = self._file.execute("SELECT zoom, tile_column, tile_row FROM pieces WHERE kind = ?", (kind,))
        return {Place(*row) for row in found}

    def arrived(self, kind: Kind) -> TileCounts:
        """How much there is of a kind."""
        sql = "SELECT count(*), coalesce(sum(length(data) = 0), 0), coalesce(sum(length(data)), 0) FROM pieces"
        return TileCounts(*self._file.execute(f"{sql} WHERE kind = ?", (kind,)).fetchone())

    def pieces(self, kind: Kind) -> Iterator[tuple[Place, bytes]]:
        """Those that the source has, in order. Raises ValueError with the place if one is not as it arrived."""
        sql = "SELECT zoom, tile_column, tile_row, sha256, data FROM pieces WHERE kind = ? AND length(data) > 0"
        for zoom, column, row, digest, data in self._file.execute(
            f"{sql} ORDER BY zoom, tile_column, tile_row", (kind,)
        ):
            if hashlib.sha256(data).digest() != digest:
                raise ValueError(f"{kind} {zoom}/{column}/{row}")
            yield Place(zoom, column, row), data

    def changed(self, kind: Kind) -> list[Place]:
        """Pieces that are not as they arrived."""
        sql = "SELECT zoom, tile_column, tile_row, sha256, data FROM pieces WHERE kind = ?"
        return [
            Place(zoom, column, row)
            for zoom, column, row, digest, data in self._file.execute(sql, (kind,))
            if hashlib.sha256(data).digest() != digest
        ]

    def close(self) -> None:
        """Close the file."""
        self._file.close()
