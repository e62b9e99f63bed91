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


def copy_to(folder: Path) -> Path:
    shutil.copytree(BACKEND / "src", folder / "src", ignore=shutil.ignore_patterns("__pycache__", "*.egg-info"))
    shutil.copy(BACKEND / "pyproject.toml", folder)
    return folder / "src" / "epf_gcs"


FORBIDDEN = [
    ("codec.checksum", "asyncio"),
    ("codec.checksum", "time"),
    ("xplane.datagram", "socket"),
    ("link.tcp", "epf_gcs.vehicle.health"),
    ("vehicle.health", "epf_gcs.flight.memory"),
    ("formats.kml", "pathlib"),
    ("formats.kml", "time"),
    ("formats.kml", "epf_gcs.vehicle.health"),
    ("clock", "epf_gcs.web"),
    ("flight.memory.memory", "epf_gcs.simulator"),
    ("simulator.link", "epf_gcs.flight.memory"),
    ("launcher.ports", "epf_gcs.web"),
    ("maps.layer", "fastapi"),
    ("access.roles", "epf_gcs.web.stream.hub"),
    ("web.stream.viewer", "epf_gcs.web.interface.deps"),
    ("flight.board.commands", "epf_gcs.flight.state.status"),
]


@pytest.fixture(scope="module")
def broken(tmp_path_factory: pytest.TempPathFactory) -> str:
    """What is said of a copy of the tree with all of the forbidden imports."""
    package = copy_to(tmp_path_factory.mktemp("broken"))
    for module, target in FORBIDDEN:
        path = package.joinpath(*module.split(".")).with_suffix(".py")
        path.write_text(f"{path.read_text()}\nimport {target}\n")
    answer = lint(package.parents[1])
    assert answer.returncode != 0
    return answer.stdout


def test_the_tree_keeps_its_rules() -> None:
    answer = lint(BACKEND)
    assert answer.returncode == 0, answer.stdout
    assert "0 broken" in answer.stdout


@pytest.mark.parametrize(("module", "target"), FORBIDDEN)
def test_a_forbidden_import_is_found(broken: str, module: str, target: str) -> None:
    assert re.search(rf"epf_gcs\.{re.escape(module)} -> {re.escape(target)} \(l\.", broken), broken


def test_a_folder_without_a_place_in_the_layers_is_found(tmp_path: Path) -> None:
    package = copy_to(tmp_path)
    (package / "misc").mkdir()
    (package / "misc" / "__init__.py").write_text("")
    assert lint(tmp_path).returncode != 0


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
