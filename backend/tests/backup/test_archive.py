"""A backup holds what cannot be made again, and is proven whole before anything is replaced."""

from __future__ import annotations

import errno
import os
import shutil
import sqlite3
import stat
import tarfile
from contextlib import closing
from pathlib import Path

import pytest

from epf_gcs.backup.archive import FILTER, LIST, backup, is_encrypted, restore
from epf_gcs.backup.errors import BackupError
from epf_gcs.data_folder.version import FORMAT, Format, read_format, write_format


def quiet(_name: str) -> None:
    pass


PASSWORD = "correct horse"  # noqa: S105


@pytest.fixture(autouse=True)
def little_work(monkeypatch: pytest.MonkeyPatch) -> None:
    """So that a password costs a millisecond."""
    monkeypatch.setattr("epf_gcs.backup.age_archive.WORK", 10)


@pytest.fixture
def data(tmp_path: Path) -> Path:
    folder = tmp_path / "data"
    for name, text in {
        "recordings/20260131T120000Z.mcap": "bytes of a flight" * 1000,
        "recordings/20260131T120000Z.json": '{"title": "first"}',
        "state.json": "{}",
        "columns/made-again.parquet": "x",
        "logs/gateway.log": "x",
        "library.sqlite": "x",
        ".lock": "77",
    }.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
    with closing(sqlite3.connect(folder / "access.sqlite")) as store:
        store.execute("create table people (name text)")
        store.execute("insert into people values ('Ana')")
        store.commit()
    (folder / "access.sqlite").chmod(0o600)
    return folder


def files(folder: Path) -> dict[str, bytes]:
    return {
        path.relative_to(folder).as_posix(): path.read_bytes() for path in sorted(folder.rglob("*")) if path.is_file()
    }


def test_what_comes_back_is_what_was_there_but_for_what_is_made_again(data: Path, tmp_path: Path) -> None:
    kept = tmp_path / "station.tar"
    assert backup(data, kept, quiet) == 4
    other = tmp_path / "other" / "data"
    assert restore(kept, other, quiet) is None
    back = files(other)
    assert set(back) == {
        "recordings/20260131T120000Z.mcap",
        "recordings/20260131T120000Z.json",
        "state.json",
        "access.sqlite",
    }
    assert back["recordings/20260131T120000Z.mcap"] == (data / "recordings/20260131T120000Z.mcap").read_bytes()
    assert (other / "access.sqlite").stat().st_mode & 0o077 == 0, "keys stay private"
    with closing(sqlite3.connect(other / "access.sqlite")) as store:
        assert store.execute("select name from people").fetchall() == [("Ana",)]


def test_a_backup_holds_private_keys_and_is_read_by_nobody_else_whatever_the_habit_of_the_shell(
    data: Path, tmp_path: Path
) -> None:
    before = os.umask(0)
    try:
        backup(data, tmp_path / "station.tar", quiet)
    finally:
        os.umask(before)
    assert stat.S_IMODE((tmp_path / "station.tar").stat().st_mode) == 0o600


def test_a_database_in_the_middle_of_a_change_is_kept_as_it_was_before(data: Path, tmp_path: Path) -> None:
    with closing(sqlite3.connect(data / "access.sqlite", isolation_level=None)) as store:
        store.execute("begin immediate")
        store.execute("insert into people values ('half')")
        backup(data, tmp_path / "station.tar", quiet)
        store.execute("rollback")
    restore(tmp_path / "station.tar", tmp_path / "back", quiet)
    with closing(sqlite3.connect(tmp_path / "back" / "access.sqlite")) as store:
        assert store.execute("select name from people").fetchall() == [("Ana",)]


def test_the_folder_that_was_there_is_kept_beside_the_restored_one(data: Path, tmp_path: Path) -> None:
    backup(data, tmp_path / "station.tar", quiet)
    (data / "state.json").write_text('{"newer": true}')
    kept = restore(tmp_path / "station.tar", data, quiet)
    assert kept is not None
    assert (kept / "state.json").read_text() == '{"newer": true}'
    assert (data / "state.json").read_text() == "{}"


@pytest.mark.parametrize("share", [0.0, 0.2, 0.5, 0.9, 0.999])
def test_a_backup_that_was_cut_off_changes_nothing(data: Path, tmp_path: Path, share: float) -> None:
    kept = tmp_path / "station.tar"
    backup(data, kept, quiet)
    whole = kept.read_bytes()
    # A tar archive ends in zeros, which nobody misses.
    kept.write_bytes(whole[: int(len(whole.rstrip(b"\0")) * share)])
    before = files(data)
    with pytest.raises(BackupError, match="not a whole backup"):
        restore(kept, data, quiet)
    assert files(data) == before
    assert [path.name for path in tmp_path.iterdir() if path.name.startswith(".")] == []


def test_a_changed_byte_is_found(data: Path, tmp_path: Path) -> None:
    kept = tmp_path / "station.tar"
    backup(data, kept, quiet)
    kept.write_bytes(kept.read_bytes().replace(b"bytes of a flight", b"bytes of a fright", 1))
    with pytest.raises(BackupError, match="is damaged"):
        restore(kept, data, quiet)


@pytest.mark.parametrize("known", [FILTER, {}], ids=["with Python's filter", "as in Python 3.11.2"])
@pytest.mark.parametrize("name", ["../outside", "/tmp/outside-of-the-station"])  # noqa: S108
def test_a_stranger_s_archive_writes_nothing_outside_the_folder(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, name: str, known: dict[str, str]
) -> None:
    monkeypatch.setattr("epf_gcs.backup.archive.FILTER", known)
    evil = tmp_path / "evil.tar"
    (tmp_path / "source").write_text("x")
    with tarfile.open(evil, "w") as archive:
        archive.add(tmp_path / "source", arcname=name)
        archive.add(tmp_path / "source", arcname=LIST)
    with pytest.raises(BackupError, match="not a whole backup"):
        restore(evil, tmp_path / "data", quiet)
    assert sorted(path.name for path in tmp_path.iterdir()) == ["evil.tar", "source"]
    assert not Path("/tmp/outside-of-the-station").exists()  # noqa: S108


def test_links_in_an_archive_are_refused(tmp_path: Path) -> None:
    evil = tmp_path / "evil.tar"
    with tarfile.open(evil, "w") as archive:
        entry = tarfile.TarInfo("recordings")
        entry.type, entry.linkname = tarfile.SYMTYPE, "/etc"
        archive.addfile(entry)
    with pytest.raises(BackupError, match="is no file"):
        restore(evil, tmp_path / "data", quiet)


def test_an_earlier_backup_is_not_written_over(data: Path, tmp_path: Path) -> None:
    (tmp_path / "station.tar").write_text("the earlier one")
    with pytest.raises(BackupError, match="is there already"):
        backup(data, tmp_path / "station.tar", quiet)
    assert (tmp_path / "station.tar").read_text() == "the earlier one"


def test_a_backup_of_a_newer_version_is_refused_and_nothing_changes(data: Path, tmp_path: Path) -> None:
    write_format(data, FORMAT + 1, "9.0.0")
    backup(data, tmp_path / "station.tar", quiet)
    write_format(data, FORMAT)
    before = files(data)
    with pytest.raises(BackupError, match=r"epf-gcs 9.0.0 .format"):
        restore(tmp_path / "station.tar", data, quiet)
    assert files(data) == before


def test_a_backup_of_an_older_version_comes_back_as_it_was(data: Path, tmp_path: Path) -> None:
    backup(data, tmp_path / "station.tar", quiet)
    write_format(data, FORMAT)
    restore(tmp_path / "station.tar", data, quiet)
    assert read_format(data) == Format(1)


def test_an_interrupted_change_of_format_is_not_kept_as_if_it_were_whole(data: Path, tmp_path: Path) -> None:
    (data / ".upgrade").mkdir()
    with pytest.raises(BackupError, match="was interrupted"):
        backup(data, tmp_path / "station.tar", quiet)
    assert not (tmp_path / "station.tar").exists()


def test_what_is_kept_with_a_password_comes_back_with_it_alone(data: Path, tmp_path: Path) -> None:
    kept = tmp_path / "station.tar.age"
    assert backup(data, kept, quiet, PASSWORD) == 4
    assert is_encrypted(kept)
    assert b"bytes of a flight" not in kept.read_bytes()
    assert stat.S_IMODE(kept.stat().st_mode) == 0o600
    before = files(data)
    with pytest.raises(BackupError, match="password is wrong"):
        restore(kept, data, quiet, "another horse")
    with pytest.raises(BackupError, match="give its password"):
        restore(kept, data, quiet)
    assert files(data) == before
    restore(kept, tmp_path / "back", quiet, PASSWORD)
    assert files(tmp_path / "back")["recordings/20260131T120000Z.mcap"] == b"bytes of a flight" * 1000


@pytest.mark.parametrize("missing", [1, 17, 1000, 20_000])
def test_an_encrypted_backup_that_was_cut_off_changes_nothing(data: Path, tmp_path: Path, missing: int) -> None:
    kept = tmp_path / "station.tar.age"
    (data / "recordings/long.mcap").write_bytes(os.urandom(200_000))
    backup(data, kept, quiet, PASSWORD)
    kept.write_bytes(kept.read_bytes()[:-missing])
    before = files(data)
    with pytest.raises(BackupError, match="cut off or damaged"):
        restore(kept, data, quiet, PASSWORD)
    assert files(data) == before
    assert [path.name for path in tmp_path.iterdir() if path.name.startswith(".")] == []


def test_a_backup_for_which_the_disk_is_too_small_is_not_begun(
    data: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(shutil, "disk_usage", lambda _folder: shutil._ntuple_diskusage(10_000, 1, 9_999))
    with pytest.raises(BackupError, match="needs 0 MB, and the disk"):
        backup(data, tmp_path / "station.tar", quiet)
    assert sorted(path.name for path in tmp_path.iterdir()) == ["data"]


@pytest.mark.parametrize("password", [None, PASSWORD])
def test_of_a_backup_that_fills_the_disk_nothing_stays(
    data: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, password: str | None
) -> None:
    def full(_descriptor: int) -> None:
        raise OSError(errno.ENOSPC, "No space left on device")

    monkeypatch.setattr(os, "fsync", full)
    with pytest.raises(BackupError, match="is full: nothing was made"):
        backup(data, tmp_path / "station.tar", quiet, password)
    assert sorted(path.name for path in tmp_path.iterdir()) == ["data"]
