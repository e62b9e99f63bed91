"""State and events to viewers that keep up, that lag, and that stopped."""

from __future__ import annotations

import asyncio
from typing import Any

import orjson
import pytest

from epf_gcs.contract.events import ConsoleEvent, FlightProcessEvent, LinkEvent
from epf_gcs.web.stream.hub import Hub
from epf_gcs.web.stream.viewer import MAX_UNDER_WAY, Viewer
from tests.support.held_loop import HeldLoop
from tests.support.waiting import eventually_async

pytestmark = pytest.mark.anyio


class Screen:
    """Takes messages as a browser would; acknowledges when told to."""

    def __init__(self, hub: Hub, rate_hz: int) -> None:
        self.messages: list[dict[str, Any]] = []
        self.stopped = False
        self.unsent = 0
        self.hub = hub
        self.viewer = Viewer("id", "name", self, hub.state, rate_hz)

    def send(self, messages: list[bytes]) -> None:
        self.messages += [orjson.loads(message) for message in messages]
        if not self.stopped and self.messages[-1]["type"] == "batch":
            self.viewer.acknowledge(self.messages[-1]["seq"])

    def unsent_bytes(self) -> int:
        return self.unsent

    @property
    def batches(self) -> list[dict[str, Any]]:
        return [message for message in self.messages if message["type"] == "batch"]

    @property
    def events(self) -> list[dict[str, Any]]:
        return [message for message in self.messages if message["type"] == "event"]

    def values(self, topic: str) -> list[Any]:
        return [
            sample["values"]["n"] for batch in self.batches for sample in batch["samples"] if sample["topic"] == topic
        ]


@pytest.fixture
async def hub() -> Hub:
    return Hub(asyncio.get_running_loop(), lambda: 1000.0)


def a_screen(hub: Hub, rate_hz: int = 60) -> Screen:
    screen = Screen(hub, rate_hz)
    hub.add(screen.viewer)
    return screen


def put(hub: Hub, topic: str, t_s: float, values: dict[str, Any]) -> None:
    hub.state.put(topic, t_s, orjson.dumps({"topic": topic, "t_s": t_s, "values": values}))


async def test_a_viewer_begins_with_the_newest_of_every_topic(hub: Hub) -> None:
    put(hub, "ahrs", 1.0, {"n": 1})
    put(hub, "ahrs", 2.0, {"n": 2})
    put(hub, "gps", 2.5, {"n": 7})
    screen = a_screen(hub)
    await eventually_async(lambda: bool(screen.batches), "the first batch")
    assert screen.batches[0]["samples"] == [
        {"topic": "ahrs", "t_s": 2.0, "values": {"n": 2}},
        {"topic": "gps", "t_s": 2.5, "values": {"n": 7}},
    ]
    assert (screen.batches[0]["seq"], screen.batches[0]["missed"], screen.batches[0]["t_s"]) == (1, 0, 2.5)


async def test_only_what_changed_is_sent_again(hub: Hub) -> None:
    screen = a_screen(hub)
    put(hub, "ahrs", 1.0, {"n": 1})
    put(hub, "gps", 1.0, {"n": 7})
    hub.flush()
    await eventually_async(lambda: screen.values("gps") == [7], "both arrive")
    put(hub, "ahrs", 2.0, {"n": 2})
    hub.flush()
    await eventually_async(lambda: screen.values("ahrs") == [1, 2], "the change arrives")
    assert screen.values("gps") == [7]


async def test_a_rate_is_kept_and_the_newest_is_never_left_behind(hub: Hub) -> None:
    screen = a_screen(hub, 20)
    for number in range(200):
        put(hub, "ahrs", float(number), {"n": number})
        hub.flush()
        await asyncio.sleep(0.001)
    await eventually_async(lambda: screen.values("ahrs")[-1:] == [199], "the newest arrives")
    assert len(screen.batches) < 100
    assert screen.values("ahrs") == sorted(set(screen.values("ahrs")))


async def test_rate_zero_brings_every_sample(hub: Hub) -> None:
    screen = a_screen(hub, 0)
    for number in range(50):
        put(hub, "ahrs", float(number), {"n": number})
        hub.flush()
    await eventually_async(lambda: len(screen.values("ahrs")) == 50, "all arrive")
    assert screen.values("ahrs") == list(range(50))


async def test_a_stopped_viewer_gets_the_newest_at_once_and_a_count_of_what_it_missed(hub: Hub) -> None:
    screen = a_screen(hub, 0)
    screen.stopped = True
    for number in range(1000):
        put(hub, "ahrs", float(number), {"n": number})
        hub.flush()
    assert len(screen.batches) == MAX_UNDER_WAY
    screen.stopped = False
    assert screen.viewer.acknowledge(MAX_UNDER_WAY)
    hub.serve(screen.viewer)
    await eventually_async(lambda: screen.values("ahrs")[-1] == 999, "the newest arrives")
    got, missed = len(screen.values("ahrs")), screen.batches[-1]["missed"]
    assert got + missed == 1000
    assert got < 300


async def test_a_stopped_viewer_harms_nobody(hub: Hub) -> None:
    stopped = a_screen(hub)
    stopped.stopped = True
    others = [a_screen(hub) for _ in range(10)]
    for number in range(30):
        put(hub, "ahrs", float(number), {"n": number})
        hub.flush()
        await asyncio.sleep(0.02)
    await eventually_async(lambda: all(other.values("ahrs")[-1] == 29 for other in others), "all others see the newest")
    assert len(stopped.batches) == MAX_UNDER_WAY
    assert all(not batch["missed"] for other in others for batch in other.batches)


async def test_a_viewer_whose_network_is_stuck_is_not_sent_more(hub: Hub) -> None:
    screen = a_screen(hub, 0)
    screen.stopped, screen.unsent = True, 10_000_000
    put(hub, "ahrs", 1.0, {"n": 1})
    hub.flush()
    put(hub, "ahrs", 2.0, {"n": 2})
    hub.flush()
    assert screen.values("ahrs") == [1]


async def test_events_are_kept_in_order_and_too_many_are_counted(hub: Hub) -> None:
    screen = a_screen(hub)
    screen.stopped = True
    for number in range(MAX_UNDER_WAY):
        put(hub, "ahrs", float(number), {"n": number})
        screen.viewer.flush()
    for number in range(300):
        hub.event(ConsoleEvent("received", str(number)))
    screen.stopped = False
    screen.viewer.acknowledge(MAX_UNDER_WAY)
    hub.serve(screen.viewer)
    await eventually_async(lambda: screen.messages[-1]["type"] == "batch" and len(screen.messages) > 10, "they arrive")
    numbers = [int(message["data"]["text"]) for message in screen.messages if message["type"] == "event"]
    assert numbers == list(range(44, 300))
    assert screen.batches[-1]["missed_events"] == 44


async def test_an_event_and_a_status_are_followed_by_a_batch_that_counts_for_them(hub: Hub) -> None:
    screen = a_screen(hub)
    hub.event(LinkEvent("open", "closed"))
    hub.status(b'{"type":"status","data":{}}')
    await eventually_async(lambda: len(screen.messages) >= 3, "they arrive")
    assert [message["type"] for message in screen.messages] == ["event", "status", "batch"]
    assert screen.batches[0]["samples"] == []


async def test_an_old_status_is_not_sent_after_a_newer_one(hub: Hub) -> None:
    screen = a_screen(hub)
    hub.status(b'{"type":"status","data":{"n":1}}')
    hub.status(b'{"type":"status","data":{"n":2}}')
    await eventually_async(lambda: bool(screen.batches), "it arrives")
    assert [message["data"]["n"] for message in screen.messages if message["type"] == "status"] == [2]


async def test_the_rate_can_be_changed_and_a_viewer_can_go(hub: Hub) -> None:
    screen = a_screen(hub, 60)
    hub.change_rate(screen.viewer, 0)
    for number in range(5):
        put(hub, "ahrs", float(number), {"n": number})
        hub.flush()
    await eventually_async(lambda: screen.values("ahrs")[-1:] == [4], "they arrive")
    assert screen.values("ahrs")[-4:] == [1, 2, 3, 4]
    hub.remove(screen.viewer)
    hub.remove(screen.viewer)
    assert hub.viewers == []
    put(hub, "ahrs", 9.0, {"n": 9})
    hub.flush()
    assert screen.values("ahrs")[-1] == 4


async def test_samples_are_wanted_at_the_rate_of_the_fastest_viewer() -> None:
    rates_hz: list[int] = []
    hub = Hub(asyncio.get_running_loop(), lambda: 1000.0, on_rate=rates_hz.append)
    unseen_hz = hub.rate_hz
    assert unseen_hz > 0
    slow = a_screen(hub, 1)
    assert hub.rate_hz == unseen_hz, "the track needs more than a slow viewer"
    fast = a_screen(hub, 60)
    every = a_screen(hub, 0)
    hub.remove(every.viewer)
    hub.remove(fast.viewer)
    hub.remove(slow.viewer)
    assert rates_hz == [60, 0, 60, unseen_hz]


async def test_an_acknowledgement_of_nothing_is_refused(hub: Hub) -> None:
    screen = a_screen(hub)
    assert not screen.viewer.acknowledge(1)
    assert not screen.viewer.acknowledge(-1)


async def test_a_value_that_is_no_data_is_null(hub: Hub) -> None:
    screen = a_screen(hub, 0)
    put(hub, "ahrs", 1.0, {"n": None})
    hub.flush()
    assert screen.values("ahrs") == [None]


def test_a_viewer_s_beat_moves_to_that_of_the_samples_and_is_not_faster() -> None:
    loop = HeldLoop()
    hub = Hub(loop, loop.time)  # type: ignore[arg-type]
    screen = a_screen(hub)
    sent_s: list[float] = []
    period_s = 1.0 / 60.0
    send = screen.send

    def sent(messages: list[bytes]) -> None:
        sent_s.append(loop.now_s)
        send(messages)

    screen.send = sent  # type: ignore[method-assign]
    came_s: list[float] = []
    for number in range(600):
        # All but the first come well before the batch that is due next: each of them would wait for it.
        loop.run_until((number - 0.3) * period_s if number else 0.0)
        came_s.append(loop.now_s)
        put(hub, "ahrs", loop.now_s, {"n": number})
        hub.flush()
    loop.run_until(11.0)
    assert screen.values("ahrs")[-1] == 599
    assert len(sent_s) <= 601
    assert sent_s[-500:] == came_s[-500:], "each leaves as it comes"


async def test_a_viewer_that_fails_costs_the_others_nothing(hub: Hub) -> None:
    failures: list[str] = []
    asyncio.get_running_loop().set_exception_handler(lambda _, context: failures.append(context["message"]))
    bad, good = a_screen(hub), a_screen(hub)

    def fail(_: list[bytes]) -> None:
        raise ZeroDivisionError

    bad.send = fail  # type: ignore[assignment, method-assign]
    hub.event(FlightProcessEvent("lost"))
    await eventually_async(lambda: bool(good.events), "the other one hears it")
    assert failures == ["a viewer of the stream"]
    hub.event(FlightProcessEvent("back"))
    await eventually_async(lambda: len(good.events) == 2, "and all that follows")
    assert len(failures) == 1
