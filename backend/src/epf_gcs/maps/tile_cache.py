"""A disk cache of online tiles with a limited size; the tiles used longest ago are deleted first.

Called from one thread at a time.
"""

from __future__ import annotations

import contextlib
import sqlite3
from collections.abc import Callable
from pathlib import Path
from typing import Final, NamedTuple

Key = tuple[str, int, int, int]
"""Source, zoom, column, row."""

# Update a tile's time of last use at most this often, to spare a flash card from writes.
_SEEN_EVERY_S: Final = 3600.0
# Trim to below the limit, so that not every new tile causes another deletion.
_KEPT_SHARE: Final = 0.95
_WHERE: Final = "source = ? AND zoom = ? AND tile_column = ? AND tile_row = ?"
_SCHEMA: Final = """
PRAGMA auto_vacuum = FULL;
PRAGMA journal_mode = WAL;
PRAGMA synchronous = NORMAL;
CREATE TABLE IF NOT EXISTS tiles (
    source TEXT, zoom INTEGER, tile_column INTEGER, tile_row INTEGER,
    size INTEGER, etag TEXT, expires_s REAL, seen_s REAL, data BLOB,
    PRIMARY KEY (source, zoom, tile_column, tile_row)
);
CREATE INDEX IF NOT EXISTS by_seen ON tiles (seen_s, size);
"""


class CachedTile(NamedTuple):
    """One tile as received; empty data: the source has no such tile. Times are Unix seconds."""

    data: bytes
    etag: str | None
    expires_s: float


class TileCache:
    """One SQLite file. A damaged one is deleted and created anew, for all tiles can be fetched again."""

    def __init__(self, path: Path, now_s: Callable[[], float]) -> None:
        """Open or create the file. Raises OSError or sqlite3.Error if that fails."""
        self._path = path
        self._now_s = now_s
        path.parent.mkdir(parents=True, exist_ok=True)
        try:
            self._open()
        except sqlite3.DatabaseError:
            self._delete()
            self._open()

    def get(self, key: Key) -> CachedTile | None:
        """A cached tile, even an expired one. Raises sqlite3.Error."""
        found = self._file.execute(f"SELECT data, etag, expires_s, seen_s FROM tiles WHERE {_WHERE}", key).fetchone()  # noqa: S608
        if found is None:
            return None
        data, etag, expires_s, seen_s = found
        now_s = self._now_s()
        if now_s - seen_s > _SEEN_EVERY_S:
            self._file.execute(f"UPDATE tiles SET seen_s = ? WHERE {_WHERE}", (now_s, *key))  # noqa: S608
        return CachedTile(data, etag, expires_s)

    def put(self, key: Key, tile: CachedTile, limit_bytes: int) -> None:
        """Store a tile, in place of an older one with the same key. Raises sqlite3.Error."""
        before = self._file.execute(f"SELECT size FROM tiles WHERE {_WHERE}", key).fetchone()  # noqa: S608
        values = (*key, len(tile.data), tile.etag, tile.expires_s, self._now_s(), tile.data)
        self._file.execute("INSERT OR REPLACE INTO tiles VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?)", values)
        self.size_bytes += len(tile.data) - (0 if before is None else before[0])
        self.trim(limit_bytes)

    def trim(self, limit_bytes: int) -> None:
        """Delete the tiles used longest ago until the rest fits. Raises sqlite3.Error."""
        if self.size_bytes <= limit_bytes:
            return
        while self.size_bytes > limit_bytes * _KEPT_SHARE:
            oldest = "SELECT rowid, size FROM tiles ORDER BY seen_s, rowid LIMIT 1"
            found = self._file.execute(oldest).fetchone()
            if found is None:
                return
            self._file.execute("DELETE FROM tiles WHERE rowid = ?", found[:1])
            self.size_bytes -= found[1]

    def clear(self) -> None:
        """Delete all tiles. Raises sqlite3.Error."""
        self._file.execute("DELETE FROM tiles")
        self.size_bytes = 0

    def close(self) -> None:
        """Close the file."""
        self._file.close()

    def _open(self) -> None:
        self._file = sqlite3.connect(self._path, check_same_thread=False, isolation_level=None)
        try:
            self._file.executescript(_SCHEMA)
            self.size_bytes = self._measured()
        except sqlite3.Error:
            self._file.close()
            raise

    def _measured(self) -> int:
        return int(self._file.execute("SELECT coalesce(sum(size), 0) FROM tiles").fetchone()[0])

    def _delete(self) -> None:
        for end in ("", "-wal", "-shm"):
            with contextlib.suppress(FileNotFoundError):
                self._path.with_name(self._path.name + end).unlink()
