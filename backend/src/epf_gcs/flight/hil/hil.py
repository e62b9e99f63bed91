"""The loop between simulator and board. Nothing here waits for a disk, a browser or a log line.

In: a datagram; when it completes a frame of the simulator, command 50 leaves in the same call. Out: a frame
with surfaces; the simulator's datagram leaves in the same call. Samples for viewers are made afterwards.
"""

from __future__ import annotations

import asyncio
from collections import Counter, deque
from collections.abc import Iterable, Mapping
from typing import Any, Final, Literal, cast

from epf_gcs.clock import Clock
from epf_gcs.codec.encode import frame_bytes
from epf_gcs.codec.frame import TO_BOARD, Frame
from epf_gcs.codec.messages_gen import COMMANDS, XPLANE_ROWS
from epf_gcs.flight.hil.stick import Stick
from epf_gcs.link.udp import UdpLink
from epf_gcs.vehicle.arrivals import Arrivals
from epf_gcs.vehicle.board import Board
from epf_gcs.vehicle.round_trip import RoundTrip
from epf_gcs.vehicle.telemetry import Telemetry
from epf_gcs.xplane.datagram import Eight, Record, Surfaces, parse, surfaces_datagram
from epf_gcs.xplane.gather import Gatherer
from epf_gcs.xplane.mapping import NEEDED_ROWS, XplaneInfo, row_meaning, surfaces_from_servos_in
from epf_gcs.xplane.whole import WholeFrames

Path = Literal["manual", "assisted"]
Source = Literal["joystick", "rc"]

_COMMAND_50: Final = COMMANDS["xplane_info"]
# With more bytes queued the line is slower than the simulator: skip the frame, it would be old when it leaves.
_MAX_BACKLOG_BYTES: Final = 256
# Hide a row not received for this long: 20 periods of the slowest simulator.
_ROW_AGE_S: Final = 1.0
# X-Plane has some 140 rows; ignore further row numbers, which no simulator sends.
_MOST_ROWS: Final = 256
_MOST_UNPARSED: Final = 256
_SHOW_EVERY_S: Final = 0.02
_RAW_EVERY_S: Final = 0.2


class Hil:
    """Takes datagrams and the board's urgent frames. `path` says who moves the simulator's surfaces."""

    def __init__(self, board: Board, telemetry: Telemetry, clock: Clock, stick: Stick) -> None:
        self._loop = asyncio.get_running_loop()
        self._board = board
        self._telemetry = telemetry
        self._clock = clock
        self.stick = stick
        self._gatherer = Gatherer("xp10")
        self._whole_frames = WholeFrames("xp10")
        self._profile = "xp10"
        self._rows: dict[int, Arrivals] = {}
        self._info: XplaneInfo | None = None
        self._unparsed: deque[tuple[float, bytes]] = deque(maxlen=_MOST_UNPARSED)
        self._show_due = False
        self._shown_s = 0.0
        self._heard_s = 0.0
        self._raw_shown_s = 0.0
        self.path: Path = "manual"
        self.link: UdpLink | None = None
        self.round_trip = RoundTrip()
        self.skipped: Counter[str] = Counter()
        self.frames_to_board = 0
        self.frames_to_simulator = 0
        self.last_to_board_s: float | None = None
        self.last_surfaces_s: float | None = None

    @property
    def source(self) -> Source | None:
        """Who holds the stick, as the board reports it; None before its first report."""
        heartbeat = self._telemetry.newest("heartbeat")
        joystick = None if heartbeat is None else heartbeat.get("source_joystick")
        return None if joystick is None else "joystick" if joystick else "rc"

    @property
    def rows(self) -> list[int]:
        """Numbers of the rows that arrive now."""
        return sorted(self._live(self._clock.steady_s()))

    @property
    def missing_rows(self) -> list[int]:
        """Numbers of the rows that command 50 needs and that do not arrive."""
        return sorted(NEEDED_ROWS - set(self.rows))

    @property
    def arrivals(self) -> Mapping[int, Arrivals]:
        """Arrival statistics of each row, by row number; times of the steady clock, in s."""
        return self._rows

    @property
    def profile(self) -> str:
        """Which generation of the simulator the rows are read as."""
        return self._profile

    def begin(self, link: UdpLink | None, profile: str) -> None:
        """Start with a new simulator, or with emulated datagrams (`link` None): forget the earlier one's data."""
        self.link = link
        self._profile = profile
        self._gatherer = Gatherer(profile)
        self._whole_frames = WholeFrames(profile)
        self._rows.clear()
        self._unparsed.clear()
        self.round_trip.clear()
        self.last_to_board_s = self.last_surfaces_s = None

    def rest(self) -> None:
        """Forget pending round trips during an AHRS test, so that the board's silence raises no HIL alarm."""
        self.round_trip.clear()
        self.last_to_board_s = self.last_surfaces_s = None

    def end(self) -> None:
        """The socket is closed."""
        self.link = None

    def on_datagram(self, datagram: bytes) -> bool:
        """Take a datagram from the simulator. False if it is not one of X-Plane's."""
        now_s = self._clock.steady_s()
        info = self._whole_frames.read(datagram)
        if info is not None:
            info = self._with_stick(info, now_s)
            self._act_on(info, now_s)
            self._unparsed.append((now_s, datagram))
        else:
            records = parse(datagram)
            if records is None:
                return False
            info = self._gatherer.take(records, now_s)
            if info is not None:
                info = self._with_stick(info, now_s)
                self._act_on(info, now_s)
            self._keep_rows(records, now_s)
        self._heard_s = self._clock.now_s()
        if info is not None:
            self._info = info
        if not self._show_due and (info is not None or now_s - self._shown_s >= _SHOW_EVERY_S):
            self._show_due = True
            self._loop.call_soon(self._show)
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
            self.round_trip.answered(now_s)
        elif self.path == "manual" and self.source == "rc":
            self._move(surfaces_from_servos_in(frame.values))

    def _keep_rows(self, records: Iterable[Record], now_s: float) -> None:
        for row, values in records:
            arrivals = self._rows.get(row)
            if arrivals is None:
                if len(self._rows) >= _MOST_ROWS:
                    continue
                arrivals = self._rows[row] = Arrivals()
            arrivals.heard(now_s, values)

    def _live(self, now_s: float) -> dict[int, Eight]:
        oldest_s = now_s - _ROW_AGE_S
        return {row: one.values for row, one in self._rows.items() if (one.last_s or 0.0) >= oldest_s}

    def _with_stick(self, info: XplaneInfo, now_s: float) -> XplaneInfo:
        """Put the chosen gamepad's position in place of the simulator's joystick, except when emulated."""
        chosen = None if self._board.is_emulated else self.stick.now(now_s)
        if chosen is None:
            return info
        elevator, aileron, rudder, throttle = chosen
        return info._replace(elevator=elevator, aileron=aileron, rudder=rudder, throttle=throttle)

    def _act_on(self, info: XplaneInfo, now_s: float) -> None:
        """Send at once what depends on a complete frame of the simulator; everything else waits for `_show`."""
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

    def _show(self) -> None:
        """Send the samples to the viewers, after the control frame has left. Their time is the newest datagram's."""
        self._show_due = False
        while self._unparsed:
            heard_s, datagram = self._unparsed.popleft()
            self._keep_rows(parse(datagram) or (), heard_s)
        t_s = self._heard_s
        self._shown_s = self._clock.steady_s()
        live = self._live(self._shown_s)
        named: dict[str, float | None] = dict(_NO_VALUES)
        implausible: list[str] = []
        for row, values in live.items():
            meaning = row_meaning(row, values, self._profile)
            named.update(meaning.values)
            implausible += meaning.implausible
        self._telemetry.take("simulator", t_s, named, implausible)
        info, self._info = self._info, None
        if info is not None:
            self._telemetry.take("xplane_info", t_s, info._asdict())
        if self._shown_s - self._raw_shown_s >= _RAW_EVERY_S:
            self._raw_shown_s = self._shown_s
            raw = {str(row): list(values) for row, values in sorted(live.items())}
            self._telemetry.take("xplane_rows", t_s, {"rows": raw})
        self._telemetry.flush()


_NO_VALUES: Final[dict[str, Any]] = {
    name: None
    for row in XPLANE_ROWS["xp10"].values()
    for name in row_meaning(row.id, cast(Eight, (0.0,) * 8), "xp10").values
}
