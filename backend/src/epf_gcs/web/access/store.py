"""Who may come in, on the disk: people, their sessions, programs and invitations, in one small SQLite file.

Keys are kept as hashes that nothing can be made of: argon2id for keys that people and programs carry, SHA-256 for the
256 random bits of a cookie. Every change is on the disk before it is answered. Used by one thread at a time.
"""

from __future__ import annotations

import contextlib
import os
import sqlite3
import threading
from collections.abc import Iterator
from dataclasses import astuple, dataclass, fields
from pathlib import Path
from typing import Final, Literal, TypeVar

import structlog

from epf_gcs.disk import set_aside

FILE: Final = "access.sqlite"
_VERSION: Final = 1
_PATIENCE_S: Final = 5.0
_TABLES: Final = """
CREATE TABLE people (id TEXT PRIMARY KEY, name TEXT, place TEXT, role INTEGER, state TEXT, made_s REAL, seen_s REAL,
  address TEXT) WITHOUT ROWID;
CREATE TABLE sessions (id TEXT PRIMARY KEY, person TEXT, digest TEXT UNIQUE, made_s REAL, seen_s REAL, address TEXT)
  WITHOUT ROWID;
CREATE TABLE programs (id TEXT PRIMARY KEY, name TEXT, role INTEGER, hash TEXT, made_s REAL, seen_s REAL)
  WITHOUT ROWID;
CREATE TABLE invitations (id TEXT PRIMARY KEY, lookup TEXT UNIQUE, role INTEGER, hash TEXT, made_s REAL, until_s REAL)
  WITHOUT ROWID;
"""

PersonState = Literal["waiting", "in", "ended"]

log = structlog.get_logger("web")


@dataclass(frozen=True, slots=True)
class Person:
    """`role` is a number of `roles.Role`. Times are Unix seconds; `seen_s` may be a minute old."""

    id: str
    name: str
    place: str
    role: int
    state: PersonState
    made_s: float
    seen_s: float
    address: str


@dataclass(frozen=True, slots=True)
class Session:
    """One browser of a person. `digest` is the SHA-256 of its cookie, in hex; `id` is no secret."""

    id: str
    person: str
    digest: str
    made_s: float
    seen_s: float
    address: str


@dataclass(frozen=True, slots=True)
class Program:
    """A program with a key, of which `hash` is kept. `seen_s` 0: never used."""

    id: str
    name: str
    role: int
    hash: str
    made_s: float
    seen_s: float


@dataclass(frozen=True, slots=True)
class Invitation:
    """A one-time key. `lookup` is its first group, by which it is found."""

    id: str
    lookup: str
    role: int
    hash: str
    made_s: float
    until_s: float


Row = TypeVar("Row", Person, Session, Program, Invitation)

_NAMES: Final[dict[type, str]] = {
    Person: "people",
    Session: "sessions",
    Program: "programs",
    Invitation: "invitations",
}


class AccessStore:
    """The open file. Methods raise sqlite3.Error where it cannot be read or written."""

    def __init__(self, data_dir: Path | None) -> None:
        """Opens the file, makes it if there is none, and sets one aside that cannot be read. None: in memory."""
        self._lock = threading.Lock()
        if data_dir is None:
            self._db = _tables(sqlite3.connect(":memory:", isolation_level=None, check_same_thread=False))
            return
        path = data_dir / FILE
        data_dir.mkdir(parents=True, exist_ok=True)
        try:
            self._db = _open(path)
        except sqlite3.DatabaseError as error:
            if isinstance(error, sqlite3.OperationalError):
                raise
            aside = set_aside(path)
            log.exception("the list of people cannot be read: nobody has a key until invited again", kept_as=str(aside))
            self._db = _open(path)

    def close(self) -> None:
        """Close the file."""
        with self._lock:
            self._db.close()

    def all(self, kind: type[Row]) -> list[Row]:
        """Every row of this kind, oldest first."""
        with self._lock:
            rows = self._db.execute(f"SELECT * FROM {_NAMES[kind]} ORDER BY made_s, id").fetchall()  # noqa: S608
        return [kind(*row) for row in rows]

    def put(self, *rows: Person | Session | Program | Invitation) -> None:
        """Write these rows, all or none; a row with the same id is replaced."""
        with self._change():
            for row in rows:
                marks = ", ".join("?" * len(fields(row)))
                self._db.execute(f"REPLACE INTO {_NAMES[type(row)]} VALUES ({marks})", astuple(row))  # noqa: S608

    def remove(self, kind: type[Row], row_id: str) -> bool:
        """Remove a row; False if there was none. A person's sessions go with the person."""
        with self._change():
            gone = self._db.execute(f"DELETE FROM {_NAMES[kind]} WHERE id = ?", (row_id,)).rowcount > 0  # noqa: S608
            if kind is Person:
                self._db.execute("DELETE FROM sessions WHERE person = ?", (row_id,))
        return gone

    def remove_sessions(self, person_id: str) -> None:
        """Remove all sessions of a person."""
        with self._change():
            self._db.execute("DELETE FROM sessions WHERE person = ?", (person_id,))

    def invitation(self, lookup: str, now_s: float) -> Invitation | None:
        """The invitation with this first group, if it has not ended."""
        with self._lock:
            row = self._db.execute(
                "SELECT * FROM invitations WHERE lookup = ? AND until_s > ?", (lookup, now_s)
            ).fetchone()
        return None if row is None else Invitation(*row)

    def forget_invitations(self, now_s: float) -> None:
        """Remove those that have ended."""
        with self._change():
            self._db.execute("DELETE FROM invitations WHERE until_s <= ?", (now_s,))

    def seen(self, kind: type[Person | Session | Program], times: dict[str, float]) -> None:
        """Write when these were last heard."""
        with self._change():
            self._db.executemany(
                f"UPDATE {_NAMES[kind]} SET seen_s = ? WHERE id = ?",  # noqa: S608
                [(seen_s, row_id) for row_id, seen_s in times.items()],
            )

    @contextlib.contextmanager
    def _change(self) -> Iterator[None]:
        with self._lock, self._db:
            self._db.execute("BEGIN IMMEDIATE")
            yield


def _open(path: Path) -> sqlite3.Connection:
    # Made by us first, so that nobody else can read it at any time; SQLite gives its journal the same rights.
    os.close(os.open(path, os.O_RDWR | os.O_CREAT, 0o600))
    path.chmod(0o600)
    return _tables(sqlite3.connect(path, timeout=_PATIENCE_S, isolation_level=None, check_same_thread=False))


def _tables(db: sqlite3.Connection) -> sqlite3.Connection:
    try:
        db.execute("PRAGMA synchronous = FULL")
        db.execute("PRAGMA secure_delete = ON")
        with db:
            db.execute("BEGIN IMMEDIATE")
            if db.execute("PRAGMA user_version").fetchone()[0] != _VERSION:
                for statement in filter(str.strip, _TABLES.split(";")):
                    db.execute(statement)
                db.execute(f"PRAGMA user_version = {_VERSION}")
    except BaseException:
        db.close()
        raise
    return db
