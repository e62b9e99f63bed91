"""Whatever happens to a line, what is wanted is opened again; and nobody is asked over and over without a pause."""

from __future__ import annotations

import asyncio
import contextlib
import errno
from collections.abc import AsyncIterator
from dataclasses import dataclass

import pytest

from epf_gcs.errors import GatewayError, LinkError
from epf_gcs.link.kept_open import KeptOpen, LinkHandlers
from tests.support.waiting import eventually_async

pytestmark = pytest.mark.anyio


@dataclass(frozen=True)
class Place:
    """An address: `device` can be open once."""

    device: str
    speed: int = 1

    @property
    def name(self) -> str:
        return self.device

    def same_device(self, other: Place) -> bool:
        return self.device == other.device


class Line:
    """What was opened."""

    def __init__(self, place: Place) -> None:
        self.place = place


LOST = LinkError("link_lost", "The line to it was lost: check the cable.")


class World:
    """Devices that open unless `faults` has a reason against it, and everything that was asked for, in order."""

    def __init__(self) -> None:
        self.faults: list[BaseException | None] = []
        self.begin_faults: list[Exception | None] = []
        self.hang_ups = 0
        self.done: list[str] = []
        self.reports: list[GatewayError] = []
        self.pauses: list[float] = []
        self.now_s = 0.0
        self.pausing = asyncio.Event()
        self.pausing.set()
        self.moved_to: Place | None = None
        self.kept: KeptOpen[Place, Line] = KeptOpen(
            LinkHandlers(
                open=self._open,
                begin=self._begin,
                end=lambda line: self.done.append(f"end {line.place.device}"),
                gone=lambda: self.done.append("gone"),
                report=self.reports.append,
                changed=lambda: None,
                find=self._find,
            ),
            now_s=lambda: self.now_s,
            wait=self._pause,
        )

    @contextlib.asynccontextmanager
    async def running(self) -> AsyncIterator[None]:
        task = asyncio.create_task(self.kept.run())
        try:
            yield
        finally:
            task.cancel()
            with contextlib.suppress(asyncio.CancelledError):
                await task

    async def is_open(self, device: str) -> None:
        await eventually_async(
            lambda: self.kept.link is not None and self.kept.link.place.device == device, f"{device} is open"
        )

    async def _pause(self, event: asyncio.Event, at_most_s: float) -> None:
        self.pauses.append(at_most_s)
        await self.pausing.wait()
        await asyncio.sleep(0)

    async def _find(self, wanted: Place) -> Place:
        return self.moved_to or wanted

    async def _open(self, place: Place) -> Line:
        fault = self.faults.pop(0) if self.faults else None
        if fault is not None:
            raise fault
        self.done.append(f"open {place.device}")
        return Line(place)

    def _begin(self, place: Place, line: Line) -> None:
        fault = self.begin_faults.pop(0) if self.begin_faults else None
        if fault is not None:
            raise fault
        self.done.append(f"begin {place.device}")
        if self.hang_ups:
            self.hang_ups -= 1
            self.kept.lose(LOST)


async def test_what_cannot_be_opened_is_tried_less_and_less_often_and_told_once() -> None:
    world = World()
    world.faults = [LinkError("link_no_device", "There is none.") for _ in range(6)]
    async with world.running():
        world.kept.want(Place("board"))
        await world.is_open("board")
    assert world.pauses == [0.1, 0.2, 0.4, 0.8, 1.0, 1.0]
    assert [error.code for error in world.reports] == ["link_no_device"]
    assert (world.kept.failure, world.kept.reopened) == (None, 1)


@pytest.mark.parametrize(
    ("fault", "words"),
    [
        (OSError(errno.EMFILE, "Too many open files"), "too many files and connections open"),
        (UnicodeError("label empty or too long"), "label empty or too long"),
        (ValueError("out of range"), "out of range"),
    ],
)
async def test_no_kind_of_error_ends_the_tries(fault: Exception, words: str) -> None:
    world = World()
    world.faults = [fault, fault]
    async with world.running():
        world.kept.want(Place("board"))
        await world.is_open("board")
    assert [error.code for error in world.reports] == ["link_failed"]
    assert words in world.reports[0].detail
    assert world.reports[0].params["target"] == "board"


async def test_whoever_asks_is_told_of_any_error_in_a_sentence() -> None:
    world = World()
    world.faults = [OSError(errno.EMFILE, "Too many open files")]
    with pytest.raises(LinkError, match="board cannot be opened because"):
        await world.kept.open(Place("board"))
    assert world.kept.address is None


async def test_a_line_that_lasted_is_opened_again_at_once() -> None:
    world = World()
    async with world.running():
        await world.kept.open(Place("board"))
        world.now_s += 1.0
        world.kept.lose(LOST)
        assert world.kept.failure is LOST
        await world.is_open("board")
    assert world.pauses == []
    assert world.done == ["open board", "begin board", "gone", "open board", "begin board"]


async def test_a_peer_that_hangs_up_at_once_is_not_asked_without_a_pause() -> None:
    world = World()
    world.hang_ups = 3
    async with world.running():
        world.kept.want(Place("board"))
        await eventually_async(lambda: world.done.count("begin board") == 4, "it stays")
    assert world.pauses == [0.1, 0.2, 0.4]


async def test_a_new_wish_begins_with_a_try_and_not_with_a_pause() -> None:
    world = World()
    world.faults = [LinkError("link_no_device", "There is none."), LinkError("link_no_device", "There is none.")]
    world.pausing.clear()
    async with world.running():
        world.kept.want(Place("board"))
        await eventually_async(lambda: world.pauses == [0.1], "it pauses")
        world.kept.want(Place("other"))
        world.pausing.set()
        await world.is_open("other")
    assert world.pauses == [0.1, 0.1], "the second failure is the first of the new wish"


async def test_the_same_device_is_closed_first_and_opened_again_where_that_fails() -> None:
    world = World()
    async with world.running():
        await world.kept.open(Place("board"))
        world.faults = [LinkError("link_busy", "It is in use."), LinkError("link_busy", "It is in use.")]
        with pytest.raises(LinkError):
            await world.kept.open(Place("board", speed=2))
        assert world.kept.address == Place("board")
        await world.is_open("board")
    assert world.done == ["open board", "begin board", "end board", "open board", "begin board"]


async def test_another_device_is_opened_before_the_old_one_is_let_go() -> None:
    world = World()
    await world.kept.open(Place("board"))
    world.faults = [LinkError("link_no_device", "There is none.")]
    with pytest.raises(LinkError):
        await world.kept.open(Place("other"))
    assert world.kept.address == Place("board")
    await world.kept.open(Place("other"))
    assert world.done == ["open board", "begin board", "open other", "end board", "begin other"]


async def test_a_device_that_moved_is_opened_where_it_is_now() -> None:
    world = World()
    async with world.running():
        await world.kept.open(Place("ttyUSB0"))
        world.moved_to = Place("ttyUSB7")
        world.kept.lose(LOST)
        await world.is_open("ttyUSB7")
        assert world.kept.address == Place("ttyUSB7")


async def test_what_was_closed_stays_closed_and_an_end_forgets_no_wish() -> None:
    world = World()
    async with world.running():
        await world.kept.open(Place("board"))
        world.kept.shut_down()
        assert (world.kept.address, world.kept.link) == (Place("board"), None)
        await world.kept.close()
        assert (world.kept.address, world.kept.failure) == (None, None)
    assert world.done == ["open board", "begin board", "end board"]


async def test_a_fault_of_ours_is_raised_and_the_next_run_opens_anew() -> None:
    world = World()
    world.begin_faults = [RuntimeError("a fault of ours")]
    world.kept.want(Place("board"))
    with pytest.raises(RuntimeError):
        await world.kept.run()
    assert world.done == ["open board", "end board"]
    async with world.running():
        await world.is_open("board")
    assert world.pauses == [1.0]
