"""One clock for everything."""

from __future__ import annotations

import time

import pytest

from epf_gcs.clock import Clock


def test_it_tells_unix_time() -> None:
    clock = Clock()
    assert clock.now_s() == pytest.approx(time.time(), abs=5.0)
    assert clock.now_ns() == pytest.approx(time.time_ns(), abs=5e9)


def test_a_clock_that_is_set_does_not_set_it_back(monkeypatch: pytest.MonkeyPatch) -> None:
    clock = Clock()
    before = clock.now_s()
    monkeypatch.setattr(time, "time_ns", lambda: 0)
    monkeypatch.setattr(time, "time", lambda: 0.0)
    assert clock.now_s() >= before


def test_a_moment_of_the_steady_clock_has_its_unix_time() -> None:
    clock = Clock()
    steady_ns = time.monotonic_ns()
    assert clock.unix_ns(steady_ns) <= clock.now_ns()
    assert clock.unix_ns(steady_ns) * 1e-9 == pytest.approx(clock.now_s(), abs=5.0)
