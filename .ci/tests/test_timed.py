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
    """The rules of the Makefile itself, with parts in place of its own, of which the first fails."""
    rules = MAKEFILE.read_text(encoding="utf-8")
    parts = re.search(r"^PARTS := (.+)$", rules, re.MULTILINE)
    assert parts is not None
    names = parts.group(1).split()
    bodies = "".join(f"\n{name}:\n\t@echo ran {name}{'; false' if name == names[0] else ''}\n" for name in names)
    (tmp_path / "parts.mk").write_text(f"include {MAKEFILE}\n.PHONY: setup\nsetup:\n{bodies}")
    results = tmp_path / "results"
    done = subprocess.run(
        ["make", "-f", tmp_path / "parts.mk", "MADE=" + str(tmp_path / "parts.mk"), f"RESULTS={results}", "test"],
        cwd=MAKEFILE.parent,
        capture_output=True,
        text=True,
        check=False,
    )
    ran = {line.removeprefix("ran ") for line in done.stdout.splitlines() if line.startswith("ran ")}
    assert ran == set(names), done.stdout + done.stderr
    assert done.returncode != 0
    assert f"{names[0]}: FAILED" in done.stdout
