"""The library of all recordings: a SQLite file that is made from the recordings and can be made again at any time.

One thread owns it. What it says comes from three kinds of files: the recordings (size, time), what people say of them
(`about.py`), and `summary.json`, which the index worker writes. Nothing is kept here alone but why a recording could
not be indexed.
"""

from __future__ import annotations

import contextlib
import sqlite3
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Final

import msgspec
import structlog

from epf_gcs.contract.flights import Fault
from epf_gcs.disk import regular_files
from epf_gcs.errors import GatewayError
from epf_gcs.library.about import About, read_about, write_about
from epf_gcs.library.query import FlightQuery, LibraryWords, plain
from epf_gcs.recordings.flight_summary import VERSION as SUMMARY_VERSION
from epf_gcs.recordings.flight_summary import FlightSummary, read_summary
from epf_gcs.recordings.places import Places, Stamp, is_id, stamp_of, started_s

# The rows hold summaries, so one of another version is a library of another version.
VERSION: Final = 1000 * SUMMARY_VERSION + 1

_SCHEMA: Final = """
CREATE TABLE flight (
  id TEXT PRIMARY KEY, bytes INTEGER, mtime_ns INTEGER, started_s REAL, duration_s REAL, highest_ft REAL,
  fastest_kt REAL, board TEXT, fingerprint TEXT, summary TEXT, about TEXT, about_stamp TEXT, fault TEXT, words TEXT
) WITHOUT ROWID;
CREATE INDEX by_start ON flight (started_s);
CREATE INDEX by_fingerprint ON flight (fingerprint);
"""
# What the rows hold beside the file's own size and time; found again by `_learn`.
_LEARNT: Final = ("started_s", "duration_s", "highest_ft", "fastest_kt", "board", "fingerprint", "summary", "words")

# A row with the ids of its copies. Of files with the same content the first is the flight.
_SELECT: Final = """SELECT *, (SELECT json_group_array(copy.id) FROM flight AS copy
  WHERE copy.fingerprint = flight.fingerprint AND copy.id <> flight.id) AS copies FROM flight"""
_IS_FIRST: Final = """NOT EXISTS (SELECT 1 FROM flight AS copy
  WHERE copy.fingerprint = flight.fingerprint AND copy.id < flight.id)"""

log = structlog.get_logger("web")


class KeptFault(msgspec.Struct):
    """Why a recording of this stamp could not be indexed, as the row has it."""

    stamp: Stamp
    fault: Fault


@dataclass(frozen=True, slots=True)
class Row:
    """One flight. `summary` is what the index worker found, None until then; `fault` why it found nothing.

    `copies` are the ids of other files with the same content.
    """

    id: str
    bytes: int
    stamp: Stamp
    started_s: float
    summary: FlightSummary | None
    fault: Fault | None
    about: About
    copies: list[str]


class Library:
    """Every method reads or writes the disk and belongs to one thread.

    `unnamed` are files among the recordings whose names are no flight's.
    """

    def __init__(self, places: Places) -> None:
        self._places = places
        self._database: sqlite3.Connection | None = None
        self._growing: str | None = None
        self.unnamed: list[str] = []

    def close(self) -> None:
        """Close the file."""
        if self._database is not None:
            self._database.close()
            self._database = None

    def refresh(self, growing: str | None) -> None:
        """Look at all files again. `growing` is the flight being recorded: its size changes, and it is no content yet.

        Raises OSError where the folder cannot be read.
        """
        self._growing = growing
        try:
            self._refresh(growing)
        except sqlite3.DatabaseError:
            self._begin_anew()

    def _refresh(self, growing: str | None) -> None:
        known = {row["id"]: row for row in self._all("SELECT id, bytes, mtime_ns, about_stamp, summary FROM flight")}
        made = self._places.made()
        there: set[str] = set()
        files = list(regular_files(self._places.recordings, "*.mcap"))
        for path in (path for path in files if is_id(path.stem)):
            flight = path.stem
            with contextlib.suppress(ValueError, FileNotFoundError):
                self._look(flight, stamp_of(path), known.get(flight), made.get(flight), is_growing=flight == growing)
                there.add(flight)
        self.unnamed = sorted(path.name for path in files if path.stem not in there)
        for flight in known.keys() - there:
            self._execute("DELETE FROM flight WHERE id = ?", flight)
        self._open().commit()

    def search(self, wanted: FlightQuery) -> tuple[list[Row], int]:
        """One page of the flights, each once however many copies it has, and how many there are in all."""
        terms, values = wanted.terms()
        where = f"{_IS_FIRST} AND {terms}"
        (count,) = self._all(f"SELECT count(*) AS n FROM flight WHERE {where}", *values)  # noqa: S608 - our own terms
        paging = "LIMIT ? OFFSET ?"
        rows = self._all(f"{_SELECT} WHERE {where} {wanted.order()} {paging}", *values, wanted.most, wanted.first)
        return [_row(row) for row in rows], int(count["n"])

    def get(self, flight: str) -> Row | None:
        """One flight; None if there is none."""
        rows = self._all(f"{_SELECT} WHERE id = ?", flight)
        return _row(rows[0]) if rows else None

    def all(self) -> list[Row]:
        """All flights, oldest first."""
        return [_row(row) for row in self._all(f"{_SELECT} ORDER BY started_s, id")]

    def waiting(self) -> list[Row]:
        """Flights of which nothing is known yet, newest first."""
        return [_row(row) for row in self._all(f"{_SELECT} WHERE summary IS NULL ORDER BY started_s DESC")]

    def newest(self, most: int) -> list[Row]:
        """The newest flights whose content is known."""
        found = self._all(
            f"{_SELECT} WHERE summary IS NOT NULL ORDER BY started_s DESC LIMIT ?",
            most,
        )
        return [_row(row) for row in found]

    def words(self) -> LibraryWords:
        """What the flights of the library may be narrowed by."""
        tags = self._all("SELECT DISTINCT value FROM flight, json_each(flight.about, '$.tags') ORDER BY value")
        return LibraryWords(
            tags=[str(row["value"]) for row in tags],
            boards=self._names("board"),
            aircraft=self._names("aircraft"),
            operators=self._names("operator"),
            unnamed=self.unnamed,
        )

    def _names(self, field: str) -> list[str]:
        found = self._all(
            "SELECT DISTINCT json_extract(summary, ?) AS name FROM flight WHERE name IS NOT NULL ORDER BY name",
            f"$.{field}",
        )
        return [str(row["name"]) for row in found]

    def with_fingerprint(self, fingerprint: str) -> str | None:
        """The flight with this content; None if there is none."""
        rows = self._all("SELECT id FROM flight WHERE fingerprint = ?", fingerprint)
        return str(rows[0]["id"]) if rows else None

    def say(self, flight: str, about: About) -> None:
        """Keep what people say of a flight. Raises OSError."""
        path = self._places.about(flight)
        write_about(path, about)
        row = self.get(flight)
        if row is not None:
            self._change(lambda: self._tell(flight, about, row.summary))

    def failed(self, flight: str, stamp: Stamp, fault: Fault) -> None:
        """Remember why a recording with this content could not be indexed; it is not tried again until it changes."""
        kept = msgspec.json.encode(KeptFault(stamp, fault)).decode()
        self._change(lambda: self._execute("UPDATE flight SET fault = ? WHERE id = ?", kept, flight))

    def refused(self, flight: str, why: GatewayError) -> None:
        """The same for a flight's content as it is now."""
        row = self.get(flight)
        if row is not None:
            self.failed(flight, row.stamp, Fault.of(why))

    def forget(self, flight: str) -> None:
        """Forget what is known of a flight, so that it is looked at anew."""
        self._change(lambda: self._execute("DELETE FROM flight WHERE id = ?", flight))

    def _look(
        self, flight: str, stamp: Stamp, known: sqlite3.Row | None, made: Path | None, *, is_growing: bool
    ) -> None:
        about_stamp = _stamp_text(self._places.about(flight))
        is_same = known is not None and (known["bytes"], known["mtime_ns"]) == stamp
        if is_same and known is not None and known["about_stamp"] == about_stamp and known["summary"] is not None:
            return
        summary = None if made is None or is_growing else read_summary(made, stamp)
        if known is None:
            self._execute("INSERT INTO flight (id, started_s) VALUES (?, ?)", flight, started_s(flight))
        self._execute("UPDATE flight SET bytes = ?, mtime_ns = ? WHERE id = ?", *stamp, flight)
        if not is_same:
            self._execute("UPDATE flight SET fault = NULL WHERE id = ?", flight)
        self._tell(flight, read_about(self._places.about(flight)), summary)

    def _tell(self, flight: str, about: About, summary: FlightSummary | None) -> None:
        values = {
            "started_s": summary.started_ns * 1e-9 + summary.clock_ahead_s if summary else started_s(flight),
            "duration_s": summary.duration_ns * 1e-9 if summary else None,
            **{name: getattr(summary, name, None) for name in ("highest_ft", "fastest_kt", "board", "fingerprint")},
            "summary": summary.as_json().decode() if summary else None,
            "words": _words(flight, about, summary),
        }
        setters = ", ".join(f"{name} = ?" for name in _LEARNT)
        self._execute(
            f"UPDATE flight SET {setters}, about = ?, about_stamp = ? WHERE id = ?",  # noqa: S608 - our own columns
            *(values[name] for name in _LEARNT),
            about.as_json().decode(),
            _stamp_text(self._places.about(flight)),
            flight,
        )

    def _open(self) -> sqlite3.Connection:
        """The database, made anew where it is of another version or cannot be read."""
        if self._database is None:
            path = self._places.library
            path.parent.mkdir(parents=True, exist_ok=True)
            try:
                self._database = _opened(path)
            except sqlite3.DatabaseError as error:
                log.warning("the library is damaged and made anew from the recordings", path=str(path), why=str(error))
                _put_aside(path)
                self._database = _opened(path)
        return self._database

    def _all(self, statement: str, *values: Any) -> list[sqlite3.Row]:
        try:
            return self._open().execute(statement, values).fetchall()
        except sqlite3.DatabaseError:
            self._begin_anew()
            return self._open().execute(statement, values).fetchall()

    def _change(self, work: Callable[[], None]) -> None:
        """Change rows. Where the library turns out to be damaged it is made anew from the files, which know better."""
        try:
            work()
            self._open().commit()
        except sqlite3.DatabaseError:
            self._begin_anew()

    def _execute(self, statement: str, *values: Any) -> None:
        self._open().execute(statement, values)

    def _begin_anew(self) -> None:
        """Keep a damaged library aside and fill a new one. Damage may be found long after opening."""
        log.warning("the library is damaged and made anew from the recordings", path=str(self._places.library))
        self.close()
        _put_aside(self._places.library)
        self._refresh(self._growing)


def _opened(path: Path) -> sqlite3.Connection:
    database = sqlite3.connect(path)
    try:
        database.row_factory = sqlite3.Row
        database.execute("PRAGMA journal_mode = WAL")
        database.execute("PRAGMA synchronous = NORMAL")
        (version,) = database.execute("PRAGMA user_version").fetchone()
        if version != VERSION:
            database.execute("DROP TABLE IF EXISTS flight")
            database.executescript(f"{_SCHEMA} PRAGMA user_version = {VERSION};")
        elif database.execute("PRAGMA quick_check").fetchone()[0] != "ok":
            raise sqlite3.DatabaseError("its pages do not fit together")
    except BaseException:
        database.close()
        raise
    return database


def _put_aside(path: Path) -> None:
    """Keep a damaged library for whoever wants to know; the one before is replaced."""
    with contextlib.suppress(FileNotFoundError):
        path.replace(path.with_name(f"{path.name}.damaged"))
    for end in ("-wal", "-shm"):
        path.with_name(path.name + end).unlink(missing_ok=True)


def _row(row: sqlite3.Row) -> Row:
    stamp = (int(row["bytes"]), int(row["mtime_ns"]))
    kept = msgspec.json.decode(row["fault"], type=KeptFault) if row["fault"] else None
    fault = kept.fault if kept is not None and kept.stamp == stamp else None
    summary = FlightSummary.from_json(row["summary"]) if row["summary"] else None
    about, copies = About.from_json(row["about"]), sorted(msgspec.json.decode(row["copies"], type=list[str]))
    return Row(row["id"], stamp[0], stamp, row["started_s"], summary, fault, about, copies)


def _stamp_text(path: Path) -> str:
    try:
        return "{}-{}".format(*stamp_of(path))
    except OSError:
        return ""


def _words(flight: str, about: About, known: FlightSummary | None) -> str:
    names = () if known is None else (known.board, known.firmware, known.aircraft, known.operator)
    said = (flight, about.title, *about.tags, about.notes, *names)
    return plain(" ".join(word for word in said if word))
