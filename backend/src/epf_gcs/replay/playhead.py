"""A vehicle that is fed from a recording: the same vehicle as the live one, with the recording's clock.

Whether it was played to a moment, sought to it, or begun at a key frame before it, its state there is the same: it
depends on the recorded bytes, notes and times alone. Ticks, which live come when they come, are at tenths of a second.
"""

from __future__ import annotations

from typing import Final

from epf_gcs.codec.frame import TO_BOARD, Frame, FrameDecoder
from epf_gcs.codec.messages_gen import COMMANDS, DATAGRAM_MAGIC
from epf_gcs.contract.events import ErrorEvent, noted_event
from epf_gcs.contract.simulator_faults import MAGIC as REPORT_MAGIC
from epf_gcs.contract.status import AlarmState
from epf_gcs.error_log import ErrorLog
from epf_gcs.recordings import notes
from epf_gcs.recordings.notes import Note
from epf_gcs.recordings.topics import BOARD_RECEIVED, BOARD_SENT, SIMULATOR_RECEIVED, SIMULATOR_SENT
from epf_gcs.replay.ahrs_test import RecordedAhrsTest
from epf_gcs.replay.clock import RecordedClock
from epf_gcs.replay.judged import JudgedAlarms
from epf_gcs.replay.known import LineNote, RecordedState
from epf_gcs.replay.playhead_state import PlayheadState
from epf_gcs.replay.recorded_line import RecordedLine
from epf_gcs.replay.timeline import Cursor, Item, Timeline
from epf_gcs.vehicle.judges import Line, Loop
from epf_gcs.vehicle.outside import Outlet
from epf_gcs.vehicle.own_topics import known_topics, own_messages
from epf_gcs.vehicle.rates import ByteRate
from epf_gcs.vehicle.simulator_samples import Reading
from epf_gcs.vehicle.vehicle import Vehicle
from epf_gcs.vehicle.wanted import RATE_COMMANDS

_TICK_NS: Final = 100_000_000
# Ticks go on this long after the last item; a file with a wrong clock may have a gap of years.
_TICKING_NS: Final = 600_000_000_000
_COMMAND_50: Final = COMMANDS["xplane_info"]
# The stick's four values come first in command 50.
_STICK_BYTES: Final = 16
_DEFAULT_BAUD: Final = 115_200


class Playhead:
    """`advance` feeds all up to a moment. `from_ns` and `kept` are a key frame's; without them it begins at the start.

    `outlet` gets the samples and events, those of the notes too.
    """

    def __init__(
        self, timeline: Timeline, outlet: Outlet, from_ns: int | None = None, kept: PlayheadState | None = None
    ) -> None:
        self._outlet = outlet
        self._cursor = Cursor(timeline, from_ns)
        self.clock = RecordedClock()
        self.known = RecordedState()
        self.errors = ErrorLog()
        self.errors.tell_viewers(self.clock.steady_s, lambda *told: outlet.event(ErrorEvent.of(*told)))
        # Those of the simulator's jumps that were noted are told from the notes.
        is_noted = timeline.has_event_notes
        self.vehicle = Vehicle(self.clock, outlet, self.errors, self._period_s, tells_jumps=not is_noted)
        self._ahrs_test = RecordedAhrsTest(self.vehicle)
        self._sent = FrameDecoder(TO_BOARD)
        self.bytes_sent = 0
        self.frames_to_board = 0
        self.frames_to_simulator = 0
        self.datagrams_dropped = 0
        self.board_in, self.board_out, self.simulator_in = ByteRate(), ByteRate(), ByteRate()
        self._tick_ns = 0
        self._attached_s = 0.0
        self._first_to_board_s: float | None = None
        self._to_board_s: float | None = None
        self.clock.t_ns = self._heard_ns = self._frame_ns = timeline.starts_ns or 0
        self._judged = None if is_noted else JudgedAlarms(self.vehicle, outlet, self._line, self._loop)
        if kept is None:
            self._begin(from_ns)
        else:
            self._restore(kept)

    @property
    def alarms(self) -> list[AlarmState]:
        """The alarms listed at the moment, oldest first: as they were noted, or judged anew if nothing was noted."""
        return self.known.alarms() if self._judged is None else self._judged.listed()

    @property
    def next_ns(self) -> int | None:
        """The time of the next message or note; None at the edge of what is recorded."""
        item = self._cursor.peek()
        return None if item is None else item.t_ns

    def advance(self, to_ns: int, most: int | None = None) -> bool:
        """Feed all up to Unix time `to_ns`, at most `most` items. False if more items wait than that."""
        cursor = self._cursor
        while (item := cursor.peek()) is not None and item.t_ns <= to_ns:
            if most is not None:
                if not most:
                    return False
                most -= 1
            if item.t_ns >= self._tick_ns:
                self._tick_to(item.t_ns)
            cursor.take()
            self.clock.t_ns = self._heard_ns = item.t_ns
            count = self._count()
            self._take(item)
            if self._count() != count:
                self._frame_ns = item.t_ns
        if to_ns >= self._tick_ns:
            self._tick_to(to_ns + 1)
        self.clock.t_ns = max(self.clock.t_ns, to_ns)
        return True

    @property
    def frame_ns(self) -> int:
        """The time of the last frame or datagram."""
        return self._frame_ns

    def step(self) -> int | None:
        """Feed on to the next frame or datagram that gives a sample; returns its time, None at the edge."""
        count = self._count()
        while (t_ns := self.next_ns) is not None:
            self.advance(t_ns)
            if self._count() != count:
                return t_ns
        return None

    def kept(self) -> str:
        """The state as a key frame holds it; only while no AHRS test has the line."""
        state = PlayheadState(
            t_ns=self.clock.t_ns,
            tick_ns=self._tick_ns,
            heard_ns=self._heard_ns,
            frame_ns=self._frame_ns,
            known=self.known.now,
            vehicle=self.vehicle.kept(),
            sent=self._sent.kept(),
            counts=(self.bytes_sent, self.frames_to_board, self.frames_to_simulator, self.datagrams_dropped),
            rates=[rate.kept() for rate in (self.board_in, self.board_out, self.simulator_in)],
            errors=dict(self.errors.counts),
            lines=(self._attached_s, self._first_to_board_s, self._to_board_s),
            judged=None if self._judged is None else self._judged.kept(),
        )
        return state.as_json()

    @property
    def can_be_kept(self) -> bool:
        """Whether a key frame can begin here: the next item is a message, of a later time than all before it."""
        item = self._cursor.peek()
        return (
            item is not None
            and item.topic > 0
            and item.t_ns > self.clock.t_ns
            and self.vehicle.board.exclusive_user is None
        )

    def _begin(self, from_ns: int | None) -> None:
        if from_ns is not None:
            self.clock.t_ns = self._heard_ns = from_ns
            for note in self._cursor.notes_before:
                self.known.take(note)
        self._tick_ns = self._after(self.clock.t_ns)
        self._attach()
        self._begin_simulator(self.known.now.lines["simulator"].profile)

    def _attach(self) -> None:
        board = self.known.now.lines["board"]
        if board.open or not self.known.now.has_lines:
            line = RecordedLine(_DEFAULT_BAUD if board.baud is None else board.baud)
            self.vehicle.board.attach(line, is_emulated=board.emulated, target=board.url or "")
            self._attached_s = self.clock.now_s()
            self._learn()

    def _learn(self) -> None:
        """The frames of the board's own topics are read as the table says that was known then."""
        own = self.known.now.own
        self.vehicle.board.learn(() if own is None else own_messages(known_topics(own.table)))

    def _restore(self, kept: PlayheadState) -> None:
        self.clock.t_ns, self._tick_ns, self._heard_ns = kept.t_ns, kept.tick_ns, kept.heard_ns
        self._frame_ns = kept.frame_ns
        self.known.now = kept.known
        self._attach()
        self.vehicle.restore(kept.vehicle)
        self._sent.restore(kept.sent)
        self.bytes_sent, self.frames_to_board, self.frames_to_simulator, self.datagrams_dropped = kept.counts
        for rate, held in zip((self.board_in, self.board_out, self.simulator_in), kept.rates, strict=True):
            rate.restore(held)
        self.errors.counts.update(kept.errors)
        self._attached_s, self._first_to_board_s, self._to_board_s = kept.lines
        if self._judged is not None and kept.judged is not None:
            self._judged.restore(kept.judged)

    def _take(self, item: Item) -> None:
        topic, data = item.topic, item.data
        if topic == BOARD_RECEIVED:
            self.vehicle.board.on_bytes(data)
        elif topic == SIMULATOR_RECEIVED:
            self._take_datagram(data)
        elif topic == BOARD_SENT:
            self.bytes_sent += len(data)
            self._ahrs_test.sent(data)
            count = len(self._told_in(data, self._sent))
            if count:
                self.frames_to_board += count
                self._to_board_s = self.clock.now_s()
                if self._first_to_board_s is None:
                    self._first_to_board_s = self._to_board_s
        elif topic == SIMULATOR_SENT:
            # Not what an X-Plane is told to send.
            self.frames_to_simulator += data.startswith(DATAGRAM_MAGIC)
        elif item.note is not None:
            self._take_note(item.note)

    def _take_datagram(self, datagram: bytes) -> None:
        simulator = self.vehicle.simulator
        reading = simulator.read(datagram, self.clock.now_s())
        if reading is None:
            # A relay brings the embedded simulator's word on its faults here too: nothing was dropped.
            self.datagrams_dropped += not datagram.startswith(REPORT_MAGIC)
            return
        simulator.show(self._with_stick(reading))
        self.vehicle.telemetry.flush()

    def _with_stick(self, reading: Reading) -> Reading:
        """The stick that the board was told: a gamepad's may have replaced the simulator's, and leaves no other trace.

        Command 50 leaves in the call that takes the datagram, so it is the very next thing recorded.
        """
        following = self._cursor.peek()
        if reading.info is None or following is None or following.topic != BOARD_SENT:
            return reading
        wire = _COMMAND_50.struct.pack(*reading.info)
        for frame in self._told_in(following.data, FrameDecoder(TO_BOARD)):
            if frame.payload[_STICK_BYTES:] == wire[_STICK_BYTES:] and frame.payload != wire:
                elevator, aileron, rudder, throttle = frame.values[:4]
                told = reading.info._replace(elevator=elevator, aileron=aileron, rudder=rudder, throttle=throttle)
                return reading._replace(info=told)
        return reading

    def _told_in(self, data: bytes, decoder: FrameDecoder) -> list[Frame]:
        return [one for one in decoder.feed(data) if isinstance(one, Frame) and one.message is _COMMAND_50]

    def _take_note(self, note: Note) -> None:
        board, simulator = self.known.now.lines["board"], self.known.now.lines["simulator"]
        own = self.known.now.own
        rate_command = self.known.take(note)
        if self.known.now.own is not own:
            self._learn()
        if rate_command is not None:
            self.vehicle.telemetry.rate_changed(rate_command)
            self.vehicle.board.frame_statistics.rate_changed(rate_command)
            if rate_command == RATE_COMMANDS[0]:
                self.vehicle.board.session.expect_heartbeat_every(self._period_s(rate_command))
        content = note.content
        if note.name == notes.LINE:
            self._lines_changed(board, simulator)
        elif note.name == "simulator_link" and isinstance(content, dict):
            # A note of the first recordings.
            self._begin_simulator(content.get("profile"))
        elif (
            note.name == notes.EVENT
            and isinstance(content, dict)
            and isinstance(content.get("data"), dict)
            and (event := noted_event(str(content.get("event")), content["data"])) is not None
        ):
            # In its place in the file, with the time that it has.
            here_ns, self.clock.t_ns = self.clock.t_ns, note.t_ns
            self._outlet.event(event)
            self.clock.t_ns = here_ns

    def _lines_changed(self, board_before: LineNote, simulator_before: LineNote) -> None:
        """A note says how the lines are; it may say what is known already."""
        board, simulator = self.known.now.lines["board"], self.known.now.lines["simulator"]
        if board != board_before:
            if self.vehicle.board.link is not None:
                self.vehicle.board.detach()
            self._attach()
        if simulator != simulator_before:
            if simulator.open:
                self._begin_simulator(simulator.profile)
            else:
                self.vehicle.simulator.end()

    def _begin_simulator(self, profile: object) -> None:
        self.vehicle.simulator.begin("xp12" if profile == "xp12" else "xp10")

    def _tick_to(self, t_ns: int) -> None:
        """Do what is due at each tick before `t_ns`. Long after the last item nothing is due any more."""
        stop_ns = min(t_ns, self._heard_ns + _TICKING_NS)
        while self._tick_ns < stop_ns:
            self.clock.t_ns = self._tick_ns
            self.vehicle.board.tick()
            now_s = self.clock.now_s()
            self.board_in.note(now_s, self.vehicle.board.bytes_in)
            self.board_out.note(now_s, self.bytes_sent)
            self.simulator_in.note(now_s, self.vehicle.simulator.bytes_in)
            if self._judged is not None:
                self._judged.look()
            self._tick_ns += _TICK_NS
        self._tick_ns = max(self._tick_ns, self._after(t_ns - 1))

    def _line(self) -> Line | None:
        """What is known of the board's line, for the alarms that are judged."""
        board, now_s = self.vehicle.board, self.clock.now_s()
        if board.link is None or board.exclusive_user is not None:
            return None
        was_heard = board.session.heartbeat_s is not None
        return Line(
            target=self.known.now.lines["board"].url or "",
            wanted_for_s=now_s - self._attached_s,
            is_lost=was_heard and not board.is_open,
            was_heard=was_heard,
            heartbeat_age_s=self.vehicle.telemetry.age_s("heartbeat"),
            stale_after_s=self.vehicle.telemetry.stale_after_s("heartbeat"),
            failure=None,
        )

    def _loop(self) -> Loop | None:
        first_s, to_board_s = self._first_to_board_s, self._to_board_s
        if first_s is None or to_board_s is None or self.vehicle.board.exclusive_user is not None:
            return None
        now_s, simulator = self.clock.now_s(), self.vehicle.simulator
        surfaces_age_s = self.vehicle.telemetry.age_s("hil_surfaces")
        return Loop(
            to_board_age_s=now_s - to_board_s,
            unanswered_s=now_s - first_s if surfaces_age_s is None else surfaces_age_s,
            is_board_open=self.vehicle.board.is_open,
            is_simulator_open=bool(simulator.rows(now_s)),
            missing_rows=simulator.missing_rows(now_s),
            unusable=simulator.unusable(now_s),
            is_paused=simulator.motion.is_paused(now_s),
        )

    def _count(self) -> int:
        return self.vehicle.board.frames_received + self.vehicle.simulator.datagrams

    def _period_s(self, rate_command: str) -> float:
        return self.known.wanted.period_s(rate_command)

    @staticmethod
    def _after(t_ns: int) -> int:
        """The first tick after a moment."""
        return (t_ns // _TICK_NS + 1) * _TICK_NS
