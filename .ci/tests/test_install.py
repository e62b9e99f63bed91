"""What a lock names is installed with uv, and with pip where uv cannot."""

from __future__ import annotations

import shutil
import subprocess
from pathlib import Path

import pytest

INSTALL = Path(__file__).parents[1] / "install"
LOCK = "backend/requirements.lock"
UV = "uv==2 \\\n    --hash=sha256:1 \\\n    --hash=sha256:2\n"


@pytest.fixture
def tree(tmp_path: Path) -> Path:
    """A checkout whose Python writes down what it is asked for, and whose locks pin uv beside another package."""
    for folder in ("backend", ".make", ".venv/bin"):
        (tmp_path / folder).mkdir(parents=True)
    (tmp_path / "backend/requirements-dev.lock").write_text(
        f"a==1 \\\n    --hash=sha256:0\n{UV}z==3 \\\n    --hash=sha256:3\n"
    )
    program(tmp_path, "python", 0)
    return tmp_path


def program(tree: Path, name: str, code: int) -> None:
    path = tree / ".venv/bin" / name
    path.write_text(f'#!/bin/sh\necho "{name} $*" >>asked\nexit {code}\n')
    path.chmod(0o755)


def installed(tree: Path) -> tuple[list[str], str]:
    """What was asked, and what was said."""
    bash = shutil.which("bash")
    assert bash is not None
    done = subprocess.run([bash, INSTALL, LOCK], cwd=tree, capture_output=True, text=True, check=True)
    return (tree / "asked").read_text().splitlines(), done.stderr


def test_uv_installs_and_every_file_is_held_against_its_hash(tree: Path) -> None:
    program(tree, "uv", 0)
    (asked,), said = installed(tree)
    assert asked.startswith("uv pip install")
    assert "--require-hashes" in asked
    assert asked.endswith(f"-r {LOCK}")
    assert said == ""


def test_where_uv_cannot_pip_installs_the_same_and_it_is_said(tree: Path) -> None:
    program(tree, "uv", 2)
    (_, asked), said = installed(tree)
    assert asked.startswith("python -m pip install")
    assert "--require-hashes" in asked
    assert asked.endswith(f"-r {LOCK}")
    assert "pip does it" in said


def test_uv_itself_is_the_one_that_the_lock_pins_and_is_never_built(tree: Path) -> None:
    # The stand-in for pip brings none: it is as on a machine that uv has no build for.
    (brings_uv, asked), _ = installed(tree)
    assert "--require-hashes --only-binary :all: -r .make/uv.lock" in brings_uv
    assert (tree / ".make/uv.lock").read_text() == UV
    assert asked.endswith(f"-r {LOCK}")
