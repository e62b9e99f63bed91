"""One browser that looks at a recording: the stream contract over a replay of its own. Nothing can be commanded."""

from __future__ import annotations

import asyncio
import contextlib
import secrets
from collections.abc import Callable
from dataclasses import asdict, replace
from typing import Any, Final

import orjson

from epf_gcs import __version__
from epf_gcs.access.caller import Caller
from epf_gcs.access.control import base_name
from epf_gcs.bus.definition import BusError, NamedText
from epf_gcs.contract.events import ErrorEvent
from epf_gcs.contract.hello import Hello
from epf_gcs.contract.notices import Notice
from epf_gcs.contract.playback import (
    FASTEST,
    SLOWEST,
    Loop,
    Pause,
    Play,
    Playback,
    SampleCredit,
    Seek,
    Step,
    Want,
)
from epf_gcs.contract.requests import ReadInspector, ReadKnown, Request
from epf_gcs.contract.status import Status
from epf_gcs.errors import ErrorCode, GatewayError
from epf_gcs.repeating import Repeating
from epf_gcs.web.replays.replay_process import ViewersReplay
from epf_gcs.web.stream.hub import Hub
from epf_gcs.web.stream.hub_state import HubState
from epf_gcs.web.stream.messages import INVALID, RATE_SENTENCE, TOPICS
from epf_gcs.web.stream.socket import SocketConnection
from epf_gcs.web.stream.viewer import MAX_RATE_HZ, Viewer

OPENING_EVERY_S: Final = 1.0
"""How often a viewer hears that its replay is being opened. A page gives up a line on which it hears nothing for 5 s,
and its replay would begin anew each time where opening takes longer: on a slow computer, or a busy one."""

# With every sample wanted the replay sends ahead, up to some hundred.
_LOG_SAMPLES: Final = 4096
_MOST_EARLY: Final = 40
_MOST_ASKED: Final = 8
_QUESTIONS: Final[dict[str, Request[Any]]] = {"inspector": ReadInspector(), "known": ReadKnown()}


class ReplayConversation:
    """Implements `epf_gcs.web.stream.socket.Conversation` and `epf_gcs.bus.station_end.Listener`.

    `on_start` gets the task that runs the replay; `on_end` is called once, when the viewer has gone.
    """

    def __init__(
        self,
        connection: SocketConnection,
        caller: Caller,
        replay: ViewersReplay,
        *,
        rate_hz: int,
        on_start: Callable[[asyncio.Task[None]], None],
        on_end: Callable[[], None],
    ) -> None:
        self._loop = asyncio.get_running_loop()
        self._connection = connection
        self._replay = replay
        self._on_start = on_start
        self._on_end: Callable[[], None] | None = on_end
        self._client = secrets.token_hex(8)
        self._caller = caller
        self._hub = Hub(self._loop, lambda: self._at_s, HubState(_LOG_SAMPLES))
        self._viewer = Viewer(self._client, base_name(caller), connection, self._hub.state, rate_hz)
        self._task: asyncio.Task[None] | None = None
        self._playback: Playback | None = None
        self._at_s = 0.0
        self._untold = 0
        self._jump: bytes | None = None
        self._is_elsewhere = True
        self._early: list[Notice] = []
        self._asked: set[asyncio.Task[None]] = set()
        self._is_greeted = False
        self._opening = Repeating(self._loop, "a replay that opens", self._tell_opening, OPENING_EVERY_S)

    def greet(self) -> None:
        """Start the replay; the hello follows when it is there."""
        self._task = self._loop.create_task(self._run(), name=f"replay of {self._replay.flight}")
        self._on_start(self._task)
        self._opening.arm(OPENING_EVERY_S)

    def on_text(self, text: str) -> None:
        """An acknowledgement, a rate, or what to play; anything else is answered with an error event."""
        fault = self._take(text)
        if fault is not None:
            self._tell_error(INVALID, fault)

    def on_closed(self) -> None:
        """The browser disconnected: the replay ends."""
        self._opening.stop()
        for task in (self._task, *self._asked):
            if task is not None:
                task.cancel()
        if self._on_end is not None:
            self._on_end()
            self._on_end = None

    def on_hello(self, hello: Hello) -> None:
        """The replay is there."""
        playback, span = hello.playback, hello.flight
        if playback is None or span is None:
            raise BusError("a replay says what it replays")
        self._playback, self._at_s = playback, playback.t_s
        if self._is_greeted:
            return
        self._is_greeted = True
        self._opening.stop()
        said = {
            "type": "hello",
            "version": __version__,
            "client": self._client,
            "name": self._viewer.name,
            "kind": self._caller.kind,
            "number": 1,
            "role": self._caller.role.name,
            "has_control": False,
            "server_time_s": self._at_s,
            "topics": TOPICS,
            "flight": span.flight,
            "starts_s": span.starts_s,
            "duration_s": span.duration_s,
            "status": self._whole(hello.status),
        }
        self._viewer.greet(orjson.dumps(said))
        self._hub.add(self._viewer)
        self._replay.notice(Want(self._viewer.rate_hz))
        for notice in self._early:
            self._replay.notice(notice)

    def on_sample(self, sample: NamedText) -> None:
        """A sample of the moment that is shown."""
        newest_s = sample.t_s if self._is_elsewhere else self._hub.state.newest_s
        self._is_elsewhere = False
        self._hub.state.put(sample.name, sample.t_s, sample.text)
        # A batch's time goes back only where the replay went elsewhere.
        self._hub.state.newest_s = max(newest_s, sample.t_s)
        self._untold += 1

    def on_samples_end(self) -> None:
        """A group of samples is complete."""
        self._tell_jump()
        self._hub.flush()
        self._tell_taken()

    def on_event(self, event: NamedText) -> None:
        """Something that happened at that moment of the flight."""
        self._hub.send_event(event.text)

    def on_status(self, status: Status) -> None:
        """The state of the flight at that moment."""
        self._tell_jump()
        self._hub.status(orjson.dumps({"type": "status", "data": self._whole(status)}))

    def on_playback(self, playback: Playback) -> None:
        """Where the replay is; after a jump all samples before it are of another moment."""
        self._at_s = playback.t_s
        text = orjson.dumps({"type": "playback", **asdict(playback)})
        if self._playback is None or playback.jumps != self._playback.jumps:
            self._hub.state.clear()
            self._hub.state.newest_s = self._at_s
            self._is_elsewhere = True
            self._untold = 0
            # Sent with the samples of the new moment, which follow: no batch lies between.
            self._jump = text
        else:
            self._tell_jump()
            self._hub.send_event(text)
        self._playback = playback

    def on_silence(self, *, silent: bool) -> None:
        """A replay may be silent: it stands still."""

    def on_lost(self, *, ended: bool) -> None:
        """The replay has gone; `_run` says why."""

    def _tell_opening(self) -> float:
        self._connection.send([b'{"type":"opening"}'])
        return OPENING_EVERY_S

    async def _run(self) -> None:
        words = await self._replay.run(self)
        sentence = words.rpartition("\n")[2].removeprefix("epf-replay: ") or "The replay ended unexpectedly."
        self._opening.stop()
        self._tell_error("recording_unreadable", sentence)
        await asyncio.sleep(0)
        self._connection.end("the replay has ended")

    def _take(self, text: str) -> str | None:
        """Handle a message; a sentence if it was not valid."""
        try:
            message: Any = orjson.loads(text)
        except orjson.JSONDecodeError:
            return 'A message on the stream was not JSON: send {"type": "ack", "seq": n}, a rate or what to play.'
        match message:
            case {"type": "ack", "seq": int(seq)} if self._viewer.acknowledge(seq):
                if self._viewer.waiting:
                    self._hub.serve(self._viewer)
                # Samples that came while the viewer was queued have been sent since, without a word to the replay.
                self._loop.call_soon(self._tell_taken)
                return None
            case {"type": "ack"}:
                return "An acknowledgement named a batch that is not under way: send the seq of a batch."
            case {"type": "rate", "rate": int(rate)} if 0 <= rate <= MAX_RATE_HZ:
                if self._is_greeted:
                    self._hub.change_rate(self._viewer, rate)
                self._viewer.rate_hz = rate
                return self._tell(Want(rate))
            case {"type": "rate"}:
                return RATE_SENTENCE
            case _:
                return self._take_wish(message)

    def _take_wish(self, message: Any) -> str | None:
        match message:
            case {"type": "play" | "loop"}:
                return self._take_course(message)
            case {"type": "pause"}:
                return self._tell(Pause())
            case {"type": "seek", "at_s": int() | float() as at_s}:
                return self._tell(Seek(at_s))
            case {"type": "step", "frames": 1 | -1 as frames}:
                return self._tell(Step(frames))
            case {"type": "ask", "about": "inspector" | "known" as about}:
                return self._ask(about)
            case {"type": "stick"}:
                return "This is a recording: nothing can be flown or commanded in it."
            case _:
                return (
                    "A message has no known type: send ack, rate, play, pause, seek {at_s}, step {frames}, loop or "
                    "ask {about}."
                )

    def _take_course(self, message: Any) -> str | None:
        """How fast it goes on, and whether it repeats a stretch."""
        match message:
            case {"type": "play", "rate": int() | float() as rate} if SLOWEST <= rate <= FASTEST:
                return self._tell(Play(rate))
            case {"type": "play"} if "rate" not in message:
                return self._tell(Play(1.0))
            case {"type": "play"}:
                return f"A rate of play must be {SLOWEST:g} to {FASTEST:g} times the real speed: send play {{rate}}."
            case {"type": "loop", "from_s": int() | float() as begin, "to_s": int() | float() as end} if begin < end:
                return self._tell(Loop(begin, end))
            case {"type": "loop"} if "from_s" not in message and "to_s" not in message:
                return self._tell(Loop())
            case _:
                return (
                    "A loop must go from a moment to a later one: send loop {from_s, to_s} in seconds, or loop alone."
                )

    def _tell(self, notice: Notice) -> str | None:
        """Pass a wish on to the replay; what is said before it is there, waits for it. Returns no fault."""
        if self._is_greeted:
            self._replay.notice(notice)
        elif len(self._early) < _MOST_EARLY:
            self._early.append(notice)
        return None

    def _ask(self, about: str) -> str | None:
        """Answer about the moment that is shown; a sentence if too many questions are open."""
        if len(self._asked) >= _MOST_ASKED:
            return f"{_MOST_ASKED} questions are unanswered: wait for an answer before you ask again."
        if self._is_greeted:
            task = self._loop.create_task(self._answer(about), name=f"answer about {about}")
            self._asked.add(task)
            task.add_done_callback(self._asked.discard)
        return None

    async def _answer(self, about: str) -> None:
        # A replay that has gone says so itself.
        with contextlib.suppress(GatewayError):
            data = await self._replay.ask(_QUESTIONS[about])
            self._viewer.offer_event(orjson.dumps({"type": "answer", "about": about, "data": data}))
            self._hub.serve(self._viewer)

    def _tell_taken(self) -> None:
        """A viewer of every sample has been sent all there is: the replay may go on."""
        if self._untold and not self._viewer.rate_hz and not self._viewer.waiting and not self._viewer.queued:
            self._replay.notice(SampleCredit(self._untold))
            self._untold = 0

    def _tell_jump(self) -> None:
        if self._jump is not None:
            self._viewer.offer_event(self._jump)
            self._jump = None
            self._hub.serve(self._viewer)

    def _tell_error(self, code: ErrorCode, detail: str) -> None:
        text = self._hub.event_text(ErrorEvent(code, detail, {}))
        if self._is_greeted:
            self._viewer.offer_event(text)
            self._hub.serve(self._viewer)
        else:
            with contextlib.suppress(OSError):
                self._connection.send([text])

    def _whole(self, status: Status) -> dict[str, Any]:
        """Nobody commands the past, and what was around the aircraft then is not known."""
        return {**asdict(replace(status, version=__version__, viewers=1)), "playback": self._playback}
