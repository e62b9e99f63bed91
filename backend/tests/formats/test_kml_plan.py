"""KML: ours is what the schema wants, and Google Earth's is understood."""

from __future__ import annotations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from epf_gcs.codec.tables import Waypoint
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


@pytest.mark.parametrize(
    "mode",
    ["<altitudeMode>relativeToGround</altitudeMode>", "<gx:altitudeMode>relativeToSeaFloor</gx:altitudeMode>"],
)
def test_a_height_above_the_ground_is_refused_and_never_flown_as_one_above_the_sea(mode: str) -> None:
    error = refusal(path(mode=mode, altitude="152.4"))
    assert error.code == "mission_file_above_ground"
    assert "absolute altitudes" in error.detail


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
