"""The live documents: whole and valid however long the track, and no name can get into their structure."""

from __future__ import annotations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from epf_gcs.formats.kml import Position
from epf_gcs.formats.kml_live import Aircraft, Link, NamedTrack, link_document, live_document, track_document
from tests.support.kml import child_texts, element, schema_faults, texts

HERE: Position = (27.93, -15.38, 300.0)
LEVEL = Aircraft("A", HERE, 90.0, 0.0, 0.0)
MODEL = "http://127.0.0.1:8000/api/v1/earth/aircraft.dae"


def line(points: int) -> list[Position]:
    return [(27.0 + step * 1e-4, -15.0, 300.0 + step) for step in range(points)]


def live(*aircraft: Aircraft, followed: Aircraft | None = None) -> bytes:
    return b"".join(live_document("x", aircraft, followed, [], MODEL))


@settings(max_examples=20)
@given(st.lists(st.integers(2, 450), max_size=4), st.text(max_size=30))
def test_a_track_of_any_length_is_one_valid_document(lengths: list[int], name: str) -> None:
    data = b"".join(track_document(name, [NamedTrack(name, [line(length) for length in lengths])]))
    assert schema_faults(data) == []
    assert [len(text.split()) for text in texts(data, "coordinates")] == lengths


def test_a_long_track_comes_in_pieces_that_are_short_work() -> None:
    pieces = list(track_document("x", [NamedTrack("x", [line(10_000)])]))
    assert len(pieces) > 40
    assert max(len(piece) for piece in pieces) < 20_000


def test_two_tracks_keep_their_names_and_lines() -> None:
    data = b"".join(track_document("x", [NamedTrack("one", [line(2)]), NamedTrack("two", [line(3), line(4)])]))
    assert texts(data, "name") == ["x", "one", "two"]
    assert [len(text.split()) for text in texts(data, "coordinates")] == [2, 3, 4]


@given(st.text())
def test_no_name_gets_into_the_structure(name: str) -> None:
    data = live(Aircraft(name, HERE, 1.0, 2.0, 3.0))
    assert schema_faults(data) == []
    assert len(texts(data, "Placemark")) == 1


@pytest.mark.parametrize(("pitch_deg", "roll_deg"), [(5.0, -30.0), (-89.0, 179.0), (0.0, 0.0)])
def test_nose_up_and_right_wing_down_are_negative_in_kml(pitch_deg: float, roll_deg: float) -> None:
    data = live(Aircraft("A", HERE, 359.5, pitch_deg, roll_deg))
    assert schema_faults(data) == []
    orientation = {name: float(text) for name, text in child_texts(element(data, "Orientation")).items()}
    assert orientation == {"heading": 359.5, "tilt": -pitch_deg, "roll": -roll_deg}
    assert texts(data, "href") == [MODEL]


def test_without_an_attitude_there_is_a_place_and_no_model() -> None:
    data = live(Aircraft("A", HERE))
    assert schema_faults(data) == []
    assert (texts(data, "Model"), texts(data, "coordinates")) == ([], ["-15.380000000,27.930000000,300.000000"])


def test_the_view_stays_behind_the_followed_aircraft() -> None:
    view = child_texts(element(live(LEVEL, followed=LEVEL), "LookAt"))
    assert (view["heading"], view["latitude"], view["altitudeMode"]) == ("90", "27.93", "absolute")
    assert texts(live(LEVEL), "LookAt") == []


def test_links_are_asked_again_or_once() -> None:
    links = [Link("often", "http://a/?x=1&y=2", 1, moves_view=True), Link("once", "http://b/", None)]
    data = link_document("x", links)
    assert schema_faults(data) == []
    assert texts(data, "href") == ["http://a/?x=1&y=2", "http://b/"]
    assert (texts(data, "refreshInterval"), texts(data, "flyToView")) == (["1"], ["1", "0"])
