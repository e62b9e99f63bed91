"""The import rules hold, and they bite: a forbidden import in a copy of the tree breaks them."""

from __future__ import annotations

import ast
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from tests.support.waiting import DEADLINE_S

BACKEND = Path(__file__).parents[1]


def lint(folder: Path) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [str(Path(sys.executable).with_name("lint-imports")), "--no-cache"],
        cwd=folder,
        env={"PYTHONPATH": str(folder / "src"), "PATH": "/usr/bin:/bin"},
        capture_output=True,
        text=True,
        timeout=DEADLINE_S,
        check=False,
    )


@pytest.fixture
def copy(tmp_path: Path) -> Path:
    shutil.copytree(BACKEND / "src", tmp_path / "src", ignore=shutil.ignore_patterns("__pycache__", "*.egg-info"))
    shutil.copy(BACKEND / "pyproject.toml", tmp_path)
    return tmp_path


def test_the_tree_keeps_its_rules() -> None:
    answer = lint(BACKEND)
    assert answer.returncode == 0, answer.stdout
    assert "0 broken" in answer.stdout


@pytest.mark.parametrize(
    ("file", "line"),
    [
        ("codec/checksum.py", "import asyncio"),
        ("codec/checksum.py", "import time"),
        ("xplane/datagram.py", "import socket"),
        ("link/tcp.py", "from epf_gcs.vehicle import health"),
        ("vehicle/health.py", "from epf_gcs.flight import memory"),
        ("formats/kml.py", "import pathlib"),
        ("formats/kml.py", "import time"),
        ("formats/kml.py", "from epf_gcs.vehicle import health"),
        ("clock.py", "from epf_gcs.web import schemas"),
        ("flight/memory/memory.py", "import epf_gcs.simulator"),
        ("simulator/__init__.py", "from epf_gcs.flight import memory"),
        ("launcher/__init__.py", "import epf_gcs.web"),
        ("maps/layer.py", "import fastapi"),
        ("access/roles.py", "from epf_gcs.web.stream import hub"),
        ("web/stream/viewer.py", "from epf_gcs.web.interface import deps"),
        ("flight/board/commands.py", "from epf_gcs.flight.state import status"),
    ],
)
def test_a_forbidden_import_breaks_them(copy: Path, file: str, line: str) -> None:
    path = copy / "src" / "epf_gcs" / file
    path.write_text(f"{path.read_text()}\n{line}\n")
    answer = lint(copy)
    assert answer.returncode != 0, answer.stdout
    assert "BROKEN" in answer.stdout


def test_a_folder_without_a_place_in_the_layers_breaks_them(copy: Path) -> None:
    (copy / "src" / "epf_gcs" / "misc").mkdir()
    (copy / "src" / "epf_gcs" / "misc" / "__init__.py").write_text("")
    assert lint(copy).returncode != 0


def test_no_hand_written_file_grows_beyond_what_one_reads_at_once() -> None:
    root = BACKEND.parent
    folders = (BACKEND / "src", root / "firmware" / "src", root / "firmware" / "ports", root / "firmware" / "tools")
    files = [file for folder in folders for kind in ("*.py", "*.c", "*.h") for file in folder.rglob(kind)]
    assert len(files) > 300
    long = {
        str(file.relative_to(root)): lines
        for file in files
        if "_gen." not in file.name and (lines := len(file.read_text().splitlines())) > 350
    }
    assert long == {}


def test_no_constructor_asks_for_more_than_seven_things_or_five_by_position() -> None:
    """What belongs together is one value, and what could be mistaken for another is given by name."""
    constructors = [
        (node.name, method.args)
        for file in (BACKEND / "src").rglob("*.py")
        for node in ast.walk(ast.parse(file.read_text()))
        if isinstance(node, ast.ClassDef)
        for method in node.body
        if isinstance(method, ast.FunctionDef) and method.name == "__init__"
    ]
    assert len(constructors) > 200
    counts = {name: (len(args.posonlyargs + args.args) - 1, len(args.kwonlyargs)) for name, args in constructors}
    assert {name: count for name, count in counts.items() if count[0] > 5 or sum(count) > 7} == {}


def test_few_things_pass_inside_as_dictionaries_of_anything() -> None:
    """Facts of the project have types; what is left is JSON of others, and what frameworks hand over."""
    found = {
        str(file.relative_to(BACKEND)): len(re.findall(r"(?:dict|Mapping)\[str, Any\]", file.read_text()))
        for file in (BACKEND / "src").rglob("*.py")
    }
    assert sum(found.values()) < 100, {name: count for name, count in found.items() if count}
