"""KML: ours is what the schema wants, and Google Earth's is understood."""

from __future__ import annotations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from epf_gcs.codec.tables import Waypoint
from epf_gcs.errors import InvalidInputError
from epf_gcs.formats.kml_plan import write_kml
from tests.formats.plans import PLANS, TWO, notes, read, refusal
from tests.support.kml import schema_faults, texts

# As Google Earth saves a path that was drawn by hand.
PATH = """<?xml version="1.0" encoding="UTF-8"?>
<kml xmlns="http://www.opengis.net/kml/2.2" xmlns:gx="http://www.google.com/kml/ext/2.2"
     xmlns:kml="http://www.opengis.net/kml/2.2" xmlns:atom="http://www.w3.org/2005/Atom">
<Document>
	<name>Ruta Costa.kml</name>
	<StyleMap id="inline0"><Pair><key>normal</key><styleUrl>#inline1</styleUrl></Pair></StyleMap>
	<Placemark>
		<name>Ruta Costa</name>
		<styleUrl>#inline0</styleUrl>
		<LineString>
			<tessellate>1</tessellate>
			{mode}
			<coordinates>
				-15.3866,27.9319,{altitude} -15.3700,27.9400,{altitude}
				-15.3500,27.9500,{altitude}
			</coordinates>
		</LineString>
	</Placemark>
	{more}
</Document>
</kml>"""
ABSOLUTE = "<altitudeMode>absolute</altitudeMode>"
PIN = "<Placemark><name>Casa</name><Point><coordinates>-15.4,27.9,0</coordinates></Point></Placemark>"


def path(*, altitude: str = "304.8", mode: str = ABSOLUTE, more: str = "") -> str:
    return PATH.format(altitude=altitude, mode=mode, more=more)


@settings(max_examples=30)
@given(PLANS, st.text(max_size=30))
def test_ours_is_valid_whatever_the_plan_and_its_name(plan: list[Waypoint], name: str) -> None:
    assert schema_faults(write_kml(name, plan)) == []


def test_ours_shows_the_line_and_each_waypoint() -> None:
    data = write_kml("Ruta <Sur> & más", TWO)
    assert texts(data, "name") == ["Ruta <Sur> & más", "Ruta <Sur> & más", "Ruta <Sur> & más", "0", "1"]
    assert texts(data, "altitudeMode") == ["absolute"] * 3
    assert (
        texts(data, "coordinates")[0] == "-15.380000000,27.930000000,304.800000 -15.360000000,27.950000000,365.760000"
    )


def test_a_single_waypoint_is_no_line() -> None:
    assert schema_faults(write_kml("x", TWO[:1])) == []
    assert len(texts(write_kml("x", TWO[:1]), "LineString")) == 0


def test_a_path_of_google_earth_is_a_plan_without_speeds() -> None:
    found = read(path())
    assert found.waypoints == tuple(
        Waypoint(latitude, longitude, 1000.0, 55.0)
        for longitude, latitude in ((-15.3866, 27.9319), (-15.37, 27.94), (-15.35, 27.95))
    )
    assert notes(found) == {"speed_missing": {"count": 3, "speed_kt": 55.0}}


@pytest.mark.parametrize(
    ("mode", "altitude", "expected_ft", "note"),
    [
        ("", "0", 1000.0, ("altitude_missing", {"count": 3, "altitude_ft": 1000.0})),
        (
            "<altitudeMode>clampToGround</altitudeMode>",
            "0",
            1000.0,
            ("altitude_missing", {"count": 3, "altitude_ft": 1000.0}),
        ),
        ("", "152.4", 500.0, ("altitude_clamped", {"count": 3})),
        (
            "<gx:altitudeMode>clampToSeaFloor</gx:altitudeMode>",
            "0",
            1000.0,
            ("altitude_missing", {"count": 3, "altitude_ft": 1000.0}),
        ),
    ],
)
def test_altitudes_that_are_not_above_the_sea_are_told(
    mode: str, altitude: str, expected_ft: float, note: tuple[str, object]
) -> None:
    found = read(path(mode=mode, altitude=altitude))
    assert {waypoint.altitude_ft for waypoint in found.waypoints} == {expected_ft}
    assert notes(found)[note[0]] == note[1]


def test_the_first_line_is_the_plan_and_the_rest_is_told() -> None:
    found = read(path(more=PIN + PIN + path().split("<Document>")[1].split("</Document>")[0]))
    assert len(found.waypoints) == 3
    assert notes(found)["shapes_skipped"] == {"count": 3}


def test_pins_alone_are_the_waypoints_in_their_order() -> None:
    pins = "".join(
        f"<Placemark><Point>{ABSOLUTE}<coordinates>\n -15.{n}, 27.{n}, 100 \n</coordinates></Point></Placemark>"
        for n in (3, 1, 2)
    )
    found = read(f"<kml><Folder>{pins}</Folder></kml>")
    assert [waypoint.latitude_deg for waypoint in found.waypoints] == [27.3, 27.1, 27.2]


@pytest.mark.parametrize("namespace", ["http://earth.google.com/kml/2.1", "http://www.opengis.net/kml/2.3", ""])
def test_older_and_newer_namespaces_are_the_same_to_us(namespace: str) -> None:
    found = read(path().replace('xmlns="http://www.opengis.net/kml/2.2"', f'xmlns="{namespace}"' if namespace else ""))
    assert len(found.waypoints) == 3


@pytest.mark.parametrize(
    ("coordinates", "words"),
    [
        ("-15.3,27.9,300 -15.4", "coordinates 2 is not longitude,latitude,altitude ('-15.4')"),
        ("-15.3,27.9,300 -15.4,,300", "latitude_deg of coordinates 2 is missing"),
        ("-15.3,27.9,300 nan,27,300", "longitude_deg of coordinates 2 is no number ('nan')"),
        ("-15.3,27.9,inf -15.4,27,300", "altitude of coordinates 1 is no number ('inf')"),
        ("-15.3,1_0,300 -15.4,27,300", "latitude_deg of coordinates 1 is no number ('1_0')"),
        ("-15.3,٢٧,300 -15.4,27,300", "latitude_deg of coordinates 1 is no number"),
        ("-15.3,1e999,300 -15.4,27,300", "latitude_deg of coordinates 1 is no number ('1e999')"),
        ("-15.3,97.9,300 -15.4,27,300", "in coordinates 1 latitude_deg must be in -90..90, not 97.9"),
    ],
)
def test_a_position_that_is_none_is_named(coordinates: str, words: str) -> None:
    text = (
        f"<kml><Placemark><LineString>{ABSOLUTE}<coordinates>{coordinates}</coordinates></LineString></Placemark></kml>"
    )
    assert words in refusal(text).detail


def test_a_speed_of_ours_that_is_no_number_is_named() -> None:
    data = write_kml("x", TWO).replace(b"<value>55</value>", b"<value>fast</value>")
    assert "speed_kt of Placemark 3 is no number ('fast')" in refusal(data).detail


def test_a_broken_pin_beside_the_line_is_nobodys_fault() -> None:
    pin = "<Placemark><Point><coordinates>here</coordinates></Point></Placemark>"
    assert len(read(path(more=pin)).waypoints) == 3
    assert "Placemark 1 is not longitude,latitude,altitude ('here')" in refusal(f"<kml>{pin}</kml>").detail


@pytest.mark.parametrize(
    ("mode", "code"),
    [
        ("<altitudeMode>relativeToGround</altitudeMode>", "mission_file_above_ground"),
        ("<altitudeMode> relativeToGround\n</altitudeMode>", "mission_file_above_ground"),
        ("<gx:altitudeMode>relativeToSeaFloor</gx:altitudeMode>", "mission_file_frame"),
        ("<altitudeMode>Absolute</altitudeMode>", "mission_file_frame"),
        ("<altitudeMode>aboveTerrain</altitudeMode>", "mission_file_frame"),
        (f"<gx:altitudeOffset>100</gx:altitudeOffset>{ABSOLUTE}", "mission_file_frame"),
    ],
)
@pytest.mark.parametrize("altitude", ["152.4", "0"])
def test_altitudes_above_the_ground_or_of_an_unknown_kind_are_refused(mode: str, code: str, altitude: str) -> None:
    assert refusal(path(mode=mode, altitude=altitude)).code == code
    point = f"<Point>{mode}<coordinates>-15.4,27.9,{altitude}</coordinates></Point>"
    more = 'xmlns:gx="http://www.google.com/kml/ext/2.2"'
    error = refusal(f"<kml {more}><Placemark>{PIN.split('<Placemark>')[1]}<Placemark>{point}</Placemark></kml>")
    assert (error.code, error.params["nth"]) == (code, 2)


def test_a_mark_of_several_places_loses_none_in_silence() -> None:
    text = PIN.replace("-15.4,27.9,0", "-15.4,27.9,100 -15.3,27.8,100")
    assert refusal(f"<kml>{text}</kml>").code == "mission_file_unreadable"


def test_a_line_beside_our_own_marks_that_says_something_else_is_told() -> None:
    moved = write_kml("x", TWO).replace(b"27.930000000,304.800000 ", b"27.990000000,304.800000 ")
    assert read(moved).waypoints == TWO
    assert notes(read(moved)) == {"shapes_skipped": {"count": 1}}


def track(count: int, mode: str = ABSOLUTE) -> str:
    """A track of Google's extension that climbs to the north, with one corner."""
    coords = "".join(
        f"<gx:coord>{-15.4 + 0.001 * max(0, nth - 60):.6f} {27.9 + 0.001 * min(nth, 60):.6f} {100 + nth}</gx:coord>"
        for nth in range(count)
    )
    space = 'xmlns="http://www.opengis.net/kml/2.2" xmlns:gx="http://www.google.com/kml/ext/2.2"'
    return f"<kml {space}><Placemark><gx:Track>{mode}{coords}</gx:Track></Placemark></kml>"


def test_a_flown_track_is_asked_about_and_becomes_the_waypoints_at_its_corners() -> None:
    error = refusal(track(120))
    assert (error.code, error.params["points"], error.params["waypoints"]) == ("mission_file_track", 120, 3)
    found = read(track(120), thin=True)
    assert [(round(at.latitude_deg, 6), round(at.longitude_deg, 6)) for at in found.waypoints] == [
        (27.9, -15.4),
        (27.96, -15.4),
        (27.96, -15.341),
    ]
    assert found.waypoints[-1].altitude_ft == pytest.approx(219 / 0.3048, abs=1e-3)
    assert notes(found)["track_thinned"]["deviation_m"] == error.params["deviation_m"]


def test_a_track_above_the_ground_stays_above_it() -> None:
    mode = "<altitudeMode>relativeToGround</altitudeMode>"
    with pytest.raises(InvalidInputError, match="above the ground"):
        read(track(120, mode), thin=True)
    found = read(track(120, mode), thin=True, ground_ft=500.0)
    assert found.waypoints[0].altitude_ft == pytest.approx(500 + 100 / 0.3048, abs=1e-3)


def test_a_line_of_more_points_than_a_plan_takes_was_flown() -> None:
    many = " ".join(f"-15.4,{27.9 + nth * 0.0001},100" for nth in range(400))
    text = f"<kml><LineString>{ABSOLUTE}<coordinates>{many}</coordinates></LineString></kml>"
    assert refusal(text).code == "mission_file_track"
    assert len(read(text, thin=True).waypoints) == 2
