"""The page and the board's program are found in an installed package, and in a source tree."""

from __future__ import annotations

import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from epf_gcs.product import BOARD, PAGE

BACKEND = Path(__file__).parents[1]
ASK = "from epf_gcs.product import BOARD, PAGE; print(PAGE.file('index.html')); print(BOARD.file('posix/epf-board'))"


def put(folder: Path, *names: str) -> None:
    for name in names:
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(name)


def package_in(folder: Path) -> Path:
    """A copy of the package's root, without anything that was built."""
    package = folder / "epf_gcs"
    package.mkdir(parents=True)
    for name in ("__init__.py", "product.py"):
        shutil.copy(BACKEND / "src" / "epf_gcs" / name, package)
    return package


def asked(site: Path) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, "-c", ASK], env={"PYTHONPATH": str(site)}, cwd="/", capture_output=True, text=True, check=False
    )


def test_an_installed_package_brings_them(tmp_path: Path) -> None:
    package = package_in(tmp_path)
    put(package / "_product", "page/index.html", "board/posix/epf-board")
    assert asked(tmp_path).stdout.split() == [
        str(package / "_product" / "page" / "index.html"),
        str(package / "_product" / "board" / "posix" / "epf-board"),
    ]


def test_a_source_tree_has_them_where_it_builds_them(tmp_path: Path) -> None:
    package_in(tmp_path / "backend" / "src")
    put(tmp_path, "backend/pyproject.toml", "frontend/dist/index.html", "firmware/build/posix/epf-board")
    assert asked(tmp_path / "backend" / "src").stdout.split() == [
        str(tmp_path / "frontend" / "dist" / "index.html"),
        str(tmp_path / "firmware" / "build" / "posix" / "epf-board"),
    ]


def test_what_is_nowhere_is_told_with_what_to_do(tmp_path: Path) -> None:
    package = package_in(tmp_path)
    said = asked(tmp_path).stderr
    assert f"The page is missing: {package / '_product' / 'page' / 'index.html'} does not exist." in said
    assert "make run" in said
    assert "install epf-gcs again" in said


def test_this_tree_looks_into_itself() -> None:
    assert PAGE.folder == BACKEND.parent / "frontend" / "dist"
    assert BOARD.folder == BACKEND.parent / "firmware" / "build"


def test_a_wheel_holds_them_and_the_program_stays_one_that_can_be_run(tmp_path: Path) -> None:
    copy = tmp_path / "backend"
    shutil.copytree(BACKEND / "src", copy / "src", ignore=shutil.ignore_patterns("__pycache__", "*.egg-info"))
    for name in ("pyproject.toml", "README.md"):
        shutil.copy(BACKEND / name, copy)
    product = copy / "src" / "epf_gcs" / "_product"
    put(product, "page/index.html", "page/assets/a.js", "board/posix/epf-board")
    (product / "board" / "posix" / "epf-board").chmod(0o755)
    pip = [sys.executable, "-m", "pip", "install", "--no-deps", "--no-build-isolation", "--no-index", "--quiet"]
    made = subprocess.run(
        [*pip, "--target", str(tmp_path / "site"), str(copy)], capture_output=True, text=True, check=False
    )
    if made.returncode:
        pytest.fail(made.stderr)
    found = [Path(line) for line in asked(tmp_path / "site").stdout.split()]
    installed = tmp_path / "site" / "epf_gcs" / "_product"
    assert found == [installed / "page" / "index.html", installed / "board" / "posix" / "epf-board"]
    assert found[1].stat().st_mode & 0o111
    assert (installed / "page" / "assets" / "a.js").is_file()


def test_a_source_archive_holds_the_page_and_builds_a_wheel_with_it(tmp_path: Path) -> None:
    tree = tmp_path / "tree"
    shutil.copytree(
        BACKEND / "src", tree / "backend" / "src", ignore=shutil.ignore_patterns("__pycache__", "*.egg-info")
    )
    for name in ("backend/pyproject.toml", "backend/README.md", "LICENSE"):
        shutil.copy(BACKEND.parent / name, tree / name)
    # The licences of what the board brings go into the archive as well.
    shutil.copytree(BACKEND.parent / "firmware" / "third_party", tree / "firmware" / "third_party")
    put(tree, "frontend/dist/index.html", "frontend/dist/assets/a.js")
    builder = BACKEND.parent / ".ci" / "wheel.py"
    subprocess.run([sys.executable, str(builder), str(tree), str(tmp_path / "out"), "sdist"], check=True)
    (archive,) = (tmp_path / "out").glob("*.tar.gz")
    pip = [sys.executable, "-m", "pip", "install", "--no-deps", "--no-build-isolation", "--no-index", "--quiet"]
    subprocess.run([*pip, "--target", str(tmp_path / "site"), str(archive)], check=True)
    installed = tmp_path / "site" / "epf_gcs" / "_product"
    assert (installed / "page" / "assets" / "a.js").read_text() == "frontend/dist/assets/a.js"
    assert asked(tmp_path / "site").stdout.split() == [str(installed / "page" / "index.html")]
    assert "board's program is missing" in asked(tmp_path / "site").stderr
    assert list(tmp_path.glob("site/*.dist-info/licenses/LICENSE")), "the licence comes with it"
