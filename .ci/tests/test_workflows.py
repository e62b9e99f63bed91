"""What the forge runs is what the Makefile has, and nothing that somebody else could change under us."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
WORKFLOWS = sorted((ROOT / ".github" / "workflows").glob("*.yml"))
VERBS = frozenset(re.findall(r"^([\w$()/.-]+)(?: [\w$()/.-]+)*:", (ROOT / "Makefile").read_text(), re.MULTILINE))


@pytest.mark.parametrize("path", WORKFLOWS, ids=lambda path: path.name)
def test_each_action_is_pinned_by_its_hash_and_says_its_version(path: Path) -> None:
    used = re.findall(r"uses: (.+)", path.read_text())
    assert used
    assert [line for line in used if not re.fullmatch(r"[\w/-]+@[0-9a-f]{40} # v\d+\.\d+\.\d+", line)] == []


def test_an_action_is_used_in_one_version() -> None:
    used = {line for path in WORKFLOWS for line in re.findall(r"uses: (.+)", path.read_text())}
    assert len({line.partition("@")[0] for line in used}) == len(used)


@pytest.mark.parametrize("path", WORKFLOWS, ids=lambda path: path.name)
def test_each_verb_is_one_of_the_makefile(path: Path) -> None:
    for line in re.findall(r"run: make (.+)", path.read_text()):
        for verb in line.split():
            assert "=" in verb or verb in VERBS | {"frontend/dist/index.html"}, verb


def test_pythons_and_nodes_of_the_workflow_begin_with_those_that_the_packages_ask_for() -> None:
    text = (ROOT / ".github" / "workflows" / "ci.yml").read_text()
    assert 'python-version: "3.11"' in text
    assert 'requires-python = ">=3.11"' in (ROOT / "backend" / "pyproject.toml").read_text()
    assert 'node-version: "20.19"' in text
    assert '"node": ">=20.19.0"' in (ROOT / "frontend" / "package.json").read_text()
