"""Each part of `make test` runs to its end, and what it took and how it ended is noted for the summary."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

import pytest

CI = Path(__file__).parents[1]
MAKEFILE = CI.parent / "Makefile"


def timed(folder: Path, *command: str) -> subprocess.CompletedProcess[str]:
    arguments = [sys.executable, CI / "timed.py", folder / "results", "lint", *command]
    return subprocess.run(arguments, capture_output=True, text=True, check=False)


@pytest.mark.parametrize(("code", "ended"), [(0, "passed"), (3, "failed")])
def test_how_a_part_ended_is_noted_and_ends_no_other_part(tmp_path: Path, code: int, ended: str) -> None:
    done = timed(tmp_path, "sh", "-c", f"echo ran; exit {code}")
    assert (done.returncode, done.stdout) == (0, "ran\n")
    note = (tmp_path / "results" / "lint.part").read_text()
    assert re.fullmatch(rf"{ended} \d+ \d+\n", note), note


def test_the_processor_time_of_all_that_a_part_starts_is_noted(tmp_path: Path) -> None:
    work = "import time\nwhile time.process_time() < 1.2: pass"
    timed(tmp_path, "sh", "-c", f"{sys.executable} -c '{work}'; true")
    assert int((tmp_path / "results" / "lint.part").read_text().split()[2]) >= 1


def test_a_part_that_is_under_way_has_a_note_that_it_has_not_ended(tmp_path: Path) -> None:
    done = timed(tmp_path, "cat", str(tmp_path / "results" / "lint.part"))
    assert done.stdout == "unended 0 0\n"


def test_make_test_runs_every_part_to_its_end_and_is_red_where_one_failed(tmp_path: Path) -> None:
    """The rule of the Makefile itself, with parts of this test in place of the project's, of which the first fails."""
    rules = tmp_path / "parts.mk"
    rules.write_text(
        f"include {MAKEFILE}\nsetup: ;\n.PHONY: first second third\n"
        "first:\n\t@echo ran first; false\nsecond third:\n\t@echo ran $@\n"
    )
    given = [f"MADE={rules}", f"RESULTS={tmp_path / 'results'}", "PARTS=first second third"]
    done = subprocess.run(
        ["make", "-f", rules, *given, "test"], cwd=MAKEFILE.parent, capture_output=True, text=True, check=False
    )
    ran = [line.removeprefix("ran ") for line in done.stdout.splitlines() if line.startswith("ran ")]
    assert ran == ["first", "second", "third"], done.stdout + done.stderr
    assert done.returncode != 0
    assert "first: FAILED" in done.stdout
    assert "third: FAILED" not in done.stdout
