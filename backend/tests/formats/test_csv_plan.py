"""Tables of text, also as spreadsheets write them."""

from __future__ import annotations

import pytest

from epf_gcs.codec.tables import Waypoint
from epf_gcs.formats.csv_plan import write_csv
from tests.formats.plans import TWO, notes, read, refusal

HEADER = "latitude_deg,longitude_deg,altitude_ft,speed_kt"


def test_ours_is_a_plain_table() -> None:
    assert write_csv(TWO).decode() == f"{HEADER}\r\n27.93,-15.38,1000.0,60.0\r\n27.95,-15.36,1200.0,55.0\r\n"


@pytest.mark.parametrize(
    "text",
    [
        "latitude_deg;longitude_deg;altitude_ft;speed_kt\r\n27,93;-15,38;1000;60\r\n27,95;-15,36;1200;55\r\n",
        "sep=;\r\nlatitude_deg;longitude_deg;altitude_ft;speed_kt\r\n27,93;-15,38;1000,0;60\r\n27.95;-15.36;1200;55",
        "latitude_deg\tlongitude_deg\taltitude_ft\tspeed_kt\n27,93\t-15,38\t1000\t60\n\n27,95\t-15,36\t1200\t55\n",
        f'{HEADER}\n"27,93","-15,38",1000,60\n27.95,-15.36,1200,55\n,,,\n',
        " Speed_kt , ALTITUDE_FT,longitude_deg,latitude_deg\n60,1000,-15.38,27.93\n55,1200,-15.36,27.95",
        "latitude_deg,longitude_deg,altitude_m,speed_m_s\n27.93,-15.38,304.8,30.866667\n27.95,-15.36,365.76,28.294444\n",
    ],
)
@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig", "utf-16"])
def test_the_ways_of_spreadsheets_are_understood(text: str, encoding: str) -> None:
    found = read(text.encode(encoding))
    assert [(at.latitude_deg, at.longitude_deg, at.altitude_ft) for at in found.waypoints] == [
        (at.latitude_deg, at.longitude_deg, at.altitude_ft) for at in TWO
    ]
    assert [at.speed_kt for at in found.waypoints] == pytest.approx([60.0, 55.0], abs=0.01)
    assert notes(found) == {}


def test_other_columns_are_left_out_and_named() -> None:
    text = "nombre;latitude_deg;longitude_deg;año\nPeña;27,93;-15,38;2013\n"
    found = read(text.encode("cp1252"))
    assert found.waypoints == (Waypoint(27.93, -15.38, 1000.0, 55.0),)
    assert notes(found) == {
        "columns_skipped": {"names": "nombre, año"},
        "altitude_missing": {"count": 1, "altitude_ft": 1000.0},
        "speed_missing": {"count": 1, "speed_kt": 55.0},
    }


@pytest.mark.parametrize(
    ("text", "code", "words"),
    [
        ("lat,lon\n1,2\n", "mission_file_header", "line 1 does not name the columns latitude_deg, longitude_deg"),
        ("27.93,-15.38,1000,60\n", "mission_file_header", "does not name the columns latitude_deg"),
        (f"{HEADER}\n1,2,3,4\n1,,3,4\n", "mission_file_unreadable", "longitude_deg of line 3 is missing"),
        (f"{HEADER}\n\n\n1,x,3,4\n", "mission_file_unreadable", "longitude_deg of line 4 is no number ('x')"),
        (f"{HEADER}\n1,nan,3,4\n", "mission_file_unreadable", "longitude_deg of line 2 is no number ('nan')"),
        (f"{HEADER}\n1,1.000.5,3,4\n", "mission_file_unreadable", "longitude_deg of line 2 is no number"),
        (
            f"{HEADER}\n1,2,3,4\n91,2,3,4\n",
            "mission_file_out_of_range",
            "in line 3 latitude_deg must be in -90..90, not 91",
        ),
        (f"{HEADER}\n1,2,3,-4\n", "mission_file_out_of_range", "in line 2 speed_kt must be in 0..500, not -4"),
        (f'{HEADER}\n1,2,3,"{"4" * 140_000}\n', "mission_file_damaged", "line 2 is no row of a table"),
    ],
)
def test_a_line_that_is_none_is_named(text: str, code: str, words: str) -> None:
    error = refusal(text)
    assert error.code == code
    assert words in error.detail


@pytest.mark.parametrize(
    ("header", "row"),
    [
        ("latitude_deg;longitude_deg;altitude_ft", "27,935;-15,387;1.000"),
        ("latitude_deg;longitude_deg;altitude_ft", "27,935;-15,387;1,000"),
        ("latitude_deg,longitude_deg,altitude_ft", '27.935,-15.387,"1,000"'),
        ("latitude_deg;longitude_deg;altitude_m", "27,935;-15,387;12.500"),
    ],
)
def test_a_number_that_may_be_a_thousand_or_one_is_asked_about(header: str, row: str) -> None:
    error = refusal(f"{header}\n{row}\n")
    assert error.code == "mission_file_which_number"
    assert "altitude" in error.detail


def test_coordinates_and_whatever_a_thousand_times_as_much_cannot_be_have_three_decimals() -> None:
    found = read("latitude_deg;longitude_deg;altitude_ft;speed_kt\n27,935;-15.387;0.125;55.125\n")
    assert found.waypoints == (Waypoint(27.935, -15.387, 0.125, 55.125),)


def test_what_we_write_is_never_asked_about() -> None:
    ours = (Waypoint(27.935, -15.387, 12.345, 1.5), Waypoint(27.936, -15.387, 999.125, 0.25))
    assert read(write_csv(ours)).waypoints == ours


def sheet(altitude: str, header: str = "altitude_ft", latitude: str = "27,93", speed: str = "60") -> str:
    return f"latitude_deg;longitude_deg;{header};speed_kt\n{latitude};-15,38;{altitude};{speed}\n"


@pytest.mark.parametrize(
    ("text", "thousand", "decimal"),
    [
        ("1,000", "1000", "1.0"),
        ("1.000", "1000", "1.0"),
        ("12,345", "12345", "12.3450"),
        ("+1.250", "1250", "1.25"),
        ("-1.500", "-1500", "-1.5"),
    ],
)
def test_a_number_of_two_readings_is_a_question(text: str, thousand: str, decimal: str) -> None:
    error = refusal(sheet(text))
    assert error.code == "mission_file_which_number"
    assert error.params == {
        "name": "file",
        "place": "@problem.place_line",
        "nth": 2,
        "field": "altitude_ft",
        "value": text,
        "thousand": thousand,
        "decimal": decimal,
    }
    assert read(sheet(thousand)).waypoints[0].altitude_ft == float(thousand)
    assert read(sheet(decimal)).waypoints[0].altitude_ft == float(decimal)


@pytest.mark.parametrize(
    ("text", "altitude_ft"),
    [
        ("1,234.5", 1234.5),
        ("1.234,5", 1234.5),
        ("-1.234,5", -1234.5),
        ("1000,0", 1000.0),
        ("1000.125", 1000.125),
        ("0,125", 0.125),
        ("0.125", 0.125),
        ("1,0000", 1.0),
        ("1.00", 1.0),
        (".125", 0.125),
        # One of the two readings lies above all that the board takes.
        ("61.234", 61.234),
        ("-2.500", -2.5),
    ],
)
def test_a_number_of_one_reading_is_taken(text: str, altitude_ft: float) -> None:
    assert read(sheet(text)).waypoints[0].altitude_ft == altitude_ft


@pytest.mark.parametrize("text", ["1.000.00", "1,00,000", "1.000,000,0", "1,000.0.0", "01.000,5", "1.,5", "1.234.567,"])
def test_marks_in_wrong_places_are_no_number(text: str) -> None:
    assert refusal(sheet(text)).code == "mission_file_unreadable"


def test_each_column_asks_by_its_own_range_also_in_metres() -> None:
    assert read(sheet("1000", latitude="27.935", speed="61,500")).waypoints == (Waypoint(27.935, -15.38, 1000, 61.5),)
    assert refusal(sheet("18,000", "altitude_m")).code == "mission_file_which_number"
    assert read(sheet("18,900", "altitude_m")).waypoints[0].altitude_ft == pytest.approx(62.0079)
    assert refusal(sheet("1.234.567")).code == "mission_file_out_of_range"


@pytest.mark.parametrize("altitude_ft", [1.0, 1.25, 12.345, 59.999, -1.5, -1.234, 0.125, 500.125])
def test_what_we_write_is_read_without_a_question(altitude_ft: float) -> None:
    plan = (Waypoint(27.935, -15.386, altitude_ft, 1.125),)
    assert read(write_csv(plan)).waypoints == plan


def test_decimal_commas_between_commas_are_not_taken_for_other_columns() -> None:
    error = refusal(f"{HEADER}\n27.93,-15.38,1000,60\n27,93,-15,38,1000,60\n")
    assert (error.code, error.params["nth"]) == ("mission_file_cells", 3)
    assert len(read(f"{HEADER}\n27.93,-15.38,1000,60,,\n").waypoints) == 1


def test_metres_beside_feet_are_left_out_and_named() -> None:
    found = read("latitude_deg;longitude_deg;altitude_ft;altitude_m;speed_kt\n27,93;-15,38;1000;400;60\n")
    assert found.waypoints[0].altitude_ft == 1000.0
    assert notes(found) == {"columns_skipped": {"names": "altitude_m"}}
