"""QGroundControl's plans: what it saves is understood, and what we save has all that it asks for."""

from __future__ import annotations

from typing import Any

import orjson
import pytest

from epf_gcs.codec.tables import Waypoint
from epf_gcs.formats.qgc_plan import write_plan
from tests.formats.plans import TWO, notes, read, refusal

HOME = [27.9319, -15.3866, 24.384]


def simple(command: int, params: Any, frame: int = 3, **more: Any) -> dict[str, Any]:
    return {"type": "SimpleItem", "command": command, "frame": frame, "params": params, "autoContinue": True, **more}


def waypoint(latitude: Any, longitude: Any, altitude: Any, frame: int = 3) -> dict[str, Any]:
    mode = {0: 2, 5: 2, 3: 1, 6: 1, 10: 4, 11: 4}.get(frame, 1)
    return simple(16, [0, 0, 0, None, latitude, longitude, altitude], frame, Altitude=altitude, AltitudeMode=mode)


def speed(m_s: Any, kind: int = 0) -> dict[str, Any]:
    return simple(178, [kind, m_s, -1, 0, 0, 0, 0], 2)


def plan(items: Any, **mission: Any) -> bytes:
    """As QGroundControl saves it for a fixed wing."""
    return orjson.dumps(
        {
            "fileType": "Plan",
            "geoFence": {"circles": [], "polygons": [], "version": 2},
            "groundStation": "QGroundControl",
            "mission": {
                "cruiseSpeed": 15,
                "firmwareType": 3,
                "globalPlanAltitudeMode": 1,
                "hoverSpeed": 5,
                "items": items,
                "plannedHomePosition": HOME,
                "vehicleType": 1,
                "version": 2,
                **mission,
            },
            "rallyPoints": {"points": [], "version": 2},
            "version": 1,
        }
    )


def test_heights_above_home_become_altitudes_and_say_so() -> None:
    found = read(plan([waypoint(27.94, -15.37, 121.92), waypoint(27.95, -15.36, 152.4, 6)]))
    assert found.waypoints == (Waypoint(27.94, -15.37, 480.0, 55.0), Waypoint(27.95, -15.36, 580.0, 55.0))
    assert notes(found)["altitude_from_home"] == {"count": 2, "home_ft": 80.0}


def test_a_speed_holds_until_the_next() -> None:
    items = [
        waypoint(27.91, -15.3, 304.8, 0),
        speed(30.866666667),
        waypoint(27.92, -15.3, 304.8, 0),
        waypoint(27.93, -15.3, 304.8, 5),
        speed(25.722222222, 1),
        speed(3.0, 2),
        speed(-1),
        waypoint(27.94, -15.3, 304.8, 0),
        speed(-2),
        waypoint(27.95, -15.3, 304.8, 0),
    ]
    found = read(plan(items))
    assert [at.speed_kt for at in found.waypoints] == [55.0, 60.0, 60.0, 50.0, 55.0]
    assert {at.altitude_ft for at in found.waypoints} == {1000.0}
    assert notes(found) == {
        "speed_missing": {"count": 2, "speed_kt": 55.0},
        "items_skipped": {"count": 1, "kinds": "178"},
    }


def test_what_is_no_waypoint_is_left_out_and_named() -> None:
    items = [
        simple(22, [15, 0, 0, None, 27.93, -15.38, 50]),
        waypoint(27.94, -15.37, 100.0),
        {"type": "ComplexItem", "complexItemType": "survey", "TransectStyleComplexItem": {}},
        simple(206, [25, 0, 1, 0, 0, 0, 0], 2),
        simple(20, [0, 0, 0, 0, 0, 0, 0], 2),
    ]
    found = read(plan(items))
    assert len(found.waypoints) == 1
    assert notes(found)["items_skipped"] == {"count": 4, "kinds": "22, survey, 206, 20"}


def test_a_home_of_zeros_is_one_that_nobody_has_set() -> None:
    error = refusal(plan([waypoint(27, -15, 100)], plannedHomePosition=[0, 0, 0]))
    assert error.code == "mission_file_no_home"


@pytest.mark.parametrize(
    ("data", "code", "words"),
    [
        (
            plan([waypoint(27, -15, 100)], plannedHomePosition=None),
            "mission_file_no_home",
            "the height of item 1 counts from home",
        ),
        (plan([waypoint(27, -15, 100)], plannedHomePosition=[27, -15]), "mission_file_no_home", "the height of item 1"),
        (plan([waypoint(27, -15, 100, 1)]), "mission_file_frame", "the position of item 1 is given in '1'"),
        (plan([speed(20), waypoint(None, -15, 100)]), "mission_file_unreadable", "latitude_deg of item 2 is missing"),
        (plan([waypoint("27", -15, 100)]), "mission_file_unreadable", "latitude_deg of item 1 is no number ('27')"),
        (plan([waypoint(True, -15, 100)]), "mission_file_unreadable", "latitude_deg of item 1 is no number"),
        (plan([simple(16, [])]), "mission_file_unreadable", "latitude_deg of item 1 is missing"),
        (plan([simple(16, {"lat": 1})]), "mission_file_unreadable", "latitude_deg of item 1 is missing"),
        (plan([speed("fast"), waypoint(27, -15, 100)]), "mission_file_unreadable", "speed of item 1 is no number"),
        (plan([7]), "mission_file_unreadable", "item 1 is no item"),
        (plan([waypoint(27, -15, 100), waypoint(95, -15, 100)]), "mission_file_out_of_range", "in item 2 latitude_deg"),
        (
            plan([waypoint(27, -15, 100), speed(1000), waypoint(27, -15, 100)]),
            "mission_file_out_of_range",
            "in item 3 speed_kt",
        ),
        (plan([]), "mission_file_no_waypoints", "there are no waypoints in it"),
        (plan("none"), "mission_file_no_waypoints", "there are no waypoints in it"),
    ],
)
def test_an_item_that_is_none_is_named(data: bytes, code: str, words: str) -> None:
    error = refusal(data)
    assert error.code == code
    assert words in error.detail


def test_ours_has_all_that_the_file_format_requires() -> None:
    written = orjson.loads(write_plan(TWO))
    assert {"fileType", "groundStation", "mission", "geoFence", "rallyPoints", "version"} == set(written)
    mission = written["mission"]
    assert {
        "cruiseSpeed",
        "firmwareType",
        "globalPlanAltitudeMode",
        "hoverSpeed",
        "items",
        "plannedHomePosition",
        "vehicleType",
        "version",
    } == set(mission)
    assert [(item["command"], item["doJumpId"]) for item in mission["items"]] == [(178, 1), (16, 2), (178, 3), (16, 4)]
    assert all(len(item["params"]) == 7 and item["type"] == "SimpleItem" for item in mission["items"])
    assert mission["items"][1]["params"][4:6] == [27.93, -15.38]
    assert mission["items"][1]["Altitude"] == pytest.approx(304.8)
    assert mission["items"][1]["frame"] == 0


def test_a_speed_is_said_once_and_not_before_each_waypoint() -> None:
    written = orjson.loads(write_plan([TWO[0], TWO[0], TWO[1]]))
    assert [item["command"] for item in written["mission"]["items"]] == [178, 16, 16, 178, 16]


# QGroundControl's modes: 0 mixed, 1 above home, 2 above the sea, 3 above the sea as worked out from terrain, 4 terrain.
@pytest.mark.parametrize(
    ("mode", "frame", "expected"),
    [
        (1, 3, 580.0),
        (1, 6, 580.0),
        (2, 0, 500.0),
        (2, 5, 500.0),
        (3, 0, 500.0),
        (4, 10, "mission_file_above_ground"),
        (4, 11, "mission_file_above_ground"),
        (0, 3, 580.0),
        (0, 0, 500.0),
        (None, 3, 580.0),
        (None, 0, 500.0),
        (None, 10, "mission_file_above_ground"),
        (1, 0, "mission_file_frame_differs"),
        (2, 3, "mission_file_frame_differs"),
        (3, 3, "mission_file_frame_differs"),
        (4, 0, "mission_file_frame_differs"),
        (2, 10, "mission_file_frame_differs"),
        (2, 1, "mission_file_frame"),
        (2, None, "mission_file_frame"),
        (2, False, "mission_file_frame"),
        (2, "0", "mission_file_frame"),
    ],
)
def test_every_altitude_mode_is_kept_or_refused(mode: int | None, frame: Any, expected: float | str) -> None:
    more = {} if mode is None else {"AltitudeMode": mode}
    item = simple(16, [0, 0, 0, None, 27.94, -15.37, 152.4], frame, Altitude=152.4, **more)
    for data in (plan([item]), plan([item], globalPlanAltitudeMode=4)):
        if isinstance(expected, str):
            assert refusal(data).code == expected
        else:
            assert [at.altitude_ft for at in read(data).waypoints] == [expected]


def test_an_altitude_that_was_never_worked_out_from_terrain_is_missing() -> None:
    item = simple(16, [0, 0, 0, None, 27.94, -15.37, None], 0, Altitude=50, AltitudeMode=3, AMSLAltAboveTerrain=None)
    assert refusal(plan([item])).code == "mission_file_unreadable"
