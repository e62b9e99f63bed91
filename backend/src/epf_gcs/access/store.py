"""Who may come in, on the disk: people, their sessions, programs and invitations, in one small SQLite file.

Of keys and cookies, all of random bits that nobody guesses, the SHA-256 is kept. Every change is on the disk before it
is answered. Used by one thread at a time.
"""

from __future__ import annotations

import contextlib
import os
import sqlite3
import threading
from collections.abc import Iterable, Iterator
from dataclasses import astuple, dataclass, fields
from functools import partial
from pathlib import Path
from typing import Final, Literal, TypeVar

import structlog

from epf_gcs.access.moment import Moment
from epf_gcs.access.roles import Role
from epf_gcs.disk import set_aside
from epf_gcs.errors import NotKeptError

FILE: Final = "access.sqlite"
_VERSION: Final = 3
_PATIENCE_S: Final = 5.0
_TABLES: Final = """
CREATE TABLE people (id TEXT PRIMARY KEY, name TEXT, place TEXT, role INTEGER, state TEXT, made_s REAL, seen_s REAL,
  address TEXT) WITHOUT ROWID;
CREATE TABLE sessions (id TEXT PRIMARY KEY, person TEXT, digest TEXT UNIQUE, made_s REAL, seen_s REAL, address TEXT)
  WITHOUT ROWID;
CREATE TABLE programs (id TEXT PRIMARY KEY, name TEXT, role INTEGER, hash TEXT, made_s REAL, seen_s REAL)
  WITHOUT ROWID;
CREATE TABLE invitations (id TEXT PRIMARY KEY, lookup TEXT UNIQUE, role INTEGER, hash TEXT, made_s REAL, until_s REAL,
  boot TEXT, until_steady_s REAL) WITHOUT ROWID;
"""
# Made before 2: by the system's time alone.
_FROM_1: Final = """
ALTER TABLE invitations ADD COLUMN boot TEXT DEFAULT '';
ALTER TABLE invitations ADD COLUMN until_steady_s REAL DEFAULT 0;
"""
# Made before 3: of keys that were kept as slow hashes nothing else can be made. They end.
_FROM_2: Final = """
DELETE FROM programs WHERE hash LIKE '$argon2%';
DELETE FROM invitations WHERE hash LIKE '$argon2%';
"""
_UPGRADES: Final = {0: _TABLES, 1: _FROM_1 + _FROM_2, 2: _FROM_2, _VERSION: ""}

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
    """A program with a key, of which `hash` is the digest. `seen_s` 0: never used."""

    id: str
    name: str
    role: int
    hash: str
    made_s: float
    seen_s: float


@dataclass(frozen=True, slots=True)
class Invitation:
    """A one-time key. `lookup` is its first group, by which it is found. `boot` and `until_steady_s` are told in
    `Moment`."""

    id: str
    lookup: str
    role: int
    hash: str
    made_s: float
    until_s: float
    boot: str
    until_steady_s: float

    def left_s(self, now: Moment) -> float:
        """Seconds until it ends; 0 or less once it has."""
        return Moment(self.until_s, self.until_steady_s, self.boot).left_s(now)


Row = TypeVar("Row", Person, Session, Program, Invitation)

_NAMES: Final[dict[type, str]] = {
    Person: "people",
    Session: "sessions",
    Program: "programs",
    Invitation: "invitations",
}


class AccessStore:
    """The open file. Methods raise NotKeptError where it cannot be read or written."""

    def __init__(self, data_dir: Path | None) -> None:
        """Opens the file, makes it if there is none, and sets one aside that cannot be read. None: in memory.

        Raises NotKeptError."""
        self._lock = threading.Lock()
        with _kept():
            self._db = _in_memory() if data_dir is None else _opened(data_dir)

    @classmethod
    def copied(cls, data_dir: Path) -> AccessStore:
        """What stands in a file that cannot be written, in memory: who is in stays in, and nothing new is kept."""
        store = cls(None)
        # Immutable: SQLite would else want a lock or a journal beside it.
        address = f"{(data_dir / FILE).resolve().as_uri()}?mode=ro&immutable=1"
        with contextlib.suppress(sqlite3.Error), contextlib.closing(sqlite3.connect(address, uri=True)) as kept:
            copy = sqlite3.connect(":memory:", isolation_level=None, check_same_thread=False)
            try:
                kept.backup(copy)
                _tables(copy)
            except BaseException:
                copy.close()
                raise
            store._db.close()
            store._db = copy
        return store

    def close(self) -> None:
        """Close the file."""
        with self._lock:
            self._db.close()

    def all(self, kind: type[Row]) -> list[Row]:
        """Every row of this kind, oldest first."""
        with self._lock, _kept():
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

    def invitation(self, lookup: str) -> Invitation | None:
        """The invitation with this first group."""
        with self._lock, _kept():
            row = self._db.execute("SELECT * FROM invitations WHERE lookup = ?", (lookup,)).fetchone()
        return None if row is None else Invitation(*row)

    def forget(self, those: Iterable[Invitation]) -> None:
        """Remove these invitations."""
        with self._change():
            self._db.executemany("DELETE FROM invitations WHERE id = ?", [(one.id,) for one in those])

    def seen(self, kind: type[Person | Session | Program], times: dict[str, float]) -> None:
        """Write when these were last heard."""
        with self._change():
            self._db.executemany(
                f"UPDATE {_NAMES[kind]} SET seen_s = ? WHERE id = ?",  # noqa: S608
                [(seen_s, row_id) for row_id, seen_s in times.items()],
            )

    @contextlib.contextmanager
    def _change(self) -> Iterator[None]:
        with self._lock, _kept(), self._db:
            self._db.execute("BEGIN IMMEDIATE")
            yield


@contextlib.contextmanager
def _kept() -> Iterator[None]:
    try:
        yield
    except (sqlite3.Error, OSError) as error:
        raise NotKeptError(
            "access_not_written",
            f"Who may come in could not be kept ({error}): free the disk or correct the permissions of the data "
            "folder.",
            why=str(error),
        ) from error


def _in_memory() -> sqlite3.Connection:
    return _tables(sqlite3.connect(":memory:", isolation_level=None, check_same_thread=False))


def _opened(data_dir: Path) -> sqlite3.Connection:
    path = data_dir / FILE
    data_dir.mkdir(parents=True, exist_ok=True)
    try:
        return _open(path)
    except sqlite3.DatabaseError as error:
        if isinstance(error, sqlite3.OperationalError):
            raise
        aside = set_aside(path)
        log.exception("the list of people cannot be read: nobody has a key until invited again", kept_as=str(aside))
        return _open(path)


def _open(path: Path) -> sqlite3.Connection:
    # Made by us first, so that nobody else can read it at any time; SQLite gives its journal the same rights.
    os.close(os.open(path, os.O_RDWR | os.O_CREAT, 0o600))
    path.chmod(0o600)
    return _tables(sqlite3.connect(path, timeout=_PATIENCE_S, isolation_level=None, check_same_thread=False))


def _tables(db: sqlite3.Connection) -> sqlite3.Connection:
    # A name with a damaged letter is no reason to shut out everybody.
    db.text_factory = partial(str, encoding="utf-8", errors="replace")
    try:
        db.execute("PRAGMA synchronous = FULL")
        db.execute("PRAGMA secure_delete = ON")
        with db:
            db.execute("BEGIN IMMEDIATE")
            version = _version(db)
            for statement in filter(str.strip, _UPGRADES[min(version, _VERSION)].split(";")):
                ended = db.execute(statement).rowcount
                if version and ended > 0:
                    log.warning("keys of an earlier version have ended: make new ones", count=ended)
            db.execute(f"PRAGMA user_version = {_VERSION}")
        _check(db)
    except BaseException:
        db.close()
        raise
    return db


def _version(db: sqlite3.Connection) -> int:
    return int(db.execute("PRAGMA user_version").fetchone()[0])


def _check(db: sqlite3.Connection) -> None:
    """A flipped bit must not keep the station from starting. Raises DatabaseError."""
    sound = db.execute("PRAGMA integrity_check").fetchone()[0]
    if sound != "ok":
        raise sqlite3.DatabaseError(sound)
    for kind, name in _NAMES.items():
        columns = {
            field.name: {"str": "text", "int": "integer", "float": "real", "PersonState": "text"}[str(field.type)]
            for field in fields(kind)
        }
        wrong = " OR ".join(f"typeof({column}) != '{what}'" for column, what in columns.items())
        roles = ",".join(str(int(role)) for role in Role)
        wrong += f" OR role NOT IN ({roles})" if "role" in columns else ""
        wrong += " OR state NOT IN ('waiting','in','ended')" if "state" in columns else ""
        if db.execute(f"SELECT count(*) FROM {name} WHERE {wrong}").fetchone()[0]:  # noqa: S608
            raise sqlite3.DatabaseError(f"a row of {name} is damaged")
