"""A part of the tests runs, or stands in the results as skipped with the reason."""

from __future__ import annotations

import shutil
import subprocess
from pathlib import Path
from xml.etree import ElementTree as ET

import pytest

CI = Path(__file__).parents[1]


def part(folder: Path, lacking: str, *command: str) -> subprocess.CompletedProcess[str]:
    """Run `.ci/part` beside a script of which `--lacking` says this."""
    shutil.copy(CI / "part", folder)
    (folder / "thing").write_text(f'[ "$1" = --lacking ] && printf "%s" "{lacking}"\n')
    arguments = ["bash", folder / "part", folder / "results", "e2e", "thing", *command]
    return subprocess.run(arguments, capture_output=True, text=True, check=False)


@pytest.mark.parametrize("code", [0, 3])
def test_with_all_that_it_needs_it_runs_and_its_end_is_the_end(tmp_path: Path, code: int) -> None:
    done = part(tmp_path, "", "sh", "-c", f"echo ran; exit {code}")
    assert (done.returncode, done.stdout) == (code, "ran\n")
    assert not (tmp_path / "results").exists()


def test_without_it_does_not_run_and_the_results_say_why(tmp_path: Path) -> None:
    done = part(tmp_path, "No thing is here.", "sh", "-c", "echo ran")
    assert (done.returncode, done.stdout) == (0, "")
    assert "No thing is here." in done.stderr
    (case,) = ET.parse(tmp_path / "results" / "e2e-without-thing.xml").iter("testcase")  # noqa: S314
    assert case.get("name") == "all that needs thing"
    assert [(child.tag, child.get("message")) for child in case] == [("skipped", "No thing is here.")]


@pytest.mark.parametrize("need", ["arm", "clang", "browser"])
def test_what_a_machine_without_any_tool_lacks_is_said_in_one_sentence(need: str, tmp_path: Path) -> None:
    """With nothing to be found but what the scripts themselves are made of."""
    for program in ("bash", "dirname", "id"):
        found = shutil.which(program)
        assert found is not None
        (tmp_path / program).symlink_to(found)
    done = subprocess.run(
        [tmp_path / "bash", CI / need, "--lacking"],
        env={"PATH": str(tmp_path), "CHROMIUM": "/none"},
        capture_output=True,
        text=True,
        check=False,
    )
    assert (done.returncode, done.stderr) == (0, "")
    assert len(done.stdout.splitlines()) == 1
    assert "apt install" in done.stdout
    assert not set(done.stdout) & set('<>&"'), "it goes into the results as it is"
