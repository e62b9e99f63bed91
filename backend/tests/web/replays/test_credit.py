"""A viewer of every sample: the replay sends so many ahead, and goes on when it hears that they were sent."""

from __future__ import annotations

import asyncio
from typing import Any, cast

import orjson

from epf_gcs.access.caller import LOCAL
from epf_gcs.bus.definition import NamedText
from epf_gcs.contract.hello import FlightSpan, Hello
from epf_gcs.contract.notices import Notice
from epf_gcs.contract.playback import Playback, SampleCredit
from epf_gcs.contract.status import Status
from epf_gcs.web.replays.replay_conversation import ReplayConversation
from epf_gcs.web.replays.replay_process import ViewersReplay
from epf_gcs.web.stream.socket import SocketConnection

FLIGHT = "20260101T120000Z"


class Replay:
    """A replay that is there; `credit` is how many samples it was told were sent."""

    flight = FLIGHT

    def __init__(self) -> None:
        self.credit = 0

    async def run(self, listener: object) -> str:
        return await asyncio.Future[str]()

    def notice(self, notice: Notice) -> None:
        if isinstance(notice, SampleCredit):
            self.credit += notice.count


class Browser:
    """A browser's connection, which takes whatever is sent."""

    def __init__(self) -> None:
        self.messages: list[dict[str, Any]] = []

    def send(self, messages: list[bytes]) -> None:
        self.messages += [orjson.loads(message) for message in messages]

    def unsent_bytes(self) -> int:
        return 0


def test_samples_that_come_together_with_a_status_are_told_as_sent() -> None:
    """A busy computer reads what the replay sent at several moments at once."""

    async def look() -> None:
        replay, browser = Replay(), Browser()
        conversation = ReplayConversation(
            cast(SocketConnection, browser),
            LOCAL,
            cast(ViewersReplay, replay),
            rate_hz=0,
            on_start=lambda _: None,
            on_end=lambda: None,
        )
        conversation.greet()
        playback = Playback(FLIGHT, 0.0, 0.0, "playing", 1.0, None, 9.0, 9.0, jumps=0)
        span = FlightSpan(FLIGHT, starts_s=0.0, duration_s=9.0)
        conversation.on_hello(Hello("1", "replay", Status(), playback=playback, flight=span))
        await asyncio.sleep(0)
        conversation.on_status(Status())
        for number in range(3):
            conversation.on_sample(NamedText(float(number), "gps", b"{}"))
        conversation.on_samples_end()
        # Each turn of the loop sends what is queued; a browser acknowledges each batch.
        for _ in range(10):
            for message in browser.messages:
                if message["type"] == "batch":
                    conversation.on_text(orjson.dumps({"type": "ack", "seq": message["seq"]}).decode())
            browser.messages.clear()
            await asyncio.sleep(0)
        assert replay.credit == 3
        conversation.on_closed()

    asyncio.run(look())
