"""A table of campaigns: what its file says, and how its lines read."""

from pathlib import Path

import pytest

from epf_gcs.lab.errors import LabError
from epf_gcs.lab.rows import Row
from epf_gcs.lab.table import lines, read

TEXT = """
flights = 3
[[rows]]
name = "Gando, 25 kt"
route = "gando"
fixed = { wind_kt = 25 }
drawn = { wind_from_deg = { uniform = [0, 360] } }
must = { near_m = 12 }
"""


def written(tmp_path: Path, text: str) -> Path:
    path = tmp_path / "table.toml"
    path.write_text(text, encoding="utf-8")
    return path


def flown(near_m: float, lost_by: str | None = None) -> Row:
    return {
        "error": None,
        "lost_by": lost_by,
        "waypoints": 8,
        "captured_honestly": 8 if lost_by is None else 2,
        "leg_rms_m": 3.0,
        "leg_largest_m": 10.0 * near_m,
        "near_rms_m": near_m,
        "altitude_rms_ft": None,
        "altitude_largest_ft": None,
        "speed_rms_kt": 0.3,
    }


def test_each_law_flies_the_same_conditions(tmp_path: Path) -> None:
    rows = read(written(tmp_path, TEXT))
    assert rows is not None
    deployed, line = rows
    assert (deployed.law, line.law) == ("bearing", "line")
    for number in range(3):
        one, other = deployed.campaign.order(number), line.campaign.order(number)
        assert {**one.conditions, "law": "line"} == other.conditions
    assert deployed.folder(tmp_path) != line.folder(tmp_path)
    assert deployed.campaign.fingerprint != line.campaign.fingerprint


def test_the_file_of_one_campaign_is_no_table(tmp_path: Path) -> None:
    assert read(written(tmp_path, 'route = "gando"\nflights = 3\n')) is None
    assert read(tmp_path / "nothing.toml") is None


def test_figures_are_of_all_flights_and_a_missed_limit_is_shown(tmp_path: Path) -> None:
    rows = read(written(tmp_path, TEXT))
    assert rows is not None
    deployed, line = rows
    results = [flown(3.0), flown(40.0, "crash")]
    cells = line.cells(results)
    assert cells == ["Gando, 25 kt", "line", "2", "3.0", "400.0", "28.4 (> 12)", "nan", "nan", "0.3", "10/16", "1"]
    assert deployed.cells(results)[5] == "28.4"
    head, rule, first = lines([cells])
    assert len({len(head), len(rule), len(first)}) == 1
    assert head.startswith("| condition")


@pytest.mark.parametrize(
    ("text", "said"),
    [
        (f"colour = 1\n{TEXT}", "is no table of campaigns"),
        (TEXT.replace('name = "Gando, 25 kt"', ""), "needs a `name`"),
        (TEXT.replace("near_m", "far_m"), "must be held against leg_m"),
        (TEXT.replace("wind_kt", "wind_kn"), "there is no condition wind_kn"),
    ],
)
def test_what_is_wrong_in_it_is_said(tmp_path: Path, text: str, said: str) -> None:
    with pytest.raises(LabError, match=said):
        read(written(tmp_path, text))


def test_the_table_that_ships_can_be_read() -> None:
    rows = read(Path(__file__).parents[3] / "campaigns" / "line.toml")
    assert rows is not None
    assert {row.law for row in rows} == {"bearing", "line"}
