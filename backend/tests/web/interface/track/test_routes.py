"""The flown tracks: their points in one piece, whole as files of every kind, cleared and brought back."""

from __future__ import annotations

import io
import struct
import zipfile
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import pytest
from lxml import etree

from tests.support.fake_board import FakeBoard
from tests.support.gateway import Gateway, running_gateway
from tests.support.kml import element, schema_faults, texts
from tests.support.waiting import eventually

GPX = "{http://www.topografix.com/GPX/1/1}"


class Points(NamedTuple):
    epoch: int
    first: int
    total: int
    t0_s: float
    records: list[tuple[int, int, int, int]]


def read_points(gateway: Gateway, query: str = "source=flight") -> Points:
    answer = gateway.http.get(f"/track/points?{query}").raise_for_status()
    assert answer.headers["content-type"] == "application/octet-stream"
    assert int(answer.headers["content-length"]) == len(answer.content)
    kind, epoch, first, count, total, zero, t0_s = struct.unpack_from("<4sIIIIId", answer.content)
    assert (kind, zero) == (b"EPT1", 0)
    records = list(struct.iter_unpack("<Iiii", answer.content[32:]))
    assert len(records) == count == total - first
    return Points(epoch, first, total, t0_s, records)


def get_kml(gateway: Gateway, path: str) -> bytes:
    answer = gateway.http.get(path).raise_for_status()
    assert answer.headers["content-type"] == "application/vnd.google-earth.kml+xml"
    assert schema_faults(answer.content) == []
    return answer.content


def points(gateway: Gateway) -> tuple[int, int]:
    state = gateway.http.get("/track").raise_for_status().json()
    return state["flight_points"], state["hil_points"]


@pytest.fixture
def emulated(gateway: Gateway) -> Gateway:
    gateway.open_board("emulation:")
    eventually(lambda: min(points(gateway)) > 20, "a track is flown")
    return gateway


def test_what_was_flown_comes_in_one_piece_and_then_only_what_is_missing(gateway: Gateway, board: FakeBoard) -> None:
    assert read_points(gateway).records == []
    gateway.open_board(board.url)
    fly(gateway, board, [27.9000, 27.9001, 27.9002])
    found = read_points(gateway)
    assert [latitude for _, latitude, _, _ in found.records] == pytest.approx([279000000, 279001000, 279002000], abs=20)
    assert {(longitude, altitude) for _, _, longitude, altitude in found.records} == {(-153800001, 300000)}
    assert found.t0_s + found.records[-1][0] / 1e3 == pytest.approx(gateway.flight.clock.now_s(), abs=20)
    fly(gateway, board, [27.9003])
    further = read_points(gateway, f"source=flight&after=3&epoch={found.epoch}")
    assert (further.epoch, further.first, further.total, len(further.records)) == (found.epoch, 3, 4, 1)
    assert read_points(gateway, f"source=flight&after=4&epoch={found.epoch}").records == []
    assert read_points(gateway, "source=hil").records == []


def test_who_has_points_of_another_track_gets_all_of_this_one(gateway: Gateway, board: FakeBoard) -> None:
    gateway.open_board(board.url)
    fly(gateway, board, [27.9000, 27.9001, 27.9002])
    before = read_points(gateway).epoch
    gateway.http.post("/track/reset").raise_for_status()
    fly(gateway, board, [27.9003, 27.9004])
    after = read_points(gateway, f"source=flight&after=1&epoch={before}")
    assert after.epoch != before
    assert (after.first, len(after.records)) == (0, 2)
    gateway.http.post("/track/restore").raise_for_status()
    restored = read_points(gateway, f"source=flight&after=2&epoch={after.epoch}")
    assert restored.epoch not in (before, after.epoch)
    assert (restored.first, len(restored.records)) == (0, 5)
    beyond = read_points(gateway, f"source=flight&after=6&epoch={restored.epoch}")
    assert (beyond.first, len(beyond.records)) == (0, 5)
    gateway.open_board("emulation:")
    assert read_points(gateway).epoch != restored.epoch


def test_every_file_holds_every_point_of_a_flight_that_is_over(gateway: Gateway) -> None:
    """Thousands of points, so that more than one piece is sent; the same in KML, KMZ, GPX and CZML."""
    track = gateway.web.tracks.now.hil
    for step in range(9000):
        track.add(1e9 + 0.02 * step, (28.0 + 2e-6 * step, -15.4, 100.0 + 0.01 * step), (10.0, 5.0, -20.0))
    line = texts(get_kml(gateway, "/track.kml"), "coordinates")[0].split()
    assert len(line) == 9000
    assert line[-1] == "-15.400000000,28.017998000,189.990000"

    packed = gateway.http.get("/track.kmz?lang=en").raise_for_status()
    assert packed.headers["content-type"] == "application/vnd.google-earth.kmz"
    with zipfile.ZipFile(io.BytesIO(packed.content)) as archive:
        assert archive.testzip() is None
        assert archive.namelist() == ["doc.kml", "models/aircraft.dae"]
        document = archive.read("doc.kml")
        assert etree.fromstring(archive.read("models/aircraft.dae")).tag.endswith("COLLADA")
    assert schema_faults(document) == []
    assert texts(document, "coordinates")[1].split() == line
    assert texts(document, "href") == ["models/aircraft.dae"]
    assert element(document, "Orientation") is not None

    gpx = gateway.http.get("/track.gpx?lang=en").raise_for_status()
    assert gpx.headers["content-type"] == "application/gpx+xml"
    assert [len(segment) for segment in etree.fromstring(gpx.content).iter(f"{GPX}trkseg")] == [9000]

    czml: list[dict[str, Any]] = gateway.http.get("/track.czml").raise_for_status().json()
    hil = next(packet for packet in czml if packet["id"] == "hil")
    assert len(hil["position"]["cartographicDegrees"]) == 4 * 9000
    assert len(hil["orientation"]["unitQuaternion"]) == 5 * 9000


def test_every_sample_that_the_board_sent_is_in_every_file_as_it_was_sent(gateway: Gateway, board: FakeBoard) -> None:
    """More than a block of them, through the line; to 1e-7 degrees and a millimetre of what its float32 said."""
    gateway.open_board(board.url)
    turn_rad = np.linspace(0.0, 25.0, 4300)
    sent = np.stack([-15.38 + 0.01 * np.sin(turn_rad), 27.93 + 0.01 * np.cos(turn_rad), 300.0 + 9.0 * turn_rad], axis=1)
    for longitude_deg, latitude_deg, altitude_m in sent.tolist():
        board.send_gps(latitude_deg, longitude_deg, altitude_m)
    eventually(lambda: points(gateway)[0] == len(sent), "all of it is heard")
    held = {
        "kml": kml_line(get_kml(gateway, "/track.kml")),
        "kmz": kml_line(kmz_document(gateway)),
        "gpx": [
            [float(at.get("lon")), float(at.get("lat")), float(at.findtext(f"{GPX}ele"))]
            for at in etree.fromstring(gateway.http.get("/track.gpx").content).iter(f"{GPX}trkpt")
        ],
        "czml": czml_places(gateway),
    }
    for kind, found in held.items():
        assert len(found) == len(sent), kind
        away = np.abs(np.asarray(found) - sent.astype(np.float32).astype(np.float64)).max(axis=0)
        assert (away < (1e-7, 1e-7, 1e-3)).all(), (kind, away)


@pytest.mark.parametrize("kind", ["kml", "kmz", "gpx", "czml"])
def test_an_empty_track_is_a_file_too(gateway: Gateway, kind: str) -> None:
    answer = gateway.http.get(f"/track.{kind}?lang=en").raise_for_status()
    assert f'filename="Track.{kind}"' in answer.headers["content-disposition"]
    if kind == "czml":
        assert answer.json() == [{"id": "document", "name": "EPF GCS: Track", "version": "1.0"}]


def test_the_board_is_heard_while_a_long_track_is_being_sent(gateway: Gateway, board: FakeBoard) -> None:
    gateway.open_board(board.url)
    track = gateway.web.tracks.now.flight
    for step in range(300_000):
        track.add(1e9 + 0.02 * step, (27.0 + 1e-6 * step, -15.0, 300.0))
    before = gateway.status()["board"]["frames_received"]
    with gateway.http.stream("GET", "/track.gpx") as answer:
        pieces = answer.iter_bytes()
        assert next(pieces)
        eventually(lambda: gateway.status()["board"]["frames_received"] > before + 5, "the line goes on")
        assert sum(len(piece) for piece in pieces) > 25_000_000


def test_the_track_is_what_was_flown(emulated: Gateway) -> None:
    data = get_kml(emulated, "/track.kml?lang=en")
    assert texts(data, "name") == ["EPF GCS: Track", "Track", "HIL track"]
    for line in texts(data, "coordinates"):
        assert len(line.split()) > 20
        for position in line.split():
            longitude, latitude, altitude = (float(number) for number in position.split(","))
            assert abs(longitude + 15.366) < 0.02
            assert abs(latitude - 27.932) < 0.02
            assert 270 < altitude < 335
    assert set(texts(data, "altitudeMode")) == {"absolute"}
    assert set(texts(data, "extrude")) == {"1"}


def test_points_are_left_out_where_fewer_are_wanted(emulated: Gateway) -> None:
    for line in texts(get_kml(emulated, "/track.kml?points=10"), "coordinates"):
        assert 2 <= len(line.split()) <= 12


def test_a_cleared_track_comes_back_with_what_was_flown_since(gateway: Gateway, board: FakeBoard) -> None:
    gateway.open_board(board.url)
    with gateway.stream() as stream:
        operator = {"X-Client": stream.hello["client"]}
        fly(gateway, board, [27.9000, 27.9001, 27.9002])
        cleared = gateway.http.post("/track/reset", headers=operator).raise_for_status().json()
        assert cleared == {"flight_points": 0, "hil_points": 0, "can_restore": True}
        assert stream.event("track") == cleared
        assert texts(get_kml(gateway, "/track.kml"), "coordinates") == []
        fly(gateway, board, [27.9003, 27.9004])
        restored = gateway.http.post("/track/restore", headers=operator).raise_for_status().json()
        assert restored == {"flight_points": 5, "hil_points": 0, "can_restore": False}
        assert stream.event("track") == restored
    latitudes = [
        round(float(position.split(",")[1]), 4)
        for line in texts(get_kml(gateway, "/track.kml"), "coordinates")
        for position in line.split()
    ]
    assert latitudes == [27.9, 27.9001, 27.9002, 27.9003, 27.9004]


def test_only_the_track_that_was_cleared_last_is_kept(gateway: Gateway, board: FakeBoard) -> None:
    refused = gateway.http.post("/track/restore")
    assert (refused.status_code, refused.json()["code"]) == (409, "track_not_kept")
    gateway.open_board(board.url)
    fly(gateway, board, [27.9000, 27.9001])
    gateway.http.post("/track/reset").raise_for_status()
    fly(gateway, board, [27.9005, 27.9006, 27.9007])
    gateway.http.post("/track/reset").raise_for_status()
    assert gateway.http.post("/track/reset").json()["can_restore"] is True, "an empty track is not kept in its place"
    assert gateway.http.post("/track/restore").json()["flight_points"] == 3
    assert gateway.http.post("/track/restore").status_code == 409


def test_examples_do_not_get_into_the_flown_track(gateway: Gateway, board: FakeBoard) -> None:
    gateway.open_board(board.url)
    fly(gateway, board, [27.9000, 27.9001])
    gateway.open_board("emulation:")
    eventually(lambda: min(points(gateway)) > 5, "examples are drawn")
    gateway.http.post("/track/reset").raise_for_status()
    assert gateway.http.post("/track/restore").status_code == 409
    gateway.http.delete("/links/board").raise_for_status()
    assert points(gateway) == (2, 0)


def test_who_has_no_control_cannot_clear_the_track(gateway: Gateway) -> None:
    with gateway.stream() as stream:
        body = {"client": stream.hello["client"], "action": "take"}
        gateway.http.post("/control", json=body).raise_for_status()
        for path in ("/track/reset", "/track/restore"):
            assert gateway.http.post(path).json()["code"] == "control_held"


def kml_line(document: bytes) -> list[list[float]]:
    """Longitude, latitude, altitude of each point of the first line."""
    line = next(line for line in texts(document, "coordinates") if len(line.split()) > 1)
    return [[float(number) for number in position.split(",")] for position in line.split()]


def czml_places(gateway: Gateway) -> list[list[float]]:
    """The same of the real track, whose packet comes after the document's."""
    numbers = gateway.http.get("/track.czml").raise_for_status().json()[1]["position"]["cartographicDegrees"]
    return [numbers[at + 1 : at + 4] for at in range(0, len(numbers), 4)]


def kmz_document(gateway: Gateway) -> bytes:
    with zipfile.ZipFile(io.BytesIO(gateway.http.get("/track.kmz").raise_for_status().content)) as archive:
        document = archive.read("doc.kml")
    assert schema_faults(document) == []
    return document


def fly(gateway: Gateway, board: FakeBoard, latitudes_deg: list[float]) -> None:
    """A few metres further with each position."""
    before = points(gateway)[0]
    for latitude_deg in latitudes_deg:
        board.send_gps(latitude_deg, -15.38, 300.0)
    eventually(lambda: points(gateway)[0] == before + len(latitudes_deg), "the positions are heard")


def test_the_track_is_there_again_after_a_restart(tmp_path: Path, board: FakeBoard) -> None:
    with running_gateway(tmp_path / "data") as gateway:
        gateway.open_board(board.url)
        fly(gateway, board, [27.9000, 27.9001, 27.9002])
    with running_gateway(tmp_path / "data") as gateway:
        eventually(lambda: points(gateway)[0] == 3, "the flown points are back")
