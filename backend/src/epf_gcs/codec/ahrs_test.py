"""The AHRS test stream: a text-mode dialogue and then bare records of attitude.

station  #sim\\r        (then waits)
station  #s00\\0
board    #SYNCH00\\n\\r  then records: AA AA AA AA, f32 yaw, pitch, roll [deg]
station  q             ends it
"""

from __future__ import annotations

from enum import StrEnum
from struct import Struct
from typing import Final, NamedTuple

BEGIN: Final = b"#sim\r"
SYNCHRONISE: Final = b"#s00\0"
SYNCHRONISED: Final = b"#SYNCH00\n\r"
QUIT: Final = b"q"
WAIT_S: Final = 0.2
ANSWER_TIMEOUT_S: Final = 2.0

_MARK: Final = b"\xaa\xaa\xaa\xaa"
_RECORD: Final = Struct("<4s3f")
_LIMITS_DEG: Final = (360.0, 90.0, 180.0)


class Attitude(NamedTuple):
    """Clockwise from north, nose up and right wing down are positive."""

    yaw_deg: float
    pitch_deg: float
    roll_deg: float


class AhrsTestState(StrEnum):
    """Where the dialogue stands."""

    IDLE = "idle"
    BEGUN = "begun"
    SYNCHRONISING = "synchronising"
    STREAMING = "streaming"


class AhrsTest:
    """The station's side: bytes in, attitudes out, the time from the caller. `skipped` counts bytes outside records."""

    def __init__(self) -> None:
        self.state = AhrsTestState.IDLE
        self.skipped = 0
        self._buffer = b""
        self._due_s = 0.0

    @property
    def deadline_s(self) -> float | None:
        """When `tick` has something to do; None when nothing waits."""
        waiting = self.state in (AhrsTestState.BEGUN, AhrsTestState.SYNCHRONISING)
        return self._due_s if waiting else None

    def start(self, now_s: float) -> bytes:
        """Begin; returns the bytes to send."""
        self.state = AhrsTestState.BEGUN
        self._buffer = b""
        self._due_s = now_s + WAIT_S
        return BEGIN

    def tick(self, now_s: float) -> bytes:
        """Do what is due; returns the bytes to send. An unanswered dialogue begins again."""
        if self.deadline_s is None or now_s < self._due_s:
            return b""
        if self.state is AhrsTestState.SYNCHRONISING:
            return self.start(now_s)
        self.state = AhrsTestState.SYNCHRONISING
        self._due_s = now_s + ANSWER_TIMEOUT_S
        return SYNCHRONISE

    def stop(self) -> bytes:
        """End; returns the bytes to send."""
        was_idle = self.state is AhrsTestState.IDLE
        self.state = AhrsTestState.IDLE
        self._buffer = b""
        return b"" if was_idle else QUIT

    def feed(self, chunk: bytes) -> list[Attitude]:
        """Take the next bytes of the line and return the attitudes that they complete."""
        if self.state is AhrsTestState.IDLE:
            return []
        self._buffer += chunk
        if self.state is not AhrsTestState.STREAMING and not self._find_answer():
            return []
        found = []
        while (attitude := self._take_record()) is not None:
            found.append(attitude)
        return found

    def _find_answer(self) -> bool:
        place = self._buffer.find(SYNCHRONISED)
        if place < 0:
            self._buffer = self._buffer[-(len(SYNCHRONISED) - 1) :]
            return False
        self._buffer = self._buffer[place + len(SYNCHRONISED) :]
        self.state = AhrsTestState.STREAMING
        return True

    def _take_record(self) -> Attitude | None:
        """The next record, or None when more bytes are needed.

        Records have no checksum and a float may hold the mark, so a record counts only when the mark of the
        next one follows it: a lost byte can lose records, but never gives a wrong attitude.
        """
        while len(self._buffer) >= _RECORD.size + len(_MARK):
            if self._buffer.startswith(_MARK) and self._buffer.startswith(_MARK, _RECORD.size):
                attitude = _plausible(self._buffer)
                if attitude is not None:
                    self._buffer = self._buffer[_RECORD.size :]
                    return attitude
            self._drop_to_mark()
        return None

    def _drop_to_mark(self) -> None:
        place = self._buffer.find(_MARK, 1)
        stop = place if place >= 0 else len(self._buffer) - len(_MARK) + 1
        self.skipped += stop
        self._buffer = self._buffer[stop:]


def _plausible(record: bytes) -> Attitude | None:
    """The record's angles; None if one is not finite or outside its limit."""
    angles: tuple[float, float, float] = _RECORD.unpack_from(record)[1:]
    inside = all(abs(angle) <= limit for angle, limit in zip(angles, _LIMITS_DEG, strict=True))
    return Attitude(*angles) if inside else None
