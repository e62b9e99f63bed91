"""The peer's side: pymavlink streams like ours, and its parser over chunks."""

from __future__ import annotations

import random
from typing import Any

from pymavlink.dialects.v20 import common

NAME = "pymavlink"


class _Sink:
    """A file-like object that collects the frames pymavlink writes."""

    def __init__(self) -> None:
        self.frames: list[bytes] = []

    def write(self, frame: bytes) -> None:
        self.frames.append(bytes(frame))


def mixed_frames(count: int, seed: int) -> list[bytes]:
    """Frames of kinds and sizes like our board's: state, attitude, sensors, servos, position, navigation."""
    rng = random.Random(seed)
    sink = _Sink()
    link: Any = common.MAVLink(sink, srcSystem=1)

    def whole(limit: int) -> int:
        return rng.randrange(limit)

    senders = (
        lambda ms: link.heartbeat_send(1, 8, whole(255), whole(1 << 30), 4),
        lambda ms: link.attitude_send(ms, *(rng.uniform(-3, 3) for _ in range(6))),
        lambda ms: link.scaled_imu_send(ms, *(whole(2000) for _ in range(9))),
        lambda ms: link.global_position_int_send(ms, *(whole(30000) for _ in range(8))),
        lambda ms: link.servo_output_raw_send(ms, 0, *(whole(2000) for _ in range(8))),
        lambda ms: link.nav_controller_output_send(*(rng.uniform(-3, 3) for _ in range(2)), 9, 9, 9, 1.0, 2.0, 3.0),
        lambda ms: link.vfr_hud_send(1.0, 2.0, 90, 50, rng.uniform(0, 500), 3.0),
        lambda ms: link.rc_channels_raw_send(ms, 0, *(whole(2000) for _ in range(8)), 200),
    )
    for index in range(count):
        senders[index % len(senders)](index)
    return sink.frames


def decode(chunks: list[bytes]) -> list[Any]:
    """All messages that the parser finds in these chunks; set to continue after damage."""
    parser: Any = common.MAVLink(None)
    parser.robust_parsing = True
    found: list[Any] = []
    for chunk in chunks:
        found += parser.parse_buffer(chunk) or ()
    return [message for message in found if not message.get_type().startswith(("BAD_DATA", "UNKNOWN"))]
