"""Brings a data folder from an earlier format to ours, so that a kill at any moment leaves the old or the new one.

Everything new is written into `.upgrade.new` and synced; one rename to `.upgrade` decides. From then on the files only
have to be put in their places, which is done again from the start if it was interrupted. The files as they were are
kept in a folder `before-format-N-...`, from which `downgrade` puts them back in the same way.
"""

from __future__ import annotations

import json
import os
import shutil
import time
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, Final

from epf_gcs import __version__
from epf_gcs.data_folder.changes import CHANGES, Change
from epf_gcs.data_folder.lock import held
from epf_gcs.data_folder.version import FILE, FORMAT, Format, FormatError, Say, read_format, usable_format, write_format
from epf_gcs.disk import sync_folder

_PREPARED: Final = ".upgrade.new"
_DECIDED: Final = ".upgrade"
_PLAN: Final = "plan.json"
_FILES: Final = "files"
_BEFORE: Final = "before"
KEPT: Final = "before-format-"
_AFTER: Final = "after-format-"


def bring_up_to_date(folder: Path, say: Say) -> None:
    """Before anything else opens the folder: finish what was interrupted, then go from its format to ours.

    Does nothing that waits or writes if the folder is of our format. Raises FormatError with a sentence if the folder
    cannot be used, ConflictError if another process has it, OSError if the disk refuses; the folder is as it was then.
    """
    if not is_interrupted(folder):
        found = usable_format(folder, say)
        if found == Format(FORMAT, __version__):
            return
    with held(folder):
        upgrade(folder, say)


def is_interrupted(folder: Path) -> bool:
    """Whether a change of format was begun in this folder and not finished."""
    return (folder / _DECIDED).exists()


def upgrade(folder: Path, say: Say, changes: Sequence[Change] = CHANGES, to: int = FORMAT) -> None:
    """The same, for the process that has the folder's lock."""
    finish(folder)
    found = usable_format(folder, say)
    if found is None or found.number >= to:
        write_format(folder, to)
        return
    needed = [change for change in changes if found.number < change.to <= to]
    before = _contents(folder, {name for change in needed for name in change.files} | {FILE})
    after = dict(before)
    for change in needed:
        made = change.make({name: after[name] for name in change.files if name in after})
        for name, content in made.items():
            if content is None:
                after.pop(name, None)
            else:
                after[name] = content
    if after == before:
        write_format(folder, to)
        return
    kept = _decide(folder, before, after, to, KEPT)
    finish(folder)
    say(
        f"The data folder {folder} was brought from format {found.number} to {to}. What was changed is kept as it was "
        f"in {folder / kept}; `epf-gcs downgrade` puts it back for an earlier version."
    )


def downgrade(folder: Path) -> tuple[int, str]:
    """Put back what the last upgrade changed; returns the format that the folder has now, and who wrote it.

    The files as they are now are kept, too. Recordings made since then stay. Raises FormatError, ConflictError and
    OSError.
    """
    with held(folder):
        finish(folder)
        copies = sorted(folder.glob(f"{KEPT}*"), key=lambda path: path.name.partition("Z")[0].rpartition("-")[2])
        if not copies:
            raise FormatError(f"No upgrade of {folder} is kept that could be taken back.")
        plan = _plan(copies[-1])
        names = set(plan["names"])
        now = _contents(folder, names)
        earlier = _contents(copies[-1] / _FILES, names)
        number = int(plan["from"])
        _decide(folder, now, earlier, number, _AFTER, written_by=plan["written_by"])
        finish(folder)
        shutil.rmtree(copies[-1])
    return number, str(plan["written_by"])


def finish(folder: Path) -> None:
    """Put what was decided in its place, from wherever it was interrupted; forget what was only prepared."""
    decided = folder / _DECIDED
    if (folder / _PREPARED).exists():
        shutil.rmtree(folder / _PREPARED)
    if not decided.exists():
        return
    plan = _plan(decided)
    for name in plan["put"]:
        source, target = decided / _FILES / name, folder / name
        if source.exists():
            target.parent.mkdir(parents=True, exist_ok=True)
            source.replace(target)
            sync_folder(target.parent)
    for name in plan["gone"]:
        (folder / name).unlink(missing_ok=True)
        sync_folder((folder / name).parent)
    write_format(folder, plan["to"], plan["by"])
    if (decided / _BEFORE).exists():
        (decided / _BEFORE).rename(folder / plan["kept"])
        sync_folder(folder)
    # The plan last: without it nobody would know what the rest is.
    shutil.rmtree(decided / _FILES, ignore_errors=True)
    decided.rename(folder / _PREPARED)
    shutil.rmtree(folder / _PREPARED)


def _decide(
    folder: Path,
    before: Mapping[str, bytes],
    after: Mapping[str, bytes],
    to: int,
    kept: str,
    written_by: str = __version__,
) -> str:
    """Prepare everything beside the files in use, then decide for it by one rename; returns the name of the copies."""
    prepared = folder / _PREPARED
    put = {name: content for name, content in after.items() if before.get(name) != content and name != FILE}
    gone = [name for name in before if name not in after and name != FILE]
    changed = sorted({*put, *gone})
    was = read_format(folder) or Format(to)
    copies = _free_name(folder, f"{kept}{to}-{time.strftime('%Y%m%dT%H%M%SZ', time.gmtime())}")
    try:
        _write_all(prepared / _FILES, put, folder)
        _write_all(prepared / _BEFORE / _FILES, {name: before[name] for name in changed if name in before}, folder)
        copy = {"from": was.number, "written_by": was.written_by, "names": changed}
        _write(prepared / _BEFORE / _PLAN, json.dumps(copy).encode())
        plan = {"put": sorted(put), "gone": gone, "to": to, "by": written_by, "kept": copies}
        _write(prepared / _PLAN, json.dumps(plan).encode())
        for path in [prepared, *prepared.rglob("*")]:
            if path.is_dir():
                sync_folder(path)
        prepared.rename(folder / _DECIDED)
    except BaseException:
        shutil.rmtree(prepared, ignore_errors=True)
        raise
    sync_folder(folder)
    return copies


def _plan(folder: Path) -> dict[str, Any]:
    try:
        found = json.loads((folder / _PLAN).read_bytes())
    except ValueError as error:
        raise FormatError(
            f"A change of the data folder's format was interrupted, and its plan {folder / _PLAN} cannot be read: "
            "restore a backup, or start with another folder by --data-dir."
        ) from error
    return dict(found)


def _free_name(folder: Path, name: str) -> str:
    number = 1
    while (folder / (free := name if number == 1 else f"{name}-{number}")).exists():
        number += 1
    return free


def _contents(folder: Path, names: set[str]) -> dict[str, bytes]:
    return {name: (folder / name).read_bytes() for name in sorted(names) if (folder / name).is_file()}


def _write_all(folder: Path, files: Mapping[str, bytes], rights_of: Path) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    for name, content in files.items():
        _write(folder / name, content, rights_of / name)


def _write(path: Path, content: bytes, rights_of: Path | None = None) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    with path.open("xb") as file:
        if rights_of is not None and rights_of.exists():
            path.chmod(rights_of.stat().st_mode & 0o777)
        file.write(content)
        file.flush()
        os.fsync(file.fileno())
