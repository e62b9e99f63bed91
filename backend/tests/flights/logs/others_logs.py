"""Small logs of other programs, of random content: written by their libraries, or by the formats' descriptions where
those only read.
"""

from __future__ import annotations

import json
import random
import struct
from io import BytesIO
from pathlib import Path
from typing import Any, Final

from mcap.writer import Writer
from pymavlink.dialects.v20 import ardupilotmega

START_S: Final = 1_700_000_000
ROWS: Final = 300


def tlog(seed: int) -> bytes:
    """A ground station's log: an aircraft, and the station itself."""
    drawn, out = random.Random(seed), BytesIO()
    aircraft = ardupilotmega.MAVLink(None, srcSystem=1, srcComponent=1)
    station = ardupilotmega.MAVLink(None, srcSystem=255, srcComponent=190)
    for row in range(ROWS):
        stamp = struct.pack(">Q", START_S * 1_000_000 + row * 100_000)
        said: list[tuple[Any, Any]] = [
            (
                aircraft,
                ardupilotmega.MAVLink_attitude_message(row * 100, *(drawn.uniform(-1.5, 1.5) for _ in range(6))),
            ),
            (
                aircraft,
                ardupilotmega.MAVLink_global_position_int_message(
                    *(row * 100, 279_300_000 + row * 40, -153_800_000, drawn.randrange(1000, 400_000), 500),
                    *(100, 200, 3, drawn.randrange(36_000)),
                ),
            ),
            (station, ardupilotmega.MAVLink_heartbeat_message(6, 8, 0, 0, 4, 3)),
        ]
        out.write(b"".join(stamp + message.pack(link) for link, message in said))
    return out.getvalue()


def dataflash(seed: int, *, knows_time: bool = True) -> bytes:
    """ArduPilot's own log, with units and two inertial sensors."""
    drawn, out = random.Random(seed), BytesIO()
    formats = {
        130: ("POS", "QLLff", "TimeUS,Lat,Lng,Alt,RelHomeAlt"),
        131: ("IMU", "QBff", "TimeUS,I,GyrX,AccZ"),
        132: ("GPS", "QBIH", "TimeUS,Status,GMS,GWk"),
        133: ("UNIT", "QbZ", "TimeUS,Id,Label"),
        134: ("FMTU", "QBNN", "TimeUS,FmtType,UnitIds,MultIds"),
    }
    sizes = {"Q": "Q", "L": "i", "f": "f", "B": "B", "I": "I", "H": "H", "b": "b", "Z": "64s", "N": "16s"}
    kinds = {
        number: struct.Struct("<" + "".join(sizes[one] for one in form)) for number, (_, form, _) in formats.items()
    }

    def say(number: int, *values: Any) -> None:
        out.write(b"\xa3\x95" + bytes([number]) + kinds[number].pack(*values))

    kinds[128] = struct.Struct("<BB4s16s64s")
    say(128, 128, 89, b"FMT", b"BBnNZ", b"Type,Length,Name,Format,Columns")
    for number, (name, form, columns) in formats.items():
        say(128, number, 3 + kinds[number].size, name.encode(), form.encode(), columns.encode())
    for letter, unit in ((b"s", b"s"), (b"D", b"deglatitude"), (b"m", b"m"), (b"E", b"rad/s"), (b"#", b"instance")):
        say(133, 1, letter[0], unit)
    say(134, 1, 130, b"sDDmm", b"F--00")
    say(134, 1, 131, b"s#Eo", b"F-00")
    for row in range(ROWS):
        time_us = 5_000_000 + row * 100_000
        if knows_time:
            say(132, time_us, 3, 100_000 + row * 100, 2288)
        say(130, time_us, 279_300_000 + row * 40, -153_800_000, drawn.uniform(0.0, 400.0), drawn.uniform(0.0, 300.0))
        for sensor in (0, 1):
            say(131, time_us, sensor, drawn.uniform(-3.0, 3.0), drawn.uniform(-20.0, 5.0))
    return out.getvalue()


def ulog(seed: int, *, knows_time: bool = True) -> bytes:
    """PX4's log, with two instances of a topic and an array."""
    drawn, out = random.Random(seed), BytesIO(b"")

    def say(kind: bytes, body: bytes) -> None:
        out.write(struct.pack("<H", len(body)) + kind + body)

    out.write(b"ULog\x01\x12\x35\x01" + struct.pack("<Q", 1_000_000))
    say(b"F", b"vehicle_global_position:uint64_t timestamp;double lat;double lon;float alt;")
    say(b"F", b"sensor_gyro:uint64_t timestamp;float[3] rate;uint8_t error;uint8_t[7] _padding0;")
    say(b"F", b"sensor_gps:uint64_t timestamp;uint64_t time_utc_usec;uint8_t fix_type;")
    for number, (name, instance) in enumerate(
        [(b"vehicle_global_position", 0), (b"sensor_gyro", 0), (b"sensor_gyro", 1), (b"sensor_gps", 0)]
    ):
        say(b"A", struct.pack("<BH", instance, number) + name)
    for row in range(ROWS):
        time_us = 1_000_000 + row * 20_000
        place = struct.pack("<Qddf", time_us, 27.93 + row * 1e-5, -15.38, drawn.uniform(0.0, 400.0))
        say(b"D", struct.pack("<H", 0) + place)
        for sensor in (1, 2):
            rates = [drawn.uniform(-2.0, 2.0) for _ in range(3)]
            say(b"D", struct.pack("<H", sensor) + struct.pack("<Q3fB", time_us, *rates, row % 2))
        utc = START_S * 1_000_000 + row * 20_000 if knows_time else 0
        say(b"D", struct.pack("<H", 3) + struct.pack("<QQB", time_us, utc, 3))
    return out.getvalue()


def mcap(seed: int, *, broken: int = 0) -> bytes:
    """Foxglove's kind of file: JSON, nested; the first so many messages are cut."""
    drawn, out = random.Random(seed), BytesIO()
    writer = Writer(out)
    writer.start("", "another program")
    schema = writer.register_schema(name="Pose", encoding="jsonschema", data=b'{"type": "object"}')
    channel = writer.register_channel(topic="/robot/pose", message_encoding="json", schema_id=schema)
    for row in range(ROWS):
        pose = {"position": {"x": drawn.uniform(-9, 9), "y": row}, "ok": row % 2 == 0, "frame": "map", "q": [0.5, row]}
        time_ns = START_S * 10**9 + row * 10**7
        text = json.dumps(pose).encode()
        writer.add_message(channel, time_ns, text[:-1] if row < broken else text, time_ns)
    writer.finish()  # type: ignore[no-untyped-call]
    return out.getvalue()


def table(seed: int) -> bytes:
    """A sheet in Spanish: semicolons, decimal commas, units in the names."""
    drawn = random.Random(seed)
    lines = ["timestamp [s];altitud [m];Vel (m/s);modo"]
    for row in range(ROWS):
        cells = (f"{START_S + row * 0.5:.1f}", f"{drawn.uniform(0, 400):.3f}", f"{drawn.uniform(0, 40):.2f}", "AUTO")
        lines.append(";".join(cells).replace(".", ","))
    return "\n".join(lines).encode()


def written(path: Path, content: bytes) -> Path:
    """The file with this content."""
    path.write_bytes(content)
    return path
