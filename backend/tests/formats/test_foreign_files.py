"""Small files as other programs write them: none changes a frame, loses a point or a digit in silence.

Each row says what a person is told: the altitudes above the sea of all waypoints and the notes, or the refusal.
"""

from __future__ import annotations

import io
import zipfile
from typing import Any, NamedTuple

import orjson
import pytest

from epf_gcs.errors import InvalidInputError
from epf_gcs.formats.fence_file import read_fence_file
from epf_gcs.units import ft_from_m
from tests.formats.plans import read

HOME_FT = 400.0
GROUND_FT = 250.0


class Row(NamedTuple):
    """`altitudes`: of the waypoints in order, feet above the sea, or the code of a refusal. `needs`: what the person
    answers or the station knows: home's altitude, the ground's, that a track is wanted."""

    what: str
    data: str | bytes
    altitudes: list[float] | str
    notes: set[str] = set()  # noqa: RUF012 - a default that nobody changes
    needs: str = ""


def kml(body: str) -> str:
    space = 'xmlns="http://www.opengis.net/kml/2.2" xmlns:gx="http://www.google.com/kml/ext/2.2"'
    return f'<?xml version="1.0" encoding="UTF-8"?><kml {space}><Document>{body}</Document></kml>'


def line(mode: str = "absolute", coordinates: str = "-5.10,40.1,100 -5.11,40.2,150.5") -> str:
    tag = f"<altitudeMode>{mode}</altitudeMode>" if mode else ""
    return f"<Placemark><LineString>{tag}<coordinates>{coordinates}</coordinates></LineString></Placemark>"


def pin(coordinates: str, mode: str = "absolute") -> str:
    point = f"<altitudeMode>{mode}</altitudeMode><coordinates>{coordinates}</coordinates>"
    return f"<Placemark><name>p</name><Point>{point}</Point></Placemark>"


def gpx(body: str) -> str:
    return f'<gpx version="1.1" creator="x" xmlns="http://www.topografix.com/GPX/1/1">{body}</gpx>'


def gpx_points(tag: str, *elevations: str) -> str:
    return "".join(
        f'<{tag} lat="{40 + nth / 10}" lon="-5.1">' + (f"<ele>{up}</ele>" if up else "") + f"</{tag}>"
        for nth, up in enumerate(elevations)
    )


def qgc(
    *items: dict[str, object], home: object = (40.0, -5.0, 200.0), fence: object = None, rally: object = None
) -> bytes:
    mission = {"version": 2, "plannedHomePosition": home, "items": items}
    parts = {"mission": mission, "geoFence": fence or {}, "rallyPoints": rally or {}}
    return orjson.dumps({"fileType": "Plan", "version": 1, "groundStation": "QGroundControl", **parts})


def kmz(text: str, name: str = "doc.kml") -> bytes:
    file = io.BytesIO()
    with zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr(name, text)
    return file.getvalue()


def simple(frame: int, altitude: float | None, command: int = 16, **more: object) -> dict[str, object]:
    params = [0, 0, 0, None, 40.1, -5.1, altitude]
    return {"type": "SimpleItem", "command": command, "frame": frame, "params": params, **more}


def wpl(*rows: str) -> str:
    return "QGC WPL 110\r\n" + "\r\n".join(row.replace(" ", "\t") for row in rows) + "\r\n"


RING = "<coordinates>-5.0,40.0,0 -5.1,40.0,0 -5.1,40.1,0 -5.0,40.0,0</coordinates>"
AREA = f"<Placemark><Polygon><outerBoundaryIs><LinearRing>{RING}</LinearRing></outerBoundaryIs></Polygon></Placemark>"
TRIANGLE = [[40.0, -5.0], [40.0, -5.1], [40.1, -5.1]]
SQUARE_FENCE: dict[str, Any] = {"circles": [], "polygons": [{"inclusion": True, "polygon": TRIANGLE, "version": 1}]}
HOME = "0 1 0 16 0 0 0 0 40.0 -5.0 200 1"
NONE: set[str] = set()
SPEED = {"speed_missing"}
M100, M150 = ft_from_m(100), ft_from_m(150.5)

PLANS = [
    Row("KML, a path with absolute heights", kml(line()), [M100, M150], SPEED),
    Row("KML, a path above the ground", kml(line("relativeToGround")), "mission_file_above_ground"),
    Row(
        "KML, a path above ground that is known",
        kml(line("relativeToGround")),
        [M100 + GROUND_FT, M150 + GROUND_FT],
        {"altitude_from_ground", *SPEED},
        "ground",
    ),
    Row("KML, a path above the sea floor", kml(line("relativeToSeaFloor")), "mission_file_frame"),
    Row("KML, a mode of no schema", kml(line("relativeToHome")), "mission_file_frame"),
    Row("KML, clamped, with heights", kml(line("clampToGround")), [M100, M150], {"altitude_clamped", *SPEED}),
    Row(
        "KML, no mode and no heights", kml(line("", "-5.1,40.1 -5.2,40.2")), [1000, 1000], {"altitude_missing", *SPEED}
    ),
    Row(
        "KML, spaces after the commas", kml(line("absolute", "-5.1, 40.1, 100 -5.2, 40.2, 150.5")), [M100, M150], SPEED
    ),
    Row(
        "KML, pins of two frames",
        kml(pin("-5,40,100") + pin("-5,41,100", "relativeToGround")),
        "mission_file_above_ground",
    ),
    Row(
        "KML, pins of two frames over known ground",
        kml(pin("-5,40,100") + pin("-5,41,100", "relativeToGround")),
        [M100, M100 + GROUND_FT],
        {"altitude_from_ground", *SPEED},
        "ground",
    ),
    Row("KML, two paths and a pin", kml(line() + line() + pin("-5,40,1")), [M100, M150], {"shapes_skipped", *SPEED}),
    Row("KML, a pin with two places", kml(pin("-5,40,1 -5,41,1")), "mission_file_unreadable"),
    Row("KML, latitude that is none", kml(line("absolute", "-5,91,1")), "mission_file_out_of_range"),
    Row("KML, cut", kml(line())[:-30], "mission_file_damaged"),
    Row(
        "KML, a flown track",
        kml(
            "<Placemark><gx:Track><altitudeMode>absolute</altitudeMode>"
            + "<gx:coord>-5 40 100</gx:coord>" * 3
            + "</gx:Track></Placemark>"
        ),
        "mission_file_track",
    ),
    Row("GPX, a route", gpx(f"<rte>{gpx_points('rtept', '100', '150.5')}</rte>"), [M100, M150], SPEED),
    Row(
        "GPX, marks, one without height", gpx(gpx_points("wpt", "100", "")), [M100, 1000], {"altitude_missing", *SPEED}
    ),
    Row(
        "GPX, a route and a track",
        gpx(f"<rte>{gpx_points('rtept', '100')}</rte><trk><trkseg>{gpx_points('trkpt', '1')}</trkseg></trk>"),
        [M100],
        {"shapes_skipped", *SPEED},
    ),
    Row(
        "GPX, a track",
        gpx(f"<trk><trkseg>{gpx_points('trkpt', '100', '101', '102')}</trkseg></trk>"),
        "mission_file_track",
    ),
    Row(
        "GPX, a track that is wanted",
        gpx(f"<trk><trkseg>{gpx_points('trkpt', '100', '100', '150.5')}</trkseg></trk>"),
        [M100, M100, M150],
        {"track_thinned", *SPEED},
        "track",
    ),
    Row("GPX, a decimal comma", gpx(f"<rte>{gpx_points('rtept', '100,5')}</rte>"), "mission_file_unreadable"),
    Row(".plan, above the sea", qgc(simple(0, 100, AltitudeMode=2)), [M100], SPEED),
    Row(
        ".plan, above home",
        qgc(simple(3, 100, AltitudeMode=1)),
        [M100 + ft_from_m(200)],
        {"altitude_from_home", *SPEED},
    ),
    Row(".plan, home that nobody set", qgc(simple(3, 100, AltitudeMode=1), home=[0, 0, 0]), "mission_file_no_home"),
    Row(
        ".plan, home without altitude",
        qgc(simple(3, 100), home=[40, -5, None]),
        [M100 + HOME_FT],
        {"altitude_from_home", *SPEED},
        "home",
    ),
    Row(
        ".plan, terrain frame",
        qgc(simple(10, 100, AltitudeMode=4)),
        [M100 + GROUND_FT],
        {"altitude_from_ground", *SPEED},
        "ground",
    ),
    Row(".plan, mode and frame that differ", qgc(simple(0, 100, AltitudeMode=1)), "mission_file_frame_differs"),
    Row(
        ".plan, take-off and landing",
        qgc(simple(3, 30, 22), simple(0, 100), simple(3, 0, 21)),
        [M100],
        {"items_skipped", *SPEED},
    ),
    Row(
        ".plan, a survey alone", qgc({"type": "ComplexItem", "complexItemType": "survey"}), "mission_file_no_waypoints"
    ),
    Row(".plan, north, east, down", qgc(simple(1, 100)), "mission_file_frame"),
    Row(
        ".waypoints, home and heights above it",
        wpl(HOME, "1 0 3 16 0 0 0 0 40.1 -5.1 100 1"),
        [M100 + ft_from_m(200)],
        {"altitude_from_home", "home_skipped", *SPEED},
    ),
    Row(".waypoints, no home", wpl("1 0 3 16 0 0 0 0 40.1 -5.1 100 1"), "mission_file_no_home"),
    Row(
        ".waypoints, home that is answered",
        wpl("1 0 3 16 0 0 0 0 40.1 -5.1 100 1"),
        [M100 + HOME_FT],
        {"altitude_from_home", *SPEED},
        "home",
    ),
    Row(".waypoints, above terrain", wpl(HOME, "1 0 10 16 0 0 0 0 40.1 -5.1 100 1"), "mission_file_above_ground"),
    Row(
        ".waypoints, item 0 with a height as waypoints have it",
        wpl(HOME.replace("0 1 0", "0 1 3"), "1 0 3 16 0 0 0 0 40.1 -5.1 100 1"),
        "mission_file_home_unclear",
    ),
    Row(
        ".waypoints, item 0 that is answered to be a waypoint",
        wpl(HOME.replace("0 1 0", "0 1 3"), "1 0 3 16 0 0 0 0 40.1 -5.1 100 1"),
        [ft_from_m(200) + HOME_FT, M100 + HOME_FT],
        {"altitude_from_home", *SPEED},
        "home, item 0 a waypoint",
    ),
    Row(
        ".waypoints, home moved in flight",
        wpl(HOME, "1 0 0 179 1 0 0 0 0 0 0 1", "2 0 3 16 0 0 0 0 40.1 -5.1 100 1"),
        "mission_file_home_moves",
    ),
    Row(".waypoints, a place of zeros", wpl(HOME, "1 0 0 16 0 0 0 0 0 0 100 1"), "mission_file_unreadable"),
    Row(".waypoints, a fence", wpl(*["1 0 3 5001 3 0 0 0 40.1 -5.1 0 1"] * 3), "mission_file_fence"),
    Row("rows of a fence", "40.0 -5.0\n40.0 -5.1\n40.1 -5.1\n40.0 -5.0\n", "mission_file_fence"),
    Row("CSV, ours", "latitude_deg,longitude_deg,altitude_ft,speed_kt\n40.123,-5.1,812.5,55\n", [812.5], NONE),
    Row(
        "CSV, of a Spanish spreadsheet",
        "latitude_deg;longitude_deg;altitude_m;speed_kt\n40,123;-5,1;150,5;55\n",
        [M150],
        NONE,
    ),
    Row(
        "CSV, one or a thousand",
        "latitude_deg,longitude_deg,altitude_ft\n40.1,-5.1,1.200\n",
        "mission_file_which_number",
    ),
    Row(
        "CSV, decimal commas between commas",
        "latitude_deg,longitude_deg,altitude_ft\n40,1,-5,1,1200\n",
        "mission_file_cells",
    ),
    Row(
        "CSV, columns of others",
        "latitude_deg,longitude_deg,altitude_ft,agl_ft\n40.1,-5.1,900,120\n",
        [900],
        {"columns_skipped", *SPEED},
    ),
    Row("CSV, columns that nobody knows", "lat,lon,alt\n40.1,-5.1,120\n", "mission_file_header"),
    Row("KMZ of Google Earth", kmz(kml(line())), [M100, M150], SPEED),
    Row("KMZ without a KML", kmz("x", "picture.png"), "mission_file_archive"),
    Row("KML, an area", kml(AREA), "mission_file_fence"),
    Row("KML, an area and a path", kml(AREA + line()), [M100, M150], SPEED),
    Row(
        "CSV in UTF-16 with tabs",
        "latitude_deg\tlongitude_deg\taltitude_ft\tspeed_kt\r\n40.1\t-5.1\t900\t55\r\n".encode("utf-16"),
        [900],
        NONE,
    ),
    Row(".plan, a fence alone", qgc(fence=SQUARE_FENCE), "mission_file_fence"),
    Row(".plan, a fence and a waypoint", qgc(simple(0, 100), fence=SQUARE_FENCE), [M100], SPEED),
    Row(".plan, rally points alone", qgc(rally={"points": [[40.1, -5.1, 50]]}), "mission_file_other"),
    Row(".waypoints, rally points", wpl("0 1 3 5100 0 0 0 0 40.1 -5.1 50 1"), "mission_file_other"),
    Row("rally points of MAVProxy", "RALLY 40.1 -5.1 50.0 0.0 0.0 0\n", "mission_file_other"),
    Row("GeoJSON", '{"type": "FeatureCollection", "features": []}', "mission_file_other"),
    Row(".params", "# Onboard parameters for Vehicle 1\n1\t1\tTRIM_THROTTLE\t45.000000\t9\n", "mission_file_other"),
    Row(".param of Mission Planner", "ACRO_LOCKING,0\r\nAHRS_COMP_BETA,0.1\r\n", "mission_file_other"),
    Row("a log of ArduPilot", b"\xa3\x95\x80\x80\x59FMT\0", "mission_file_other"),
    Row("a log of PX4", b"ULog\x01\x12\x35\x01\0\0", "mission_file_other"),
    Row("MAVLink as it was received", b"\0\x05\x8e\x1b\xaa\xbb\xcc\xdd\xfd\x09\0", "mission_file_other"),
    Row("a recorded flight", b"\x89MCAP0\r\n\x01", "mission_file_other"),
    Row("a picture", b"\x89PNG\r\n\x1a\n\0\0", "mission_file_unknown"),
    Row("nothing", "", "mission_file_empty"),
]


@pytest.mark.parametrize("row", PLANS, ids=[row.what for row in PLANS])
def test_a_plan_of_another_program_is_read_whole_or_refused_in_words(row: Row) -> None:
    answers = {
        "home_ft": HOME_FT if "home" in row.needs else None,
        "first": "waypoint" if "item 0" in row.needs else None,
        "ground_ft": GROUND_FT if row.needs == "ground" else None,
        "thin": row.needs == "track",
    }
    if isinstance(row.altitudes, str):
        with pytest.raises(InvalidInputError) as caught:
            read(row.data, **answers)  # type: ignore[arg-type]
        assert caught.value.code == row.altitudes
        assert caught.value.detail.startswith("'file' cannot be read as a flight plan because ")
        return
    found = read(row.data, **answers)  # type: ignore[arg-type]
    assert [at.altitude_ft for at in found.waypoints] == pytest.approx(row.altitudes, abs=1e-3)
    assert {note.code for note in found.notes} == row.notes


SQUARE = "40.0 -5.0\n40.0 -5.1\n40.1 -5.1\n40.0 -5.0\n"
FENCES = [
    ("MAVProxy, with the place to return to", f"40.05 -5.05\n{SQUARE}", 3, {"return_skipped"}),
    ("rows alone", SQUARE, 3, NONE),
    (
        "fence items",
        wpl(
            HOME,
            *[
                "1 0 3 5001 3 0 0 0 40.0 -5.0 0 1",
                "2 0 3 5001 3 0 0 0 40.0 -5.1 0 1",
                "3 0 3 5001 3 0 0 0 40.1 -5.1 0 1",
            ],
        ),
        3,
        NONE,
    ),
    ("a circle", wpl("1 0 3 5003 250 0 0 0 40.0 -5.0 0 1"), 36, {"circle_cornered"}),
    ("an area to stay out of", wpl("1 0 3 5004 250 0 0 0 40.0 -5.0 0 1"), "fence_file_no_fence", NONE),
    ("a border that does not close", "40.0 -5.0\n40.0 -5.1\n40.1 -5.1\n40.1 -5.0\n", "fence_file_open", NONE),
    ("a plan", wpl(HOME, "1 0 3 16 0 0 0 0 40.1 -5.1 100 1"), "fence_file_plan", NONE),
    ("a plan of QGroundControl", qgc(simple(0, 100)), "fence_file_plan", NONE),
    ("a path of Google Earth", kml(line()), "fence_file_plan", NONE),
    ("a plan as CSV", "latitude_deg,longitude_deg\n40.1,-5.1\n", "fence_file_plan", NONE),
    ("parameters", "ACRO_LOCKING,0\n", "fence_file_unknown", NONE),
    ("a polygon of QGroundControl", qgc(fence=SQUARE_FENCE), 3, NONE),
    (
        "a circle of QGroundControl",
        qgc(fence={"circles": [{"inclusion": True, "circle": {"center": [40.0, -5.0], "radius": 250}}]}),
        36,
        {"circle_cornered"},
    ),
    ("an area of Google Earth, packed", kmz(kml(AREA)), 3, NONE),
    ("a border that crosses itself", "40.0 -5.0\n40.1 -5.1\n40.1 -5.0\n40.0 -5.1\n40.0 -5.0\n", 4, {"crosses"}),
    ("rows with commas and a remark", f"# campo\n{SQUARE.replace(' ', ', ')}", 3, NONE),
]


@pytest.mark.parametrize(("what", "data", "corners", "notes"), FENCES, ids=[fence[0] for fence in FENCES])
def test_a_fence_of_another_program_is_read_whole_or_refused_in_words(
    what: str, data: str | bytes, corners: int | str, notes: set[str]
) -> None:
    packed = data.encode() if isinstance(data, str) else data
    if isinstance(corners, str):
        with pytest.raises(InvalidInputError) as caught:
            read_fence_file(what, packed)
        assert caught.value.code == corners
        return
    found = read_fence_file(what, packed)
    assert len(found.corners) == corners
    assert {note.code for note in found.notes} == notes
