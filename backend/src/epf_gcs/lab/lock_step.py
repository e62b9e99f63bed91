"""The closed loop as fast as one core flies it: the simulator's values go to the board's laws without the datagrams.

The flight is the one of `ClosedLoop`, to the last bit: X-Plane's rows and command 50 both hold single precision, so
leaving the rows out changes no value. `tests/lab/test_lock_step.py` holds the two against each other.
"""

from __future__ import annotations

import math
from array import array
from collections.abc import Mapping, Sequence
from pathlib import Path
from struct import Struct
from typing import Final, NamedTuple, Self

from epf_gcs.codec.checksum import MASK
from epf_gcs.codec.encode import encode_command
from epf_gcs.codec.frame import TO_BOARD
from epf_gcs.codec.messages_gen import COMMANDS, END
from epf_gcs.codec.tables import Waypoint
from epf_gcs.lab.answers import Answers
from epf_gcs.lab.closed_loop import FIRST_COMMANDS
from epf_gcs.lab.errors import LabError
from epf_gcs.lab.figures import RouteEnd
from epf_gcs.lab.laws import FMS_PERIOD_S, FMS_TASK, LINE_GAIN, Laws
from epf_gcs.lab.own_gains import OwnGains
from epf_gcs.lab.truth import Truth
from epf_gcs.simulator.airframe import STEP_HZ, Airframe, AirframeError, ground_course
from epf_gcs.simulator.crash import LOAD_LIMIT_G, crash_cause
from epf_gcs.simulator.link import Link
from epf_gcs.simulator.models import AIRCRAFT
from epf_gcs.simulator.simulation import SimulationOptions
from epf_gcs.simulator.state import Controls
from epf_gcs.simulator.trim import trimmed
from epf_gcs.units import FT_MIN_PER_FT_S
from epf_gcs.xplane.datagram import Surfaces

_READ: Final = (
    "latitude_deg",
    "longitude_deg",
    "altitude_ft",
    "indicated_ft",
    "roll_rad",
    "pitch_rad",
    "heading_rad",
    "p",
    "q",
    "r",
    "cas_kt",
    "north_ft_s",
    "east_ft_s",
    "down_ft_s",
    "load_x",
    "load_y",
    "load_z",
)
_INFO: Final = COMMANDS["xplane_info"]
_TOLD: Final = Struct(f"<I{_INFO.struct.format.lstrip('<')}")
_TOLD_WORDS: Final = Struct(f"<{_TOLD.size // 4}I")
_WORD: Final = Struct("<I")


class Upset(NamedTuple):
    """How a flight ended before its time, and when."""

    time_s: float
    cause: str


class LockStep:
    """A simulator and a board on the assisted path. Raises LabError where one of the two is missing."""

    _plan_stream = "fms_hil_plan"

    def __init__(self, options: SimulationOptions, library: Path | None = None) -> None:
        model = AIRCRAFT[options.aircraft]
        trim = trimmed(model, options.situation.start)
        try:
            self._craft = Airframe(model, options.situation, trim.motion, trim.controls)
        except AirframeError as error:
            raise LabError(str(error)) from error
        self._rate_hz = options.rate_hz
        self._library = library
        self._laws = self._new_board()
        self._own_gains = OwnGains(self._ask)
        self._answers = self._new_answers()
        lever = trim.controls.throttle if options.throttle is None else options.throttle
        self._lever = lever
        self._controls = trim.controls if options.throttle is None else _with_lever(trim.controls, lever)
        seed = options.situation.seed
        self._uplink: Link[Surfaces] = Link(options.link, f"{seed} to the simulator")
        self._downlink: Link[bytes] = Link(options.link, f"{seed} from the simulator")
        self._read = self._craft.reader(_READ)
        self._fms_every = round(FMS_PERIOD_S * options.rate_hz)
        self._frames = 0
        self._rows = array("d")
        self.upset: Upset | None = None
        for name, *values in FIRST_COMMANDS:
            self.command(name, *values)

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self._laws.close()

    @property
    def time_s(self) -> float:
        """Simulated time since the start."""
        return self._frames / self._rate_hz

    def command(self, name: str, *values: float) -> None:
        """Give the board a command."""
        self._tell(encode_command(name, *values))

    def select(self, law: str) -> None:
        """Let the board fly its plan by one of its laws. Raises LabError if it has not this one."""
        self._own_gains.select(law)

    def set_gains(self, gains: Mapping[str, float]) -> None:
        """Set gains by their name on the board, as `k_roll`. Raises LabError for one that it has not, or refuses."""
        for name, value in gains.items():
            if name.startswith(LINE_GAIN):
                self._own_gains.set(name, value)
                continue
            if f"set_{name}" not in COMMANDS:
                raise LabError(f"the board has no gain {name}")
            is_whole = COMMANDS[f"set_{name}"].values[0].kind == "integer"
            try:
                self.command(f"set_{name}", round(value) if is_whole else value)
            except ValueError as error:
                raise LabError(f"the board takes no such gain: {error}") from error

    def fly(self, route: Sequence[Waypoint], longest_s: float) -> Truth:
        """Fly until the route's last waypoint is captured, the aircraft is lost, or time is up; returns all frames."""
        is_at = RouteEnd(route).is_at
        end = round(longest_s * self._rate_hz)
        while self._frames < end and self.upset is None:
            latitude_deg, longitude_deg = self._frame()
            if is_at(self._answers.waypoint, latitude_deg, longitude_deg):
                break
        return Truth.from_rows(self._rows)

    def _new_board(self) -> Laws:
        return Laws(1.0 / self._rate_hz, self._library)

    def _new_answers(self) -> Answers:
        return Answers(self._plan_stream)

    def _frame(self) -> tuple[float, float]:
        for surfaces in self._uplink.due(self.time_s):
            self._controls = Controls(*surfaces)
        rate_hz, frames = self._rate_hz, self._frames
        self._frames += 1
        self._craft.command(self._moved())
        try:
            self._craft.step((frames + 1) * STEP_HZ // rate_hz - frames * STEP_HZ // rate_hz)
        except AirframeError as error:
            self.upset = Upset(self.time_s, str(error))
            return self._rows[-5], self._rows[-4]
        values = self._read()
        latitude_deg, longitude_deg, altitude_ft = values[:3]
        if self._is_suspicious(values):
            cause = crash_cause(self._craft.state())
            if cause is not None:
                self.upset = Upset(self.time_s, cause)
                return latitude_deg, longitude_deg
        self._downlink.send(self._told(values), self.time_s)
        self._give(self._downlink.due(self.time_s))
        if self._frames % self._fms_every == 0:
            self._take(self._laws.send_streams(FMS_TASK))
        self._rows.extend((self.time_s, latitude_deg, longitude_deg, altitude_ft, values[10], self._answers.waypoint))
        return latitude_deg, longitude_deg

    def _moved(self) -> Controls:
        """Where the aircraft's surfaces go."""
        return self._controls

    def _give(self, arrived: list[bytes]) -> None:
        """Give the board what has arrived, and take its answers."""
        for told in arrived:
            self._tell(told)

    def _is_suspicious(self, values: Sequence[float]) -> bool:
        """Whether this may be a crash; quick, for it is asked every frame."""
        load_x, load_y, load_z = values[14:17]
        is_sound = abs(sum(values)) < 1e9  # false for one that is no number, too
        is_light = load_x * load_x + load_y * load_y + load_z * load_z <= LOAD_LIMIT_G**2
        return not (is_sound and is_light) or self._craft.touches()

    def _told(self, values: Sequence[float]) -> bytes:
        """Command 50 of this instant."""
        _, _, _, indicated_ft, roll, pitch, heading, p, q, r, cas_kt, north, east, down = values[:14]
        heading_deg = math.degrees(heading) % 360.0
        body = _TOLD.pack(
            _INFO.id,
            0.0,
            0.0,
            0.0,
            self._lever,
            p,
            q,
            r,
            ground_course(north, east, heading_deg),
            math.degrees(pitch),
            math.degrees(roll),
            indicated_ft,
            -down * FT_MIN_PER_FT_S,
            cas_kt,
            values[0],
            values[1],
        )
        return TO_BOARD.header + body + _WORD.pack(-sum(_TOLD_WORDS.unpack(body)) & MASK) + END

    def _tell(self, data: bytes) -> None:
        self._take(self._laws.feed(data))

    def _ask(self, data: bytes) -> bytes:
        """Of the present board, which a fault may have put in the place of the first."""
        return self._laws.feed(data)

    def _take(self, data: bytes) -> None:
        """What the station does with the board's frames."""
        for surfaces in self._answers.take(data):
            self._uplink.send(surfaces, self.time_s)


def _with_lever(controls: Controls, lever: float) -> Controls:
    return Controls(controls.elevator, controls.aileron, controls.rudder, lever)
