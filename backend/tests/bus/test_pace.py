"""When gathered samples leave. Time is what the test says it is."""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from types import SimpleNamespace

import pytest

from epf_gcs.bus.vehicle_end import Broadcast


class _Listener:
    """Gives what it is sent to `send`, and never falls behind."""

    unsent_bytes = 0

    def __init__(self, send: Callable[[bytes], object]) -> None:
        self.send = send


class _Loop:
    """Gives the time that the test says, and keeps what is to be done later."""

    def __init__(self) -> None:
        self.now_s = 100.0
        self.later: list[float] = []

    def time(self) -> float:
        return self.now_s

    def call_at(self, at_s: float, _: Callable[[], None]) -> SimpleNamespace:
        self.later.append(at_s)
        return SimpleNamespace(cancel=lambda: None)


def test_gathered_samples_leave_a_period_of_the_fastest_after_those_before(monkeypatch: pytest.MonkeyPatch) -> None:
    loop = _Loop()
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
    assert loop.later == [pytest.approx(100.025)], "on the way to its beat, half a period after it"
    loop.now_s = 100.025
    broadcast.sample("gps", loop.now_s, {})
    broadcast.flush()
    assert len(sent) == 2
    broadcast.sample("gps", loop.now_s, {})
    broadcast.flush()
    assert loop.later[-1] == pytest.approx(100.075), "from then on a twentieth of a second"
