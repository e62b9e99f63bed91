"""Any file of any kind: ours come back exactly, and whatever is no plan is refused in one sentence."""

from __future__ import annotations

import contextlib
import io
import zipfile

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from epf_gcs.codec.messages_gen import ROUTES
from epf_gcs.codec.tables import Waypoint
from epf_gcs.contract.flights import FlownPath
from epf_gcs.errors import InvalidInputError
from epf_gcs.formats.mission_file import FileFormat
from epf_gcs.formats.recognise import MAX_FILE_BYTES, WRITERS, plan_of_path, settle_plan
from epf_gcs.vehicle.mission import mission_fault
from tests.formats.plans import PLANS, TWO, notes, read, refusal

FORMATS = list(WRITERS)
READ_AS = {"kmz": "kml"}
BOMB = (
    '<?xml version="1.0"?><!DOCTYPE lolz [<!ENTITY lol "lol">'
    + "".join(f'<!ENTITY lol{n + 1} "{f"&lol{n};" * 10}">' for n in range(9)).replace("&lol0;", "&lol;")
    + "]><kml><Document><name>&lol9;</name></Document></kml>"
)
STEALER = '<!DOCTYPE gpx [<!ENTITY x SYSTEM "file:///etc/passwd">]><gpx><rte><name>&x;</name></rte></gpx>'


def kmz(name: str, data: bytes) -> bytes:
    file = io.BytesIO()
    with zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("files/picture.png", b"no picture")
        archive.writestr(name, data)
    return file.getvalue()


def assert_refused_or_whole(data: bytes) -> None:
    """Nothing but a plan that a board takes, or an InvalidInputError, comes out of any bytes."""
    with contextlib.suppress(InvalidInputError):
        assert mission_fault(read(data).waypoints) is None


@pytest.mark.parametrize("format_name", FORMATS)
@settings(max_examples=60, suppress_health_check=[HealthCheck.too_slow, HealthCheck.large_base_example])
@given(plan=PLANS, title=st.text(max_size=40))
def test_what_was_written_comes_back(format_name: FileFormat, plan: list[Waypoint], title: str) -> None:
    found = read(WRITERS[format_name](title, plan))
    assert (found.format, found.notes) == (READ_AS.get(format_name, format_name), ())
    assert len(found.waypoints) == len(plan)
    for written, came_back in zip(plan, found.waypoints, strict=True):
        assert abs(came_back.latitude_deg - written.latitude_deg) <= 1e-7
        assert abs(came_back.longitude_deg - written.longitude_deg) <= 1e-7
        assert abs(came_back.altitude_ft - written.altitude_ft) <= 0.01
        assert abs(came_back.speed_kt - written.speed_kt) <= 0.01


@pytest.mark.parametrize("format_name", FORMATS)
@pytest.mark.parametrize("route", ROUTES)
def test_a_route_of_the_board_comes_back_as_it_is_written_by_people(format_name: FileFormat, route: str) -> None:
    """No 1000.0000000000001 ft in anybody's table."""
    waypoints = ROUTES[route].waypoints
    assert read(WRITERS[format_name](route, waypoints)).waypoints == waypoints


@pytest.mark.parametrize("format_name", FORMATS)
def test_the_content_says_what_a_file_is_and_not_its_name(format_name: FileFormat) -> None:
    assert read(WRITERS[format_name]("x", TWO), "notes.txt").format == READ_AS.get(format_name, format_name)


@given(st.binary(max_size=300))
def test_no_bytes_do_anything_but_be_refused_or_read(data: bytes) -> None:
    assert_refused_or_whole(data)


@pytest.mark.parametrize("format_name", FORMATS)
@settings(max_examples=150, suppress_health_check=[HealthCheck.too_slow])
@given(place=st.integers(0, 10000), byte=st.integers(0, 255), cut=st.booleans())
def test_a_damaged_file_is_refused_or_still_a_whole_plan(
    format_name: FileFormat, place: int, byte: int, cut: bool
) -> None:
    data = WRITERS[format_name]("x", TWO)
    place %= len(data)
    damaged = data[:place] if cut else data[:place] + bytes((byte,)) + data[place + 1 :]
    assert_refused_or_whole(damaged)


def test_an_archive_cut_or_damaged_at_any_byte_is_refused_or_still_a_whole_plan() -> None:
    """Every place, because a random one finds what zipfile raises only now and then."""
    data = WRITERS["kmz"]("x", TWO)
    for place in range(len(data)):
        assert_refused_or_whole(data[:place])
        for byte in (0, 1, 255):
            assert_refused_or_whole(data[:place] + bytes((byte,)) + data[place + 1 :])


@pytest.mark.parametrize(
    ("data", "code"),
    [
        (b"", "mission_file_empty"),
        (b" \r\n\t ", "mission_file_empty"),
        (b"\xef\xbb\xbf", "mission_file_empty"),
        (b"\xff\xfe", "mission_file_empty"),
        (BOMB.encode(), "mission_file_forbidden"),
        (STEALER.encode(), "mission_file_forbidden"),
        (b"<kml><Document></kml>", "mission_file_damaged"),
        (b'<?xml version="1.0" encoding="no-such"?><kml/>', "mission_file_damaged"),
        (b"<" * 1000, "mission_file_damaged"),
        (b"<a>" * 200_000, "mission_file_damaged"),
        (b"<svg xmlns='http://www.w3.org/2000/svg'/>", "mission_file_unknown"),
        (b"{" * 100_000, "mission_file_damaged"),
        (b'{"fileType": "Plan"', "mission_file_damaged"),
        (b'{"fileType": "Plan", "mission": {"items": NaN}}', "mission_file_damaged"),
        (b'{"type": "FeatureCollection"}', "mission_file_other"),
        (bytes(range(256)) * 20, "mission_file_unknown"),
        (b"\x7fELF" + bytes(2000), "mission_file_unknown"),
        (b"\x89PNG\r\n\x1a\n" + bytes(range(256)), "mission_file_unknown"),
        (b"\xff\xfel\0a\0t", "mission_file_unknown"),
        (b"PK\x03\x04 and nothing else", "mission_file_archive"),
        (kmz("doc.txt", b"hello"), "mission_file_archive"),
        (kmz("doc.kml", b" " * (MAX_FILE_BYTES + 1)), "mission_file_archive"),
        (kmz("doc.kml", BOMB.encode()), "mission_file_forbidden"),
        (b"The quick brown fox", "mission_file_header"),
        (b"<kml/>", "mission_file_no_waypoints"),
        (b"<gpx/>", "mission_file_no_waypoints"),
        (b"latitude_deg,longitude_deg\n", "mission_file_no_waypoints"),
        (b'{"fileType": "Plan", "mission": {}}', "mission_file_no_waypoints"),
    ],
)
def test_what_is_no_plan_is_refused_with_its_reason(data: bytes, code: str) -> None:
    assert refusal(data).code == code


@pytest.mark.parametrize("format_name", FORMATS)
@pytest.mark.parametrize(
    ("bad", "field"),
    [
        (Waypoint(90.1, 0, 0, 0), "latitude_deg"),
        (Waypoint(0, -180.5, 0, 0), "longitude_deg"),
        (Waypoint(0, 0, 60001, 0), "altitude_ft"),
        (Waypoint(0, 0, 0, 501), "speed_kt"),
    ],
)
def test_one_point_out_of_range_refuses_the_whole_file_and_is_named(
    format_name: FileFormat, bad: Waypoint, field: str
) -> None:
    error = refusal(WRITERS[format_name]("x", [*TWO, bad]))
    assert error.code == "mission_file_out_of_range"
    assert error.params["field"] == field
    assert str(error.params["nth"]) in error.detail
    assert field in error.detail


@pytest.mark.parametrize("format_name", FORMATS)
def test_a_plan_that_is_too_long_says_how_long_it_may_be(format_name: FileFormat) -> None:
    error = refusal(WRITERS[format_name]("x", TWO * 51))
    assert (error.code, error.params["maximum"]) == ("mission_file_too_long", 100)


def test_a_kmz_of_google_earth_is_read() -> None:
    found = read(kmz("doc.kml", WRITERS["kml"]("x", TWO)))
    assert (found.format, found.waypoints, notes(found)) == ("kml", TWO, {})


def test_a_flown_path_is_asked_about_with_its_figures_before_it_is_a_plan() -> None:
    path = FlownPath(4000, 3, 12.34, [[28.0, -15.0, 100.0], [28.1, -15.1, 304.8]])
    with pytest.raises(InvalidInputError) as caught:
        plan_of_path("20260131T120000Z", path, thin=False)
    assert caught.value.code == "mission_file_track"
    figures = {"points": 4000, "waypoints": 2, "deviation_m": 12.3}
    assert caught.value.params == {"name": "20260131T120000Z", **figures}
    found = settle_plan("x", plan_of_path("x", path, thin=True))
    assert [round(at.altitude_ft) for at in found.waypoints] == [328, 1000]
    assert notes(found)["track_thinned"] == figures
    assert notes(found)["track_pieces"] == {"count": 3}


def test_a_flight_without_a_track_is_no_plan() -> None:
    with pytest.raises(InvalidInputError) as caught:
        settle_plan("x", plan_of_path("x", FlownPath(0, 0, 0.0, []), thin=False))
    assert caught.value.code == "mission_file_no_waypoints"
