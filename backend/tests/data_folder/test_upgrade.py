"""A data folder of an earlier format becomes one of ours whole, or stays what it was, whenever the power goes."""

from __future__ import annotations

import errno
import json
import os
import signal
import sys
from collections.abc import Callable
from functools import partial
from pathlib import Path

import pytest

from epf_gcs import __version__
from epf_gcs.data_folder import changes, version
from epf_gcs.data_folder.changes import Change, Changed, Files
from epf_gcs.data_folder.lock import DataFolder, held
from epf_gcs.data_folder.upgrade import bring_up_to_date, downgrade, finish, is_interrupted, upgrade
from epf_gcs.data_folder.version import FILE, FORMAT, FormatError, read_format, write_format
from epf_gcs.errors import ConflictError

Tree = dict[str, bytes]


def tree(folder: Path, *but: str) -> Tree:
    return {
        path.relative_to(folder).as_posix(): path.read_bytes()
        for path in sorted(folder.rglob("*"))
        if path.is_file() and path.relative_to(folder).parts[0] not in (".lock", *but)
    }


def quiet(_said: str) -> None:
    pass


def second(files: Files) -> Changed:
    """Changes one file, makes one, removes one."""
    return {"state.json": files["state.json"].upper(), "deep/new.json": b"made", "gone.json": None}


CHANGES = (Change(2, ("state.json", "gone.json", "deep/new.json"), second),)


@pytest.fixture
def data(tmp_path: Path) -> Path:
    folder = tmp_path / "data"
    (folder / "recordings").mkdir(parents=True)
    (folder / "recordings" / "20260131T120000Z.mcap").write_bytes(b"bytes of a flight")
    (folder / "state.json").write_bytes(b'{"board_url": "tcp://h:1"}')
    (folder / "state.json").chmod(0o600)
    (folder / "gone.json").write_bytes(b"{}")
    return folder


OLD: Tree = {
    "recordings/20260131T120000Z.mcap": b"bytes of a flight",
    "state.json": b'{"board_url": "tcp://h:1"}',
    "gone.json": b"{}",
}
NEW: Tree = {
    "recordings/20260131T120000Z.mcap": b"bytes of a flight",
    "state.json": b'{"BOARD_URL": "TCP://H:1"}',
    "deep/new.json": b"made",
}


def of_format(folder: Path) -> int | None:
    found = read_format(folder)
    return None if found is None else found.number


def kept_copies(folder: Path) -> list[str]:
    return [path.name for path in folder.iterdir() if path.name.startswith("before-format-")]


def test_everything_changes_and_what_was_is_kept(data: Path) -> None:
    said: list[str] = []
    upgrade(data, said.append, CHANGES, 2)
    (kept,) = kept_copies(data)
    assert tree(data, FILE, kept) == NEW
    assert json.loads((data / FILE).read_bytes()) == {"format": 2, "epf_gcs": __version__}
    assert tree(data / kept / "files") == {name: OLD[name] for name in ("state.json", "gone.json")}
    assert kept in said[0]
    assert (data / "state.json").stat().st_mode & 0o777 == 0o600, "rights stay"
    assert (data / kept / "files" / "state.json").stat().st_mode & 0o777 == 0o600


def test_what_was_changed_can_be_put_back_and_what_came_since_stays(data: Path) -> None:
    upgrade(data, quiet, CHANGES, 2)
    (data / "recordings" / "20260201T120000Z.mcap").write_bytes(b"a later flight")
    assert downgrade(data) == (1, "")
    (after,) = [path.name for path in data.iterdir() if path.name.startswith("after-format-1-")]
    assert tree(data, FILE, after) == {**OLD, "recordings/20260201T120000Z.mcap": b"a later flight"}
    assert of_format(data) == 1
    upgrade(data, quiet, CHANGES, 2)
    assert (data / "state.json").read_bytes() == NEW["state.json"]


def test_without_a_copy_there_is_nothing_to_put_back(data: Path) -> None:
    with pytest.raises(FormatError, match="No upgrade"):
        downgrade(data)


def test_a_new_folder_is_of_our_format(tmp_path: Path) -> None:
    bring_up_to_date(tmp_path / "new", quiet)
    assert of_format(tmp_path / "new") == FORMAT
    assert kept_copies(tmp_path / "new") == []


def test_where_nothing_has_to_change_nothing_is_kept_or_said(data: Path) -> None:
    said: list[str] = []
    upgrade(data, said.append, (Change(2, ("state.json",), lambda _files: {}),), 2)
    assert (of_format(data), kept_copies(data), said) == (2, [], [])


def test_what_the_launcher_made_is_no_earlier_folder(tmp_path: Path) -> None:
    for name in ("logs", "card", "run.lock"):
        (tmp_path / name).mkdir()
    assert read_format(tmp_path) is None


def test_a_folder_of_our_format_is_not_written_to(tmp_path: Path) -> None:
    bring_up_to_date(tmp_path, quiet)
    with DataFolder(tmp_path):  # as while the station runs
        before = (tmp_path / FILE).stat().st_mtime_ns
        bring_up_to_date(tmp_path, quiet)
    assert (tmp_path / FILE).stat().st_mtime_ns == before


def test_a_folder_in_use_is_left_alone(data: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("epf_gcs.data_folder.upgrade.held", partial(held, patience_s=0.0))
    with DataFolder(data), pytest.raises(ConflictError):
        bring_up_to_date(data, quiet)
    assert tree(data) == OLD


def test_a_newer_folder_is_refused_with_its_version_and_nothing_changes(data: Path) -> None:
    write_format(data, FORMAT + 1, "9.1.0")
    before = tree(data)
    with pytest.raises(FormatError, match=f"epf-gcs 9.1.0 .format {FORMAT + 1}.*Nothing was changed"):
        bring_up_to_date(data, quiet)
    assert tree(data) == before


@pytest.mark.parametrize("content", [b"", b"{", b"[]", b"{}", b'{"format": "2"}', b'{"format": 0}', b"\xff"])
def test_a_damaged_format_file_is_kept_aside_and_told_and_the_folder_counts_as_ours(data: Path, content: bytes) -> None:
    (data / FILE).write_bytes(content)
    said: list[str] = []
    bring_up_to_date(data, said.append)
    (aside,) = data.glob(f"{FILE}.damaged-*")
    assert aside.read_bytes() == content
    assert aside.name in said[0]
    assert of_format(data) == FORMAT
    assert (data / "state.json").read_bytes() == OLD["state.json"]


def _interrupted(folder: Path, at: int, how: Callable[[], None], work: Callable[[Path], object]) -> int:
    """Do the work in a child process that is stopped before its operation number `at` on the disk; its exit status."""
    child = os.fork()
    if child:
        return os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])
    count = 0
    inside = str(folder)

    def before_each(event: str, arguments: tuple[object, ...]) -> None:
        nonlocal count
        writes = event in ("os.rename", "os.remove", "os.mkdir", "os.rmdir", "os.chmod") or (
            event == "open" and isinstance(arguments[2], int) and arguments[2] & (os.O_WRONLY | os.O_RDWR)
        )
        # What removes a whole folder names its files without it.
        if writes and (event in ("os.remove", "os.rmdir") or inside in str(arguments[0])):
            count += 1
            if count > at:
                how()

    try:
        sys.addaudithook(before_each)
        work(folder)
    except OSError as error:
        os._exit(3 if error.errno == errno.ENOSPC else 4)
    except BaseException:  # noqa: BLE001 - the child of a test must never return into it
        os._exit(5)
    os._exit(0)


def _killed() -> None:
    os.kill(os.getpid(), signal.SIGKILL)


def _full() -> None:
    raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))


@pytest.mark.filterwarnings("ignore:This process:DeprecationWarning")
def test_killed_before_any_operation_it_is_the_old_or_the_new_folder(tmp_path: Path) -> None:
    seen, at = set(), 0
    while True:
        folder = _fresh(tmp_path / str(at))
        code = _interrupted(folder, at, _killed, lambda one: upgrade(one, quiet, CHANGES, 2))
        if code == 0:
            break
        assert code == -signal.SIGKILL
        was_interrupted = is_interrupted(folder)
        finish(folder)
        number = of_format(folder)
        seen.add((was_interrupted, number))
        assert tree(folder, FILE, *kept_copies(folder)) == (OLD if number == 1 else NEW), f"killed at {at}"
        upgrade(folder, quiet, CHANGES, 2)
        (kept,) = kept_copies(folder)
        assert tree(folder, FILE, kept) == NEW, f"killed at {at}"
        assert tree(folder / kept / "files") == {name: OLD[name] for name in ("state.json", "gone.json")}
        at += 1
    assert at > 15
    assert seen == {(False, 1), (True, 2), (False, 2)}


@pytest.mark.filterwarnings("ignore:This process:DeprecationWarning")
def test_killed_on_the_way_back_it_is_the_one_or_the_other(tmp_path: Path) -> None:
    at = 0
    while True:
        folder = _fresh(tmp_path / str(at))
        upgrade(folder, quiet, CHANGES, 2)
        code = _interrupted(folder, at, _killed, downgrade)
        finish(folder)
        copies = [path.name for path in folder.iterdir() if path.name.startswith(("before-", "after-"))]
        assert tree(folder, FILE, *copies) == (OLD if of_format(folder) == 1 else NEW), f"killed at {at}"
        if code == 0:
            break
        at += 1
    assert of_format(folder) == 1


@pytest.mark.filterwarnings("ignore:This process:DeprecationWarning")
def test_a_disk_that_fills_up_leaves_a_folder_that_the_next_start_can_use(tmp_path: Path) -> None:
    at = 0
    while True:
        folder = _fresh(tmp_path / str(at))
        code = _interrupted(folder, at, _full, lambda one: upgrade(one, quiet, CHANGES, 2))
        if code == 0:
            break
        assert code == 3, f"full at {at}"
        finish(folder)
        number = of_format(folder)
        assert tree(folder, FILE, *kept_copies(folder)) == (OLD if number == 1 else NEW), f"full at {at}"
        upgrade(folder, quiet, CHANGES, 2)
        assert tree(folder, FILE, *kept_copies(folder)) == NEW
        at += 1
    assert at > 10


def _fresh(folder: Path) -> Path:
    for name, content in OLD.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_bytes(content)
    return folder


def test_a_damaged_plan_is_told_and_nothing_is_changed(data: Path) -> None:
    (data / ".upgrade").mkdir()
    (data / ".upgrade" / "plan.json").write_text("{")
    with pytest.raises(FormatError, match=r"cannot be read"):
        bring_up_to_date(data, quiet)
    assert tree(data, ".upgrade") == OLD


def test_our_number_is_that_of_the_last_change() -> None:
    assert [change.to for change in changes.CHANGES] == list(range(2, version.FORMAT + 1))
