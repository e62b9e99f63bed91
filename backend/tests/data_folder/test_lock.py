"""A data folder belongs to one process at a time."""

from __future__ import annotations

import os
import stat
import subprocess
import sys
from pathlib import Path

import pytest

from epf_gcs.data_folder.lock import FORMAT_FILE, STATION, WEB, DataFolder, is_in_use
from epf_gcs.data_folder.whereabouts import Whereabouts, held_by_launcher, leave
from epf_gcs.errors import ConflictError

HOLDER = """
import sys
from pathlib import Path
from epf_gcs.data_folder.lock import DataFolder
folder = DataFolder(Path(sys.argv[1]))
print("held", flush=True)
sys.stdin.read()
"""


def test_a_second_process_is_told_who_has_it(tmp_path: Path) -> None:
    with subprocess.Popen(
        [sys.executable, "-c", HOLDER, str(tmp_path)], stdin=subprocess.PIPE, stdout=subprocess.PIPE
    ) as holder:
        assert holder.stdout is not None
        assert holder.stdout.readline() == b"held\n"
        with pytest.raises(ConflictError) as taken:
            DataFolder(tmp_path)
        assert (taken.value.code, taken.value.params["pid"]) == ("data_folder_taken", str(holder.pid))
        assert str(holder.pid) in taken.value.detail
        holder.kill()
        holder.wait()
        with DataFolder(tmp_path):
            pass


def test_a_folder_that_is_not_there_is_made_and_can_be_had_again_after_the_end(tmp_path: Path) -> None:
    folder = tmp_path / "deep" / "data"
    with DataFolder(folder), pytest.raises(ConflictError, match=str(os.getpid())):
        DataFolder(folder)
    with DataFolder(folder):
        assert (folder / ".lock").read_text() == f"{os.getpid()}\n"


def test_our_own_folder_is_closed_to_all_others_from_then_on(tmp_path: Path) -> None:
    folder = tmp_path / "data"
    folder.mkdir()
    folder.chmod(0o755)
    with DataFolder(folder):
        assert stat.S_IMODE(folder.stat().st_mode) == 0o755, "it may be anything that somebody named"
    (folder / FORMAT_FILE).write_text("{}")
    with DataFolder(folder):
        assert stat.S_IMODE(folder.stat().st_mode) == 0o700
        assert stat.S_IMODE((folder / ".lock").stat().st_mode) == 0o600


def test_files_of_an_earlier_version_lose_the_rights_of_others_and_nothing_behind_a_link_does(tmp_path: Path) -> None:
    folder, foreign = tmp_path / "data", tmp_path / "foreign"
    (folder / "recordings").mkdir(parents=True)
    for path in (folder / FORMAT_FILE, folder / "recordings" / "a.mcap", foreign):
        path.write_text("{}")
        path.chmod(0o644)
    (folder / "recordings").chmod(0o755)
    (folder / "recordings" / "link.mcap").symlink_to(foreign)
    with held_by_launcher(folder):
        assert stat.S_IMODE((folder / FORMAT_FILE).stat().st_mode) == 0o600
        assert stat.S_IMODE((folder / "recordings").stat().st_mode) == 0o700
        assert stat.S_IMODE((folder / "recordings" / "a.mcap").stat().st_mode) == 0o600
        assert stat.S_IMODE(foreign.stat().st_mode) == 0o644


def test_a_web_process_alone_keeps_a_second_one_out_and_counts_as_a_station(tmp_path: Path) -> None:
    with DataFolder(tmp_path, WEB):
        with pytest.raises(ConflictError):
            DataFolder(tmp_path, WEB)
        assert is_in_use(tmp_path)
        with pytest.raises(ConflictError):
            held_by_launcher(tmp_path, patience_s=0.0)
        with DataFolder(tmp_path):
            """The flight process has a lock of its own."""
    with held_by_launcher(tmp_path, patience_s=0.0), pytest.raises(ConflictError):
        held_by_launcher(tmp_path, patience_s=0.0)


def test_a_second_launcher_is_told_at_once_at_which_port_the_first_one_is(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def wait(_: float) -> None:
        raise AssertionError("there is nothing to wait for")

    with DataFolder(tmp_path, STATION), DataFolder(tmp_path, WEB):
        leave(tmp_path, Whereabouts("127.0.0.1", 8123, tls=False))
        monkeypatch.setattr("epf_gcs.data_folder.lock.time.sleep", wait)
        with pytest.raises(ConflictError, match=f"process {os.getpid()}, TCP port 8123") as taken:
            held_by_launcher(tmp_path)
    assert (taken.value.code, taken.value.params["port"]) == ("data_folder_taken", 8123)


def test_one_that_was_killed_leaves_no_port_that_counts(tmp_path: Path) -> None:
    leave(tmp_path, Whereabouts("127.0.0.1", 8123, tls=False))
    with DataFolder(tmp_path, STATION), pytest.raises(ConflictError) as taken:
        held_by_launcher(tmp_path, patience_s=0.0)
    assert "port" not in taken.value.params


def test_the_number_of_one_before_with_more_digits_leaves_nothing_behind(tmp_path: Path) -> None:
    (tmp_path / ".lock").write_text("123456789012345\n")
    with DataFolder(tmp_path):
        assert (tmp_path / ".lock").read_text() == f"{os.getpid()}\n"
