"""GPX of hand-helds and planners, and ours."""

from __future__ import annotations

import pytest
from lxml import etree

from epf_gcs.codec.tables import Waypoint
from epf_gcs.formats.gpx_plan import write_gpx
from tests.formats.plans import TWO, notes, read, refusal

# As a hand-held writes it: marks, a route, and the track of a walk with times and measured speeds.
HAND_HELD = """<?xml version="1.0" encoding="UTF-8" standalone="no" ?>
<gpx xmlns="http://www.topografix.com/GPX/1/1" creator="eTrex 30" version="1.1"
     xmlns:gpxtpx="http://www.garmin.com/xmlschemas/TrackPointExtension/v1">
  <metadata><time>2013-05-04T10:00:00Z</time></metadata>
  <wpt lat="27.9000" lon="-15.4000"><ele>24.384</ele><name>001</name><sym>Flag, Blue</sym></wpt>
  {route}
  <trk><name>04-MAY-13</name><trkseg>
    <trkpt lat="27.91" lon="-15.41"><ele>30.48</ele><time>2013-05-04T10:00:00Z</time>
      <extensions><gpxtpx:TrackPointExtension><gpxtpx:speed>1.2</gpxtpx:speed></gpxtpx:TrackPointExtension></extensions>
    </trkpt>
    <trkpt lat="27.92" lon="-15.42"><ele>60.96</ele></trkpt>
  </trkseg></trk>
</gpx>"""
ROUTE = """<rte><name>RUTA</name>
  <rtept lat="27.9319" lon="-15.3866"><ele>304.8</ele><name>A</name></rtept>
  <rtept lat="27.95" lon="-15.36"><ele>365.76</ele></rtept></rte>"""


def test_the_route_of_a_hand_held_is_the_plan() -> None:
    found = read(HAND_HELD.format(route=ROUTE))
    assert found.waypoints == (Waypoint(27.9319, -15.3866, 1000.0, 55.0), Waypoint(27.95, -15.36, 1200.0, 55.0))
    assert notes(found) == {"shapes_skipped": {"count": 2}, "speed_missing": {"count": 2, "speed_kt": 55.0}}


def test_without_a_route_the_marks_are_the_plan() -> None:
    found = read(HAND_HELD.format(route=""))
    assert found.waypoints == (Waypoint(27.9, -15.4, 80.0, 55.0),)


def test_a_walks_speed_is_never_a_speed_to_fly() -> None:
    track = HAND_HELD.format(route="").replace("<wpt", "<!--").replace("</wpt>", "-->")
    assert refusal(track).code == "mission_file_track"
    found = read(track, thin=True)
    assert found.waypoints == (Waypoint(27.91, -15.41, 100.0, 55.0), Waypoint(27.92, -15.42, 200.0, 55.0))


def test_points_without_elevation_get_one_that_is_told() -> None:
    found = read('<gpx version="1.0"><rte><rtept lat="27.9" lon="-15.4"/></rte></gpx>')
    assert found.waypoints == (Waypoint(27.9, -15.4, 1000.0, 55.0),)
    assert notes(found)["altitude_missing"] == {"count": 1, "altitude_ft": 1000.0}


def test_a_file_with_prefixes_is_read_too() -> None:
    text = '<g:gpx xmlns:g="http://www.topografix.com/GPX/1/1"><g:rte><g:rtept lat="1" lon="2"/></g:rte></g:gpx>'
    assert read(text).waypoints[0].longitude_deg == 2.0


@pytest.mark.parametrize(
    ("point", "words"),
    [
        ('lat="27.9"', "longitude_deg of rtept 2 is missing"),
        ('lat="north" lon="1"', "latitude_deg of rtept 2 is no number ('north')"),
        ('lat="NaN" lon="1"', "latitude_deg of rtept 2 is no number ('NaN')"),
        ('lat="1" lon="181"', "in rtept 2 longitude_deg must be in -180..180, not 181"),
    ],
)
def test_a_point_that_is_none_is_named(point: str, words: str) -> None:
    text = f'<gpx><rte><rtept lat="1" lon="2"/><rtept {point}/></rte></gpx>'
    assert words in refusal(text).detail


def test_ours_is_gpx_1_1_in_the_order_of_its_schema() -> None:
    root = etree.fromstring(write_gpx("Ruta <1>", TWO))
    space = "{http://www.topografix.com/GPX/1/1}"
    assert (root.tag, root.get("version"), bool(root.get("creator"))) == (f"{space}gpx", "1.1", True)
    (route,) = root
    assert [child.tag.removeprefix(space) for child in route] == ["name", "rtept", "rtept"]
    assert [child.tag.removeprefix(space) for child in route[1]] == ["ele", "name", "extensions"]
    assert route[1][2][0].tag == "{urn:epf-gcs:mission:1}speed_kt"


def test_a_point_is_always_the_decimal_mark() -> None:
    assert read('<gpx><rte><rtept lat="27.935" lon="-15.386"><ele>9.144</ele></rtept></rte></gpx>').waypoints == (
        Waypoint(27.935, -15.386, 30.0, 55.0),
    )
