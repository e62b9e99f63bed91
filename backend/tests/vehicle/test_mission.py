"""Plans as values."""

from __future__ import annotations

import math
from dataclasses import asdict, replace

import pytest

from epf_gcs.codec.messages_gen import ROUTES
from epf_gcs.codec.tables import Waypoint
from epf_gcs.codec.values import single
from epf_gcs.vehicle.mission import MAX_WAYPOINTS, item_arguments, mission_fault, same_plan, waypoint_from

GANDO = ROUTES["gando"].waypoints


def test_a_known_route_can_be_sent() -> None:
    assert mission_fault(GANDO) is None
    assert mission_fault([GANDO[0]] * MAX_WAYPOINTS) is None


@pytest.mark.parametrize("count", [0, MAX_WAYPOINTS + 1])
def test_a_plan_has_at_least_one_and_at_most_a_hundred_waypoints(count: int) -> None:
    assert mission_fault([GANDO[0]] * count) == f"A plan has 1 to 100 waypoints, not {count}."


@pytest.mark.parametrize(
    ("field", "value"),
    [("latitude_deg", 90.1), ("longitude_deg", -180.1), ("altitude_ft", math.nan), ("speed_kt", -1.0)],
)
def test_a_wrong_waypoint_is_named(field: str, value: float) -> None:
    wrong: Waypoint = replace(GANDO[1], **{field: value})
    found = mission_fault([GANDO[0], wrong])
    assert found is not None
    assert found.startswith(f"Waypoint 1: {field}")


def test_the_way_to_the_board_and_back_is_no_difference() -> None:
    there = Waypoint(27.95151234567, -15.37411234567, 700.1, 55.3)
    plan, index, latitude, longitude, altitude, speed = item_arguments(1, 7, there)
    assert (plan, index) == (1, 7)
    values = {
        "latitude_deg": latitude,
        "longitude_deg": longitude,
        "altitude_ft": single(altitude),
        "speed_kt": single(speed),
    }
    back = waypoint_from(values)
    assert back is not None
    assert same_plan([there], [back])
    assert not same_plan([there], [replace(back, speed_kt=56.0)])
    assert not same_plan([there], [back, back])
    assert waypoint_from({**values, "speed_kt": None}) is None


@pytest.mark.parametrize("field", ["latitude_deg", "longitude_deg", "altitude_ft", "speed_kt"])
@pytest.mark.parametrize("missing", [None, "27.9"])
def test_a_waypoint_with_a_value_that_is_no_number_is_none(field: str, missing: str | None) -> None:
    values = asdict(GANDO[0])
    assert waypoint_from(values) == GANDO[0]
    assert waypoint_from({**values, field: missing}) is None
    del values[field]
    assert waypoint_from(values) is None


def test_a_plan_is_another_one_if_any_field_of_any_waypoint_differs() -> None:
    for field, value in (("latitude_deg", 1e-9), ("longitude_deg", 1e-9), ("altitude_ft", 0.01), ("speed_kt", 0.01)):
        there = Waypoint(27.5, -15.25, 700.0, 55.0)
        found = replace(there, **{field: getattr(there, field) + value})
        assert same_plan([there, there], [there, there])
        assert not same_plan([there, there], [there, found])
