"""The vehicle's end of the stream: sends to all listeners, answers requests, never waits for a slow listener."""

from __future__ import annotations

import asyncio
from collections.abc import Awaitable, Callable, Mapping
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
    pack,
    pack_event,
    pack_numbered,
    pack_sample,
    unpack_numbered,
    unpack_object,
)
from epf_gcs.bus.faults import fault_of
from epf_gcs.errors import GatewayError

# A listener with this many unsent bytes gets no samples until it has caught up: only the newest ones are of use.
_MOST_UNSENT_SAMPLES: Final = 1_000_000
# With this many it counts as hung: it is disconnected, and may connect again.
_MOST_UNSENT: Final = 8_000_000
_MOST_REQUESTS: Final = 256

log = structlog.get_logger("flight")


Handler = Callable[[Asker, dict[str, Any]], Awaitable[Any]]


class Broadcast:
    """Sends samples, events and status to every listener; costs nothing while there is none. Implements `Outlet`."""

    def __init__(self, now_s: Callable[[], float]) -> None:
        self._now_s = now_s
        self._channels: set[Channel] = set()
        self._samples: list[bytes] = []

    @property
    def has_listeners(self) -> bool:
        """Whether any listener is connected."""
        return bool(self._channels)

    def sample(self, topic: str, t_s: float, values: Any) -> None:
        """The newest values of a topic; sent with the next `flush`."""
        if self._channels:
            self._samples.append(pack_sample(topic, t_s, values))

    def flush(self) -> None:
        """Send the samples taken since the last `flush`."""
        if self._samples:
            data = b"".join(self._samples)
            self._samples.clear()
            for channel in tuple(self._channels):
                if channel.unsent_bytes < _MOST_UNSENT_SAMPLES:
                    channel.send(data)

    def event(self, kind: str, data: Mapping[str, Any]) -> None:
        """Something happened."""
        if self._channels:
            self.flush()
            self._send(pack_event(kind, self._now_s(), data))

    def status(self, status: Mapping[str, Any]) -> None:
        """The state of links, HIL, recording, alarms, errors and topics."""
        if self._channels:
            self._send(pack(Kind.STATUS, orjson.dumps(status)))

    def playback(self, playback: Mapping[str, Any], *, with_samples: bool = False) -> None:
        """Where a replay is, and whether it plays; sent at once, or before the samples of the next `flush`."""
        if not self._channels:
            return
        data = pack(Kind.PLAYBACK, orjson.dumps(playback))
        if with_samples:
            self._samples.insert(0, data)
        else:
            self._send(data)

    def add(self, channel: Channel) -> None:
        """Send everything to this listener from now on."""
        self._channels.add(channel)

    def remove(self, channel: Channel) -> None:
        """This listener has gone."""
        self._channels.discard(channel)

    def _send(self, data: bytes) -> None:
        for channel in tuple(self._channels):
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
        hello: Callable[[], Mapping[str, Any]],
        samples: Callable[[], list[tuple[str, float, Mapping[str, Any]]]],
        requests: Mapping[str, Handler],
        on_notice: Callable[[str, dict[str, Any]], None],
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

    def notice(self, body: bytes) -> None:
        """Pass on the body of a NOTICE. Raises BusError."""
        said = unpack_object(body)
        self._on_notice(str(said.get("name")), dict(said.get("arguments") or {}))

    async def answer(self, asked: dict[str, Any]) -> dict[str, Any]:
        """Handle a request; returns its result or its fault, as ANSWER holds it."""
        name = str(asked.get("name"))
        handler = self._requests.get(name)
        try:
            if handler is None:
                raise GatewayError("internal", f"This vehicle does not know the request '{name}': update the station.")
            return {"result": await handler(Asker(**(asked.get("by") or {})), dict(asked.get("arguments") or {}))}
        except GatewayError as error:
            return {"fault": fault_of(error)}
        except Exception as error:
            log.exception("a request failed", request=name)
            failed = GatewayError("internal", f"'{name}' failed in the flight process ({type(error).__name__}).")
            return {"fault": fault_of(failed)}

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
            self._end.notice(record.body)
        elif record.kind == Kind.REQUEST:
            number, asked = unpack_numbered(record.body)
            if self._under_way >= _MOST_REQUESTS:
                busy = GatewayError("internal", "Too much is asked of the flight process at once: try again.")
                self._channel.send(pack_numbered(Kind.ANSWER, number, {"fault": fault_of(busy)}))
                return
            self._under_way += 1
            self._tasks.create_task(self._answer(number, asked))

    async def _answer(self, number: int, asked: dict[str, Any]) -> None:
        try:
            answer = await self._end.answer(asked)
            self._channel.send(pack_numbered(Kind.ANSWER, number, answer))
        finally:
            self._under_way -= 1

    def _on_closed(self) -> None:
        self._end.end(self._channel)
