"""CZML: what Cesium reads of it, and that an attitude means the same on every place of the Earth."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
import orjson
import pytest

from epf_gcs.formats.czml import MovingTrack, czml_pieces, earth_quaternions
from epf_gcs.formats.samples import Samples

YELLOW = (255, 255, 0, 255)


def samples(*rows: Sequence[float]) -> Samples:
    """Rows of time, latitude, longitude, altitude, heading, pitch, roll."""
    unknown = np.full((2, len(rows)), np.nan)
    return Samples(*(np.array(column, dtype=np.float64) for column in zip(*rows, strict=True)), *unknown)


def turned(at: tuple[float, float], attitude: tuple[float, float, float], axis: tuple[float, float, float]) -> Any:
    """Where an axis of the body points, in east, north and up of its place: by the rotation matrix, not by Hamilton."""
    (quaternion,) = earth_quaternions(samples((0.0, *at, 0.0, *attitude)))
    x, y, z, w = quaternion
    matrix = np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
        ]
    )
    latitude, longitude = np.radians(at)
    east = np.array([-np.sin(longitude), np.cos(longitude), 0.0])
    up = np.array([np.cos(latitude) * np.cos(longitude), np.cos(latitude) * np.sin(longitude), np.sin(latitude)])
    earth = matrix @ np.array(axis)
    return np.array([earth @ east, earth @ np.cross(up, east), earth @ up])


NOSE, LEFT, TOP = (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)


@pytest.mark.parametrize("at", [(0.0, 0.0), (27.93, -15.38), (-60.0, 170.0), (89.0, 33.0)])
def test_the_body_looks_where_the_attitude_says(at: tuple[float, float]) -> None:
    assert turned(at, (0.0, 0.0, 0.0), NOSE) == pytest.approx([0, 1, 0], abs=1e-9), "north"
    assert turned(at, (90.0, 0.0, 0.0), NOSE) == pytest.approx([1, 0, 0], abs=1e-9), "east"
    assert turned(at, (90.0, 0.0, 0.0), TOP) == pytest.approx([0, 0, 1], abs=1e-9)
    assert turned(at, (0.0, 30.0, 0.0), NOSE)[2] == pytest.approx(0.5), "the nose is up"
    assert turned(at, (200.0, 0.0, 30.0), LEFT)[2] == pytest.approx(0.5), "the right wing is down"
    assert turned(at, (0.0, 0.0, 30.0), TOP)[0] == pytest.approx(0.5), "in a right turn"


def document(*tracks: MovingTrack) -> list[dict[str, Any]]:
    packets: list[dict[str, Any]] = orjson.loads(b"".join(czml_pieces("x", tracks)))
    return packets


def test_every_point_is_there_with_its_time_and_attitude() -> None:
    first = samples((1000.0, 27.9, -15.4, 100.0, 10.0, 1.0, 2.0), (1000.02, 27.90001, -15.4, 101.0, 11.0, 1.0, 2.0))
    nan = float("nan")
    second = samples((1060.0, 28.0, -15.4, 200.0, nan, nan, nan), (1061.5, 28.0001, -15.4, 201.0, 12.0, 0.0, 0.0))
    track = MovingTrack("real", "Track", YELLOW, [(1000.0, 1000.02), (1060.0, 1061.5)], [[first], [second]])
    head, packet = document(track)
    assert head["clock"]["interval"] == "1970-01-01T00:16:40.000Z/1970-01-01T00:17:41.500Z"
    assert packet["availability"] == [
        "1970-01-01T00:16:40.000Z/1970-01-01T00:16:40.020Z",
        "1970-01-01T00:17:40.000Z/1970-01-01T00:17:41.500Z",
    ]
    position = packet["position"]
    assert position["epoch"] == "1970-01-01T00:16:40.000Z"
    assert position["cartographicDegrees"] == [
        *(0.0, -15.4, 27.9, 100.0, 0.02, -15.4, 27.90001, 101.0),
        *(60.0, -15.4, 28.0, 200.0, 61.5, -15.4, 28.0001, 201.0),
    ]
    turns = np.array(packet["orientation"]["unitQuaternion"]).reshape(-1, 5)
    assert turns[:, 0].tolist() == [0.0, 0.02, 61.5], "an attitude that was not known is left out"
    assert np.linalg.norm(turns[:, 1:], axis=1) == pytest.approx([1, 1, 1], abs=1e-6)


def test_without_an_attitude_there_is_no_orientation() -> None:
    nan = float("nan")
    part = samples((5.0, 27.9, -15.4, 100.0, nan, nan, nan), (6.0, 27.9, -15.3, 100.0, nan, nan, nan))
    _, packet = document(MovingTrack("hil", "Track", YELLOW, [(5.0, 6.0)], [[part]]))
    assert "orientation" not in packet
    assert packet["availability"] == "1970-01-01T00:00:05.000Z/1970-01-01T00:00:06.000Z"


def test_a_track_without_a_line_is_not_there() -> None:
    assert [packet["id"] for packet in document(MovingTrack("hil", "Track", YELLOW, [], []))] == ["document"]
