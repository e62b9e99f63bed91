"""A replay that takes long to open, because its recording is long or the computer is busy."""

from __future__ import annotations

import asyncio
from typing import cast

import orjson
import pytest

from epf_gcs.access.caller import LOCAL
from epf_gcs.web.replays import replay_conversation
from epf_gcs.web.replays.replay_conversation import ReplayConversation
from epf_gcs.web.replays.replay_process import ReplayProcess, ViewersReplay
from epf_gcs.web.stream.socket import SocketConnection


class EndlessOpening:
    """A replay's process that never comes to its hello."""

    def join(self) -> None:
        pass

    async def leave(self) -> None:
        pass

    def open(self, folder: str, at_s: float) -> None:
        pass

    async def last_words(self) -> str:
        return await asyncio.Future[str]()


class FaultyConnection:
    """A browser's connection, whose first message meets a fault; `queue` has what was sent after it."""

    def __init__(self) -> None:
        self.queue: asyncio.Queue[bytes] = asyncio.Queue()
        self._faults = [ZeroDivisionError]

    def send(self, messages: list[bytes]) -> None:
        if self._faults:
            raise self._faults.pop()
        for message in messages:
            self.queue.put_nowait(message)


def test_its_viewer_hears_again_and_again_that_it_is_being_opened_also_after_a_fault(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(replay_conversation, "OPENING_EVERY_S", 0.001)

    async def look() -> None:
        raised: list[object] = []
        asyncio.get_running_loop().set_exception_handler(lambda _, context: raised.append(context["exception"]))
        connection = FaultyConnection()
        started: list[asyncio.Task[None]] = []
        replay = ViewersReplay("20260101T120000Z", lambda: cast(ReplayProcess, EndlessOpening()), 0.0)
        conversation = ReplayConversation(
            cast(SocketConnection, connection),
            LOCAL,
            replay,
            rate_hz=60,
            on_start=started.append,
            on_end=lambda: None,
        )
        conversation.greet()
        for _ in range(3):
            assert orjson.loads(await connection.queue.get()) == {"type": "opening"}
        conversation.on_closed()
        await asyncio.wait(started)
        assert started[0].cancelled()
        assert [type(error) for error in raised] == [ZeroDivisionError]

    asyncio.run(look())
