"""Plans uploaded to the running board, whole or not at all, and read back."""

from collections.abc import Sequence

import pytest

from board_tests.line.station import LEVEL_FLIGHT, Station

DONE, BAD_VALUE, BAD_STATE = 0, 1, 2
FLIGHT, HIL = 0, 1

Waypoint = tuple[float, float, float, float]
SQUARE: tuple[Waypoint, ...] = (
    (27.95123456789, -15.37987654321, 700.0, 55.0),
    (27.96, -15.36, 900.0, 60.0),
    (27.94, -15.35, 1100.0, 50.0),
)


def upload(station: Station, plan: int, waypoints: Sequence[Waypoint]) -> int:
    """Write the plan; the result of the commit."""
    assert station.ask("mission_begin", plan, len(waypoints)) == DONE
    for index, waypoint in enumerate(waypoints):
        assert station.ask("mission_item", plan, index, *waypoint) == DONE
    return station.ask("mission_commit", plan)


def read(station: Station, plan: int) -> list[Waypoint]:
    """The plan that the board holds."""
    station.frames.clear()
    station.command("mission_read", plan)
    _, count = station.wait(lambda: station.newest("mission_count")).values
    station.wait(lambda: station.count("mission_item") >= count)
    items = [frame.values for frame in station.frames if frame.message.name == "mission_item"]
    assert [item[:2] for item in items] == [(plan, index) for index in range(count)]
    return [item[2:] for item in items]


@pytest.mark.parametrize("plan", [FLIGHT, HIL])
def test_an_uploaded_plan_is_read_back_in_full_precision(extended: Station, plan: int) -> None:
    assert upload(extended, plan, SQUARE) == DONE
    assert read(extended, plan) == list(SQUARE)
    assert read(extended, 1 - plan) == []


def test_a_hundred_waypoints_are_possible_and_one_more_is_not(extended: Station) -> None:
    many = [(27.9 + index / 1000, -15.4, 1000.0, 55.0) for index in range(100)]
    assert upload(extended, HIL, many) == DONE
    assert read(extended, HIL) == many
    begin = (HIL).to_bytes(4, "little") + (101).to_bytes(4, "little")
    assert extended.ask_bytes(0x104, extended.raw_command("mission_begin", begin)) == BAD_VALUE
    extended.command("exit_binary_mode")
    assert sum(" ft " in line for line in extended.lines("hil")) == 100


def test_an_incomplete_upload_leaves_the_old_plan(extended: Station) -> None:
    upload(extended, HIL, SQUARE)
    assert extended.ask("mission_begin", HIL, 3) == DONE
    assert extended.ask("mission_item", HIL, 0, 28.0, -15.0, 500.0, 40.0) == DONE
    assert extended.ask("mission_item", HIL, 2, 28.0, -15.0, 500.0, 40.0) == DONE
    assert extended.ask("mission_commit", HIL) == BAD_STATE
    assert read(extended, HIL) == list(SQUARE)


def test_an_impossible_waypoint_is_refused(extended: Station) -> None:
    upload(extended, HIL, SQUARE)
    assert extended.ask("mission_begin", HIL, 1) == DONE
    pack = extended.command_struct("mission_item").pack
    for wrong in ((HIL, 0, 91.0, 0.0, 500.0, 40.0), (HIL, 0, 28.0, float("nan"), 500.0, 40.0),
                  (HIL, 0, 28.0, -15.0, 500.0, -1.0), (HIL, 1, 28.0, -15.0, 500.0, 40.0),
                  (2, 0, 28.0, -15.0, 500.0, 40.0)):  # fmt: skip
        assert extended.ask_bytes(0x105, extended.raw_command("mission_item", pack(*wrong))) == BAD_VALUE
    assert extended.ask("mission_commit", HIL) == BAD_STATE
    assert read(extended, HIL) == list(SQUARE)


def test_the_station_chooses_the_waypoint(extended: Station) -> None:
    extended.command("xplane_info", *LEVEL_FLIGHT)
    upload(extended, HIL, SQUARE)
    assert extended.ask("fms_hil_plan_on") == DONE
    assert extended.ask("go_to_waypoint", HIL, 2) == DONE
    extended.next("fms_hil_plan")
    bearing_deg, altitude_ft, speed_kt, distance_m, waypoint = extended.next("fms_hil_plan").values
    assert (altitude_ft, speed_kt, waypoint) == (1100.0, 50.0, 2)
    assert 100.0 < bearing_deg < 115.0
    assert 2900 < distance_m < 3300
    assert extended.ask("go_to_waypoint", HIL, 3) == BAD_VALUE
    assert extended.ask("go_to_waypoint", FLIGHT, 0) == BAD_STATE


def test_an_uploaded_hil_plan_has_no_route_s_name(extended: Station) -> None:
    extended.ask("hil_load_gando")
    assert extended.wait(lambda: extended.next("board_status").values[3] == 0)
    upload(extended, HIL, SQUARE)
    extended.next("board_status")
    assert extended.next("board_status").values[3] == -1


def test_reading_a_long_plan_does_not_keep_the_hil_answers_waiting(extended: Station) -> None:
    upload(extended, HIL, [(27.9 + index / 1000, -15.4, 1000.0, 55.0) for index in range(60)])
    extended.frames.clear()
    extended.command("mission_read", HIL)
    extended.command("xplane_info", *LEVEL_FLIGHT)
    extended.wait(lambda: extended.newest("hil_surfaces"))
    assert extended.count("mission_item") < 60
    extended.wait(lambda: extended.count("mission_item") == 60)
