"""What a query may do in an SQLite file of a stranger: read its tables and plain views, within bounds of memory."""

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
# Views of map files join tables; hardly one calls anything, and these cannot make much of little.
_FUNCTIONS: Final = frozenset({"substr", "min", "max", "coalesce", "ifnull", "length", "abs", "count", "lower"})
_READING: Final = frozenset({sqlite3.SQLITE_SELECT, sqlite3.SQLITE_READ})


def confine(connection: sqlite3.Connection) -> None:
    """For a connection that was just opened. Raises sqlite3.Error."""
    for limit, value in _LIMITS.items():
        connection.setlimit(limit, value)
    connection.executescript(
        "PRAGMA trusted_schema = OFF; PRAGMA query_only = ON; PRAGMA cell_size_check = ON; PRAGMA temp_store = MEMORY;"
        f"PRAGMA mmap_size = 0; PRAGMA hard_heap_limit = {_MOST_HEAP_BYTES}"
    )
    connection.set_authorizer(_may)


def _may(action: int, _first: str | None, second: str | None, _file: str | None, _view: str | None) -> int:
    """Recursion has no other use in a map than to be endless."""
    if action in _READING or (action == sqlite3.SQLITE_FUNCTION and second in _FUNCTIONS):
        return sqlite3.SQLITE_OK
    return sqlite3.SQLITE_DENY
