"""Fences as files: ours come back exactly, Google Earth's and QGroundControl's are understood, the rest is refused."""

from __future__ import annotations

import io
import math
import zipfile
from typing import Any

import orjson
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from epf_gcs.errors import InvalidInputError
from epf_gcs.formats.fence_border import Corner, crossing_edges
from epf_gcs.formats.fence_file import read_fence_file, write_fence_kml, write_fence_plan
from tests.support.kml import schema_faults

CORNERS: tuple[Corner, ...] = ((28.0, -15.5), (28.0, -15.4), (28.1, -15.4))


def _around(centre: Corner, spokes: dict[int, float]) -> list[Corner]:
    """A border without crossings: its corners in the order of their bearing (degrees), so far from the centre."""
    latitude, longitude = centre
    return [
        (
            round(latitude + far * math.cos(math.radians(bearing)), 6),
            round((longitude + far * math.sin(math.radians(bearing)) + 180.0) % 360.0 - 180.0, 6),
        )
        for bearing, far in sorted(({0: 3.0, 120: 3.0, 240: 3.0} | spokes).items())
    ]


FENCES = st.builds(
    _around,
    st.tuples(st.floats(-80, 80), st.floats(-180, 180)),
    st.dictionaries(st.integers(0, 359), st.floats(0.5, 5.0), max_size=90),
)

# As Google Earth saves a polygon that was drawn by hand.
DRAWN = """<?xml version="1.0" encoding="UTF-8"?>
<kml xmlns="http://www.opengis.net/kml/2.2" xmlns:gx="http://www.google.com/kml/ext/2.2"><Document>
<Placemark><name>Campo</name>{first}</Placemark><Placemark><name>Otro</name>{more}</Placemark>
</Document></kml>"""
RING = "-15.5,28,0 -15.4,28,0 -15.4,28.1,0 -15.5,28,0"


def polygon(ring: str = RING, hole: str = "") -> str:
    border = f"<outerBoundaryIs><LinearRing><coordinates>\n\t{ring}\n</coordinates></LinearRing></outerBoundaryIs>"
    return f"<Polygon><tessellate>1</tessellate>{border}{hole}</Polygon>"


def drawn(first: str, more: str = "") -> bytes:
    return DRAWN.format(first=first, more=more).encode()


def plan(polygons: list[Any] | None = None, circles: list[Any] | None = None) -> bytes:
    fence = {"circles": circles or [], "polygons": polygons or [], "version": 2}
    return orjson.dumps({"fileType": "Plan", "geoFence": fence, "mission": {}, "version": 1})


def counted(data: bytes) -> dict[str, Any]:
    return {note.code: note.params["count"] for note in read_fence_file("x", data).notes}


@settings(max_examples=30)
@given(FENCES, st.none() | st.floats(-1500, 60_000), st.text(max_size=30))
def test_ours_comes_back_exactly_and_is_what_the_schema_wants(
    corners: list[Corner], ceiling_ft: float | None, name: str
) -> None:
    data = write_fence_kml(name, corners, ceiling_ft)
    assert schema_faults(data) == []
    found = read_fence_file("x.kml", data)
    assert (found.format, found.corners, found.notes) == ("kml", tuple(corners), ())
    assert found.ceiling_ft == (None if ceiling_ft is None else pytest.approx(ceiling_ft, abs=1e-9))
    read = read_fence_file("x.plan", write_fence_plan(corners))
    assert (read.format, read.corners, read.ceiling_ft, read.notes) == ("plan", tuple(corners), None, ())


def test_a_polygon_a_closed_path_and_an_archive_of_google_earth_are_fences() -> None:
    assert read_fence_file("x", drawn(polygon())).corners == CORNERS
    assert read_fence_file("x", drawn(polygon(RING.replace(",", " , ")))).corners == CORNERS
    line = f"<LineString><coordinates>{RING}</coordinates></LineString>"
    assert read_fence_file("x", drawn(line)).corners == CORNERS
    packed = io.BytesIO()
    with zipfile.ZipFile(packed, "w") as archive:
        archive.writestr("doc.kml", drawn(polygon()))
    assert read_fence_file("x", packed.getvalue()).corners == CORNERS


def test_what_a_fence_cannot_have_is_left_out_and_said() -> None:
    hole = "<innerBoundaryIs><LinearRing><coordinates>0,0 1,0 1,1 0,0</coordinates></LinearRing></innerBoundaryIs>"
    assert counted(drawn(polygon(hole=hole), polygon())) == {"shapes_skipped": 1, "exclusions_skipped": 1}
    border = {"inclusion": True, "polygon": [list(corner) for corner in CORNERS], "version": 1}
    out = {**border, "inclusion": False}
    circle = {"circle": {"center": [28.0, -15.0], "radius": 500.0}, "inclusion": True, "version": 1}
    assert counted(plan([out, border], [circle])) == {"shapes_skipped": 1, "exclusions_skipped": 1}
    assert read_fence_file("x", plan([out, border])).corners == CORNERS


def test_a_circle_becomes_corners_that_all_lie_on_it() -> None:
    circle = {"circle": {"center": [60.0, 179.999], "radius": 1000.0}, "inclusion": True}
    found = read_fence_file("x", plan(circles=[circle]))
    assert counted(plan(circles=[circle])) == {"circle_cornered": 36}
    assert max(latitude for latitude, _ in found.corners) == pytest.approx(60 + 1000 / 111_195, abs=1e-6)
    east = [(longitude - 179.999 + 180) % 360 - 180 for _, longitude in found.corners]
    assert max(east) == pytest.approx(2 * 1000 / 111_195, rel=1e-6)
    assert min(longitude for _, longitude in found.corners) < -179, "it goes over the date line"


@pytest.mark.parametrize(
    ("data", "code"),
    [
        (b"", "fence_file_unknown"),
        (b"\x00\xff\x00", "fence_file_unknown"),
        (drawn(polygon())[:-20], "fence_file_unknown"),
        (b"<gpx/>", "fence_file_unknown"),
        (b'<!DOCTYPE kml [<!ENTITY a "b">]><kml>&a;</kml>', "fence_file_unknown"),
        (b"PK\x03\x04 no archive", "fence_file_unknown"),
        (plan()[:-3], "fence_file_unknown"),
        (b'{"fileType":"GeoFence"}', "fence_file_unknown"),
        (b'{"fileType":"Plan","geoFence":[3]}', "fence_file_no_fence"),
        (plan(), "fence_file_no_fence"),
        (plan([{"inclusion": False, "polygon": [list(corner) for corner in CORNERS]}]), "fence_file_no_fence"),
        (drawn("<Point><coordinates>1,2</coordinates></Point>"), "fence_file_plan"),
        (drawn("<LineString><coordinates>1,2 3,4 5,6 7,8</coordinates></LineString>"), "fence_file_plan"),
        (drawn("<Polygon/>"), "fence_file_no_fence"),
        (drawn(polygon("1,2 3,4 1,2")), "fence_file_corners"),
        (plan([{"polygon": [[1, index / 100] for index in range(101)]}]), "fence_file_corners"),
        (plan([{"polygon": 7}]), "fence_file_corners"),
        (drawn(polygon("1,2 3,x 5,6")), "fence_file_place"),
        (drawn(polygon("1,2 3,91 5,6")), "fence_file_place"),
        (drawn(polygon("1,2 nan,4 5,6")), "fence_file_place"),
        (plan([{"polygon": [[1, 2], [True, 3], [4, 5]]}]), "fence_file_place"),
        (plan([{"polygon": [[1, 2], {}, [4, 5]]}]), "fence_file_place"),
        (plan(circles=[{"circle": {"center": [28, -15], "radius": -3}}]), "fence_file_place"),
        (plan(circles=[{"circle": {"center": "here", "radius": 3}}]), "fence_file_place"),
        (plan(circles=[{"circle": None}]), "fence_file_place"),
    ],
)
def test_what_is_no_fence_is_refused_with_a_reason(data: bytes, code: str) -> None:
    with pytest.raises(InvalidInputError) as caught:
        read_fence_file("x.plan", data)
    assert caught.value.code == code
    assert caught.value.params["name"] == "x.plan"


@settings(max_examples=200)
@given(st.binary(max_size=200) | st.builds(lambda cut: drawn(polygon())[:cut], st.integers(0, 700)))
def test_no_bytes_do_more_than_be_refused(data: bytes) -> None:
    try:
        found = read_fence_file("x", data)
    except InvalidInputError:
        return
    assert 3 <= len(found.corners) <= 100


@pytest.mark.parametrize(
    ("corners", "sides"),
    [
        ([(27.0, -15.0), (28.0, -14.0), (28.0, -15.0), (27.0, -14.0)], (1, 3)),
        ([(0.0, 179.5), (1.0, -179.5), (1.0, 179.5), (0.0, -179.5)], (1, 3)),  # over the date line
        ([(0.0, 0.0), (0.0, 2.0), (2.0, 1.0), (0.0, 1.0), (2.0, 0.0)], (1, 3)),  # a corner on another side
        ([(0.0, 0.0), (0.0, 2.0), (0.0, 1.0), (1.0, 1.0)], (1, 2)),  # a spike
    ],
)
def test_a_border_that_crosses_itself_is_read_with_its_two_sides(corners: list[Corner], sides: tuple[int, int]) -> None:
    assert crossing_edges(corners) == sides
    (note,) = read_fence_file("x.plan", write_fence_plan(corners)).notes
    assert note == ("crosses", {"first": sides[0], "second": sides[1]})


@given(FENCES)
def test_a_border_around_a_place_crosses_nothing(corners: list[Corner]) -> None:
    assert crossing_edges(corners) is None
    assert crossing_edges(corners[::-1]) is None


def test_a_side_that_goes_on_straight_crosses_nothing() -> None:
    assert crossing_edges([(0.0, 0.0), (0.0, 1.0), (0.0, 2.0), (1.0, 1.0)]) is None


ROWS = "28.0 -15.5\n28.0 -15.4\n28.1 -15.4\n28.0 -15.5\n"


def fence_items(*rows: tuple[int, float, float, float], head: str = "") -> bytes:
    """Command, first parameter, latitude and longitude of each item."""
    lines = [f"{nth}\t0\t3\t{row[0]}\t{row[1]}\t0\t0\t0\t{row[2]}\t{row[3]}\t0\t1" for nth, row in enumerate(rows, 1)]
    return ("QGC WPL 110\n" + head + "\n".join(lines) + "\n").encode()


INSIDE = [(5001, 3.0, *corner) for corner in CORNERS]


def test_fence_items_of_a_list_of_waypoints_are_read_and_the_others_passed_over() -> None:
    home = "0\t1\t0\t16\t0\t0\t0\t0\t28.01\t-15.42\t20\t1\n"
    found = read_fence_file("x", fence_items((5000, 0, 28.02, -15.45), *INSIDE, head=home))
    assert (found.format, found.corners) == ("waypoints", CORNERS)
    away = [(5002, 3.0, latitude + 1, longitude) for latitude, longitude in CORNERS]
    more = fence_items(*away, (5004, 80.0, 28.3, -15.1), *INSIDE, *INSIDE, (5003, 500.0, 28.0, -15.0))
    assert read_fence_file("x", more).corners == CORNERS
    assert counted(more) == {"exclusions_skipped": 2, "shapes_skipped": 2}
    circle = fence_items((5003, 500.0, 28.0, -15.0))
    assert len(read_fence_file("x", circle).corners) == counted(circle)["circle_cornered"] == 36


def test_rows_are_a_closed_border_with_the_place_to_return_to_before_it_or_without() -> None:
    assert read_fence_file("x", ROWS.encode()).corners == CORNERS
    with_return = f"#saved by a planner\r\n28.05\t-15.45\r\n{ROWS}".encode()
    found = read_fence_file("x", with_return)
    assert (found.format, found.corners, counted(with_return)) == ("rows", CORNERS, {"return_skipped": 1})


@pytest.mark.parametrize(
    ("data", "code", "nth"),
    [
        (fence_items(*INSIDE[:2]), "fence_file_rows", 3),
        (fence_items(*INSIDE[:2], (5002, 3.0, 28.0, -15.0)), "fence_file_rows", 3),
        (fence_items(*INSIDE[:2], (16, 0.0, 28.0, -15.0)), "fence_file_rows", 3),
        (b"QGC WPL 110\n0\t1\t0\n", "fence_file_rows", 2),
        (b"28.0 -15.5\n28.0 -15.4\n28.1 -15.4\n28.1 -15.5\n", "fence_file_open", 4),
        (b"28.0 -15.5\nnorth\n", "fence_file_rows", 2),
    ],
)
def test_rows_that_are_not_whole_are_refused_by_their_line(data: bytes, code: str, nth: int) -> None:
    with pytest.raises(InvalidInputError) as caught:
        read_fence_file("x.fen", data)
    assert (caught.value.code, caught.value.params["nth"]) == (code, nth)
