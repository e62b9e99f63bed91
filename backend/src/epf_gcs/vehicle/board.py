"""One board: bytes in; samples, console lines and damage out; frames back. Knows no device and no clock of its own."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterator
from contextlib import AbstractContextManager, contextmanager
from typing import Final

from epf_gcs.codec.frame import Damage, Frame, FrameDecoder
from epf_gcs.codec.session import Session, SessionState
from epf_gcs.codec.tables import Message
from epf_gcs.codec.values import Json, Meaning
from epf_gcs.contract.events import ConsoleEvent
from epf_gcs.error_log import ErrorLog
from epf_gcs.errors import ConflictError, LinkError
from epf_gcs.vehicle.board_state import BoardState
from epf_gcs.vehicle.exclusive_user import ExclusiveUser
from epf_gcs.vehicle.frame_statistics import FrameStatistics
from epf_gcs.vehicle.outside import Clock, Line, Outlet
from epf_gcs.vehicle.restart import BoardRestart, Restart
from epf_gcs.vehicle.telemetry import Telemetry

_URGENT: Final = frozenset({"hil_surfaces", "servos_in"})
# Counted when it comes, for the next command of its type asks how many are still to come.
_COUNTED: Final = "acknowledgement"
# More pieces of noise than the board's shell or plugging in a cable can cause.
_RUBBISH: Final = 20
_HANDSHAKE: Final = frozenset({"heartbeat", "capabilities"})

Listener = Callable[[Frame, Meaning], None]


class Board:
    """Takes links and bytes; passes frames first to `on_urgent`, then to the telemetry, then to the listeners.

    Frames are decoded when the telemetry is looked at or wanted outside; at once while anybody listens to all of them.
    `on_opened` is called when commands can be sent, `on_restarted` when the board has lost what it was told.
    """

    def __init__(
        self,
        clock: Clock,
        outlet: Outlet,
        telemetry: Telemetry,
        errors: ErrorLog,
        *,
        on_opened: Callable[[], None] = lambda: None,
        on_restarted: Callable[[Restart], None] = lambda _: None,
    ) -> None:
        self._clock = clock
        self._event = outlet.event
        self._telemetry = telemetry
        self._errors = errors
        self._decoder = FrameDecoder()
        self._link: Line | None = None
        self._deliver: Callable[[], None] = lambda: None
        self._listeners: list[Listener] = []
        self._listeners_of: dict[str, list[Listener]] = {}
        self._bytes_at_tick = 0
        self._damage_before: Counter[str] = Counter()
        self._was_open = False
        self.exclusive_user: ExclusiveUser | None = None
        self.session = Session()
        self.frames_received = 0
        self.damage: Counter[str] = Counter()
        self._statistics = FrameStatistics()
        telemetry.on_decoded = self._on_decoded
        self.bytes_in = 0
        self.bytes_out = 0
        self.baud = 0
        # The link brings example values: they must not reach a simulator, and commands are refused.
        self.is_emulated = False
        # Set by the composition root: the HIL bridge, which gets its frames first, and is made from this board.
        self.on_urgent: Callable[[Frame], None] | None = None
        self._on_opened = on_opened
        self._on_restarted = on_restarted
        self._restart = BoardRestart()

    @property
    def link(self) -> Line | None:
        """The open line, if any."""
        return self._link

    @property
    def is_open(self) -> bool:
        """Commands can be sent, and it is known whether the board acknowledges them."""
        return self._link is not None and self.session.is_open

    @property
    def frame_statistics(self) -> FrameStatistics:
        """Counts of all frames so far."""
        self._telemetry.catch_up()
        return self._statistics

    @property
    def frames_damaged(self) -> int:
        """Number of failed frame candidates, without noise and text."""
        return sum(count for kind, count in self.damage.items() if kind not in ("noise", "remains", "text"))

    @property
    def hears_only_rubbish(self) -> bool:
        """Much noise came on this link, no heartbeat and hardly any text: probably a wrong baud rate."""
        noise = self.damage["noise"] - self._damage_before["noise"]
        text = self.damage["text"] - self._damage_before["text"]
        return self._link is not None and self.session.heartbeat_s is None and noise > _RUBBISH and noise > 10 * text

    def heartbeat_age_s(self) -> float | None:
        """Time since the board's last heartbeat on this link."""
        return self.session.heartbeat_age_s(self._clock.steady_s())

    def attach(
        self, link: Line, *, is_emulated: bool = False, target: str = "", deliver: Callable[[], None] = lambda: None
    ) -> None:
        """A link to `target` is open: begin the dialogue. `deliver` makes it hand over bytes that wait."""
        self._telemetry.catch_up()
        self._link, self._deliver = link, deliver
        self.is_emulated = is_emulated
        if is_emulated:
            self._statistics.clear()
        self.baud = link.baud
        self._begin_decoding()
        self._was_open = False
        self._damage_before = Counter(self.damage)
        self._restart.link_opened(target)
        self.write(self.session.open(self._clock.steady_s()))

    def detach(self) -> None:
        """The link is gone."""
        self._link, self._deliver = None, lambda: None
        self._end_exclusive_use()
        self._take(self._decoder.finish())
        self._was_open = False
        self.session.close()
        if self.is_emulated:
            self.is_emulated = False
            self.frame_statistics.clear()
            self._telemetry.blank()

    def _begin_decoding(self) -> None:
        self._decoder = FrameDecoder()
        self.learn(())

    def learn(self, own: tuple[Message, ...]) -> None:
        """From now on the board's own topics are these: what it described, until it may be another board."""
        self._decoder.learn(own)
        self.frame_statistics.learn(own)

    def say_goodbye(self) -> None:
        """Stop the board's streams and put it into text mode, if the link is still open."""
        farewell = self._end_exclusive_use() + self.session.close()
        if farewell:
            self.write(farewell)

    def acquire_line(self, user: ExclusiveUser) -> None:
        """Leave binary mode and give the line to `user` alone: nothing can be commanded until `release_line`."""
        self.write(self.session.close())
        self._restart.link_opened("")
        self._take(self._decoder.finish())
        self._begin_decoding()
        self._was_open = False
        self.exclusive_user = user

    def release_line(self) -> None:
        """End the exclusive use of the line and begin the dialogue again."""
        farewell = self._end_exclusive_use()
        if self._link is not None:
            self.write(farewell + self.session.open(self._clock.steady_s()))

    def _end_exclusive_use(self) -> bytes:
        user, self.exclusive_user = self.exclusive_user, None
        return b"" if user is None else user.on_line_released()

    def check_commandable(self) -> None:
        """Raise ConflictError while the AHRS test has the line, or while the link is the emulation."""
        if self.exclusive_user is not None:
            raise ConflictError(
                "ahrs_test_running", "Nothing was sent because the AHRS test is running: stop the test first."
            )
        if self.is_emulated:
            raise ConflictError(
                "emulation_running", "Nothing was sent because this is the emulation, not a board: stop it first."
            )

    def write(self, data: bytes) -> bool:
        """Send bytes as they are. False if there is no link or its queue is full."""
        if self._link is None or not self._link.write(data):
            return False
        self.bytes_out += len(data)
        return True

    def listen(self, message: str, listener: Listener) -> None:
        """Call `listener` for every good frame of this message from now on."""
        self._listeners_of.setdefault(message, []).append(listener)

    @contextmanager
    def listening(self, listener: Listener) -> Iterator[None]:
        """Call `listener` for every good frame that comes inside the `with` block, as soon as it comes."""
        self._deliver()
        self._telemetry.catch_up()
        self._listeners.append(listener)
        try:
            yield
        finally:
            self._listeners.remove(listener)

    def on_bytes(self, data: bytes) -> None:
        """Bytes of the line."""
        self.bytes_in += len(data)
        if self.exclusive_user is not None:
            self.exclusive_user.on_bytes(data)
            return
        found = self._decoder.feed(data)
        if found:
            self._take(found)

    def missing_bytes(self, ahead: bytes = b"") -> int:
        """The least number of bytes still needed to complete a frame; 0 if unknown. `ahead`: what comes next."""
        return 0 if self.exclusive_user is not None else self._decoder.missing_with(ahead)

    def may_wait(self) -> bool:
        """Whether nothing here needs the line's bytes as they come: the dialogue is open and no answer is awaited."""
        return self.is_open and self.exclusive_user is None and not self._listeners

    def together(self) -> AbstractContextManager[None]:
        """Frames of bytes that are given inside are decoded and sent together."""
        return self._telemetry.together()

    def tick(self) -> None:
        """Do what is due; called some times a second."""
        self._telemetry.catch_up()
        if self.bytes_in == self._bytes_at_tick:
            # Nothing came since the last tick: hand out text without its line end, as the board's prompt has none.
            self._take(self._decoder.flush())
        self._bytes_at_tick = self.bytes_in
        if self._link is not None:
            answer = self.session.tick(self._clock.steady_s())
            if answer:
                self.write(answer)
            self._notice_opening()

    def _take(self, found: list[Frame | Damage]) -> None:
        """Pass on what the line brought, the most urgent receiver first: simulator, viewers, statistics."""
        if not found:
            return
        t_s = self._clock.now_s()
        frames: list[Frame] = []
        others: list[Frame] = []
        for item in found:
            if isinstance(item, Frame):
                frames.append(item)
                if item.message.name not in _URGENT:
                    others.append(item)
                elif self.on_urgent is not None:
                    self.on_urgent(item)
        if frames:
            self.frames_received += len(frames)
            is_awaited = bool(self._listeners) or any(frame.message.name == _COUNTED for frame in others)
            self._telemetry.hear(frames, t_s, at_once=is_awaited)
            self._converse(others)
        if len(frames) < len(found):
            self._take_damages(found, t_s)

    def _converse(self, frames: list[Frame]) -> None:
        """Go on with the dialogue that opens the session and watches it."""
        for frame in frames:
            if frame.message.name in _HANDSHAKE or frame.message.extension:
                answer = self.session.on_frame(frame, self._clock.steady_s())
                if answer:
                    self.write(answer)
        if not self._was_open:
            self._notice_opening()

    def _on_decoded(self, frame: Frame, meant: Meaning, t_s: float) -> None:
        name = frame.message.name
        self._statistics.heard[name].heard(t_s, meant.values)
        for listener in (*self._listeners_of.get(name, ()), *self._listeners):
            listener(frame, meant)

    def _take_damages(self, found: list[Frame | Damage], t_s: float) -> None:
        self._telemetry.catch_up()  # what came before an event goes out before it
        for item in found:
            if isinstance(item, Damage):
                self._statistics.on_damage(item, t_s)
                self._take_damage(item)

    def _take_damage(self, damage: Damage) -> None:
        text = damage.text
        self.damage[damage.kind if text is None else "text"] += 1
        if text:
            if self.session.state is SessionState.OPENING:
                self._restart.heard_text()
            self._event(ConsoleEvent("received", text))
        elif text is None and damage.kind != "remains":
            self._errors.report(
                LinkError(
                    "line_garbage",
                    f"The board's line brought bytes that are no frame ({damage.kind}): check baud rate and cable.",
                    kind=damage.kind,
                )
            )

    def _notice_opening(self) -> None:
        """Notice that the session has opened, or that it is no longer open because the heartbeat stopped."""
        is_open = self.is_open
        if is_open and not self._was_open:
            self._was_open = True
            self._on_opened()
            self._notice_restart()
        elif not is_open and self.session.state is SessionState.OPENING:
            if self._was_open:
                self._restart.fell_silent(self._telemetry.newest("heartbeat") or {})
            self._was_open = False

    def _notice_restart(self) -> None:
        uptime = self.capabilities().get("uptime_ms")
        found = self._restart.opened(
            self._clock.steady_s(),
            self._clock.now_s(),
            uptime if isinstance(uptime, int) else None,
            self._telemetry.newest("heartbeat") or {},
        )
        if found is not None:
            self._on_restarted(found)

    def kept(self) -> BoardState:
        """For `restore`."""
        return BoardState(
            session=self.session.kept(),
            decoder=self._decoder.kept(),
            was_open=self._was_open,
            frames=self.frames_received,
            bytes_in=(self.bytes_in, self._bytes_at_tick),
            damage=(dict(self.damage), dict(self._damage_before)),
            statistics=self.frame_statistics.kept(),
        )

    def restore(self, kept: BoardState) -> None:
        """Go on from a state that `kept` gave, with the same line attached."""
        self.session.restore(kept.session)
        self._decoder.restore(kept.decoder)
        self._was_open = kept.was_open
        self.frames_received = kept.frames
        self.bytes_in, self._bytes_at_tick = kept.bytes_in
        self.damage, self._damage_before = map(Counter, kept.damage)
        self._statistics.restore(kept.statistics)

    def capabilities(self) -> dict[str, Json]:
        """What an extended board reported about itself; empty for a legacy board."""
        return self.session.capabilities or {}
