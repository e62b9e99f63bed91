"""The live stream of a station as a program hears it: every batch is acknowledged as soon as it was taken."""

from __future__ import annotations

import asyncio
from collections import deque
from collections.abc import AsyncIterator, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any, Final, Generic, TypeVar

import msgspec
import orjson
from websockets.asyncio.client import ClientConnection
from websockets.exceptions import ConnectionClosed

from epf_gcs.client.errors import StationLostError
from epf_gcs.client.samples_gen import Topic
from epf_gcs.contract.base import RoleName, Values
from epf_gcs.contract.events import EVENTS, Event
from epf_gcs.contract.status import Status

TopicT = TypeVar("TopicT", bound=Topic)
EventT = TypeVar("EventT", bound=Event)
HeardT = TypeVar("HeardT")
# Ten seconds of the fastest topic: a program that is further behind is told how many it missed.
_MOST_WAITING: Final = 512


@dataclass(frozen=True, slots=True)
class Sample(Generic[TopicT]):
    """A topic's values and when they were heard, in Unix seconds. `missed`: samples before it that were left out,
    because the program took longer over the ones before than they take to come."""

    t_s: float
    values: TopicT
    missed: int = 0


class Waiting(Generic[HeardT]):
    """What one loop of the program has not taken yet; bounded, because the line does not wait for a program."""

    def __init__(self) -> None:
        self._heard: deque[HeardT] = deque(maxlen=_MOST_WAITING)
        self._came = asyncio.Event()
        self._end: StationLostError | None = None
        self.missed = 0

    def put(self, one: HeardT) -> None:
        """Something was heard."""
        self.missed += len(self._heard) == _MOST_WAITING
        self._heard.append(one)
        self._came.set()

    def end(self, reason: StationLostError) -> None:
        """Nothing follows."""
        self._end = reason
        self._came.set()

    async def take(self) -> HeardT:
        """The oldest that waits. Raises StationLostError when all were taken and the stream has ended."""
        while not self._heard:
            if self._end is not None:
                raise self._end
            self._came.clear()
            await self._came.wait()
        return self._heard.popleft()


class Stream:
    """Reads in a task of its own. `status` and `role` are what the station said last."""

    def __init__(self, connection: ClientConnection, hello: Any) -> None:
        self.client: str = hello["client"]
        self.version: str = hello["version"]
        self.role: RoleName = hello["role"]
        self._status = msgspec.convert(hello["status"], Status)
        self._connection = connection
        self._everybody: list[Waiting[Any]] = []
        self._samples: dict[str, list[Waiting[tuple[float, Values]]]] = {}
        self._events: list[tuple[tuple[type[Event], ...], Waiting[Event]]] = []
        self._statuses: list[Waiting[Status]] = []
        self._lost: StationLostError | None = None
        self._reading = asyncio.create_task(self._read())

    @property
    def is_open(self) -> bool:
        """Whether more can come."""
        return self._lost is None

    @property
    def status(self) -> Status:
        """What the station said last. Raises StationLostError after its end: it would not be live."""
        if self._lost is not None:
            raise self._lost
        return self._status

    async def samples(self, topic: type[TopicT]) -> AsyncIterator[Sample[TopicT]]:
        """Every batch's sample of a topic, until the program leaves the loop."""
        waiting: Waiting[tuple[float, Values]] = Waiting()
        listeners = self._samples.setdefault(topic.NAME, [])
        with self._listening(listeners, waiting, waiting):
            while True:
                t_s, values = await waiting.take()
                missed, waiting.missed = waiting.missed, 0
                yield Sample(t_s, msgspec.convert(values, topic), missed)

    async def events(self, *kinds: type[EventT]) -> AsyncIterator[EventT]:
        """What happens from now on, of these kinds."""
        waiting: Waiting[Event] = Waiting()
        with self._listening(self._events, (kinds, waiting), waiting):
            while True:
                yield await waiting.take()  # type: ignore[misc]

    async def statuses(self) -> AsyncIterator[Status]:
        """The status now, and again whenever the station tells it."""
        waiting: Waiting[Status] = Waiting()
        with self._listening(self._statuses, waiting, waiting):
            waiting.put(self._status)
            while True:
                yield await waiting.take()

    async def close(self) -> None:
        """End it."""
        await self._connection.close()
        await self._reading

    @contextmanager
    def _listening(self, listeners: list[Any], entry: object, waiting: Waiting[Any]) -> Iterator[None]:
        """One more who waits, as long as it does."""
        if self._lost is not None:
            waiting.end(self._lost)
        listeners.append(entry)
        self._everybody.append(waiting)
        try:
            yield
        finally:
            listeners.remove(entry)
            self._everybody.remove(waiting)

    async def _read(self) -> None:
        reason = "The program has closed it."
        try:
            async for text in self._connection:
                await self._take(orjson.loads(text))
        except ConnectionClosed as error:
            reason = str(error)
        finally:
            self._lost = StationLostError(f"The stream of the station has ended. {reason}")
            for waiting in self._everybody:
                waiting.end(self._lost)

    async def _take(self, message: Values) -> None:
        match message["type"]:
            case "batch":
                for sample in message["samples"]:
                    for waiting in self._samples.get(sample["topic"], ()):
                        waiting.put((sample["t_s"], sample["values"]))
                await self._connection.send(orjson.dumps({"type": "ack", "seq": message["seq"]}).decode())
            case "status":
                self._status = msgspec.convert(message["data"], Status)
                for one in self._statuses:
                    one.put(self._status)
            case "event":
                self._take_event(message["event"], message["data"])

    def _take_event(self, name: str, data: Values) -> None:
        """An event; those of subjects, which the contract does not have, are left out."""
        kind = EVENTS.get(name)
        if kind is None:
            return
        event = msgspec.convert(data, kind)
        if name == "access":
            self.role = data["role"]
        for kinds, waiting in self._events:
            if isinstance(event, kinds):
                waiting.put(event)
