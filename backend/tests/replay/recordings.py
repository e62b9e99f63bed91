"""Recordings made for tests: a flight's frames, datagrams, text and notes at the times of a real one."""

from __future__ import annotations

import math
import random
from pathlib import Path
from typing import Any

import orjson

from epf_gcs.codec.encode import encode_telemetry
from epf_gcs.recordings import notes
from epf_gcs.recordings.mcap_file import Tally, closing, data_end, message_record, metadata_record, opening
from epf_gcs.recordings.topics import BOARD_RECEIVED, BOARD_SENT, SIMULATOR_RECEIVED, TOPICS
from epf_gcs.xplane.datagram import Record, build
from tests.support.simulator import ROWS

STARTS_NS = 1_767_225_600_123_456_789
SECOND_NS = 1_000_000_000

Made = list[tuple[int, int, bytes] | tuple[int, str, Any]]


def flight(seconds: float, *, seed: int = 1, gap: tuple[float, float] | None = None) -> Made:
    """Messages (time, topic, bytes) and notes (time, name, content) of a flight with a legacy board.

    ahrs at 20 Hz, heartbeat and gps at 5 and 2 Hz, text now and then, damage, a simulator at 20 Hz, alarms.
    Nothing comes in the `gap` (seconds after the start).
    """
    rng = random.Random(seed)
    items: Made = [
        (STARTS_NS, notes.LINE, {"line": "board", "open": True, "url": "pty:///b", "baud": 115200, "emulated": False}),
        (STARTS_NS, notes.LINE, {"line": "simulator", "open": True, "profile": "xp10", "emulated": False}),
        (STARTS_NS, notes.EVENT, {"event": "link", "data": {"board": "open", "simulator": "open"}}),
        (STARTS_NS, BOARD_SENT, b"#QT\n"),
    ]
    steps = int(seconds * 20)
    for step in range(steps):
        t_s = step / 20.0
        if gap is not None and gap[0] <= t_s < gap[1]:
            continue
        t_ns = STARTS_NS + round(t_s * SECOND_NS) + rng.randrange(2_000_000)
        frames = encode_telemetry("ahrs", 180.0 + 90.0 * math.sin(t_s), 5.0 * math.cos(t_s), 20.0 * math.sin(t_s / 3.0))
        if step % 4 == 0:
            frames += encode_telemetry("heartbeat", *(1,) * 12)
        if step % 10 == 0:
            frames += encode_telemetry("statistics", 30 + step % 20, 40)
        if step % 97 == 50:
            frames = frames[:-3] + b"\xff" + frames[-2:]
        if step % 211 == 100:
            frames = b"ready\n" + frames
        cut = rng.randrange(1, len(frames))
        items.append((t_ns, BOARD_RECEIVED, frames[:cut]))
        items.append((t_ns + 1_500_000, BOARD_RECEIVED, frames[cut:]))
        rows = {**ROWS, 17: (5.0 * math.sin(t_s), 10.0 * math.cos(t_s), 135.0, *ROWS[17][3:])}
        datagrams = [build(Record(row, values) for row, values in rows.items())]
        if step % 7 == 3:  # spread over two datagrams, as some simulators do
            several = list(rows.items())
            datagrams = [build(Record(*one) for one in several[:5]), build(Record(*one) for one in several[5:])]
        for number, datagram in enumerate(datagrams):
            items.append((t_ns + 5_000_000 + number * 300_000, SIMULATOR_RECEIVED, datagram))
        items.append((t_ns + 7_000_000, BOARD_SENT, b"\x01" * 76))
        items += noted(step, t_ns + 8_000_000)
    return items


def noted(step: int, t_ns: int) -> Made:
    """What is noted in this step."""
    if step == 180:
        changed = {"name": "set_parameter_task_rate", "value": [50], "state": "confirmed"}
        return [(t_ns, notes.EVENT, {"event": "command", "data": changed})]
    if step % 200 not in (120, 160):
        return []
    return [(t_ns, notes.EVENT, {"event": "alarm", "data": alarm(t_ns, None if step % 200 == 120 else t_ns * 1e-9)})]


def alarm(t_ns: int, until_s: float | None) -> dict[str, Any]:
    """The data of an alarm's event."""
    return {
        "id": "gps_lost",
        "level": "critical",
        "since_s": t_ns * 1e-9,
        "until_s": until_s,
        "text": "The GPS is lost.",
        "params": {},
        "acknowledged": until_s is not None,
        "active": until_s is None,
    }


def write(path: Path, items: Made, *, finished: bool = True) -> Path:
    """The recording as a file; without its end if it is not finished."""
    tally = Tally()
    parts = [opening("test", TOPICS)]
    for t_ns, what, content in items:
        if isinstance(what, str):
            parts.append(metadata_record(what, notes.written(t_ns, content)))
        else:
            parts.append(message_record(what, tally.add(what, t_ns), t_ns, content))
    data = b"".join(parts)
    if finished:
        end = data_end()
        data += end + closing(TOPICS, tally, len(data) + len(end))
    path.write_bytes(data)
    return path


def plain(value: Any) -> Any:
    """A value as JSON has it, to compare what came another way."""
    return orjson.loads(orjson.dumps(value))
