"""A plan as mission items and back: the same plan, or a refusal that says why."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from epf_gcs.codec.messages_gen import ROUTES
from epf_gcs.codec.tables import Waypoint
from epf_gcs.mavlink.choice import Home
from epf_gcs.mavlink.dialect import MAKE, WIRE
from epf_gcs.mavlink.plan_items import PlanError, items_of, plan_of

GANDO = list(ROUTES["gando"].waypoints)
waypoints = st.builds(
    Waypoint, st.floats(-85, 85), st.floats(-179, 179), st.floats(-1000, 50_000), st.floats(10, 400).map(round)
)


def over_the_wire(item: Any) -> Any:
    """An item as the other side reads it, in single precision."""
    (read,) = WIRE.MAVLink(None).parse_buffer(bytes(item.pack(WIRE.MAVLink(None, 1, 1))))
    return read


@given(st.lists(waypoints, min_size=1, max_size=20), st.sampled_from([None, 60.0]))
def test_a_plan_comes_back_within_the_resolution_of_the_wire(
    plan: list[Waypoint], usual_speed_kt: float | None
) -> None:
    items = [over_the_wire(item) for item in items_of(plan, usual_speed_kt).items]
    for before, after in zip(plan, plan_of(items, usual_speed_kt, None), strict=True):
        assert after.latitude_deg == pytest.approx(before.latitude_deg, abs=6e-8)
        assert after.longitude_deg == pytest.approx(before.longitude_deg, abs=6e-8)
        assert after.altitude_ft == pytest.approx(before.altitude_ft, abs=4e-3)
        assert after.speed_kt == pytest.approx(before.speed_kt, abs=1e-3)


def test_a_speed_stands_where_it_changes() -> None:
    made = items_of(GANDO, None)
    commands = [item.command for item in made.items]
    assert commands[:2] == [WIRE.MAV_CMD_DO_CHANGE_SPEED, WIRE.MAV_CMD_NAV_WAYPOINT]
    assert [made.items[at].command for at in made.at] == [WIRE.MAV_CMD_NAV_WAYPOINT] * len(GANDO)
    assert [item.seq for item in made.items] == list(range(len(commands)))
    usual = [replace(waypoint, speed_kt=70.0) for waypoint in GANDO]
    assert len(items_of(usual, 70.0).items) == len(GANDO)


def test_flying_to_a_change_of_speed_means_the_waypoint_after_it() -> None:
    made = items_of(GANDO, None)
    assert (made.waypoint_at(0), made.waypoint_at(1)) == (0, 0)
    assert made.waypoint_at(made.at[-1]) == len(GANDO) - 1
    with pytest.raises(ValueError, match="no item"):
        made.waypoint_at(made.at[-1] + 1)


def item(command: int = WIRE.MAV_CMD_NAV_WAYPOINT, frame: int = WIRE.MAV_FRAME_GLOBAL_INT, **changes: Any) -> Any:
    made = MAKE.mission_item_int_encode(1, 1, 0, frame, command, 0, 1, 0, 0, 0, 0, 279000000, -154000000, 120.0)
    for name, value in changes.items():
        setattr(made, name, value)
    return made


def test_a_height_above_home_is_converted_by_the_home_that_was_told() -> None:
    above_home = item(frame=WIRE.MAV_FRAME_GLOBAL_RELATIVE_ALT_INT)
    (waypoint,) = plan_of([above_home], 70.0, Home(27.9, -15.4, 100.0))
    assert waypoint.altitude_ft == pytest.approx(220 / 0.3048)


@pytest.mark.parametrize(
    ("items", "result", "words"),
    [
        ([item(frame=WIRE.MAV_FRAME_GLOBAL_RELATIVE_ALT_INT)], "UNSUPPORTED_FRAME", "above home"),
        ([item(frame=WIRE.MAV_FRAME_GLOBAL_TERRAIN_ALT_INT)], "UNSUPPORTED_FRAME", "above mean sea level"),
        ([item(WIRE.MAV_CMD_NAV_RETURN_TO_LAUNCH)], "UNSUPPORTED", "NAV_RETURN_TO_LAUNCH"),
        ([item(60_000)], "UNSUPPORTED", "60000"),
        ([item(z=math.nan)], "INVALID_PARAM7", "no altitude"),
        ([item(WIRE.MAV_CMD_DO_CHANGE_SPEED, param1=1.0)], "INVALID_PARAM1", "over ground"),
        ([item(WIRE.MAV_CMD_DO_CHANGE_SPEED, param2=-1.0)], "INVALID_PARAM2", "no speed"),
        ([item(WIRE.MAV_CMD_DO_CHANGE_SPEED, param2=30.0)], "DENIED", "at least one waypoint"),
        ([item()] * 101, "NO_SPACE", "100"),
    ],
)
def test_what_the_board_cannot_fly_is_refused_in_words(items: list[Any], result: str, words: str) -> None:
    with pytest.raises(PlanError, match=words) as refused:
        plan_of(items, 70.0, None)
    assert refused.value.result == getattr(WIRE, f"MAV_MISSION_{result}")


def test_a_plan_without_any_speed_is_refused() -> None:
    with pytest.raises(PlanError, match="--speed-kt"):
        plan_of([item()], None, None)
