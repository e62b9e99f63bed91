"""The alarms of ground and fence: what the station says, for as long as it says it."""

from __future__ import annotations

from typing import Any

import pytest

from epf_gcs.vehicle.surroundings import LASTS_S, START_S, ToldSurroundings

TERRAIN = {"id": "terrain_ahead", "aircraft": "flight", "what": "terrain", "in_s": 28.4}


def test_what_is_said_is_an_alarm_until_it_is_not_said_any_more() -> None:
    told = ToldSurroundings()
    assert told.look(100.0) == []
    told.take([TERRAIN], 100.0)
    (found,) = told.look(100.0 + LASTS_S)
    assert (found.id, found.level) == ("terrain_ahead", "critical")
    assert found.params == {"aircraft": "flight", "what": "terrain"}
    assert "in 28 s" in found.text
    told.take([], 101.0)
    assert told.look(101.0) == []


def test_a_station_that_dies_ends_no_alarm_as_if_all_were_well() -> None:
    told = ToldSurroundings()
    told.take([{**TERRAIN, "id": "fence_left", "what": "fence"}], 100.0, ["fence", "terrain"])
    (found,) = told.look(100.0 + LASTS_S + 0.1)
    assert (found.id, found.level) == ("surroundings_unwatched", "critical")
    assert found.params == {"what": "both", "was_left": True}
    assert "outside the fence" in found.text
    told.take([], 200.0, ["fence"])
    assert told.look(200.0) == []
    told.take([], 300.0, [])
    assert told.look(400.0) == [], "nobody wants to be warned of anything"


def test_what_was_to_be_watched_is_remembered_for_a_station_that_does_not_come() -> None:
    kept: list[tuple[str, ...]] = []
    before = ToldSurroundings(on_watched=kept.append)
    for _ in range(3):
        before.take([], 1.0, ["terrain", "<b>", 3])
    assert kept == [("terrain",)]
    told = ToldSurroundings(kept[-1], now_s=50.0)
    assert told.look(50.0 + START_S) == [], "it is being started"
    (found,) = told.look(50.0 + START_S + 0.1)
    assert found.params == {"what": "terrain", "was_left": False}


@pytest.mark.parametrize(
    ("watched", "blind", "what"), [(["unknown"], [], "unknown"), (["terrain"], ["terrain"], "terrain")]
)
def test_a_choice_that_cannot_be_read_and_ground_that_is_not_seen_are_not_watched(
    watched: list[str], blind: list[str], what: str
) -> None:
    told = ToldSurroundings()
    told.take([TERRAIN], 1.0, watched, blind)
    assert [(one.id, one.params.get("what")) for one in told.look(1.0)] == [
        ("terrain_ahead", "terrain"),
        ("surroundings_unwatched", what),
    ]


@pytest.mark.parametrize(
    "said",
    [
        "terrain_ahead",
        None,
        {},
        {**TERRAIN, "id": "battery_low"},
        {**TERRAIN, "aircraft": "<b>"},
        {**TERRAIN, "what": 3},
        {**TERRAIN, "what": "<b>"},
        {**TERRAIN, "in_s": float("nan")},
        {**TERRAIN, "in_s": -1},
        {**TERRAIN, "in_s": "soon"},
        {**TERRAIN, "in_s": 1e9},
        {**TERRAIN, "in_s": 601},
    ],
)
def test_what_has_no_known_form_is_no_alarm(said: Any) -> None:
    told = ToldSurroundings()
    told.take([said, *[TERRAIN]], 1.0)
    assert [found.id for found in told.look(1.0)] == ["terrain_ahead"]


def test_the_ceiling_and_the_border_are_told_apart() -> None:
    told = ToldSurroundings()
    told.take(
        [
            {"id": "fence_left", "aircraft": "hil", "what": "ceiling", "in_s": 0},
            {"id": "fence_ahead", "aircraft": "flight", "what": "fence", "in_s": 12},
        ],
        1.0,
    )
    left, ahead = told.look(1.0)
    assert (left.level, ahead.level) == ("critical", "warning")
    assert left.text == "The aircraft is beyond the fence's ceiling: bring it back."
    assert ahead.text == "The present track leaves the fence at its border, in 12 s: turn."


def test_seconds_are_rounded_and_the_border_of_the_fence_is_no_ceiling() -> None:
    told = ToldSurroundings()
    told.take(
        [
            {**TERRAIN, "in_s": 28.6},
            {"id": "fence_left", "aircraft": "hil", "what": "fence", "in_s": 0},
            {"id": "fence_ahead", "aircraft": "hil", "what": "ceiling", "in_s": 600},
        ],
        1.0,
    )
    ground, left, ahead = told.look(1.0)
    assert "in 29 s" in ground.text
    assert left.text == "The aircraft is beyond the fence's border: bring it back."
    assert ahead.text == "The present track leaves the fence at its ceiling, in 600 s: turn."
    assert left.params == {"aircraft": "hil", "what": "fence"}


def test_of_a_flood_of_findings_the_first_eight_count() -> None:
    told = ToldSurroundings()
    told.take([{**TERRAIN, "in_s": place} for place in range(100)], 1.0)
    assert [found.text for found in told.look(1.0)] == [
        f"Ground ahead on the present track, in {place} s: climb or turn." for place in range(8)
    ]
