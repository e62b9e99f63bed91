"""A flight of which more is kept than a route is judged by: attitude, load and surfaces of every frame."""

from __future__ import annotations

import math
from array import array
from collections.abc import Sequence
from dataclasses import dataclass, fields
from typing import Final

import numpy as np

from epf_gcs.codec.encode import frame_bytes
from epf_gcs.codec.frame import TO_BOARD
from epf_gcs.codec.messages_gen import COMMANDS
from epf_gcs.lab.aircraft_loop import AircraftLoop
from epf_gcs.lab.faulty import FaultyLockStep
from epf_gcs.lab.lock_step import LockStep
from epf_gcs.lab.truth import Column
from epf_gcs.simulator.airframe import ground_course

_INFO: Final = COMMANDS["xplane_info"]
_STICK_AT: Final = 8


@dataclass(frozen=True, slots=True)
class Watch:
    """A column for each quantity, a value for each frame. Surfaces -1..1 in X-Plane's signs, as they were commanded."""

    time_s: Column
    altitude_ft: Column
    airspeed_kt: Column
    pitch_deg: Column
    roll_deg: Column
    track_deg: Column
    load_g: Column
    elevator: Column
    aileron: Column
    rudder: Column
    throttle: Column

    def largest_move(self) -> float:
        """The furthest that a surface or the throttle moved in a frame."""
        controls = np.array([self.elevator, self.aileron, self.rudder, self.throttle])
        return float(np.abs(np.diff(controls)).max())

    def settling_s(self, error: Column, band: float) -> float:
        """From the first frame to the last one whose error is outside the band."""
        outside = np.flatnonzero(np.abs(error) > band)
        return float(self.time_s[outside[-1]] - self.time_s[0]) if len(outside) else 0.0


_COLUMNS: Final = len(fields(Watch))


class _Watching(LockStep):
    """Keeps what is watched of whatever loop it is mixed into."""

    _watched: array[float]

    def go(self, seconds: float) -> Watch:
        """Fly on for so long, or until the aircraft is lost; returns the frames of that time."""
        self._watched = array("d")
        for _ in range(round(seconds * self._rate_hz)):
            if self.upset is None:
                self._frame()
        return Watch(*np.array(self._watched).reshape(-1, _COLUMNS).T.copy())

    def servos(self) -> list[float]:
        """Where the board's servos are: aileron, elevator, throttle, rudder."""
        return self._laws.positions()[:4]

    def _told(self, values: Sequence[float]) -> bytes:
        _, _, altitude_ft, _, roll, pitch, heading = values[:7]
        course_deg = ground_course(values[11], values[12], math.degrees(heading) % 360.0)
        controls = self._controls
        self._watched.extend(
            (
                *(self.time_s, altitude_ft, values[10], math.degrees(pitch), math.degrees(roll), course_deg),
                *(-values[16], controls.elevator, controls.aileron, controls.rudder, controls.throttle),
            )
        )
        return super()._told(values)


class Watched(_Watching, FaultyLockStep):
    """On the path of HIL. `stick`: elevator, aileron and rudder of the pilot, -1..1, told with every frame."""

    stick = (0.0, 0.0, 0.0)

    def silence(self, seconds: float) -> None:
        """The simulator stands still and sends nothing."""
        for _ in range(round(seconds * self._rate_hz)):
            self._tick()

    def repeat(self, seconds: float) -> None:
        """The simulator stands still and repeats its last frame."""
        for _ in range(round(seconds * self._rate_hz)):
            self._tick()
            self._take(self._laws.feed(self._newest))

    def _told(self, values: Sequence[float]) -> bytes:
        frame = super()._told(values)
        told = list(_INFO.struct.unpack_from(frame, _STICK_AT))
        told[:3] = self.stick
        return frame_bytes(TO_BOARD, _INFO, _INFO.struct.pack(*told))


class WatchedAircraft(_Watching, AircraftLoop):
    """In the loop of the real aircraft. `channels`: aileron, elevator, throttle and rudder of the transmitter, and its
    switches."""
