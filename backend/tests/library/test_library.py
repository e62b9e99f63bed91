"""The library is made from the files, and can be made from them again."""

from __future__ import annotations

import contextlib
import os
import sqlite3
from pathlib import Path
from typing import Any

import pytest

from epf_gcs.contract.flights import Fault
from epf_gcs.library.about import About, KeptMark, read_about
from epf_gcs.library.folder import KEPT_S, FlightFolder
from epf_gcs.library.library import Library, Row
from epf_gcs.library.query import FlightQuery
from epf_gcs.recordings.flight_summary import VERSION as SUMMARY_VERSION
from epf_gcs.recordings.flight_summary import FlightSummary, write_summary
from epf_gcs.recordings.places import SUMMARY, Places, stamp_of
from tests.support.files import the_one_like

FIRST, SECOND, THIRD = "20260101T100000Z", "20260102T100000Z", "20260102T100000Z-2"


@pytest.fixture
def places(tmp_path: Path) -> Places:
    return Places(tmp_path)


def record(places: Places, flight: str, size: int = 100) -> Path:
    places.recordings.mkdir(exist_ok=True)
    path = places.recording(flight)
    path.write_bytes(b"x" * size)
    return path


def index(places: Places, flight: str, **figures: Any) -> Path:
    """What the index worker leaves."""
    folder = places.columns / "vehicle=unknown" / "date=2026-01-01" / f"flight={flight}"
    folder.mkdir(parents=True, exist_ok=True)
    started_ns = figures.pop("started_ns", 1_767_261_600_000_000_000)
    stamp = stamp_of(places.recording(flight))
    write_summary(folder, FlightSummary(started_ns, started_ns + 60_000_000_000, stamp=stamp, **figures))
    return folder


def change(places: Places, statements: str) -> None:
    with contextlib.closing(sqlite3.connect(places.library)) as database:
        database.executescript(statements)


def ids(library: Library, **wanted: Any) -> list[str]:
    return [row.id for row in library.search(FlightQuery(**wanted))[0]]


def row_of(library: Library, flight: str) -> Row:
    found = library.get(flight)
    assert found is not None
    return found


def test_every_recording_is_listed_the_newest_first_and_nothing_else(places: Places) -> None:
    for flight in (FIRST, SECOND, THIRD, "notes", "20269999T999999Z"):
        record(places, flight)
    library = Library(places)
    library.refresh(None)
    assert ids(library) == [THIRD, SECOND, FIRST]
    assert library.search(FlightQuery())[1] == 3
    assert library.unnamed == ["20269999T999999Z.mcap", "notes.mcap"], "but what is there is named"
    places.recording(SECOND).unlink()
    library.refresh(None)
    assert ids(library) == [THIRD, FIRST]


def test_it_is_searched_by_words_tag_board_and_time_and_sorted(places: Places) -> None:
    for number, flight in enumerate((FIRST, SECOND, THIRD)):
        record(places, flight)
        index(
            places,
            flight,
            board="ala fija" if number else "delta",
            aircraft=["Libélula", None, "Gaviota"][number],
            operator=["Ana", "Luis", "Ana"][number],
            highest_ft=[900.0, None, 300.0][number],
            distance_nm=[None, 1.5, 20.0][number],
            alarms=[0, 12, 5][number],
            marks=number,
            started_ns=(1_767_261_600 + number) * 10**9,
        )
    library = Library(places)
    library.refresh(None)
    library.say(FIRST, About(title="Ensayo del Avión", tags=["viraje", "50%"], notes="tras la lluvia"))
    assert ids(library, text="avion LLUVIA") == [FIRST]
    assert ids(library, text="avion sol") == []
    assert ids(library, text="0%") == [FIRST], "a percent sign is a letter, not a wildcard"
    assert ids(library, tag="viraje") == [FIRST]
    assert ids(library, tag="vira") == []
    assert ids(library, board="ala fija") == [THIRD, SECOND]
    assert ids(library, aircraft="Gaviota") == [THIRD]
    assert ids(library, operator="Ana") == [THIRD, FIRST]
    assert ids(library, operator="Ana", aircraft="Libélula") == [FIRST]
    assert ids(library, from_s=1_767_261_601, to_s=1_767_261_601.5) == [SECOND]
    assert ids(library, sort="highest") == [FIRST, THIRD, SECOND], "what is not known comes last"
    assert ids(library, sort="highest", descending=False) == [THIRD, FIRST, SECOND]
    assert ids(library, sort="distance") == [THIRD, SECOND, FIRST]
    assert ids(library, sort="alarms") == [SECOND, THIRD, FIRST]
    assert ids(library, sort="marks", descending=False) == [FIRST, SECOND, THIRD]
    library.say(THIRD, About(title="despegue"))
    assert ids(library, sort="title", descending=False) == [THIRD, FIRST, SECOND], "without a title comes last"
    assert ids(library, first=1, most=1) == [SECOND]
    words = library.words()
    assert (words.tags, words.boards) == (["50%", "viraje"], ["ala fija", "delta"])
    assert (words.aircraft, words.operators) == (["Gaviota", "Libélula"], ["Ana", "Luis"])


def test_a_copy_of_a_recording_is_no_second_flight_and_is_named_at_the_first(places: Places) -> None:
    for flight, content in ((FIRST, "other"), (SECOND, "same"), (THIRD, "same")):
        record(places, flight)
        index(places, flight, fingerprint=content)
    library = Library(places)
    library.refresh(None)
    rows, total = library.search(FlightQuery())
    assert ([row.id for row in rows], total) == ([SECOND, FIRST], 2)
    assert [row.copies for row in rows] == [[THIRD], []]
    assert row_of(library, THIRD).copies == [SECOND], "by its id it is there still"
    places.recording(SECOND).unlink()
    library.refresh(None)
    assert ids(library) == [THIRD, FIRST]


def test_recordings_that_are_not_read_yet_are_no_copies(places: Places) -> None:
    for flight in (FIRST, SECOND):
        record(places, flight)
    library = Library(places)
    library.refresh(None)
    assert ids(library) == [SECOND, FIRST]


def test_a_changed_recording_is_known_no_more_until_it_is_indexed_again(places: Places) -> None:
    path = record(places, FIRST)
    index(places, FIRST, fingerprint="abc")
    library = Library(places)
    library.refresh(None)
    assert library.with_fingerprint("abc") == FIRST
    assert library.waiting() == []
    path.write_bytes(b"y" * 50)
    library.refresh(None)
    assert [row.id for row in library.waiting()] == [FIRST]
    assert library.with_fingerprint("abc") is None
    index(places, FIRST, fingerprint="def")
    library.refresh(None)
    assert library.with_fingerprint("def") == FIRST


def test_what_was_indexed_while_it_is_recorded_is_not_believed(places: Places) -> None:
    record(places, FIRST)
    index(places, FIRST)
    library = Library(places)
    library.refresh(FIRST)
    assert row_of(library, FIRST).summary is None
    library.refresh(None)
    assert row_of(library, FIRST).summary is not None


def test_why_a_recording_could_not_be_indexed_is_kept_until_it_changes(places: Places) -> None:
    path = record(places, FIRST)
    library = Library(places)
    library.refresh(None)
    fault = Fault("recording_foreign", "It is none.", {})
    library.failed(FIRST, row_of(library, FIRST).stamp, fault)
    library.refresh(None)
    assert row_of(library, FIRST).fault == fault
    path.write_bytes(b"z" * 7)
    library.refresh(None)
    assert row_of(library, FIRST).fault is None


@pytest.mark.parametrize("loss", ["missing", "damaged", "older", "damaged while it is open"])
def test_a_library_that_was_lost_is_made_again_with_all_that_people_said(places: Places, loss: str) -> None:
    record(places, FIRST)
    index(places, FIRST, highest_ft=800.0)
    said = About(title="Primero", tags=["a"], notes="n", pinned=True, marks=[KeptMark("m", "here")])
    library = Library(places)
    library.refresh(None)
    library.say(FIRST, said)
    if loss != "damaged while it is open":
        library.close()
    match loss:
        case "missing":
            places.library.unlink()
        case "damaged":
            places.library.write_bytes(os.urandom(8192))
        case "older":
            change(places, "DROP TABLE flight; CREATE TABLE flight (id TEXT); PRAGMA user_version = 0;")
        case _:
            change(places, "DROP TABLE flight;")
    if loss != "damaged while it is open":
        library = Library(places)
        library.refresh(None)
    row = row_of(library, FIRST)
    assert row.about == said
    assert row.summary is not None
    assert row.summary.highest_ft == 800.0
    assert places.library.with_name("library.sqlite.damaged").exists() == loss.startswith("damaged")
    library.close()


def test_summaries_of_an_earlier_station_are_made_again_and_the_list_opens_meanwhile(places: Places) -> None:
    record(places, FIRST)
    folder = index(places, FIRST, highest_ft=800.0)
    library = Library(places)
    library.refresh(None)
    library.say(FIRST, About(title="Primero"))
    library.close()
    earlier = (folder / SUMMARY).read_text().replace(f'"version":{SUMMARY_VERSION}', f'"version":{SUMMARY_VERSION - 1}')
    (folder / SUMMARY).write_text(earlier)
    change(places, f"UPDATE flight SET summary = '{earlier}'; PRAGMA user_version = 1;")  # noqa: S608 - our own text
    library = Library(places)
    library.refresh(None)
    assert [(row.id, row.summary, row.about.title) for row in library.waiting()] == [(FIRST, None, "Primero")]
    assert ids(library) == [FIRST]
    index(places, FIRST, highest_ft=810.0)
    library.refresh(None)
    assert library.waiting() == []
    library.close()


def test_words_that_cannot_be_read_are_kept_aside_and_not_overwritten(places: Places) -> None:
    record(places, FIRST)
    places.about(FIRST).write_bytes(b'{"title": 5}')
    library = Library(places)
    library.refresh(None)
    assert row_of(library, FIRST).about == About()
    library.say(FIRST, About(title="neu"))
    assert the_one_like(places.recordings, f"{FIRST}.json.damaged-*").read_bytes() == b'{"title": 5}'
    assert read_about(places.about(FIRST)).title == "neu"


def test_a_deleted_flight_lies_in_the_bin_with_its_words_and_comes_back(places: Places) -> None:
    record(places, FIRST)
    index(places, FIRST)
    library, folder = Library(places), FlightFolder(places)
    library.refresh(None)
    library.say(FIRST, About(title="weg", pinned=True))
    folder.delete(FIRST, 1000.0)
    library.refresh(None)
    assert ids(library) == []
    assert places.made_of(FIRST) is None
    assert not list(places.columns.iterdir()), "no empty folders stay"
    (gone,) = folder.bin()
    assert (gone.id, gone.about.title, gone.deleted_s, gone.bytes) == (FIRST, "weg", 1000.0, 100)
    folder.restore(FIRST)
    library.refresh(None)
    assert row_of(library, FIRST).about == About(title="weg", pinned=True)
    assert folder.bin() == []


def test_the_bin_keeps_a_flight_for_thirty_days(places: Places) -> None:
    record(places, FIRST)
    folder = FlightFolder(places)
    folder.delete(FIRST, 1000.0)
    assert folder.purge(1000.0 + KEPT_S - 1) == []
    assert folder.purge(1000.0 + KEPT_S) == [FIRST]
    assert list(places.bin.iterdir()) == []


def test_a_flight_that_began_under_a_wrong_clock_is_filed_under_its_true_time(places: Places) -> None:
    for flight, ahead_s in ((FIRST, 86400.0), (SECOND, 0.0)):
        record(places, flight)
        index(places, flight, clock_ahead_s=ahead_s)
    library = Library(places)
    library.refresh(None)
    assert row_of(library, FIRST).started_s - row_of(library, SECOND).started_s == 86400.0
    assert ids(library, sort="started") == [FIRST, SECOND]


def test_what_was_made_of_a_recording_that_has_gone_goes_too_but_not_when_its_disk_has_gone(places: Places) -> None:
    for flight in (FIRST, SECOND):
        record(places, flight)
        index(places, flight)
        keep_keys(places, flight)
    folder = FlightFolder(places)
    assert folder.drop_orphans() == []
    places.recording(FIRST).unlink()
    assert folder.drop_orphans() == [FIRST]
    assert places.made_of(FIRST) is None
    assert [path.stem for path in places.all_keyframes.iterdir()] == [SECOND]
    away = places.recordings.rename(places.data_dir / "away")
    assert folder.drop_orphans() == []
    away.rename(places.recordings)
    assert places.made_of(SECOND) is not None


def test_the_bytes_of_a_flight_are_those_of_its_columns_and_key_frames_too(places: Places) -> None:
    record(places, FIRST, 100)
    folder = FlightFolder(places)
    assert (folder.used_bytes(), folder.made_bytes(FIRST)) == (100, 0)
    summary = index(places, FIRST) / "summary.json"
    keep_keys(places, FIRST, 1000)
    made = 1000 + summary.stat().st_size
    assert (folder.used_bytes(), folder.made_bytes(FIRST)) == (100 + made, made)
    record(places, SECOND, 30)
    folder.delete(SECOND, 1000.0)
    words = (places.bin / f"{SECOND}.json").stat().st_size
    assert folder.used_bytes() == 100 + made + 30 + words, "the bin is on the disk too"


def keep_keys(places: Places, flight: str, size: int = 10) -> None:
    """Key frames as a replay leaves them."""
    places.all_keyframes.mkdir(exist_ok=True)
    places.keyframes(flight).write_bytes(bytes(size))
