"""Notes of a release are its part of the changelog, and a tag that does not fit the tree makes none."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

CI = Path(__file__).parents[1]
TOLD = "# Changelog\n\n## 1.2.0 (2026-12-01)\n\n- New: it flies.\n\nMended:\n\n- It crashed.\n\n## 1.1.0\n\n- Old.\n"


@pytest.fixture
def tree(tmp_path: Path) -> Path:
    (tmp_path / "backend").mkdir()
    (tmp_path / "backend" / "pyproject.toml").write_text('[project]\nversion = "1.2.0"\n')
    (tmp_path / "CHANGELOG.md").write_text(TOLD)
    return tmp_path


def said(tree: Path, *tag: str) -> tuple[int, str]:
    done = subprocess.run([sys.executable, CI / "notes.py", tree, *tag], capture_output=True, text=True, check=False)
    return done.returncode, done.stdout.strip() if done.returncode == 0 else done.stderr.strip()


def test_they_are_the_part_of_the_version_and_no_more(tree: Path) -> None:
    assert said(tree, "v1.2.0") == (0, "- New: it flies.\n\nMended:\n\n- It crashed.")


@pytest.mark.parametrize("tag", ["v1.2.1", "1.2.0", "v1.2.0-rc1"])
def test_a_tag_that_is_not_the_version_makes_no_release(tree: Path, tag: str) -> None:
    assert said(tree, tag) == (1, f"notes: the tag is {tag} and the version is 1.2.0: the tag has to be v1.2.0.")


def test_what_stands_under_unreleased_makes_no_release(tree: Path) -> None:
    (tree / "CHANGELOG.md").write_text(TOLD.replace("## 1.2.0", "## Unreleased\n\n- More.\n\n## 1.2.0"))
    assert said(tree, "v1.2.0") == (1, "notes: CHANGELOG.md has something under Unreleased: put it under 1.2.0.")
    assert said(tree)[0] == 0


def test_a_version_that_is_not_the_newest_makes_no_release(tree: Path) -> None:
    (tree / "CHANGELOG.md").write_text(TOLD.replace("## 1.2.0", "## 1.3.0\n\n- Newer.\n\n## 1.2.0"))
    assert said(tree, "v1.2.0") == (1, "notes: the newest part of CHANGELOG.md is 1.3.0 and not 1.2.0.")


def test_a_version_of_which_nothing_is_told_makes_no_release(tree: Path) -> None:
    (tree / "CHANGELOG.md").write_text("# Changelog\n\n## 1.2.0\n\n## 1.1.0\n\n- Old.\n")
    assert said(tree, "v1.2.0") == (1, "notes: CHANGELOG.md tells nothing of 1.2.0.")


def test_a_version_that_is_under_way_makes_no_release(tree: Path) -> None:
    (tree / "backend" / "pyproject.toml").write_text('[project]\nversion = "1.3.0.dev0"\n')
    sentence = "notes: 1.3.0.dev0 is under way: a release takes its number first (CONTRIBUTING.md)."
    assert said(tree) == said(tree, "v1.3.0.dev0") == (1, sentence)
