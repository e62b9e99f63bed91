"""Decoded MCAP for Foxglove's viewers: position, attitude and log by the published schemas, and what is known of the
flight as metadata."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import foxglove.messages
import numpy as np
import orjson
import pytest
from jsonschema import Draft202012Validator
from mcap.reader import make_reader

from epf_gcs.codec.encode import encode_telemetry
from epf_gcs.flights.export.foxglove_messages import poses, quaternions
from epf_gcs.flights.export.foxglove_schemas import LEVELS, LOCATION_FIX_SCHEMA, LOG_SCHEMA, POSE_SCHEMA, Schema
from epf_gcs.formats.samples import Samples
from epf_gcs.recordings.notes import EVENT, IDENTITY, MARK, PARAMETERS
from tests.codec.streams import mixed_frames
from tests.flights.flown_flights import WAYPOINTS, indexed, recording
from tests.flights.test_columns import recording as recording_of
from tests.flights.test_exports import columns_of, decoded, export

GPS_LOST = {"id": "gps_lost", "level": "critical", "active": True, "text": "The GPS lost its fix."}


def alarm(content: dict[str, Any]) -> dict[str, Any]:
    return {"event": "alarm", "data": content}


@pytest.fixture(scope="module")
def flight(tmp_path_factory: pytest.TempPathFactory) -> Path:
    notes = [
        (0.5, IDENTITY, {"operator": "Ana", "board": {"firmware_name": "EPF"}, "firmware": "2.1"}),
        (1.0, PARAMETERS, {"k_altura": {"value": 0.06, "state": "loaded"}, "k_pitch": {"value": None}}),
        (3.0, MARK, {"text": "first turn", "by": "Ana", "id": "1"}),
        (5.0, EVENT, alarm(GPS_LOST)),
        (8.0, PARAMETERS, {"k_altura": {"value": 0.08, "state": "confirmed"}}),
        (9.0, EVENT, alarm(GPS_LOST | {"active": False})),
    ]
    return indexed(tmp_path_factory.mktemp("foxglove"), recording(30, notes=notes))


Found = list[tuple[str, int, dict[str, Any], dict[str, Any]]]


@pytest.fixture(scope="module")
def found(flight: Path) -> Found:
    return decoded(export(flight, "mcap-decoded"))


@pytest.mark.parametrize(("topic", "title"), [("location_", "LocationFix"), ("pose_", "PoseInFrame"), ("log", "Log")])
def test_each_message_fits_its_schema_and_has_its_time(found: Found, topic: str, title: str) -> None:
    chosen = [one for one in found if one[0].startswith(topic)]
    assert chosen
    for _, t_ns, message, schema in chosen:
        assert schema["title"] == f"foxglove.{title}"
        Draft202012Validator(schema).validate(message)
        assert message["timestamp"] == {"sec": t_ns // 10**9, "nsec": t_ns % 10**9}


def test_positions_are_those_of_the_flight(flight: Path, found: Found) -> None:
    gps = columns_of(flight)["gps"]["latitude_deg"].to_pylist()
    assert [one[2]["latitude"] for one in found if one[0] == "location_flight"] == gps
    assert {(topic, message["frame_id"]) for topic, _, message, _ in found if topic.startswith("location_")} == {
        ("location_flight", "flight"),
        ("location_hil", "hil"),
    }


def test_poses_are_metres_from_the_start_and_attitudes(found: Found) -> None:
    poses = {t_ns: message["pose"] for topic, t_ns, message, _ in found if topic == "pose_hil"}
    places = {t_ns: message for topic, t_ns, message, _ in found if topic == "location_hil"}
    first = places[min(places)]
    assert poses.keys() == places.keys()
    for t_ns, pose in poses.items():
        position, place = pose["position"], places[t_ns]
        assert position["y"] == pytest.approx((place["latitude"] - first["latitude"]) * 111_195.0, abs=0.01)
        east = (place["longitude"] - first["longitude"]) * 111_195.0 * np.cos(np.radians(first["latitude"]))
        assert position["x"] == pytest.approx(east, abs=0.01)
        assert position["z"] == pytest.approx(place["altitude"] - first["altitude"], abs=0.01)
        forward, left, _ = axes(np.array([[pose["orientation"][axis] for axis in "xyzw"]]))
        # The flown circles bank 20 degrees to the right, with the nose 3 degrees up.
        assert forward[2] == pytest.approx(np.sin(np.radians(3.0)), abs=1e-4)
        assert left[2] == pytest.approx(np.sin(np.radians(20.0)) * np.cos(np.radians(3.0)), abs=1e-4)


def test_poses_stay_beside_each_other_over_the_date_line() -> None:
    longitude_deg = np.array([179.9999, -179.9999])
    known, unknown = np.zeros(2), np.full(2, np.nan)
    line = [Samples(np.array([1.0, 2.0]), known, longitude_deg, known, known, known, known, unknown, unknown)]
    ((_, messages),) = poses("flight", [line])
    assert orjson.loads(messages[1])["pose"]["position"] == {"x": pytest.approx(22.239, abs=0.001), "y": 0.0, "z": 0.0}


@pytest.mark.parametrize(
    ("heading", "pitch", "roll", "forward", "left"),
    [
        (0.0, 0.0, 0.0, (0, 1, 0), (-1, 0, 0)),
        (90.0, 0.0, 0.0, (1, 0, 0), (0, 1, 0)),
        (0.0, 30.0, 0.0, (0, 3**0.5 / 2, 0.5), (-1, 0, 0)),
        (180.0, 0.0, 90.0, (0, -1, 0), (0, 0, 1)),
        (270.0, 0.0, -90.0, (-1, 0, 0), (0, 0, -1)),
    ],
)
def test_the_nose_points_where_the_heading_says_and_the_left_wing_rises_in_a_turn_to_the_right(
    heading: float, pitch: float, roll: float, forward: tuple[float, ...], left: tuple[float, ...]
) -> None:
    found = axes(quaternions(np.array([[heading, pitch, roll]])))
    assert found[0] == pytest.approx(forward, abs=1e-12)
    assert found[1] == pytest.approx(left, abs=1e-12)


def axes(quaternion: np.ndarray[Any, np.dtype[np.float64]]) -> list[np.ndarray[Any, np.dtype[np.float64]]]:
    """Where the aircraft's forward, left and up point: east, north, up."""
    x, y, z, w = quaternion[0]
    turned = [
        [1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)],
        [2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x)],
        [2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)],
    ]
    return [np.array(one) for one in turned]


def test_a_flight_without_a_position_has_its_attitude_all_the_same(tmp_path: Path) -> None:
    line = b"".join(encode_telemetry("ahrs", 90.0, 0.0, float(roll)) for roll in range(10))
    poses = [
        one for one in decoded(export(indexed(tmp_path, recording_of(line, b"")), "mcap-decoded")) if "pose" in one[0]
    ]
    assert {topic for topic, *_ in poses} == {"pose_flight"}
    assert len(poses) == 10
    assert all(message["pose"]["position"] == {"x": 0.0, "y": 0.0, "z": 0.0} for _, _, message, _ in poses)


def test_the_log_says_what_happened_in_words_and_how_serious_it_is(flight: Path, found: Found) -> None:
    log = [message for topic, _, message, _ in found if topic == "log"]
    assert len(log) == columns_of(flight)["events"].num_rows
    assert [(one["level"], one["message"]) for one in log if one["name"] == "mark"] == [
        (LEVELS["INFO"], "first turn, by Ana")
    ]
    (lost,) = (one for one in log if one["name"] == "alarm")
    assert lost["level"] == LEVELS["ERROR"]
    assert lost["message"].startswith("GPS ")
    assert [one["message"] for one in log if one["name"] == "limits"] == []


def test_a_stretch_has_the_log_of_its_own_time(flight: Path) -> None:
    found = decoded(export(flight, "mcap-decoded", "--from-s", "4", "--to-s", "6"))
    assert [message["name"] for topic, _, message, _ in found if topic == "log"].count("mark") == 0
    assert [message["name"] for topic, _, message, _ in found if topic == "log"].count("alarm") == 1


def test_whose_flight_it_is_and_its_gains_and_plans_are_metadata(flight: Path) -> None:
    def metadata(*options: str) -> dict[str, dict[str, str]]:
        with export(flight, "mcap-decoded", *options).open("rb") as file:
            return {one.name: one.metadata for one in make_reader(file).iter_metadata()}

    known = metadata()
    assert known["flight"]["aircraft"] == "ala fija"
    assert (known["flight"]["operator"], known["flight"]["firmware"]) == ("Ana", "2.1")
    assert known["gains"] == {"k_altura": "0.08"}
    assert orjson.loads(known["plans"]["hil"]) == WAYPOINTS
    assert metadata("--to-s", "6")["gains"] == {"k_altura": "0.06"}


def test_every_topic_and_field_of_a_decoded_file_is_described(flight: Path, tmp_path: Path) -> None:
    every = indexed(tmp_path, recording_of(b"".join(mixed_frames(2000, seed=5)), b"".join(mixed_frames(300, seed=3))))
    for path in (flight, every):
        schemas = {topic: schema for topic, _, _, schema in decoded(export(path, "mcap-decoded"))}
        lacking = [
            f"{topic}.{name}"
            for topic, schema in schemas.items()
            for name, said in (("", schema), *schema["properties"].items())
            if not said.get("description")
        ]
        assert lacking == []


@pytest.mark.parametrize(
    ("schema", "published"),
    [
        (LOCATION_FIX_SCHEMA, foxglove.messages.LocationFix),
        (POSE_SCHEMA, foxglove.messages.PoseInFrame),
        (LOG_SCHEMA, foxglove.messages.Log),
    ],
)
def test_the_schemas_are_the_published_ones(schema: Schema, published: Any) -> None:
    """The package has them as descriptors of protocol buffers; JSON has the same fields, and a time as sec and nsec."""
    descriptor = published.get_schema()
    assert schema["title"] == descriptor.name
    check(schema, {message.name: message for message in _messages(descriptor.data)})


# Of protocol buffers: double, fixed 32-bit number, text.
_PLAIN = {1: "number", 7: "integer", 9: "string"}


def check(schema: Schema, published: dict[str, _Message]) -> None:
    message = published[schema["title"].removeprefix("foxglove.")]
    # What is optional there (heading, velocity, colour, lineage) may be left out.
    assert set(schema["required"]) == set(schema["properties"]) <= set(message.fields)
    for name, said in schema["properties"].items():
        field = message.fields[name]
        assert field.repeated == (said.get("type") == "array"), name
        if field.kind in _PLAIN:
            assert (said["items"] if field.repeated else said)["type"] == _PLAIN[field.kind], name
        elif field.message == ".google.protobuf.Timestamp":
            assert set(said["properties"]) == {"sec", "nsec"}
        elif "oneOf" in said:
            numbers = {one["title"]: one["const"] for one in said["oneOf"]}
            assert numbers == message.enums[field.message.rpartition(".")[2]], name
        else:
            assert said["title"] == field.message.removeprefix("."), name
            check(said, published)


class _Field:
    def __init__(self, data: bytes) -> None:
        values = dict(_records(data))
        self.name = values[1].decode()
        self.repeated = values.get(4) == 3
        self.kind = values[5]
        self.message = values.get(6, b"").decode()


class _Message:
    def __init__(self, data: bytes) -> None:
        pairs = list(_records(data))
        self.name = next(value.decode() for tag, value in pairs if tag == 1)
        self.fields = {field.name: field for field in (_Field(value) for tag, value in pairs if tag == 2)}
        self.enums = {}
        for value in (value for tag, value in pairs if tag == 4):
            inside = list(_records(value))
            name = next(one.decode() for tag, one in inside if tag == 1)
            numbers = [dict(_records(one)) for tag, one in inside if tag == 2]
            self.enums[name] = {one[1].decode(): one.get(2, 0) for one in numbers}


def _messages(data: bytes) -> list[_Message]:
    """The messages of a set of descriptors of protocol buffers."""
    files = [value for tag, value in _records(data) if tag == 1]
    return [_Message(value) for file in files for tag, value in _records(file) if tag == 4]


def _records(data: bytes) -> list[tuple[int, Any]]:
    """Number and value of each field of a message of protocol buffers: numbers and bytes."""
    found: list[tuple[int, Any]] = []
    at = 0

    def number() -> int:
        nonlocal at
        value = shift = 0
        while True:
            byte = data[at]
            at += 1
            value |= (byte & 0x7F) << shift
            shift += 7
            if byte < 0x80:
                return value

    while at < len(data):
        tag = number()
        value: Any = number()
        if tag & 7 == 2:
            size = value
            value = data[at : at + size]
            at += size
        found.append((tag >> 3, value))
    return found
