"""What a machine is asked for is what the packages ask for, and each lack is one sentence."""

from __future__ import annotations

import json
import re
import shutil
import subprocess
import tomllib
from pathlib import Path

import pytest

CI = Path(__file__).parents[1]
ROOT = CI.parent
WANTED = re.compile(r">=(\d+)\.(\d+)(?:\.0)?")


def wanted(text: str) -> tuple[int, int]:
    found = WANTED.fullmatch(text)
    assert found is not None, text
    return int(found[1]), int(found[2])


def node_wanted(package: str) -> tuple[int, int]:
    return wanted(json.loads((ROOT / package / "package.json").read_text())["engines"]["node"])


def said(folder: Path, node: tuple[int, int], python_is_too_old: int = 0) -> list[str]:
    """What is said on a machine whose programs answer like this."""
    major, minor = node
    answers = {
        # It is asked for its number with a program of its own language, and for its name to be told.
        "node": f'if [ "$1" = -p ]; then echo {major * 100 + minor}; else echo v{major}.{minor}.0; fi',
        "npm": "true",
        "cc": "true",
        "make": "true",
        "python3": f'case "$2" in *version_info*) exit {python_is_too_old};; esac; [ "$1" != -V ] || echo Python',
    }
    for name, answer in answers.items():
        (folder / name).write_text(f"#!/bin/sh\n{answer}\n")
        (folder / name).chmod(0o755)
    bash = shutil.which("bash")
    assert bash is not None
    done = subprocess.run(
        [bash, CI / "require"], env={"PATH": str(folder)}, capture_output=True, text=True, check=False
    )
    lines = done.stderr.splitlines()
    assert done.returncode == (1 if lines else 0)
    return lines


def test_page_and_journeys_ask_for_the_same_node() -> None:
    assert node_wanted("frontend") == node_wanted("e2e")


def test_the_least_node_will_do(tmp_path: Path) -> None:
    assert said(tmp_path, node_wanted("frontend")) == []


@pytest.mark.parametrize("newer", [22, 24])
def test_a_newer_node_will_do(tmp_path: Path, newer: int) -> None:
    assert said(tmp_path, (newer, 0)) == []


def test_an_older_node_is_named(tmp_path: Path) -> None:
    major, minor = node_wanted("frontend")
    assert said(tmp_path, (major, minor - 1)) == [
        f"make: Node {major}.{minor} or newer is needed and this is v{major}.{minor - 1}.0: install a newer one."
    ]


def test_python_is_asked_for_as_the_package_asks(tmp_path: Path) -> None:
    project = tomllib.loads((ROOT / "backend" / "pyproject.toml").read_text())["project"]
    major, minor = wanted(project["requires-python"])
    (line,) = said(tmp_path, node_wanted("frontend"), python_is_too_old=1)
    assert line.startswith(f"make: Python {major}.{minor} or newer is needed")
    assert f"({major}, {minor})" in (CI / "require").read_text()
