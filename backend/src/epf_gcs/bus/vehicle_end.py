"""The vehicle's end of the stream: sends to all listeners, answers requests, never waits for a slow listener."""

from __future__ import annotations

import asyncio
from collections.abc import Awaitable, Callable, Mapping
from dataclasses import dataclass, field
from typing import Any, Final

import orjson
import structlog

from epf_gcs.bus.address import Listener
from epf_gcs.bus.channel import Channel
from epf_gcs.bus.definition import (
    Asker,
    BusError,
    Decoder,
    Kind,
    Record,
    converted,
    pack,
    pack_event,
    pack_numbered,
    pack_sample,
    unpack_as,
    unpack_numbered,
)
from epf_gcs.bus.faults import fault_of
from epf_gcs.contract.base import Values
from epf_gcs.contract.events import Event
from epf_gcs.contract.hello import Hello
from epf_gcs.contract.notices import Notice, Pace
from epf_gcs.contract.playback import Playback
from epf_gcs.contract.requests import REQUESTS, Request
from epf_gcs.contract.status import Status
from epf_gcs.errors import GatewayError
from epf_gcs.repeating import Repeating

# A listener with this many unsent bytes gets no samples until it has caught up: only the newest ones are of use.
_MOST_UNSENT_SAMPLES: Final = 1_000_000
# With this many it counts as hung: it is disconnected, and may connect again.
_MOST_UNSENT: Final = 8_000_000
_MOST_REQUESTS: Final = 256
# Gathered samples may leave this share of a period early, with others that arrive just then: one wake-up less.
_EARLY: Final = 0.25

log = structlog.get_logger("flight")


Handler = Callable[[Any, Asker], Awaitable[Any]]
"""Takes a request and who asks; returns the answer. Raises GatewayError."""
Handlers = Mapping[type[Request[Any]], Handler]


NOTICES: Final[Mapping[str, type[Notice]]] = {kind.__name__: kind for kind in Notice.__subclasses__()}


@dataclass(frozen=True, slots=True)
class _Named:
    """The JSON of a NOTICE."""

    name: str
    arguments: dict[str, Any] = field(default_factory=dict)


class Broadcast:
    """Sends samples, events and status to every listener; costs nothing while there is none. Implements `Outlet`.

    Made on a running loop. Samples leave at once if any listener wants that; else they are gathered at the pace of the
    fastest one.
    """

    def __init__(self, now_s: Callable[[], float]) -> None:
        self._now_s = now_s
        self._loop = asyncio.get_running_loop()
        self._rates_hz: dict[Channel, int] = {}
        self._samples: list[bytes] = []
        self._gather_s = 0.0
        self._due_s = 0.0
        self._sending = Repeating(self._loop, "samples for the station", self._send_due)
        self._decode: Callable[[], None] | None = None

    @property
    def has_listeners(self) -> bool:
        """Whether any listener is connected."""
        return bool(self._rates_hz)

    @property
    def gathers(self) -> bool:
        """Whether samples wait: there are listeners, and none wants each sample at once."""
        return self._gather_s > 0.0

    def sample(self, topic: str, t_s: float, values: Any) -> None:
        """The newest values of a topic; sent with the next `flush`, or gathered."""
        if self._rates_hz:
            self._samples.append(pack_sample(topic, t_s, values))

    def flush(self) -> None:
        """Send the samples taken since the last `flush`, or have them sent when their time has come."""
        if self._samples and self._is_due():
            self._plan()
            self.send_gathered()

    def later(self, decode: Callable[[], None]) -> bool:
        """Whether frames may wait for the samples that leave next; without listeners they wait for whoever looks."""
        if self._rates_hz:
            if self._is_due():
                return False
            self._decode = decode
        return True

    def event(self, event: Event, /) -> None:
        """Something happened."""
        if self._rates_hz:
            self.send_gathered()
            self._send(pack_event(event, self._now_s()))

    def status(self, status: Status) -> None:
        """The state of links, HIL, recording, alarms, errors and topics."""
        if self._rates_hz:
            self.send_gathered()
            self._send(pack(Kind.STATUS, orjson.dumps(status)))

    def playback(self, playback: Playback, *, with_samples: bool = False) -> None:
        """Where a replay is, and whether it plays; sent at once, or before the samples of the next `flush`."""
        if self._rates_hz:
            data = pack(Kind.PLAYBACK, orjson.dumps(playback))
            if with_samples:
                self._samples.append(data)
            else:
                self.send_gathered()
                self._send(data)

    def add(self, channel: Channel) -> None:
        """Send everything to this listener from now on, each sample at once until it tells its pace."""
        self.pace(channel, 0)

    def pace(self, channel: Channel, rate_hz: int) -> None:
        """This listener looks at samples so many times a second; 0: each at once."""
        self.send_gathered()
        self._rates_hz[channel] = rate_hz
        self._choose_pace()

    def remove(self, channel: Channel) -> None:
        """This listener has gone."""
        if self._rates_hz.pop(channel, None) is not None:
            self._choose_pace()

    def send_gathered(self) -> None:
        """Send the gathered samples now: what follows them must not overtake them."""
        decode, self._decode = self._decode, None
        if decode is not None:
            decode()
        if self._sending.is_armed:
            self._sending.cancel()
        if self._samples:
            data = b"".join(self._samples)
            self._samples.clear()
            for channel in tuple(self._rates_hz):
                if channel.unsent_bytes < _MOST_UNSENT_SAMPLES:
                    channel.send(data)

    def _choose_pace(self) -> None:
        rates_hz = self._rates_hz.values()
        self._gather_s = 1.0 / max(rates_hz) if rates_hz and min(rates_hz) > 0 else 0.0
        self._due_s = 0.0

    def _is_due(self) -> bool:
        """Whether samples leave now. If not, a timer will send them."""
        if not self._gather_s:
            return True
        if self._loop.time() >= self._due_s - _EARLY * self._gather_s:
            return True
        if not self._sending.is_armed:
            self._sending.arm(self._due_s - self._loop.time())
        return False

    def _plan(self) -> None:
        # Due times lie on a fixed grid, so that the mean rate is exact; after a pause the grid starts anew.
        now_s = self._loop.time()
        self._due_s = max(self._due_s + self._gather_s, now_s + 0.5 * self._gather_s)

    def _send_due(self) -> None:
        self._plan()
        self.send_gathered()

    def _send(self, data: bytes) -> None:
        for channel in tuple(self._rates_hz):
            if channel.unsent_bytes > _MOST_UNSENT:
                channel.lose()
            else:
                channel.send(data)


class VehicleEnd:
    """Accepts listeners. `hello` and `samples` give what is sent to a new one first; `requests` holds the handlers.

    `on_notice` gets what needs no answer; `on_gone` is called when a listener has gone. Handlers raise GatewayError.
    """

    def __init__(
        self,
        broadcast: Broadcast,
        *,
        hello: Callable[[], Hello],
        samples: Callable[[], list[tuple[str, float, Values]]],
        requests: Handlers,
        on_notice: Callable[[Notice], None],
        on_gone: Callable[[], None],
    ) -> None:
        self._broadcast = broadcast
        self._hello = hello
        self._samples = samples
        self._requests = requests
        self._on_notice = on_notice
        self._on_gone = on_gone
        self._open: set[Channel] = set()

    async def run(self, listener: Listener) -> None:
        """Accept listeners until cancelled; then disconnect them all."""
        try:
            async with asyncio.TaskGroup() as tasks:
                while True:
                    connection = await listener.accept()
                    if connection is not None:
                        _Conversation(self, connection, tasks)
        finally:
            for channel in tuple(self._open):
                self._close(channel)

    def begin(self, channel: Channel) -> None:
        """A listener has connected: send it HELLO and the newest samples."""
        self._open.add(channel)
        data = pack(Kind.HELLO, orjson.dumps(self._hello()))
        channel.send(data + b"".join(pack_sample(*sample) for sample in self._samples()))
        self._broadcast.add(channel)

    def end(self, channel: Channel) -> None:
        """A listener has gone."""
        self._open.discard(channel)
        self._broadcast.remove(channel)
        self._on_gone()

    def notice(self, channel: Channel, body: bytes) -> None:
        """Take the body of a listener's NOTICE: its pace, or pass it on. Raises BusError."""
        said = unpack_as(_Named, body)
        kind = NOTICES.get(said.name)
        if kind is None:
            log.warning("an unknown notice was dropped", notice=said.name)
            return
        try:
            notice = converted(kind, said.arguments)
            if isinstance(notice, Pace):
                self._broadcast.pace(channel, max(0, notice.rate_hz))
            else:
                self._on_notice(notice)
        except Exception:  # a request behind it is still waited for
            log.exception("a notice could not be taken", notice=said.name)

    async def answer(self, asked: dict[str, Any]) -> dict[str, Any]:
        """Handle a request; returns its result or its fault, as ANSWER holds it."""
        name = str(asked.get("name"))
        kind = REQUESTS.get(name)
        handler = None if kind is None else self._requests.get(kind)
        try:
            if handler is None:
                raise GatewayError("internal", f"This vehicle does not know the request '{name}': update the station.")
            by = converted(Asker | None, asked.get("by")) or Asker()
            return {"result": await handler(converted(kind, asked.get("arguments") or {}), by)}
        except GatewayError as error:
            return {"fault": fault_of(error)}
        except Exception as error:
            log.exception("a request failed", request=name)
            failed = GatewayError("internal", f"'{name}' failed in the flight process ({type(error).__name__}).")
            return {"fault": fault_of(failed)}

    def send_answer(self, channel: Channel, number: int, answer: dict[str, Any]) -> None:
        """Send an answer, after all samples before it."""
        self._broadcast.send_gathered()
        channel.send(pack_numbered(Kind.ANSWER, number, answer))

    def _close(self, channel: Channel) -> None:
        self._open.discard(channel)
        self._broadcast.remove(channel)
        channel.send(pack(Kind.BYE, b""))
        channel.close()


class _Conversation:
    """The connection of one listener."""

    def __init__(self, end: VehicleEnd, connection: Any, tasks: asyncio.TaskGroup) -> None:
        self._end = end
        self._tasks = tasks
        self._decoder = Decoder()
        self._under_way = 0
        self._channel = Channel(connection, self._on_data, self._on_closed)
        end.begin(self._channel)

    def _on_data(self, data: bytes) -> None:
        try:
            for record in self._decoder.feed(data):
                self._take(record)
        except BusError as error:
            log.warning("a listener does not speak the stream and was let go", reason=str(error))
            self._channel.lose()

    def _take(self, record: Record) -> None:
        if record.kind == Kind.NOTICE:
            self._end.notice(self._channel, record.body)
        elif record.kind == Kind.REQUEST:
            number, asked = unpack_numbered(record.body)
            if self._under_way >= _MOST_REQUESTS:
                busy = GatewayError("internal", "Too much is asked of the flight process at once: try again.")
                self._end.send_answer(self._channel, number, {"fault": fault_of(busy)})
                return
            self._under_way += 1
            self._tasks.create_task(self._answer(number, asked))

    async def _answer(self, number: int, asked: dict[str, Any]) -> None:
        try:
            self._end.send_answer(self._channel, number, await self._end.answer(asked))
        finally:
            self._under_way -= 1

    def _on_closed(self) -> None:
        self._end.end(self._channel)
