"""A process gives signs of life as long as its loop turns, and its parent's trouble is not its own."""

from __future__ import annotations

import asyncio
import contextlib
import os
import subprocess
import sys
from collections.abc import Iterator

import pytest

from epf_gcs import watchdog
from epf_gcs.watchdog import feed, wait_for_end
from tests.support.waiting import eventually_async

pytestmark = pytest.mark.anyio


@pytest.fixture(autouse=True)
def _quick(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(watchdog, "FEED_S", 0.001)


@pytest.fixture
def pipe() -> Iterator[tuple[int, int]]:
    ends = os.pipe()
    yield ends
    for end in ends:
        try:
            os.close(end)
        except OSError:
            continue


async def test_signs_of_life_come_again_and_again(pipe: tuple[int, int]) -> None:
    os.set_blocking(pipe[0], False)
    feeding = asyncio.create_task(feed(pipe[1]))
    got = b""

    def three() -> bool:
        nonlocal got
        with contextlib.suppress(BlockingIOError):
            got += os.read(pipe[0], 1)
        return len(got) >= 3

    await eventually_async(three, "three of them")
    feeding.cancel()


async def test_a_parent_that_does_not_read_stops_nobody(pipe: tuple[int, int]) -> None:
    os.set_blocking(pipe[1], False)
    with contextlib.suppress(BlockingIOError):
        while True:
            os.write(pipe[1], bytes(4096))
    await stays_alive(pipe[1])


async def test_a_parent_that_died_stops_nobody(pipe: tuple[int, int]) -> None:
    os.close(pipe[0])
    await stays_alive(pipe[1])


async def stays_alive(descriptor: int) -> None:
    feeding = asyncio.create_task(feed(descriptor))
    for _ in range(20):
        await asyncio.sleep(0.001)
    assert not feeding.done()
    feeding.cancel()


def test_one_that_ends_by_itself_is_not_one_that_hangs(pipe: tuple[int, int]) -> None:
    process = subprocess.Popen([sys.executable, "-c", "raise SystemExit(3)"], pass_fds=[pipe[1]])
    os.close(pipe[1])
    hung: list[bool] = []
    assert wait_for_end(process, pipe[0], 5.0, lambda: hung.append(True)) == 3
    assert hung == []
