"""A full line is read at rest: late, but with the time of each frame; and at once whenever somebody needs it."""

from __future__ import annotations

import asyncio
import os
from collections.abc import AsyncIterator

import pytest
from hypothesis import given
from hypothesis import strategies as st

from epf_gcs.link import descriptor
from epf_gcs.link.base import Device, LinkCallbacks
from epf_gcs.link.descriptor import DescriptorLink
from epf_gcs.link.unbroken import ByteTimes
from tests.support.waiting import eventually_async

pytestmark = pytest.mark.anyio

BAUD = 100_000
BYTE_S = 1e-4
FRAME_BYTES = 50
# Longer than a rest, and four frames of a line without a gap.
WINDOW_S = 0.02
FULL = bytes(4 * FRAME_BYTES)


class SerialLine:
    """A device in the test's hand: what it puts in is there at once, and the clock stands still until it is moved."""

    def __init__(self, monkeypatch: pytest.MonkeyPatch, *, is_serial: bool = True) -> None:
        self.now_s = 1000.0
        self.told: list[tuple[str, int, float]] = []
        self.may_wait = True
        self.fails = False
        self._waiting = b""
        self._ready, self._signal = os.pipe()
        os.set_blocking(self._ready, False)
        monkeypatch.setattr(descriptor, "monotonic", lambda: self.now_s)
        device = Device("line", self._ready, BAUD, lambda: None, lambda: 0, self._read, len, is_serial=is_serial)
        self.link = DescriptorLink(device)
        self.link.start(
            LinkCallbacks(lambda _: None, lambda _: None, self, lambda _: FRAME_BYTES, lambda: self.may_wait)
        )

    def received(self, data: bytes, ago_s: float = 0.0) -> None:
        self.told.append(("received", len(data), round(ago_s, 6)))
        if self.fails:
            raise ZeroDivisionError

    def sent(self, data: bytes) -> None:
        self.told.append(("sent", len(data), 0.0))

    def bring(self, data: bytes, lasted_s: float = WINDOW_S) -> None:
        """So many bytes in this time."""
        self.now_s += lasted_s
        self._waiting += data
        os.write(self._signal, b".")

    async def hears(self, *told: tuple[str, int, float]) -> None:
        await eventually_async(lambda: len(self.told) >= len(told), f"it hears {told}, not {self.told}")
        assert self.told == list(told)
        self.told.clear()

    async def is_full(self) -> None:
        """For long enough that the link rests, if it may."""
        for _ in range(2):
            self.bring(FULL)
            await self.hears(("received", len(FULL), 0.0))

    def close(self) -> None:
        self.link.close()
        os.close(self._ready)
        os.close(self._signal)

    def _read(self, _most: int) -> bytes:
        os.read(self._ready, 4096)
        taken, self._waiting = self._waiting, b""
        return taken


@pytest.fixture
async def line(monkeypatch: pytest.MonkeyPatch) -> AsyncIterator[SerialLine]:
    made = SerialLine(monkeypatch)
    yield made
    made.close()


AT_REST = [("received", FRAME_BYTES, round(later * FRAME_BYTES * BYTE_S, 6)) for later in (3, 2, 1, 0)]


async def test_frames_of_a_full_line_come_late_each_with_its_time(line: SerialLine) -> None:
    await line.is_full()
    for _ in range(2):
        line.bring(FULL)
        await line.hears(*AT_REST)


async def test_a_pause_of_the_line_ends_the_rest(line: SerialLine) -> None:
    await line.is_full()
    line.bring(bytes(FRAME_BYTES))
    await line.hears(("received", FRAME_BYTES, round(WINDOW_S - FRAME_BYTES * BYTE_S, 6)))
    line.bring(FULL)
    await line.hears(("received", len(FULL), 0.0))


async def test_what_came_before_a_write_is_recorded_before_it(line: SerialLine) -> None:
    await line.is_full()
    line.bring(FULL)
    assert line.link.write(b"asks")
    await line.hears(*AT_REST, ("sent", 4, 0.0))
    # An answer is expected: nothing waits for the next second, however full the line is.
    for _ in range(3):
        line.bring(FULL)
        await line.hears(("received", len(FULL), 0.0))


async def test_what_waits_can_be_had_at_once(line: SerialLine) -> None:
    await line.is_full()
    line.bring(FULL)
    line.link.deliver()
    assert line.told == AT_REST
    line.link.deliver()
    assert line.told == AT_REST


async def test_bytes_that_cannot_be_taken_after_a_rest_cost_themselves_alone_and_the_line_is_read_on(
    line: SerialLine,
) -> None:
    failures: list[str] = []
    asyncio.get_running_loop().set_exception_handler(lambda _, context: failures.append(context["message"]))
    await line.is_full()
    line.fails = True
    line.bring(FULL)
    await eventually_async(lambda: bool(failures), "the failure is told")
    assert failures == ["the bytes of a line"]
    line.fails = False
    line.told.clear()
    line.bring(FULL)
    await line.hears(*AT_REST)


async def test_nothing_waits_while_somebody_needs_it(line: SerialLine) -> None:
    line.may_wait = False
    await line.is_full()
    line.bring(FULL)
    await line.hears(("received", len(FULL), 0.0))


async def test_a_rest_ends_when_somebody_begins_to_need_it(line: SerialLine) -> None:
    await line.is_full()
    line.may_wait = False
    line.bring(FULL)
    await line.hears(*AT_REST)
    line.bring(FULL)
    await line.hears(("received", len(FULL), 0.0))


async def test_bytes_that_come_faster_than_their_baud_rate_do_not_wait(line: SerialLine) -> None:
    for _ in range(3):
        line.bring(2 * FULL)
        await line.hears(("received", 2 * len(FULL), 0.0))


async def test_a_network_line_has_no_times_to_be_known_and_never_rests(monkeypatch: pytest.MonkeyPatch) -> None:
    line = SerialLine(monkeypatch, is_serial=False)
    await line.is_full()
    line.bring(FULL)
    await line.hears(("received", len(FULL), 0.0))
    line.close()


@given(count=st.integers(1, 400), gap_s=st.floats(0.0, 0.0019), place=st.floats(0.0, 1.0), asked=st.floats(0.0, 1.0))
def test_each_byte_s_time_is_known_to_a_millisecond(count: int, gap_s: float, place: float, asked: float) -> None:
    unbroken = ByteTimes(BAUD)
    number = int(asked * (count - 1))
    lasted_s = count * BYTE_S + gap_s
    came_s = (number + 1) * BYTE_S + (gap_s if number >= place * count else 0.0)
    assert unbroken.holds(count, lasted_s)
    assert abs(unbroken.ago_s(count - 1 - number, count, lasted_s) - (lasted_s - came_s)) <= 0.001 + 1e-9
