"""When gathered samples leave. Time is what the test says it is."""

from __future__ import annotations

import asyncio
from collections.abc import Callable

import pytest

from epf_gcs.bus.definition import Decoder, Kind
from epf_gcs.bus.vehicle_end import Broadcast
from epf_gcs.contract.events import FlightProcessEvent
from epf_gcs.contract.status import Status
from tests.support.contract import a_playback
from tests.support.held_loop import HeldLoop


class _Listener:
    """Gives what it is sent to `send`, and falls behind as the test says."""

    def __init__(self, send: Callable[[bytes], object]) -> None:
        self.send = send
        self.unsent_bytes = 0
        self.is_lost = False

    def lose(self) -> None:
        self.is_lost = True


def test_gathered_samples_leave_a_period_of_the_fastest_after_those_before(monkeypatch: pytest.MonkeyPatch) -> None:
    loop = HeldLoop(100.0)
    monkeypatch.setattr(asyncio, "get_running_loop", lambda: loop)
    broadcast = Broadcast(lambda: 5.0)
    sent: list[bytes] = []
    broadcast.pace(_Listener(lambda _: None), 1)  # type: ignore[arg-type]
    broadcast.pace(_Listener(sent.append), 20)  # type: ignore[arg-type]
    for late_s in (0.0, 0.005, 0.01):
        loop.now_s = 100.0 + late_s
        broadcast.sample("gps", loop.now_s, {})
        broadcast.flush()
    assert len(sent) == 1, "the first leaves at once"
    assert [one.due_s for one in loop.timers] == [pytest.approx(100.025)], (
        "on the way to its beat, half a period after it"
    )
    loop.now_s = 100.025
    broadcast.sample("gps", loop.now_s, {})
    broadcast.flush()
    assert len(sent) == 2
    broadcast.sample("gps", loop.now_s, {})
    broadcast.flush()
    assert loop.timers[-1].due_s == pytest.approx(100.075), "from then on a twentieth of a second"


@pytest.fixture
def loop(monkeypatch: pytest.MonkeyPatch) -> HeldLoop:
    made = HeldLoop(100.0)
    monkeypatch.setattr(asyncio, "get_running_loop", lambda: made)
    return made


def kinds(sent: list[bytes]) -> list[int]:
    return [record.kind for record in Decoder().feed(b"".join(sent))]


@pytest.mark.usefixtures("loop")
def test_a_listener_that_falls_behind_gets_no_samples_then_nothing_and_costs_the_others_none() -> None:
    broadcast = Broadcast(lambda: 5.0)
    slow_sent: list[bytes] = []
    quick_sent: list[bytes] = []
    slow, quick = _Listener(slow_sent.append), _Listener(quick_sent.append)
    for listener in (slow, quick):
        broadcast.add(listener)  # type: ignore[arg-type]
    for unsent in (900_000, 1_100_000, 7_900_000, 8_100_000):
        assert not slow.is_lost
        slow.unsent_bytes = unsent
        broadcast.sample("gps", 1.0, {})
        broadcast.flush()
        broadcast.event(FlightProcessEvent("back"))
    assert kinds(slow_sent) == [Kind.SAMPLE, Kind.EVENT, Kind.EVENT, Kind.EVENT]
    assert slow.is_lost
    assert kinds(quick_sent) == [Kind.SAMPLE, Kind.EVENT] * 4
    assert not quick.is_lost


def test_whatever_is_told_sends_the_samples_that_were_gathered_before_it(loop: HeldLoop) -> None:
    broadcast = Broadcast(lambda: 5.0)
    sent: list[bytes] = []
    broadcast.pace(_Listener(sent.append), 1)  # type: ignore[arg-type]
    broadcast.sample("gps", 1.0, {})
    broadcast.flush()
    tells: tuple[Callable[[], None], ...] = (
        lambda: broadcast.event(FlightProcessEvent("back")),
        lambda: broadcast.status(Status()),
        lambda: broadcast.playback(a_playback()),
    )
    for tell in tells:
        sent.clear()
        broadcast.sample("gps", 2.0, {})
        broadcast.flush()
        assert sent == [], "their time has not come"
        tell()
        assert kinds(sent)[0] == Kind.SAMPLE
        assert len(kinds(sent)) == 2
    assert len(loop.timers) == 3, "each time they would have left by themselves"


@pytest.mark.usefixtures("loop")
def test_a_playback_with_samples_goes_out_in_its_place_among_them() -> None:
    broadcast = Broadcast(lambda: 5.0)
    sent: list[bytes] = []
    broadcast.add(_Listener(sent.append))  # type: ignore[arg-type]
    broadcast.sample("gps", 1.0, {})
    broadcast.playback(a_playback(jumps=1), with_samples=True)
    broadcast.sample("gps", 2.0, {})
    assert sent == []
    broadcast.flush()
    assert kinds(sent) == [Kind.SAMPLE, Kind.PLAYBACK, Kind.SAMPLE]


@pytest.mark.usefixtures("loop")
def test_without_listeners_nothing_is_kept_for_one_who_comes_later() -> None:
    broadcast = Broadcast(lambda: 5.0)
    broadcast.sample("gps", 1.0, {})
    broadcast.playback(a_playback(), with_samples=True)
    sent: list[bytes] = []
    listener = _Listener(sent.append)
    broadcast.add(listener)  # type: ignore[arg-type]
    broadcast.flush()
    assert sent == []
    broadcast.remove(listener)  # type: ignore[arg-type]
    assert not broadcast.has_listeners
    broadcast.event(FlightProcessEvent("back"))
    assert sent == []


def test_gathered_samples_leave_with_others_that_come_just_before_their_time(loop: HeldLoop) -> None:
    broadcast = Broadcast(lambda: 5.0)
    sent: list[bytes] = []
    broadcast.pace(_Listener(sent.append), 1)  # type: ignore[arg-type]
    for now_s, has_left in ((100.0, 1), (100.2, 1), (100.3, 2)):
        loop.now_s = now_s
        broadcast.sample("gps", now_s, {})
        broadcast.flush()
        assert len(sent) == has_left, "the beat is at 100.5"
    assert kinds(sent) == [Kind.SAMPLE] * 3


def test_another_pace_begins_with_the_next_sample(loop: HeldLoop) -> None:
    broadcast = Broadcast(lambda: 5.0)
    sent: list[bytes] = []
    listener = _Listener(sent.append)
    broadcast.pace(listener, 1)  # type: ignore[arg-type]
    for _ in range(2):
        broadcast.sample("gps", 1.0, {})
        broadcast.flush()
    assert (len(sent), len(loop.timers)) == (1, 1)
    broadcast.pace(listener, 2)  # type: ignore[arg-type]
    assert len(sent) == 2, "what was gathered"
    broadcast.sample("gps", 2.0, {})
    broadcast.flush()
    assert len(sent) == 3
