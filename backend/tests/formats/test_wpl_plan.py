"""Mission Planner's lists of waypoints: what it saves is understood, and what is left out is said."""

from __future__ import annotations

import contextlib

import pytest
from hypothesis import given
from hypothesis import strategies as st

from epf_gcs.codec.tables import Waypoint
from epf_gcs.errors import InvalidInputError
from tests.formats.plans import notes, read, refusal

HOME = "0\t1\t0\t16\t0\t0\t0\t0\t27.931900\t-15.386600\t24.384000\t1"


def item(seq: int, command: int, params: str, frame: int = 3) -> str:
    return f"{seq}\t0\t{frame}\t{command}\t{params}\t1"


def waypoint(seq: int, latitude: str, longitude: str, altitude: str, frame: int = 3) -> str:
    return item(seq, 16, f"0.00\t0.00\t0.00\t0.00\t{latitude}\t{longitude}\t{altitude}", frame)


def wpl(*lines: str, version: str = "110", end: str = "\r\n") -> bytes:
    return end.join([f"QGC WPL {version}", *lines, ""]).encode()


def test_the_first_item_is_home_and_heights_count_from_it() -> None:
    found = read(wpl(HOME, waypoint(1, "27.94", "-15.37", "121.92"), waypoint(2, "27.95", "-15.36", "304.8", 0)))
    assert found.format == "waypoints"
    assert found.waypoints == (Waypoint(27.94, -15.37, 480.0, 55.0), Waypoint(27.95, -15.36, 1000.0, 55.0))
    assert notes(found)["altitude_from_home"] == {"count": 1, "home_ft": 80.0}
    assert notes(found)["home_skipped"] == {"latitude_deg": 27.9319, "longitude_deg": -15.3866}


def test_a_file_that_begins_with_item_1_has_no_home_and_loses_no_waypoint() -> None:
    """Its first waypoint was taken for home: lost, and its height above home became home's altitude."""
    relative = wpl(waypoint(1, "27.94", "-15.37", "120"), waypoint(2, "27.95", "-15.36", "120"))
    error = refusal(relative)
    assert error.code == "mission_file_no_home"
    assert "line 2" in error.detail
    found = read(wpl(waypoint(1, "27.94", "-15.37", "304.8", 0), waypoint(2, "27.95", "-15.36", "304.8", 0)))
    assert [one.latitude_deg for one in found.waypoints] == [27.94, 27.95]
    assert "home_skipped" not in notes(found)


def test_take_off_landing_and_jumps_are_left_out_and_named_and_a_speed_holds() -> None:
    lines = (
        HOME,
        item(1, 22, "15\t0\t0\t0\t0\t0\t30"),
        item(2, 178, "0\t30.866666667\t0\t0\t0\t0\t0"),
        waypoint(3, "27.94", "-15.37", "304.8", 0),
        item(4, 177, "1\t-1\t0\t0\t0\t0\t0"),
        item(5, 21, "0\t0\t0\t0\t27.9\t-15.4\t0"),
    )
    found = read(wpl(*lines))
    assert [at.speed_kt for at in found.waypoints] == [60.0]
    assert notes(found)["items_skipped"] == {"count": 3, "kinds": "22, 177, 21"}


def test_a_byte_order_mark_spaces_and_empty_lines_do_no_harm() -> None:
    lines = (HOME.replace("\t", "  "), "", waypoint(1, "27.94", "-15.37", "304.8", 0))
    assert len(read(b"\xef\xbb\xbf" + wpl(*lines, end="\n")).waypoints) == 1


@pytest.mark.parametrize(
    ("data", "code"),
    [
        (wpl(HOME), "mission_file_no_waypoints"),
        (wpl(HOME, "1\t0\t3\t16\t0\t0"), "mission_file_damaged"),
        (wpl(HOME, waypoint(1, "north", "-15.37", "100")), "mission_file_unreadable"),
        (wpl(HOME, waypoint(1, "97.94", "-15.37", "100")), "mission_file_out_of_range"),
        (wpl(HOME, waypoint(1, "27.94", "-15.37", "100", 1)), "mission_file_frame"),
        (wpl(item(0, 22, "0\t0\t0\t0\t0\t0\t9"), waypoint(1, "27.94", "-15.37", "100")), "mission_file_no_home"),
        (wpl(HOME, waypoint(1, "27.94", "-15.37", "100"), version="120"), "mission_file_unknown"),
        (b"QGC WPL 110\n\xff\xfe", "mission_file_damaged"),
        (wpl(HOME, *(waypoint(n, "27.94", "-15.37", "100", 0) for n in range(1, 102))), "mission_file_too_long"),
    ],
)
def test_what_is_no_plan_is_refused_with_its_reason(data: bytes, code: str) -> None:
    assert refusal(data).code == code


@given(st.text(max_size=300), st.integers(0, 200))
def test_any_text_behind_the_first_line_is_refused_or_a_whole_plan(text: str, cut: int) -> None:
    data = (wpl(HOME, waypoint(1, "27.94", "-15.37", "100")) + text.encode("utf-8", "ignore"))[: 20 + cut]
    # Anything else that is raised is a fault of the reader.
    with contextlib.suppress(InvalidInputError):
        assert read(data).waypoints


@pytest.mark.parametrize("frame", [0, 5])
def test_a_file_without_home_keeps_its_first_waypoint(frame: int) -> None:
    found = read(wpl(waypoint(1, "27.94", "-15.37", "304.8", frame), waypoint(2, "27.95", "-15.36", "365.76", frame)))
    assert found.waypoints == (Waypoint(27.94, -15.37, 1000.0, 55.0), Waypoint(27.95, -15.36, 1200.0, 55.0))
    assert "home_skipped" not in notes(found)


# Each frame of MAVLink: what becomes of 120 m at a waypoint of a file whose home is 24.384 m above the sea.
@pytest.mark.parametrize(
    ("frame", "with_home", "without_home"),
    [
        ("0", 393.7008, 393.7008),
        ("5", 393.7008, 393.7008),
        ("3", 473.7008, "mission_file_no_home"),
        ("6", 473.7008, "mission_file_no_home"),
        ("10", "mission_file_above_ground", "mission_file_above_ground"),
        ("11", "mission_file_above_ground", "mission_file_above_ground"),
        *(
            (str(frame), "mission_file_frame", "mission_file_frame")
            for frame in (1, 2, 4, 7, 8, 9, *range(12, 23), -1, 99)
        ),
        ("3.7", "mission_file_unreadable", "mission_file_unreadable"),
        ("0.9", "mission_file_unreadable", "mission_file_unreadable"),
    ],
)
def test_every_frame_is_kept_or_refused(frame: str, with_home: float | str, without_home: float | str) -> None:
    line = waypoint(1, "27.94", "-15.37", "120").replace("\t3\t16", f"\t{frame}\t16")
    for data, expected in ((wpl(HOME, line), with_home), (wpl(line), without_home)):
        if isinstance(expected, str):
            assert refusal(data).code == expected
        else:
            assert [at.altitude_ft for at in read(data).waypoints] == [expected]


def test_a_height_above_the_ground_is_named_by_its_line_and_counted() -> None:
    lines = [waypoint(n, "27.94", "-15.37", "120", 10 if n > 1 else 0) for n in (1, 2, 3)]
    error = refusal(wpl(HOME, *lines))
    assert "the height of line 4 is above the ground, and" in error.detail
    assert (error.params["place"], error.params["nth"], error.params["count"]) == ("@problem.place_line", 4, 2)


@pytest.mark.parametrize("frame", [3, 6, 10])
def test_a_first_item_that_may_be_home_or_a_waypoint_is_refused(frame: int) -> None:
    first = HOME.replace("\t0\t16", f"\t{frame}\t16")
    assert refusal(wpl(first, waypoint(1, "27.94", "-15.37", "120", 0))).code == "mission_file_home_unclear"


def test_item_0_with_the_height_of_a_waypoint_is_what_a_person_says() -> None:
    file = wpl(HOME.replace("\t0\t16", "\t3\t16"), waypoint(1, "27.94", "-15.37", "120"))
    as_waypoint = read(file, first="waypoint", home_ft=100.0)
    assert [round(at.latitude_deg, 2) for at in as_waypoint.waypoints][1:] == [27.94]
    assert len(as_waypoint.waypoints) == 2
    assert "home_skipped" not in notes(as_waypoint)
    as_home = read(file, first="home", home_ft=100.0)
    assert as_home.waypoints == as_waypoint.waypoints[1:]
    assert "home_skipped" in notes(as_home)
    nowhere = wpl("0\t1\t3\t16\t0\t0\t0\t0\t0\t0\t0\t1", waypoint(1, "27.94", "-15.37", "120"))
    assert len(read(nowhere, first="home", home_ft=100.0).waypoints) == 1
    with pytest.raises(InvalidInputError):
        read(nowhere, first="waypoint", home_ft=100.0)
    # Its height is no altitude of home, whichever it is.
    for first in ("home", "waypoint"):
        with pytest.raises(InvalidInputError) as caught:
            read(file, first=first)
        assert caught.value.code == "mission_file_no_home"


@pytest.mark.parametrize(
    "lines",
    [
        ("0\t1\t0\t16\t0\t0\t0\t0\t0\t0\t0\t1", waypoint(1, "27.94", "-15.37", "120")),
    ],
)
def test_a_home_that_was_not_set_gives_no_height(lines: tuple[str, ...]) -> None:
    assert refusal(wpl(*lines)).code == "mission_file_no_home"


def test_a_home_that_an_item_moves_gives_no_height() -> None:
    moved = (HOME, item(1, 179, "0\t0\t0\t0\t28.1\t-15.4\t900"), waypoint(2, "27.94", "-15.37", "120"))
    assert refusal(wpl(*moved)).code == "mission_file_home_moves"


def test_a_waypoint_without_a_place_is_no_place_in_the_gulf_of_guinea() -> None:
    assert refusal(wpl(HOME, waypoint(1, "0", "0", "120"))).code == "mission_file_unreadable"


def test_a_point_is_always_the_decimal_mark() -> None:
    assert read(wpl(HOME, waypoint(1, "27.935", "-15.386", "9.144", 0))).waypoints == (
        Waypoint(27.935, -15.386, 30.0, 55.0),
    )
