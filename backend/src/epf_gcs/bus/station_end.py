"""A station's end of the stream: stays connected to a vehicle, passes on its records and sends it requests."""

from __future__ import annotations

import asyncio
import contextlib
import itertools
from collections.abc import Callable
from pathlib import Path
from typing import Any, Final, Protocol, cast

import structlog

from epf_gcs.bus.address import connect
from epf_gcs.bus.channel import Channel
from epf_gcs.bus.definition import (
    Asker,
    BusError,
    Decoder,
    Kind,
    NamedText,
    Record,
    converted,
    pack_notice,
    pack_request,
    unpack_as,
    unpack_named,
    unpack_numbered,
)
from epf_gcs.bus.faults import error_of
from epf_gcs.contract.hello import Hello
from epf_gcs.contract.notices import Notice
from epf_gcs.contract.playback import Playback
from epf_gcs.contract.requests import AnswerT_co, Request, answer_type
from epf_gcs.contract.status import Status
from epf_gcs.errors import ConflictError, GatewayError, UnavailableError

_RETRY_S: Final = 0.05
# The longest request is to send a plan of 100 waypoints over a slow line.
_ANSWER_S: Final = 120.0
_LOOK_S: Final = 0.1
_MOST_OF_A_LOOK_S: Final = 2 * _LOOK_S
# A busy machine may keep a process waiting for a second or two: that long, silence fails no request.
_SILENCES_WAITED: Final = 4.0

log = structlog.get_logger("web")


class Listener(Protocol):
    """Receives a vehicle's records, on the event loop."""

    def on_hello(self, hello: Hello) -> None:
        """Connected to the vehicle; the newest sample of every topic follows."""

    def on_sample(self, sample: NamedText) -> None:
        """The newest values of a topic."""

    def on_samples_end(self) -> None:
        """All samples that arrived together were passed to `on_sample`."""

    def on_event(self, event: NamedText) -> None:
        """Something happened."""

    def on_status(self, status: Status) -> None:
        """The state of links, HIL, recording, alarms, errors and topics."""

    def on_playback(self, playback: Playback) -> None:
        """Where a replayed vehicle is, and whether it plays; a live one never says this."""

    def on_silence(self, *, silent: bool) -> None:
        """The vehicle's process is connected and says nothing any more, or is heard again."""

    def on_lost(self, *, ended: bool) -> None:
        """The connection is lost (`ended`: because the vehicle's process was told to end); reconnecting goes on."""


class StationEnd:
    """Made on a running loop. Looks for the vehicle of a data folder until `run` is cancelled.

    `silent_after_s`: a live vehicle says its status twice a second; one that says nothing for so long hangs. After four
    times as long whoever waits for it is told so. None: it may be silent.
    """

    def __init__(self, folder: Path, listener: Listener, *, silent_after_s: float | None = None) -> None:
        self._loop = asyncio.get_running_loop()
        self._silent_after_s = silent_after_s
        self._silence_s = 0.0
        self._looked_s = 0.0
        self._is_silent = False
        self._folder = folder
        self._listener = listener
        self._numbers = itertools.count(1)
        self._waiting: dict[int, asyncio.Future[Any]] = {}
        self._decoder = Decoder()
        self._channel: Channel | None = None
        self._gone = asyncio.Event()
        self._said_bye = False

    @property
    def is_connected(self) -> bool:
        """There is a connection to the vehicle's process."""
        return self._channel is not None

    async def run(self) -> None:
        """Connect, and connect again when the vehicle has gone."""
        try:
            while True:
                try:
                    connection = await connect(self._folder)
                except (OSError, ValueError, KeyError, TypeError):
                    await asyncio.sleep(_RETRY_S)
                    continue
                self._decoder = Decoder()
                self._gone.clear()
                self._said_bye = False
                self._silence_s, self._looked_s, self._is_silent = 0.0, self._loop.time(), False
                self._channel = Channel(connection, self._on_data, self._on_closed)
                await self._watch()
        finally:
            if self._channel is not None:
                self._channel.close()
                self._on_closed()

    async def _watch(self) -> None:
        """Until the connection is lost, notice when the vehicle falls silent."""
        while not self._gone.is_set():
            with contextlib.suppress(TimeoutError):
                async with asyncio.timeout(None if self._silent_after_s is None else _LOOK_S):
                    await self._gone.wait()
            self.look(self._loop.time())

    def look(self, now_s: float) -> None:
        """Whether the vehicle has fallen silent by now, a time of the loop; told a few times in `silent_after_s`.

        If this process was stalled itself, the records of that time still wait to be read: it counts as a short one.
        """
        self._silence_s += min(max(0.0, now_s - self._looked_s), _MOST_OF_A_LOOK_S)
        self._looked_s = now_s
        limit_s = self._silent_after_s
        if limit_s is not None and self.is_connected and not self._is_silent and self._silence_s > limit_s:
            self._is_silent = True
            self._listener.on_silence(silent=True)
        if self._is_given_up():
            self._fail_all(_silent())

    def _is_given_up(self) -> bool:
        limit_s = self._silent_after_s
        return limit_s is not None and self._silence_s > _SILENCES_WAITED * limit_s

    def _fail_all(self, error: GatewayError) -> None:
        for future in self._waiting.values():
            if not future.done():
                future.set_exception(error)

    async def ask(self, request: Request[AnswerT_co], by: Asker | None = None) -> AnswerT_co:
        """Send a request and return its answer. Raises what the vehicle raised; ConflictError if not connected.

        Of a vehicle that is silent, a question (without `by`) waits a little for the answer; an order is refused at
        once, because nobody would expect it to be done later.
        """
        channel = self._channel
        if channel is None:
            raise _away()
        if self._is_given_up() or (self._is_silent and by is not None):
            raise _silent()
        number = next(self._numbers)
        answer: asyncio.Future[Any] = asyncio.get_running_loop().create_future()
        self._waiting[number] = answer
        channel.send(pack_request(number, request, by))
        try:
            async with asyncio.timeout(_ANSWER_S):
                return cast(AnswerT_co, converted(answer_type(type(request)), await answer))
        except TimeoutError:
            name = type(request).__name__
            raise GatewayError("internal", f"The flight process did not answer '{name}': look at its log.") from None
        finally:
            self._waiting.pop(number, None)

    def notice(self, notice: Notice) -> None:
        """Send something that needs no answer; dropped if not connected."""
        if self._channel is not None:
            self._channel.send(pack_notice(notice))

    def _on_data(self, data: bytes) -> None:
        self._silence_s = 0.0
        if self._is_silent:
            self._is_silent = False
            self._listener.on_silence(silent=False)
        try:
            has_samples = False
            for record in self._decoder.feed(data):
                if record.kind == Kind.SAMPLE:
                    has_samples = True
                elif record.kind == Kind.PLAYBACK and has_samples:
                    # What came before it goes out before it: it may say that all samples are old.
                    has_samples = False
                    self._safely(self._listener.on_samples_end)
                self._safely(self._pass_on, record)
            if has_samples:
                self._safely(self._listener.on_samples_end)
        except BusError:
            if self._channel is not None:
                self._channel.lose()

    def _safely(self, tell: Callable[..., None], *what: Record) -> None:
        """What fails here costs no other record: an answer behind it is still waited for. Raises BusError."""
        try:
            tell(*what)
        except BusError:
            raise
        except Exception:
            log.exception("what the vehicle sent could not be taken", kinds=[record.kind for record in what])

    def _pass_on(self, record: Record) -> None:
        if record.kind == Kind.SAMPLE:
            self._listener.on_sample(unpack_named(record.body))
        elif record.kind == Kind.EVENT:
            self._listener.on_event(unpack_named(record.body))
        elif record.kind == Kind.STATUS:
            self._listener.on_status(unpack_as(Status, record.body))
        elif record.kind == Kind.ANSWER:
            number, answer = unpack_numbered(record.body)
            future = self._waiting.get(number)
            if future is None or future.done():
                return
            if "fault" in answer:
                future.set_exception(error_of(answer["fault"]))
            else:
                future.set_result(answer.get("result"))
        elif record.kind == Kind.PLAYBACK:
            self._listener.on_playback(unpack_as(Playback, record.body))
        elif record.kind == Kind.HELLO:
            self._listener.on_hello(unpack_as(Hello, record.body))
        elif record.kind == Kind.BYE:
            self._said_bye = True

    def _on_closed(self) -> None:
        self._channel = None
        self._fail_all(_away())
        self._listener.on_lost(ended=self._said_bye)
        self._gone.set()


def _silent() -> UnavailableError:
    return UnavailableError(
        "flight_silent", "The flight process does not answer: whether anything was done is not known. It is watched."
    )


def _away() -> ConflictError:
    return ConflictError(
        "flight_away", "Nothing was done because the flight process is not there: it is being started again."
    )
