"""Recordings of an aircraft that flies circles, on the board's GPS and in the simulator, with stalls of the station."""

from __future__ import annotations

import math
import random
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

from epf_gcs.codec.encode import encode_command, encode_telemetry
from epf_gcs.codec.messages_gen import VALUES_PER_ROW, XPLANE_ROWS
from epf_gcs.flights.index import run as index
from epf_gcs.recordings.mcap_file import Tally, closing, data_end, message_record, metadata_record, opening
from epf_gcs.recordings.notes import IDENTITY, PLAN, written
from epf_gcs.recordings.topics import BOARD_RECEIVED, BOARD_SENT, SIMULATOR_RECEIVED, TOPICS
from epf_gcs.xplane.datagram import Record, build
from tests.recordings.files import START_NS

FLIGHT = "20260131T120000Z"
SPEED_M_S = 35.0
RADIUS_M = 400.0
M_PER_DEG = 111_195.0
WAYPOINTS = [
    {"latitude_deg": 27.93, "longitude_deg": -15.39, "altitude_ft": 500.0, "speed_kt": 60.0},
    {"latitude_deg": 27.94, "longitude_deg": -15.38, "altitude_ft": 650.5, "speed_kt": 55.25},
]
_ROWS = (3, 4, 6, 8, 11, 16, 17, 18, 20, 25)


def quiet(_progress: float, _doing: str) -> None:
    """No progress is looked at."""


def place(at_s: float) -> tuple[float, float, float]:
    """Latitude and longitude (deg) and altitude (m) on the circle."""
    angle = at_s * SPEED_M_S / RADIUS_M
    latitude = 27.9 + RADIUS_M * math.sin(angle) / M_PER_DEG
    longitude = -15.4 + RADIUS_M * math.cos(angle) / M_PER_DEG / math.cos(math.radians(27.9))
    return latitude, longitude, 150.0 + 20.0 * math.sin(angle / 3)


def gps(at_s: float, valid: bytes = b"A") -> bytes:
    """A frame of the receiver; speed in kt."""
    return encode_telemetry("gps", *place(at_s), SPEED_M_S / 0.514444, 45.0, 0x38, 0x33, valid[0])


def datagram(at_s: float) -> bytes:
    """All rows of the simulator."""
    latitude, longitude, altitude_m = place(at_s)
    known = {"latitude_deg": latitude, "longitude_deg": longitude, "altitude_msl_ft": altitude_m / 0.3048}
    known |= {
        "ground_speed_kt": SPEED_M_S / 0.514444,
        "pitch_deg": 3.0,
        "roll_deg": 20.0,
        "true_heading_deg": at_s * 5.0 % 360.0,
    }
    records = []
    for number in _ROWS:
        row = [0.0] * VALUES_PER_ROW
        for value in XPLANE_ROWS["xp10"][number].values:
            row[value.index] = known.get(value.name, max(0.0, value.minimum))
        records.append(Record(number, tuple(row)))
    return build(records)


def recording(
    seconds: float,
    stalls: tuple[tuple[float, float], ...] = (),
    seed: int = 1,
    board: Callable[[float], bytes] = lambda _: b"",
    notes: Sequence[tuple[float, str, Any]] = (),
) -> bytes:
    """A whole recording: AHRS and simulator at 50 Hz, GPS and `board` at 10 Hz, commands, plans, identity and `notes`.

    What is sent in a stall (from and to, in seconds) is read at its end, all at once.
    """
    rng, tally = random.Random(seed), Tally()
    waypoints: dict[str, Any] = {"plan": "hil", "waypoints": WAYPOINTS}
    noted: list[tuple[float, str, Any]] = [
        (0.0, IDENTITY, {"station": "1.0.0", "aircraft": "ala fija"}),
        (0.0, PLAN, waypoints),
        *notes,
    ]
    body = opening("test", TOPICS)
    for at_s, name, content in noted:
        body += metadata_record(name, written(START_NS + round(at_s * 1e9), content))
    tally.metadata_count = len(noted)
    pieces = [body]
    late: list[tuple[int, bytes]] = []

    def put(channel: int, at_s: float, data: bytes) -> None:
        t_ns = START_NS + round(at_s * 1e9)
        pieces.append(message_record(channel, tally.add(channel, t_ns), t_ns, data))

    for tick in range(round(seconds * 50)):
        at_s = tick / 50
        line = encode_telemetry("ahrs", at_s * 5.0 % 360.0 - 180.0, 3.0, rng.uniform(-20.0, 20.0))
        if tick % 5 == 0:
            line += gps(at_s) + board(at_s)
        came = [(BOARD_RECEIVED, line), (SIMULATOR_RECEIVED, datagram(at_s))]
        if tick % 50 == 0:
            came.append((BOARD_SENT, encode_command("ahrs_on")))
        late += came
        if any(begin <= at_s < end for begin, end in stalls):
            continue
        # A stall's bytes of the line are one record; each datagram is its own, microseconds after the one before.
        joined = b"".join(data for channel, data in late if channel == BOARD_RECEIVED)
        put(BOARD_RECEIVED, at_s, joined)
        for number, (channel, data) in enumerate(one for one in late if one[0] != BOARD_RECEIVED):
            put(channel, at_s + number * 20e-6, data)
        late.clear()
    body = b"".join(pieces) + data_end()
    return body + closing(TOPICS, tally, len(body))


def indexed(data_dir: Path, content: bytes, flight: str = FLIGHT) -> Path:
    """The recording in a data folder, with its columns; its path."""
    path = data_dir / "recordings" / f"{flight}.mcap"
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(content)
    index([str(path)], quiet)
    return path
