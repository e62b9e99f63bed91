"""The summary is green only where everything ran, and nothing was skipped that may not be."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

CI = Path(__file__).parents[1]
SUITES = ("ci", "protocol", "firmware", "backend", "frontend", "e2e")
PASSED = '<testcase classname="a.b" name="c"/>'
SKIPPED = '<testcase classname="a.b" name="d[x]"><skipped message="no such device"/></testcase>'


@pytest.fixture
def results(tmp_path: Path) -> Path:
    """A folder in which each suite has one test that passed."""
    folder = tmp_path / "results"
    folder.mkdir()
    for suite in SUITES:
        write(folder, suite, PASSED)
    return folder


def write(folder: Path, name: str, *cases: str) -> None:
    (folder / f"{name}.xml").write_text(f"<testsuites><testsuite>{''.join(cases)}</testsuite></testsuites>")


def summary(results: Path, *listed: str) -> tuple[int, str]:
    """Exit code and what it prints, with this list of skips that are allowed."""
    skips = results.parent / "skips.txt"
    skips.write_text("".join(f"{line}\n" for line in listed))
    done = subprocess.run(
        [sys.executable, CI / "summary.py", results, skips], capture_output=True, text=True, check=False
    )
    return done.returncode, done.stdout + done.stderr


def test_all_passed_is_green_and_is_counted(results: Path) -> None:
    code, said = summary(results)
    assert (code, said.splitlines()[-1]) == (0, "6 passed, 0 failed, 0 skipped")


@pytest.mark.parametrize("kind", ["failure", "error"])
def test_a_failure_is_red(results: Path, kind: str) -> None:
    write(results, "backend-more", f'<testcase classname="a" name="b"><{kind}/></testcase>')
    code, said = summary(results)
    assert code == 1
    assert "backend: 1 passed, 1 failed, 0 skipped" in said


def test_a_failure_is_told_with_what_was_said_but_not_all_of_it(results: Path) -> None:
    said = "".join(f"line {number}\n" for number in range(100))
    write(results, "e2e", f'<testcase classname="a" name="b"><failure message="why">\x09{said}</failure></testcase>')
    lines = summary(results)[1].splitlines()
    at = lines.index("  e2e, FAILED: a::b")
    assert [line.strip() for line in lines[at + 1 : at + 4]] == ["why", "line 0", "line 1"]
    assert "and 77 more lines" in "\n".join(lines)
    assert "line 99" not in "\n".join(lines)


@pytest.mark.parametrize("suite", SUITES)
def test_a_suite_that_did_not_run_is_red(results: Path, suite: str) -> None:
    write(results, suite)
    code, said = summary(results)
    assert code == 1
    assert f"{suite}: no test was run" in said
    (results / f"{suite}.xml").unlink()
    assert summary(results)[0] == 1


def test_a_skip_is_told_with_its_reason_and_is_red(results: Path) -> None:
    write(results, "backend", PASSED, SKIPPED)
    code, said = summary(results)
    assert code == 1
    assert "backend, 1 skipped, NOT ALLOWED: no such device" in said


def test_a_skip_that_is_listed_is_told_and_green(results: Path) -> None:
    write(results, "backend", PASSED, SKIPPED)
    code, said = summary(results, "# of this suite", "", "backend a.b::d* it is so")
    assert code == 0
    assert "backend, 1 skipped, allowed: no such device" in said


@pytest.mark.parametrize("line", ["e2e a.b::d* of another suite", "backend a.b::e* another test"])
def test_a_line_allows_no_other_skip(results: Path, line: str) -> None:
    write(results, "backend", PASSED, SKIPPED)
    assert summary(results, line)[0] == 1


@pytest.mark.parametrize("line", ["backend a.b::d*", "backend", "elsewhere a.b::d* it is so"])
def test_a_line_without_a_reason_or_of_no_suite_is_refused(results: Path, line: str) -> None:
    code, said = summary(results, line)
    assert code == 1
    assert "line 1 of the list of skips" in said


def test_what_each_part_took_is_said_the_longest_first(results: Path) -> None:
    (results / "short.part").write_text("passed 30 45\n")
    (results / "long.part").write_text("passed 366 600\n")
    code, said = summary(results)
    assert code == 0
    assert said.splitlines()[:2] == [
        "long: 6.1 min, 10.0 min of processor time",
        "short: 0.5 min, 0.8 min of processor time",
    ]


@pytest.mark.parametrize("ended", ["failed", "unended"])
def test_a_part_that_failed_is_red_although_all_its_tests_passed(results: Path, ended: str) -> None:
    (results / "lint.part").write_text(f"{ended} 30 45\n")
    code, said = summary(results)
    assert code == 1
    assert f"lint: {ended.upper()} 0.5 min" in said


def test_the_list_of_the_project_can_be_read(results: Path) -> None:
    done = subprocess.run([sys.executable, CI / "summary.py", results], capture_output=True, check=False)
    assert done.returncode == 0
