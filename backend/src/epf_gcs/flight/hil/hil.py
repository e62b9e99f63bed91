"""The loop between simulator and board. Nothing here waits for a disk, a browser or a log line.

In: a datagram; when it completes a frame of the simulator, command 50 leaves in the same call. Out: a frame
with surfaces; the simulator's datagram leaves in the same call. Samples for viewers are made afterwards.
"""

from __future__ import annotations

import asyncio
from collections import Counter, deque
from collections.abc import Callable, Mapping
from typing import Final, Literal

from epf_gcs.clock import Clock
from epf_gcs.codec.encode import frame_bytes
from epf_gcs.codec.frame import TO_BOARD, Frame
from epf_gcs.codec.messages_gen import COMMANDS
from epf_gcs.codec.values import single
from epf_gcs.contract.base import SimulatorProfile
from epf_gcs.errors import ConflictError
from epf_gcs.flight.hil.stick import Stick
from epf_gcs.link.udp import UdpLink
from epf_gcs.repeating import Repeating
from epf_gcs.vehicle.arrivals import Arrivals
from epf_gcs.vehicle.board import Board
from epf_gcs.vehicle.judges import Finding
from epf_gcs.vehicle.profile_judge import PROFILE_NAMES
from epf_gcs.vehicle.round_trip import RoundTrip
from epf_gcs.vehicle.simulator_samples import Reading, SimulatorSamples
from epf_gcs.vehicle.telemetry import Telemetry
from epf_gcs.vehicle.unusable_value import UnusableValue
from epf_gcs.vehicle.vehicle import Vehicle
from epf_gcs.xplane.datagram import Surfaces, release_datagram, surfaces_datagram
from epf_gcs.xplane.mapping import XplaneInfo, surfaces_from_servos_in

Path = Literal["manual", "assisted"]
Source = Literal["joystick", "rc"]

_COMMAND_50: Final = COMMANDS["xplane_info"]
# With more bytes queued the line is slower than the simulator: skip the frame, it would be old when it leaves.
_MAX_BACKLOG_BYTES: Final = 256
# A frame is judged and shown once the board has answered it, or after this long: a board that answers at once does not
# wait for it.
_SHOW_AFTER_S: Final = 0.001
_MOST_UNSHOWN: Final = 256


class Hil:
    """Takes datagrams and the board's urgent frames. `path` says who moves the simulator's surfaces."""

    def __init__(self, vehicle: Vehicle, clock: Clock, stick: Stick) -> None:
        self._board: Board = vehicle.board
        self._telemetry: Telemetry = vehicle.telemetry
        self._samples: SimulatorSamples = vehicle.simulator
        self._clock = clock
        self.stick = stick
        self._unshown: deque[Reading] = deque(maxlen=_MOST_UNSHOWN)
        self._showing = Repeating(asyncio.get_running_loop(), "a frame of the simulator", self.show)
        # At the newest frame that was shown: the HIL path does not compute it.
        self._was_paused = False
        self.path: Path = "manual"
        # Set by the composition root: called when the surfaces were taken from the board.
        self.on_taken: Callable[[], None] | None = None
        self.link: UdpLink | None = None
        self.round_trip = RoundTrip()
        self.skipped: Counter[str] = Counter()
        self.frames_to_board = 0
        self.frames_to_simulator = 0
        self.first_to_board_s: float | None = None
        self.last_to_board_s: float | None = None
        self.last_surfaces_s: float | None = None

    @property
    def source(self) -> Source | None:
        """Who holds the stick, as the board reports it; None before its first report."""
        heartbeat = self._telemetry.peek("heartbeat")
        joystick = None if heartbeat is None else heartbeat.get("source_joystick")
        return None if joystick is None else "joystick" if joystick else "rc"

    @property
    def rows(self) -> list[int]:
        """Numbers of the rows that arrive now."""
        return self._samples.rows(self._clock.now_s())

    @property
    def missing_rows(self) -> list[int]:
        """Numbers of the rows that command 50 needs and that do not arrive."""
        return self._samples.missing_rows(self._clock.now_s())

    @property
    def unusable(self) -> list[UnusableValue]:
        """The values that command 50 needs, whose rows arrive now, and that cannot be used."""
        return self._samples.unusable(self._clock.now_s())

    @property
    def found(self) -> list[Finding | None]:
        """What is wrong with the simulator, as its rows tell."""
        return self._samples.look(self._clock.now_s())

    @property
    def fitting_profile(self) -> SimulatorProfile | None:
        """The generation of the simulator that its rows are of; None while they have not said."""
        return self._samples.fitting_profile

    def check_profile(self) -> None:
        """Raise ConflictError while the board must not fly: it is told wrong angular rates."""
        if self._samples.is_profile_wrong:
            fits, profile = PROFILE_NAMES[str(self._samples.fitting_profile)], PROFILE_NAMES[self.profile]
            raise ConflictError(
                "profile_wrong",
                f"The board may not fly because the simulator sends the rows of {fits} and they are read as those of "
                f"{profile}: choose the profile {fits} in the simulator's link.",
                profile=profile,
                fits=fits,
            )

    @property
    def is_paused(self) -> bool:
        """Whether the simulator is paused: rows come, but an aircraft in flight hangs still in them."""
        return self._samples.motion.is_paused(self._clock.now_s())

    @property
    def arrivals(self) -> Mapping[int, Arrivals]:
        """Arrival statistics of each row, by row number; Unix times."""
        return self._samples.arrivals

    @property
    def profile(self) -> SimulatorProfile:
        """Which generation of the simulator the rows are read as."""
        return self._samples.profile

    def begin(self, link: UdpLink | None, profile: SimulatorProfile) -> None:
        """Start with a new simulator, or with emulated datagrams (`link` None): forget the earlier one's data."""
        self.link = link
        self._samples.begin(profile)
        self._unshown.clear()
        self.rest()

    def rest(self) -> None:
        """Forget pending round trips during an AHRS test, so that the board's silence raises no HIL alarm."""
        self.round_trip.clear()
        self.first_to_board_s = self.last_to_board_s = self.last_surfaces_s = None

    def end(self) -> None:
        """The socket is closed."""
        self.link = None
        self._samples.end()

    def on_datagram(self, datagram: bytes) -> bool:
        """Take a datagram from the simulator. False if it is not one of X-Plane's."""
        reading = self._samples.read(datagram, self._clock.now_s())
        if reading is None:
            return False
        if reading.info is not None:
            now_s = self._clock.steady_s()
            info = self._with_stick(reading.info, now_s)
            self._act_on(info, now_s)
            reading = reading._replace(info=info)
        self._unshown.append(reading)
        self._showing.arm(_SHOW_AFTER_S)
        return True

    def on_urgent(self, frame: Frame) -> None:
        """Take surfaces or RC channels, straight from the decoder. Emulated ones never move a simulator."""
        if self._board.is_emulated:
            return
        if frame.message.name == "hil_surfaces":
            now_s = self._clock.steady_s()
            self.last_surfaces_s = now_s
            if self.path == "assisted":
                self._move(Surfaces(*frame.values))
            self.round_trip.answered(now_s, is_counted=not self._was_paused)
            if self._showing.is_armed:
                self._showing.hurry()
        elif self.path == "manual" and self.source == "rc":
            self._move(surfaces_from_servos_in(frame.values))

    def show(self) -> None:
        """Judge the frames that came and send them to the viewers; comes by itself once the control frame has left."""
        while self._unshown:
            self._samples.show(self._unshown.popleft())
        self._was_paused = self.is_paused
        if self.path == "assisted" and self._samples.is_profile_wrong:
            self._take_surfaces()
        self._telemetry.flush()

    def _with_stick(self, info: XplaneInfo, now_s: float) -> XplaneInfo:
        """Put the chosen gamepad's position in place of the simulator's joystick, except when emulated."""
        chosen = None if self._board.is_emulated else self.stick.now(now_s)
        if chosen is None:
            return info
        # As the wire will carry them, so that the recording holds what was shown.
        elevator, aileron, rudder, throttle = map(single, chosen)
        return info._replace(elevator=elevator, aileron=aileron, rudder=rudder, throttle=throttle)

    def _act_on(self, info: XplaneInfo, now_s: float) -> None:
        """Send at once what depends on a complete frame of the simulator; everything else waits for `show`."""
        if self._board.is_emulated:
            self.skipped["emulation"] += 1
            return
        if self.path == "manual" and self.source == "joystick":
            self._move(info.stick)
        link = self._board.link
        if link is None or not self._board.is_open:
            self.skipped["board_not_open"] += 1
        elif link.backlog > _MAX_BACKLOG_BYTES:
            self.skipped["line_busy"] += 1
        elif self._board.write(frame_bytes(TO_BOARD, _COMMAND_50, _COMMAND_50.struct.pack(*info))):
            self.frames_to_board += 1
            self.last_to_board_s = now_s
            if self.first_to_board_s is None:
                self.first_to_board_s = now_s
            self.round_trip.asked(now_s)
        else:
            self.skipped["line_busy"] += 1

    def _move(self, surfaces: Surfaces) -> None:
        if self.link is None:
            return
        datagram = surfaces_datagram(surfaces)
        if datagram is None:
            self.skipped["surfaces_not_finite"] += 1
        elif self.link.send(datagram):
            self.frames_to_simulator += 1

    def _take_surfaces(self) -> None:
        """The board flies by wrong angular rates, which crashes the aircraft: the surfaces go to the stick, and until
        that moves them, to the simulator's own pilot, so that none stays where the board had put it."""
        self.path = "manual"
        if self.link is not None:
            self.link.send(release_datagram())
        if self.on_taken is not None:
            self.on_taken()
