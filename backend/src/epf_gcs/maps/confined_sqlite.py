"""Limits for an untrusted SQLite file: queries only read tables and plain views, in bounded memory."""

from __future__ import annotations

import sqlite3
from typing import Final

_MOST_VALUE_BYTES: Final = 32_000_000
_MOST_HEAP_BYTES: Final = 200_000_000
_LIMITS: Final = {
    sqlite3.SQLITE_LIMIT_LENGTH: _MOST_VALUE_BYTES,
    sqlite3.SQLITE_LIMIT_SQL_LENGTH: 100_000,
    sqlite3.SQLITE_LIMIT_COLUMN: 100,
    sqlite3.SQLITE_LIMIT_EXPR_DEPTH: 100,
    sqlite3.SQLITE_LIMIT_COMPOUND_SELECT: 20,
    sqlite3.SQLITE_LIMIT_VDBE_OP: 25_000,
    sqlite3.SQLITE_LIMIT_ATTACHED: 0,
    sqlite3.SQLITE_LIMIT_TRIGGER_DEPTH: 1,
    sqlite3.SQLITE_LIMIT_WORKER_THREADS: 0,
}
# The views of map files join tables and call few functions; none of these can turn a small value into a huge one.
_FUNCTIONS: Final = frozenset({"substr", "min", "max", "coalesce", "ifnull", "length", "abs", "count", "lower"})
_READING: Final = frozenset({sqlite3.SQLITE_SELECT, sqlite3.SQLITE_READ})


def confine(connection: sqlite3.Connection) -> None:
    """Apply the limits to a newly opened connection. Raises sqlite3.Error."""
    for limit, value in _LIMITS.items():
        connection.setlimit(limit, value)
    connection.executescript(
        "PRAGMA trusted_schema = OFF; PRAGMA query_only = ON; PRAGMA cell_size_check = ON; PRAGMA temp_store = MEMORY;"
        f"PRAGMA mmap_size = 0; PRAGMA hard_heap_limit = {_MOST_HEAP_BYTES}"
    )
    connection.set_authorizer(_may)


def _may(action: int, _first: str | None, second: str | None, _file: str | None, _view: str | None) -> int:
    """Allow reads and a few functions. Recursive queries are denied: a map needs none, and they can be endless."""
    if action in _READING or (action == sqlite3.SQLITE_FUNCTION and second in _FUNCTIONS):
        return sqlite3.SQLITE_OK
    return sqlite3.SQLITE_DENY
