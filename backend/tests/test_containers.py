"""Dockerfile and compose files fit the tree, and the check that says so finds what does not."""

from __future__ import annotations

import importlib.util
import shutil
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
READ = (
    "Dockerfile",
    ".dockerignore",
    "Makefile",
    "docker-compose.yml",
    "docker-compose.use.yml",
    "backend/pyproject.toml",
    "frontend/vite.config.ts",
    "e2e/support/there.ts",
)


def check(root: Path) -> list[str]:
    spec = importlib.util.spec_from_file_location("containers", ROOT / ".ci" / "containers.py")
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    sys.modules["containers"] = module
    spec.loader.exec_module(module)
    found: list[str] = module.faults(root)
    return found


@pytest.fixture(scope="module")
def whole(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A copy of what is read, with every other file of the tree there and empty."""
    copy = tmp_path_factory.mktemp("tree")
    listed = subprocess.run(["git", "-C", ROOT, "ls-files", "-z"], capture_output=True, text=True, check=True).stdout
    for name in filter(None, listed.split("\0")):
        path = copy / name
        path.parent.mkdir(parents=True, exist_ok=True)
        if name in READ:
            shutil.copy(ROOT / name, path)
        else:
            path.touch()
    subprocess.run(["git", "-C", copy, "init", "--quiet"], check=True)
    subprocess.run(["git", "-C", copy, "add", "--all", "--force"], check=True)
    return copy


@pytest.fixture
def tree(whole: Path) -> Iterator[Path]:
    """The copy, which is as before after each test."""
    yield whole
    for name in READ:
        shutil.copy(ROOT / name, whole / name)


def change(path: Path, old: str, new: str) -> None:
    text = path.read_text(encoding="utf-8")
    assert old in text
    path.write_text(text.replace(old, new), encoding="utf-8")


def test_they_fit_the_tree(tree: Path) -> None:
    assert check(tree) == []


@pytest.mark.parametrize(
    ("file", "old", "new", "said"),
    [
        ("Dockerfile", "COPY LICENSE", "COPY LICENCE", "Dockerfile copies LICENCE, which is not in the tree"),
        (".dockerignore", "!firmware", "!firmware/src", "Dockerfile copies firmware/, which .dockerignore keeps back"),
        ("Dockerfile", "--from=board", "--from=boards", "Dockerfile copies from boards, which is no stage"),
        ("Dockerfile", "GCS_DATA_DIR=", "GCS_DATA_FOLDER=", "Dockerfile sets GCS_DATA_FOLDER, which nothing reads"),
        ("Dockerfile", "49003/udp", "49009/udp", "Dockerfile opens port 49009, where no program listens"),
        ("Dockerfile", 'image.title="EPF GCS"', 'image.title="GCS"', "labels no title, which is EPF GCS"),
        ("Dockerfile", 'licenses="MIT"', 'licenses="GPL-3.0"', "labels no licenses, which is MIT"),
        ("Dockerfile", 'version="${VERSION}"', 'version="1.0.0"', "labels no version, which is ${VERSION}"),
        ("Makefile", "--build-arg REVISION=", "--build-arg COMMIT=", "`make container` does not say REVISION"),
        ("Dockerfile", 'image.title="', 'image.url="https://a.example" org.x="', "image.url names an address"),
        (
            "Dockerfile",
            'base.name="docker.io/library/python:3.11',
            'base.name="docker.io/library/python:3.10',
            "its base",
        ),
        (
            "docker-compose.yml",
            "target: dev-page",
            "target: page-dev",
            "page is built from page-dev, which is no stage",
        ),
        ("docker-compose.yml", "./frontend/src:", "./frontend/source:", "mounts ./frontend/source, which is not in"),
        (
            "docker-compose.yml",
            "key: { condition: service_c",
            "keys: { condition: service_c",
            "needs keys, which is no",
        ),
        ("docker-compose.yml", '"5760"', '"5761"', "its health check looks for another one"),
        ("docker-compose.yml", "GCS_ALLOWED_HOSTS:", "GCS_ALLOWED:", "sets GCS_ALLOWED, which nothing reads"),
        ("docker-compose.yml", '"epf-sim"', '"epf-simulator"', "simulator runs epf-simulator, which no image has"),
        ("docker-compose.use.yml", '["epf-sim"]', '["epf-simulator"]', "runs epf-simulator, which no image has"),
    ],
)
def test_what_does_not_fit_is_found(tree: Path, file: str, old: str, new: str, said: str) -> None:
    change(tree / file, old, new)
    found = check(tree)
    assert any(said in sentence for sentence in found), found
