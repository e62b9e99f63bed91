"""The archive for a computer without internet holds what the lock names for its Pythons, and is the same each time."""

from __future__ import annotations

import sys
import tarfile
from pathlib import Path

import pytest

CI = Path(__file__).parents[1]
ROOT = CI.parent
sys.path.insert(0, str(CI))

import shipped  # noqa: E402
import wheelhouse  # noqa: E402

LOCK = """\
# a comment
jsbsim==1.3.3 \\
    --hash=sha256:1
    # via epf-gcs
numpy==2.4.6 ; python_full_version < '3.12' \\
    --hash=sha256:2 \\
    --hash=sha256:3
numpy==2.5.5 ; python_full_version >= '3.12' \\
    --hash=sha256:4
setuptools==84.2.1 \\
    --hash=sha256:5
uvloop==0.23.0 ; sys_platform != 'win32' \\
    --hash=sha256:6
pywin32==1 ; sys_platform == 'win32' \\
    --hash=sha256:7
"""


def said(chosen: list[wheelhouse.Pin]) -> list[str]:
    return [str(package) for package, _ in chosen]


def test_all_that_the_gateway_needs_is_read_from_the_real_lock() -> None:
    lock = (ROOT / "backend/requirements.lock").read_text(encoding="utf-8")
    named = {package.name for package, _ in wheelhouse.pins(lock)}
    assert {one.name.lower().replace("_", "-") for one in shipped.of_gateway(ROOT)} <= named


def test_each_python_gets_its_own_version_and_nothing_of_another_system() -> None:
    chosen = wheelhouse.wanted(LOCK, "x86_64")
    assert said(wheelhouse.for_python(chosen, "3.11", "x86_64")) == ["jsbsim==1.3.3", "numpy==2.4.6", "uvloop==0.23.0"]
    assert said(wheelhouse.for_python(chosen, "3.13", "x86_64")) == ["jsbsim==1.3.3", "numpy==2.5.5", "uvloop==0.23.0"]


def test_what_has_no_wheel_for_a_processor_is_left_out_there() -> None:
    assert "jsbsim" not in {package.name for package, _ in wheelhouse.wanted(LOCK, "aarch64")}


def test_the_list_of_the_archive_keeps_hashes_and_conditions() -> None:
    text = wheelhouse.text(wheelhouse.wanted(LOCK, "x86_64"))
    assert "    --hash=sha256:2 \\\n    --hash=sha256:3\n" in text
    assert said(list(wheelhouse.pins(text))) == said(wheelhouse.wanted(LOCK, "x86_64"))


def test_without_the_stations_own_wheel_its_name_is_said(tmp_path: Path) -> None:
    with pytest.raises(FileNotFoundError, match=r"epf_gcs-1\.0"):
        wheelhouse.own_wheel(tmp_path, "1.0", "x86_64")


def test_two_archives_of_one_folder_are_equal_whoever_made_its_files_and_when(tmp_path: Path) -> None:
    made = []
    for number, names in enumerate((("a.whl", "b.whl"), ("b.whl", "a.whl"))):
        folder = tmp_path / str(number)
        folder.mkdir()
        for name in names:
            (folder / name).write_text(name)
            (folder / name).chmod(0o600 + number * 0o44)
        wheelhouse.pack(folder, "wheels", tmp_path / f"{number}.tar", 1_800_000_000)
        made.append((tmp_path / f"{number}.tar").read_bytes())
    assert made[0] == made[1]
    with tarfile.open(tmp_path / "0.tar") as packed:
        assert packed.getnames() == ["wheels/a.whl", "wheels/b.whl"]
