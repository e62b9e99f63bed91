"""Tracks as files of other programs: valid, with the times of the flight, and no speed that nobody flew."""

from __future__ import annotations

import io
import math
import random
import zipfile
from collections.abc import Callable
from datetime import UTC, datetime
from itertools import pairwise
from pathlib import Path
from typing import Any

import fastkml
import numpy as np
import orjson
import pytest
from fastkml.validator import get_schema_parser
from lxml import etree

from epf_gcs.codec.encode import encode_telemetry
from epf_gcs.errors import GatewayError
from epf_gcs.flights.export.flown import FlownLine
from epf_gcs.flights.export.pace import pace, steps_m
from epf_gcs.flights.export.thinning import thinned_lines
from epf_gcs.flights.export.verb import run
from epf_gcs.flights.fields import fields_of
from epf_gcs.formats.recognise import read_plan_file
from epf_gcs.recordings.mcap_file import Tally, closing, data_end, message_record, opening
from epf_gcs.recordings.notes import EVENT, MARK
from epf_gcs.recordings.topics import BOARD_RECEIVED, TOPICS
from tests.flights.flown_flights import M_PER_DEG, SPEED_M_S, WAYPOINTS, gps, indexed, place, quiet, recording
from tests.formats.plans import read
from tests.recordings.files import START_NS

GPX = "{http://www.topografix.com/GPX/1/1}"
GPXTPX = "{http://www.garmin.com/xmlschemas/TrackPointExtension/v2}"
KML = "{http://www.opengis.net/kml/2.2}"
GX = "{http://www.google.com/kml/ext/2.2}"
# One of 11.4 s, in which 114 positions of the board come at once; short ones; two that follow each other closely.
STALLS = ((10.0, 21.4), (30.0, 30.5), (40.0, 40.6), (40.62, 41.0), (45.0, 45.06))
Point = tuple[float, float, float, float]


@pytest.fixture(scope="module")
def flight(tmp_path_factory: pytest.TempPathFactory) -> Path:
    alarm = {"id": "gps_lost", "text": "No position", "acknowledged": False}
    notes = [
        (20.0, MARK, {"text": "Here <&>", "by": "Ana", "id": "1"}),
        (23.0, EVENT, {"event": "alarm", "data": {**alarm, "active": True}}),
        (25.0, EVENT, {"event": "alarm", "data": {**alarm, "active": False}}),
        (500.0, MARK, {"text": "After the flight", "by": "Ana", "id": "2"}),
    ]
    return indexed(tmp_path_factory.mktemp("tracks"), recording(60, STALLS, notes=notes, board=passing))


def passing(at_s: float) -> bytes:
    """The plan goes from waypoint 1 to 2 at 30 s."""
    values = dict.fromkeys(fields_of("fms_hil_plan"), 0) | {"waypoint": 2 if at_s >= 30.0 else 1}
    return encode_telemetry("fms_hil_plan", *values.values())


def exported(flight: Path, kind: str, *options: str) -> bytes:
    """Every point of it."""
    return thinned(flight, kind, "--every-point", *options)


def thinned(flight: Path, kind: str, *options: str) -> bytes:
    target = flight.parent.parent / "exports" / "one"
    target.unlink(missing_ok=True)
    run([str(flight), kind, str(target), *options], quiet)
    return target.read_bytes()


def unix_s(text: str) -> float:
    return datetime.fromisoformat(text).astimezone(UTC).timestamp()


def gpx_lines(data: bytes) -> list[list[Point]]:
    return [
        [
            (
                unix_s(point.findtext(f"{GPX}time")),
                float(point.get("lat")),
                float(point.get("lon")),
                float(point.findtext(f"{GPX}ele")),
            )
            for point in segment
        ]
        for segment in etree.fromstring(data).iter(f"{GPX}trkseg")
    ]


def kml_lines(data: bytes) -> list[list[Point]]:
    lines = []
    for track in etree.fromstring(data).iter(f"{GX}Track"):
        whens = [unix_s(found.text) for found in track.iter(f"{KML}when")]
        places = [[float(one) for one in found.text.split()] for found in track.iter(f"{GX}coord")]
        lines.append([(t_s, at[1], at[0], at[2]) for t_s, at in zip(whens, places, strict=True)])
    return lines


def czml_lines(data: bytes) -> list[list[Point]]:
    lines = []
    for packet in orjson.loads(data)[1:]:
        epoch_s = unix_s(packet["position"]["epoch"])
        rows = np.array(packet["position"]["cartographicDegrees"]).reshape(-1, 4)
        lines.append([(epoch_s + row[0], row[2], row[1], row[3]) for row in rows])
    return lines


def speed_m_s(one: Point, other: Point) -> float:
    north = (other[1] - one[1]) * M_PER_DEG
    east = (other[2] - one[2]) * M_PER_DEG * math.cos(math.radians(one[1]))
    return math.hypot(north, east) / (other[0] - one[0])


READERS: dict[str, Any] = {"gpx": gpx_lines, "kml": kml_lines, "czml": czml_lines}


@pytest.mark.parametrize("kind", list(READERS))
def test_no_two_points_share_a_time_and_no_speed_is_absurd_however_late_they_were_read(flight: Path, kind: str) -> None:
    lines = READERS[kind](exported(flight, kind))
    assert [len(line) for line in lines] == [600, 3000], "none is lost, neither of GPS nor of the simulator"
    for line in lines:
        assert all(one[0] < other[0] for one, other in pairwise(line))
        speeds = [speed_m_s(one, other) for one, other in pairwise(line)]
        assert max(speeds) < 1.2 * SPEED_M_S
        for t_s, *found in line:
            flown = place(t_s - START_NS * 1e-9)
            assert found == pytest.approx(flown, abs=2.0)
            assert math.hypot(found[0] - flown[0], found[1] - flown[1]) * M_PER_DEG < 0.6 * SPEED_M_S


@pytest.mark.parametrize("seed", range(5))
def test_under_load_no_step_is_faster_than_1_2_times_what_was_flown(tmp_path: Path, seed: int) -> None:
    """Each position is read late by as much as a busy computer makes it; some wait for a while."""
    rng, read_s = random.Random(seed), 0.0
    frames = []
    for index in range(600):
        late_s = rng.expovariate(1 / 0.06) + (rng.uniform(0.0, 3.0) if rng.random() < 0.01 else 0.0)
        read_s = max(read_s + 20e-6, index / 10 + late_s)
        frames.append((read_s, gps(index / 10)))
    raw = [(at_s, *place(index / 10)) for index, (at_s, _) in enumerate(frames)]
    assert max(speed_m_s(one, other) for one, other in pairwise(raw)) > 10 * SPEED_M_S
    (line,) = gpx_lines(exported(indexed(tmp_path, of_positions(frames)), "gpx"))
    assert len(line) == 600
    assert max(speed_m_s(one, other) for one, other in pairwise(line)) < 1.2 * SPEED_M_S


def test_where_no_speed_is_sent_the_way_of_some_seconds_is_the_measure(tmp_path: Path) -> None:
    t_s = np.arange(0.0, 120.0, 0.1)
    early = np.where((t_s > 40.0) & (t_s < 40.9), t_s + (40.9 - t_s) * 0.9, t_s)
    rows = np.zeros((len(t_s), 9))
    rows[:, 0], rows[:, 1], rows[:, 7] = early, 30.0 * t_s / M_PER_DEG, np.nan
    (tmp_path / "track").write_bytes(rows.astype("<f8").tobytes())
    pace(tmp_path / "track", [(0, 500), (500, len(t_s))])
    found = np.fromfile(tmp_path / "track").reshape(-1, 9)
    assert (np.diff(found[:500, 0]) > 0.0).all()
    assert np.max(steps_m(found[:500]) / np.diff(found[:500, 0])) < 1.2 * 30.0
    assert (found[:, 0] <= early).all()
    assert (found[500:, 0] == early[500:]).all(), "another line"


def deviation_m(whole: list[Point], few: list[Point]) -> float:
    """How far a point of the whole line is at most from the place that the other has at its time."""
    every, kept = np.array(whole), np.array(few)
    at = [np.interp(every[:, 0], kept[:, 0], kept[:, column]) - every[:, column] for column in (1, 2, 3)]
    east = at[1] * np.cos(np.radians(every[:, 1]))
    return float(np.sqrt((at[0] * M_PER_DEG) ** 2 + (east * M_PER_DEG) ** 2 + at[2] ** 2).max())


@pytest.mark.parametrize(("kind", "read"), [("gpx", gpx_lines), ("kml", kml_lines)])
def test_what_lies_between_two_points_anyway_is_left_out_and_the_deviation_is_said(
    flight: Path, kind: str, read: Callable[[bytes], list[list[Point]]]
) -> None:
    data = thinned(flight, kind, "--language", "en")
    whole, few = read(exported(flight, kind)), read(data)
    assert [line[0] for line in few] == [line[0] for line in whole]
    assert [line[-1] for line in few] == [line[-1] for line in whole]
    assert sum(map(len, few)) * 4 < sum(map(len, whole))
    assert max(deviation_m(every, kept) for every, kept in zip(whole, few, strict=True)) < 1.0
    assert b"no sample is more than 1 m from the track" in data


def test_a_turn_keeps_the_points_that_it_needs_and_a_straight_leg_two(tmp_path: Path) -> None:
    t_s = np.arange(0.0, 60.0, 0.02)
    turn = np.minimum(t_s, 30.0) * 0.2
    north_m = 50.0 * np.sin(turn) + np.where(t_s > 30.0, 10.0 * (t_s - 30.0) * np.cos(6.0), 0.0)
    east_m = 50.0 * (1 - np.cos(turn)) + np.where(t_s > 30.0, 10.0 * (t_s - 30.0) * np.sin(6.0), 0.0)
    rows = np.column_stack(
        [t_s, north_m / M_PER_DEG, east_m / M_PER_DEG, np.full(len(t_s), 100.0), *np.zeros((5, len(t_s)))]
    )
    (tmp_path / "whole").write_bytes(rows.astype("<f8").tobytes())
    (line,) = thinned_lines([FlownLine(tmp_path / "whole", 0, len(rows))], tmp_path / "few")
    kept = np.concatenate([samples.t_s for samples in line])
    assert np.count_nonzero(kept > 32.0) == 1
    assert 15 < np.count_nonzero(kept <= 32.0) < 40


def test_the_recorded_times_alone_would_have_been_absurd() -> None:
    read = [min((end for begin, end in STALLS if begin <= at_s < end), default=at_s) for at_s in np.arange(600) / 10]
    assert sum(one == other for one, other in pairwise(read)) > 110


def test_the_times_are_those_of_the_flight_and_can_be_cut(flight: Path) -> None:
    lines = gpx_lines(exported(flight, "gpx", "--from-s", "22", "--to-s", "29.5"))
    for line in lines:
        assert line[0][0] - START_NS * 1e-9 == pytest.approx(22.0, abs=0.11)
        assert line[-1][0] - START_NS * 1e-9 == pytest.approx(29.5, abs=0.11)


def test_kml_fits_the_schema_with_googles_extension_and_has_the_plan(flight: Path) -> None:
    data = exported(flight, "kml", "--language", "en")
    schema = get_schema_parser(Path(fastkml.__file__).parent / "schema" / "kml22gx.xsd")
    schema.validate(etree.fromstring(data))
    assert [str(fault.message) for fault in schema.error_log] == []
    names = [found.text for found in etree.fromstring(data).iter(f"{KML}name")]
    assert names[0] == "EPF GCS: Track, 2026-01-31 12:00:00 UTC"
    assert {"Track", "HIL track", "HIL flight plan"} <= set(names)
    begins = [unix_s(found.text) for found in etree.fromstring(data).iter(f"{KML}begin")]
    assert begins == pytest.approx([START_NS * 1e-9] * 2, abs=0.03)


def test_kmz_holds_the_same_document_and_its_plan_can_be_read_back(flight: Path) -> None:
    kmz = exported(flight, "kmz")
    with zipfile.ZipFile(io.BytesIO(kmz)) as archive:
        assert archive.testzip() is None
        document = archive.read("doc.kml")
    assert document == exported(flight, "kml")
    placemarks = [
        found for found in etree.fromstring(document).iter(f"{KML}Placemark") if found.find(f"{KML}Point") is not None
    ]
    assert len(placemarks) == len(WAYPOINTS) + 3


def test_marks_alarms_and_waypoints_passed_are_placemarks_at_their_time_and_place(flight: Path) -> None:
    root = etree.fromstring(exported(flight, "kml", "--language", "en"))
    found = [one for one in root.iter(f"{KML}Placemark") if one.find(f"{KML}TimeStamp") is not None]
    assert [one.findtext(f"{KML}name") for one in found] == ["Here <&>", "GPS lost", "Waypoint 1 \u2192 2"]
    for one, at_s in zip(found, (20.0, 23.0, 30.0), strict=True):
        assert unix_s(one.findtext(f"{KML}TimeStamp/{KML}when")) - START_NS * 1e-9 == pytest.approx(at_s, abs=0.6)
        longitude, latitude, _ = map(float, one.findtext(f"{KML}Point/{KML}coordinates").split(","))
        flown = place(unix_s(one.findtext(f"{KML}TimeStamp/{KML}when")) - START_NS * 1e-9)
        assert math.hypot(latitude - flown[0], longitude - flown[1]) * M_PER_DEG < SPEED_M_S


def test_every_point_of_a_kml_track_has_attitude_speed_and_course(flight: Path) -> None:
    root = etree.fromstring(exported(flight, "kml"))
    board, simulator = root.iter(f"{GX}Track")
    for track in (board, simulator):
        count = len(list(track.iter(f"{KML}when")))
        angles = [found.text.split() for found in track.iter(f"{GX}angles")]
        assert len(angles) == count
        assert angles[0][1] == "3.00"
        for data in track.iter(f"{GX}SimpleArrayData"):
            values = [found.text for found in data.iter(f"{GX}value")]
            assert len(values) == count
            if data.get("name") == "speed_mps":
                assert {float(value) for value in values} == {SPEED_M_S}


def test_gpx_has_the_same_as_waypoints_which_are_not_read_as_a_plan_and_speed_and_course(flight: Path) -> None:
    data = exported(flight, "gpx", "--language", "es")
    root = etree.fromstring(data)
    points = list(root.iter(f"{GPX}wpt"))
    assert [child.tag for child in points[0]] == [f"{GPX}{name}" for name in ("ele", "time", "name", "type")]
    assert [(one.findtext(f"{GPX}name"), one.findtext(f"{GPX}type")) for one in points] == [
        ("Here <&>", "epf:mark"),
        ("GPS perdido", "epf:alarm"),
        ("Waypoint 1 \u2192 2", "epf:waypoint"),
    ]
    first = next(root.iter(f"{GPX}trkpt"))
    assert float(next(first.iter(f"{GPXTPX}speed")).text) == pytest.approx(SPEED_M_S, abs=0.01)
    assert float(next(first.iter(f"{GPXTPX}course")).text) == 45.0
    assert len(read_plan_file("flight.gpx", data, thin=True).points) > 3, "the track, and not what happened on it"


def test_gpx_has_the_structure_of_its_schema(flight: Path) -> None:
    root = etree.fromstring(exported(flight, "gpx"))
    assert (root.tag, root.get("version"), bool(root.get("creator"))) == (f"{GPX}gpx", "1.1", True)
    assert [child.tag for child in root] == [f"{GPX}wpt"] * 3 + [f"{GPX}trk"] * 2
    for track in root.iter(f"{GPX}trk"):
        assert [child.tag for child in track] == [f"{GPX}name", f"{GPX}trkseg"]
        for point in track.iter(f"{GPX}trkpt"):
            assert [child.tag for child in point] == [f"{GPX}ele", f"{GPX}time", f"{GPX}extensions"]
            assert -90 <= float(point.get("lat")) <= 90
            assert -180 <= float(point.get("lon")) < 180


def test_czml_has_the_attitude_and_a_clock_over_the_flight(flight: Path) -> None:
    document, board, simulator = orjson.loads(exported(flight, "czml"))
    assert (document["id"], document["version"]) == ("document", "1.0")
    begin, end = document["clock"]["interval"].split("/")
    assert unix_s(begin) == pytest.approx(START_NS * 1e-9, abs=0.03)
    assert unix_s(end) - unix_s(begin) == pytest.approx(59.98, abs=0.04)
    for packet, count in ((board, 600), (simulator, 3000)):
        quaternions = np.array(packet["orientation"]["unitQuaternion"]).reshape(-1, 5)
        assert len(quaternions) >= 0.97 * count
        assert np.hypot.reduce(quaternions[:, 1:], axis=1) == pytest.approx(1.0, abs=1e-6)


def of_positions(frames: list[tuple[float, bytes]]) -> bytes:
    """A recording of the receiver alone: a frame at each of these seconds."""
    tally, body = Tally(), opening("test", TOPICS)
    for at_s, data in frames:
        t_ns = START_NS + round(at_s * 1e9)
        body += message_record(BOARD_RECEIVED, tally.add(BOARD_RECEIVED, t_ns), t_ns, data)
    body += data_end()
    return body + closing(TOPICS, tally, len(body))


def test_a_receiver_slower_than_its_messages_gives_one_point_a_place(tmp_path: Path) -> None:
    """Each place is sent ten times: as points they would be a second of rest and a tenth of 350 m/s."""
    frames = [(index / 10, gps(float(index // 10))) for index in range(600)]
    (line,) = gpx_lines(exported(indexed(tmp_path, of_positions(frames)), "gpx"))
    assert len(line) == 60
    assert max(speed_m_s(one, other) for one, other in pairwise(line)) < 1.1 * SPEED_M_S


def test_without_a_fix_there_is_no_point_and_a_gap_or_a_jump_breaks_the_line(tmp_path: Path) -> None:
    frames = [(index / 10, gps(index / 10, b"V" if 20 <= index < 30 else b"A")) for index in range(100)]
    frames += [(60 + index / 10, gps(60 + index / 10)) for index in range(50)]
    # Put to the other side of the circle at once.
    opposite = math.pi * 400.0 / SPEED_M_S
    frames += [(65 + index / 10, gps(65 + opposite + index / 10)) for index in range(50)]
    lines = gpx_lines(exported(indexed(tmp_path, of_positions(frames)), "gpx"))
    assert [len(line) for line in lines] == [90, 50, 50]


def test_one_wrong_position_is_left_out(tmp_path: Path) -> None:
    frames = [(index / 10, gps(index / 10 + (2.0 if index == 50 else 0.0))) for index in range(100)]
    (line,) = gpx_lines(exported(indexed(tmp_path, of_positions(frames)), "gpx"))
    assert len(line) == 99
    assert max(speed_m_s(one, other) for one, other in pairwise(line)) < 2.2 * SPEED_M_S


def test_a_flight_without_a_position_says_so(tmp_path: Path) -> None:
    flight = indexed(tmp_path, of_positions([(index / 10, gps(index / 10, b"V")) for index in range(20)]))
    for kind in ("kml", "kmz", "gpx", "czml"):
        with pytest.raises(GatewayError) as fault:
            exported(flight, kind)
        assert fault.value.code == "export_no_position"
    assert list((tmp_path / "exports").iterdir()) == []


def test_a_plan_of_a_recording_is_a_plan_file(flight: Path) -> None:
    """The KML of a flight without its tracks is read as a plan; of the whole, the plan's own placemarks are taken."""
    found = read(exported(flight, "kml", "--from-s", "22", "--to-s", "22.5"))
    assert [(one.latitude_deg, one.longitude_deg, one.speed_kt) for one in found.waypoints] == [
        (one["latitude_deg"], one["longitude_deg"], one["speed_kt"]) for one in WAYPOINTS
    ]
