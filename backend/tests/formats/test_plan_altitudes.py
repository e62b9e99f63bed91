"""Each altitude of a file becomes one above the sea by figures that are known and told, or the file is refused."""

from __future__ import annotations

import pytest

from epf_gcs.formats.mission_file import AltitudeOrigin, FileFault, FilePlan, Frame, Place, Point
from epf_gcs.formats.plan_altitudes import DEFAULT_ALTITUDE_FT, settle


def point(nth: int, altitude_ft: float | None, frame: Frame = "sea") -> Point:
    return Point(Place("line", nth), 27.9 + nth / 100, -15.4, altitude_ft, 55.0, frame)


MIXED = FilePlan("waypoints", [point(1, 900.0), point(2, 300.0, "home"), point(3, 200.0, "ground")])


def test_each_height_counts_from_its_own_reference_and_says_which() -> None:
    found = settle(MIXED, [100.0, 150.0, 175.0], home_ft=80.0)
    assert [at.altitude_ft for at in found.waypoints] == [900.0, 380.0, 375.0]
    assert found.origins == (None, AltitudeOrigin("home", 300.0, 80.0), AltitudeOrigin("ground", 200.0, 175.0))
    assert {note.code: note.params for note in found.notes} == {
        "altitude_from_home": {"count": 1, "home_ft": 80.0},
        "altitude_from_ground": {"count": 1, "lowest_ft": 175.0, "highest_ft": 175.0},
    }


def test_without_home_the_question_brings_the_grounds_altitude_as_a_proposal() -> None:
    with pytest.raises(FileFault) as caught:
        settle(MIXED, [100.0, 150.0, 175.0])
    assert caught.value.code == "mission_file_no_home"
    assert (caught.value.params["count"], caught.value.params["ground_ft"]) == (1, 100.0)


@pytest.mark.parametrize("ground_ft", [(), (100.0, 150.0, None)])
def test_where_the_ground_is_not_known_nothing_is_taken_for_it(ground_ft: tuple[float | None, ...]) -> None:
    with pytest.raises(FileFault) as caught:
        settle(MIXED, ground_ft, home_ft=80.0)
    assert (caught.value.code, caught.value.params["nth"]) == ("mission_file_above_ground", 3)


def test_the_files_own_home_is_not_overruled_and_one_off_the_ground_is_told() -> None:
    plan = FilePlan("plan", [point(1, 300.0, "home")], home_ft=0.0)
    found = settle(plan, [950.0], home_ft=80.0)
    assert found.waypoints[0].altitude_ft == 300.0
    notes = {note.code: note.params for note in found.notes}
    assert notes["home_off_ground"] == {"home_ft": 0.0, "ground_ft": 950.0}
    near = settle(FilePlan("plan", [point(1, 300.0, "home")], home_ft=900.0), [950.0])
    assert "home_off_ground" not in {note.code for note in near.notes}


def test_a_missing_altitude_has_no_reference_and_asks_for_none() -> None:
    found = settle(FilePlan("kml", [point(1, None, "ground"), point(2, None, "home")]))
    assert [at.altitude_ft for at in found.waypoints] == [DEFAULT_ALTITUDE_FT] * 2
    assert found.origins == (None, None)
