"""`epf-lab` and the pytest plug-in, as a user starts them."""

from __future__ import annotations

import html
import re
import subprocess
import sys
from pathlib import Path

import pytest

PLAN = "latitude_deg,longitude_deg,altitude_ft,speed_kt\n27.9380,-15.3830,1000,55\n"


def lab(*words: str | Path) -> subprocess.CompletedProcess[str]:
    program = [sys.executable, "-m", "epf_gcs.lab", *map(str, words)]
    return subprocess.run(program, capture_output=True, text=True, check=False)


def test_a_flight_says_how_it_was_flown_and_whether_it_is_safe(tmp_path: Path) -> None:
    plan = tmp_path / "plan.csv"
    plan.write_text(PLAN, encoding="utf-8")
    flown = lab("fly", plan, "wind_kt=10", "seed=7", "gains.k_roll=2.5")
    assert flown.stdout.startswith("plan: safe; 1 of 1 waypoints, "), flown.stderr
    assert "off the leg" in flown.stdout
    assert flown.returncode == 0
    plan.write_text(PLAN.replace("1000", "3000"), encoding="utf-8")
    below = lab("fly", plan)
    assert below.stdout.startswith("plan: NOT SAFE; 0 of 1 waypoints, ")
    assert below.returncode == 1


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("fly", "nowhere"), "nowhere cannot be read (No such file or directory); routes with a name are gando"),
        (("fly", "gando", "wind_kt"), "'wind_kt' is not NAME=VALUE"),
        (("fly", "gando", "wind_kt=much"), "wind_kt cannot be 'much': it must be a number"),
        (("fly", "gando", "bank=3"), "there is no condition bank"),
        (("fly", "gando", "gains.k_tail=3"), "the board has no gain k_tail"),
        (("fly", "gando", "mass_factor=1.1", "aircraft=c172p"), "no weights by which its mass could be changed"),
        (("fly", "gando", "--laws", "/dev/null"), "cannot be loaded as the laws of a board"),
        (("report", "/nowhere"), "holds no finished campaign"),
    ],
)
def test_what_cannot_be_done_is_one_sentence(words: tuple[str, ...], said: str) -> None:
    refused = lab(*words)
    assert refused.returncode == 2
    assert refused.stderr.startswith("epf-lab: ")
    assert said in refused.stderr
    assert refused.stderr.count("\n") == 1


def test_a_campaign_is_flown_reported_and_compared(tmp_path: Path) -> None:
    (tmp_path / "plan.csv").write_text(PLAN, encoding="utf-8")
    for name, gain in (("before", 2.0), ("after", 2.5)):
        text = f'route = "plan.csv"\nflights = 2\n[fixed.gains]\nk_roll = {gain}\n'
        (tmp_path / f"{name}.toml").write_text(text, encoding="utf-8")
        flown = lab("campaign", tmp_path / f"{name}.toml", "--into", tmp_path / name, "--workers", "1", "--record", "1")
        assert "2 of 2 flights are safe: 100.0 %" in flown.stdout, flown.stderr
        assert "epf-gcs --data-dir" in flown.stdout
        assert len(list((tmp_path / name / "station" / "recordings").glob("*.mcap"))) == 1
    assert "2 flights in the same conditions" in lab("compare", tmp_path / "before", tmp_path / "after").stdout


def test_a_test_of_its_own_flies_by_the_fixture(pytester: pytest.Pytester) -> None:
    pytester.makepyfile(
        """
        def test_one_leg(lab):
            flight = lab.fly("plan.csv", wind_kt=5)
            assert flight.captured_honestly == 1
            assert flight.cross_track.rms_m < 60

        def test_too_much(lab):
            assert lab.fly("plan.csv", seed=5).altitude.settled.rms_ft < 0
        """
    )
    (pytester.path / "plan.csv").write_text(PLAN, encoding="utf-8")
    result = pytester.runpytest_subprocess("-p", "no:cacheprovider")
    result.assert_outcomes(passed=1, failed=1)
    result.stdout.fnmatch_lines(["*<flight of plan (seed=5): 1 of 1 waypoints*"])


def test_a_failed_test_has_its_flight_in_a_station_and_on_a_page_and_its_figures_in_junit(
    pytester: pytest.Pytester,
) -> None:
    pytester.makepyfile(
        """
        def test_too_much(lab):
            lab.fly("plan.csv", seed=5).check(captured_honestly=1, altitude_rms_ft=0)
        """
    )
    (pytester.path / "plan.csv").write_text(PLAN, encoding="utf-8")
    result = pytester.runpytest_subprocess("-p", "no:cacheprovider", "--junitxml=junit.xml")
    result.assert_outcomes(failed=1)
    result.stdout.re_match_lines([r".*captured_honestly 1, bound 1; altitude_rms_ft [0-9.]+, bound 0"])
    link = r"(http://127\.0\.0\.1:8000/\?flight=(\S+)&at=[0-9.]+)"
    said = re.search(f"{link}, once this runs: epf-gcs", str(result.stdout))
    assert said is not None
    data_dir = pytester.path / "epf-lab-flights"
    assert [path.stem for path in (data_dir / "recordings").glob("*.mcap")] == [said[2]]
    page = (data_dir / "pages" / f"{said[2]}.html").read_text(encoding="utf-8")
    assert page.count("<svg") == 4
    assert re.search(r'class="bad"><td>altitude_rms_ft</td><td>[0-9.]+</td><td>0<', page)
    junit = (pytester.path / "junit.xml").read_text(encoding="utf-8")
    told = dict(re.findall(r'<property name="flight\.(\w+)" value="(.*?)"', junit))
    assert (told["seed"], told["captured_honestly"], told["altitude_rms_ft_bound"]) == ("5", "1", "0")
    assert html.unescape(told["link"]) == said[1]
