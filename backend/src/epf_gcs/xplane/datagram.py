"""Rows <-> the simulator's UDP datagrams: "DATA", a tag byte, then records of a row number and eight values."""

from __future__ import annotations

import math
from collections.abc import Iterable
from struct import Struct
from typing import Final, NamedTuple

from epf_gcs.codec.messages_gen import DATAGRAM_MAGIC, NO_VALUE, TAG_FROM_SIMULATOR, TAG_TO_SIMULATOR, VALUES_PER_ROW

_PREFIX_SIZE: Final = len(DATAGRAM_MAGIC) + 1
_RECORD: Final = Struct(f"<i{VALUES_PER_ROW}f")
_SURFACES_ROW: Final = 11
_THROTTLE_ROW: Final = 25

Eight = tuple[float, ...]


class Record(NamedTuple):
    """One row as it is on the wire."""

    row: int
    values: Eight


class Surfaces(NamedTuple):
    """Controls of the simulator's aircraft, -1..1: nose up, right wing down and nose right are +; throttle 0..1."""

    elevator: float
    aileron: float
    rudder: float
    throttle: float

    def clamped(self) -> Surfaces | None:
        """Within the limits of the simulator; None if a value is not finite, because that must not be sent."""
        if not all(math.isfinite(value) for value in self):
            return None
        elevator, aileron, rudder = (min(1.0, max(-1.0, value)) for value in self[:3])
        return Surfaces(elevator, aileron, rudder, min(1.0, max(0.0, self.throttle)))


def parse(datagram: bytes) -> list[Record] | None:
    """The records of a datagram; None unless it consists of the magic, a tag and whole records."""
    body = datagram[_PREFIX_SIZE:]
    if not datagram.startswith(DATAGRAM_MAGIC) or not body or len(body) % _RECORD.size:
        return None
    return [Record(row, tuple(values)) for row, *values in _RECORD.iter_unpack(body)]


def build(records: Iterable[Record], tag: int = TAG_FROM_SIMULATOR) -> bytes:
    """A datagram with these records; the default tag is the one that the simulator sends."""
    return DATAGRAM_MAGIC + bytes((tag,)) + b"".join(_RECORD.pack(record.row, *record.values) for record in records)


def surfaces_datagram(surfaces: Surfaces) -> bytes | None:
    """The datagram that moves the aircraft, clamped; None if a value is not finite."""
    safe = surfaces.clamped()
    if safe is None:
        return None
    unused = VALUES_PER_ROW - 3
    return _to_simulator((safe.elevator, safe.aileron, safe.rudder) + (NO_VALUE,) * unused, safe.throttle)


def release_datagram() -> bytes:
    """The datagram that hands all controls back: "no value" in every one that we send."""
    return _to_simulator((NO_VALUE,) * VALUES_PER_ROW, NO_VALUE)


def _to_simulator(surfaces: Eight, throttle: float) -> bytes:
    return build(
        (Record(_SURFACES_ROW, surfaces), Record(_THROTTLE_ROW, (throttle,) * VALUES_PER_ROW)), TAG_TO_SIMULATOR
    )
