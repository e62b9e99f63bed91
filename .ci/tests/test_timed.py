"""Each part of `make test` runs to its end, and what it took and how it ended is noted for the summary."""

from __future__ import annotations

import os
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
    assert done.returncode == 0
    assert re.fullmatch(rf"ran\nlint: {ended} after \d+\.\d min\n", done.stdout), done.stdout
    note = (tmp_path / "results" / "lint.part").read_text()
    assert re.fullmatch(rf"{ended} \d+ \d+\n", note), note


def test_the_processor_time_of_all_that_a_part_starts_is_noted(tmp_path: Path) -> None:
    work = "import time\nwhile time.process_time() < 1.2: pass"
    timed(tmp_path, "sh", "-c", f"{sys.executable} -c '{work}'; true")
    assert int((tmp_path / "results" / "lint.part").read_text().split()[2]) >= 1


def test_a_part_that_is_under_way_has_a_note_that_it_has_not_ended(tmp_path: Path) -> None:
    done = timed(tmp_path, "cat", str(tmp_path / "results" / "lint.part"))
    assert done.stdout.splitlines()[0] == "unended 0 0"


def made(folder: Path, rules: str) -> subprocess.CompletedProcess[str]:
    """The rule of the Makefile itself, with the parts first, second and third, of these rules, in place of its own."""
    parts = folder / "parts.mk"
    parts.write_text(f"include {MAKEFILE}\nsetup: ;\n.PHONY: first second third\n{rules}")
    given = [f"MADE={parts}", f"RESULTS={folder / 'results'}", "PARTS=first second third"]
    # The make that runs the tests has told its own options.
    own = {name: value for name, value in os.environ.items() if not name.startswith("MAKE") and name != "MFLAGS"}
    command = ["make", "-f", parts, *given, "test"]
    return subprocess.run(command, cwd=MAKEFILE.parent, env=own, capture_output=True, text=True, check=False)


def test_make_test_runs_every_part_to_its_end_and_is_red_where_one_failed(tmp_path: Path) -> None:
    done = made(tmp_path, "first:\n\t@echo ran first; false\nsecond third:\n\t@echo ran $@\n")
    ran = {line.removeprefix("ran ") for line in done.stdout.splitlines() if line.startswith("ran ")}
    assert ran == {"first", "second", "third"}, done.stdout + done.stderr
    assert done.returncode != 0
    assert "first: FAILED" in done.stdout
    assert "third: FAILED" not in done.stdout


def test_a_part_that_waits_does_not_hold_up_the_others(tmp_path: Path) -> None:
    waits = f"for i in $$(seq 3000); do test -e {tmp_path / 'done'} && exit 0; sleep 0.02; done; exit 1"
    done = made(tmp_path, f"first second:\n\t@{waits}\nthird:\n\t@touch {tmp_path / 'done'}\n")
    assert all(f"{part}: passed" in done.stdout for part in ("first", "second", "third")), done.stdout + done.stderr
    assert "jobserver" not in done.stderr
