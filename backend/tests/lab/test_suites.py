"""The suites that ship, as a user starts them, and what they say of laws that are right and of laws that are not."""

from __future__ import annotations

import math
import subprocess
import sys
from pathlib import Path

import pytest

from bench.planted import BUGS, build
from epf_gcs.lab.bounds import Bounds


def suites(*words: str | Path) -> subprocess.CompletedProcess[str]:
    program = [sys.executable, "-m", "epf_gcs.lab", "test", *map(str, words)]
    return subprocess.run(program, capture_output=True, text=True, check=False)


def test_a_suite_says_each_figure_beside_its_bound(tmp_path: Path) -> None:
    flown = suites("failsafes", "--junit", tmp_path / "report.xml")
    assert flown.returncode == 0, flown.stdout
    assert "neutral from 0.18 s, bound 0.25 s" in flown.stdout
    assert "neutral from 0.18 s, bound 0.25 s" in (tmp_path / "report.xml").read_text(encoding="utf-8")


def test_a_suite_that_there_is_none_of_is_refused_with_those_that_there_are() -> None:
    refused = suites("loops")
    assert refused.returncode == 2
    assert refused.stderr == (
        "epf-lab: there is no suite loops: choose of bumpless, failsafes, faults, line, link, routes, steps, wind\n"
    )


@pytest.mark.parametrize("bug", [bug for bug in BUGS if bug.by == "line"], ids=lambda bug: bug.says)
def test_a_bug_planted_in_the_lines_code_is_caught(bug: object, tmp_path: Path) -> None:
    flown = suites("line", "--laws", build(bug, tmp_path))  # type: ignore[arg-type]
    assert flown.returncode == 1
    assert "the board lacks:" in flown.stdout


def test_a_figure_outside_its_bound_fails_with_both_and_no_number_is_within_one() -> None:
    kept: list[object] = []
    bounds = Bounds(lambda _, sentence: kept.append(sentence))
    bounds.below("bank", 29.0, 30.0, "deg")
    bounds.above("speed", 40.0, 30.0, "kt")
    with pytest.raises(AssertionError, match="bank 31 deg, bound 30 deg"):
        bounds.below("bank", 31.0, 30.0, "deg")
    for judge in (bounds.below, bounds.above):
        with pytest.raises(AssertionError, match="nan"):
            judge("distance", math.nan, 30.0)
    with pytest.raises(AssertionError, match="waypoints 7, wanted 8"):
        bounds.equal("waypoints", 7, 8)
    assert kept[:2] == ["bank 29 deg, bound 30 deg", "speed 40 kt, at least 30 kt"]
