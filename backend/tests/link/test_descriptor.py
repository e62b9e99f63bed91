"""Bytes over a real pseudo-terminal, however the other side behaves."""

from __future__ import annotations

import contextlib
import os
import pty
import sys
import tty
from collections.abc import Iterator
from pathlib import Path

import pytest

from epf_gcs.errors import LinkError
from epf_gcs.link.address import parse_address
from epf_gcs.link.base import LinkCallbacks
from epf_gcs.link.descriptor import DescriptorLink
from epf_gcs.link.open import open_link
from tests.support.waiting import eventually_async

pytestmark = pytest.mark.anyio


class Tape:
    """Keeps what a tap is told, in order."""

    def __init__(self) -> None:
        self.entries: list[tuple[str, bytes]] = []

    def received(self, data: bytes, ago_s: float = 0.0) -> None:
        del ago_s
        self.entries.append(("received", data))

    def sent(self, data: bytes) -> None:
        self.entries.append(("sent", data))


class Ends:
    """Both ends of a line, and what the link told."""

    def __init__(self) -> None:
        self.master, slave = pty.openpty()
        tty.setraw(slave)
        self.path = os.ttyname(slave)
        self._slave = slave
        self.got = b""
        self.lost: list[LinkError] = []
        self.tape = Tape()
        self.missing = 0

    async def open(self) -> DescriptorLink:
        link = await open_link(parse_address(f"pty://{self.path}"))
        link.start(LinkCallbacks(self._take, self.lost.append, self.tape, lambda _: self.missing))
        return link

    @property
    def reads(self) -> list[bytes]:
        return [data for kind, data in self.tape.entries if kind == "received"]

    def pull(self) -> None:
        os.close(self.master)
        self.master = -1

    def close(self) -> None:
        for fd in (self.master, self._slave):
            with contextlib.suppress(OSError):
                os.close(fd)

    def _take(self, data: bytes) -> None:
        assert self.tape.entries[-1] == ("received", data), "the tap must hear it first"
        self.got += data


@pytest.fixture
def ends() -> Iterator[Ends]:
    both = Ends()
    yield both
    both.close()


async def test_bytes_arrive_both_ways_and_the_tap_hears_all(ends: Ends) -> None:
    link = await ends.open()
    os.write(ends.master, b"from the board")
    await eventually_async(lambda: ends.got == b"from the board", "the bytes arrive")
    assert link.write(b"to the board")
    assert os.read(ends.master, 100) == b"to the board"
    assert ("sent", b"to the board") in ends.tape.entries
    link.close()


async def test_what_the_system_does_not_take_at_once_follows_in_order(ends: Ends) -> None:
    link = await ends.open()
    message = bytes(range(256)) * 256
    assert link.write(message)
    assert link.write(b"the end")
    assert link.backlog > 0
    got = b""
    os.set_blocking(ends.master, False)

    def drained() -> bool:
        nonlocal got
        with contextlib.suppress(BlockingIOError):
            got += os.read(ends.master, 65536)
        return got == message + b"the end"

    await eventually_async(drained, "everything comes out")
    await eventually_async(lambda: link.backlog == 0, "nothing is left")
    link.close()


async def test_a_full_queue_takes_whole_messages_or_nothing(ends: Ends) -> None:
    link = await ends.open()
    accepted = 0
    while link.write(b"x" * 4096):
        accepted += 1
        assert accepted < 1000, "the queue has no bound"
    assert link.backlog <= 131072 + 65536
    assert len([entry for entry in ends.tape.entries if entry[0] == "sent"]) == accepted
    link.close()


async def test_a_pulled_cable_is_told_once_with_a_reason(ends: Ends) -> None:
    link = await ends.open()
    ends.pull()
    await eventually_async(lambda: bool(ends.lost), "the loss is noticed")
    assert not link.write(b"into the void")
    assert link.backlog == 0
    link.close()
    assert len(ends.lost) == 1
    assert ends.lost[0].code == "link_lost"
    assert ends.path in ends.lost[0].detail


async def test_nothing_is_told_after_a_close(ends: Ends) -> None:
    link = await ends.open()
    link.close()
    link.close()
    os.write(ends.master, b"too late")
    assert not link.write(b"too late")
    ends.pull()
    assert (ends.got, ends.lost) == (b"", [])


async def test_bytes_that_came_before_the_start_are_not_lost(ends: Ends, tmp_path: Path) -> None:
    link = await open_link(parse_address(f"pty://{ends.path}"))
    os.write(ends.master, b"early")
    got: list[bytes] = []
    link.start(LinkCallbacks(got.append, ends.lost.append))
    await eventually_async(lambda: b"".join(got) == b"early", "the early bytes arrive")
    link.close()


on_linux = pytest.mark.skipif(sys.platform != "linux", reason="only Linux has a terminal wait for more than a byte")


@on_linux
async def test_nobody_is_woken_before_what_is_missing_can_be_there(ends: Ends) -> None:
    link = await ends.open()
    ends.missing = 40
    os.write(ends.master, b"begun")
    await eventually_async(lambda: ends.got == b"begun", "the first bytes arrive")
    for _ in range(4):
        os.write(ends.master, bytes(10))
    await eventually_async(lambda: len(ends.got) == 45, "the rest arrives")
    assert ends.reads == [b"begun", bytes(40)]
    link.close()


@on_linux
async def test_what_is_more_than_was_waited_for_comes_with_it(ends: Ends) -> None:
    link = await ends.open()
    ends.missing = 1000
    os.write(ends.master, b"begun")
    await eventually_async(lambda: ends.got == b"begun", "the first bytes arrive")
    os.write(ends.master, bytes(300))
    await eventually_async(lambda: len(ends.got) == 305, "no more is waited for than a terminal can")
    link.close()


@on_linux
async def test_a_line_that_falls_silent_hands_over_what_it_has(ends: Ends) -> None:
    link = await ends.open()
    ends.missing = 40
    os.write(ends.master, b"begun")
    await eventually_async(lambda: ends.got == b"begun", "the first bytes arrive")
    os.write(ends.master, b", and no more")
    await eventually_async(lambda: ends.got == b"begun, and no more", "what there is arrives")
    link.close()


@on_linux
async def test_a_line_that_is_pulled_while_bytes_are_missing_is_told_as_lost(ends: Ends) -> None:
    await ends.open()
    ends.missing = 40
    os.write(ends.master, b"begun")
    await eventually_async(lambda: ends.got == b"begun", "the first bytes arrive")
    ends.pull()
    await eventually_async(lambda: len(ends.lost) == 1, "the loss is noticed")


@on_linux
async def test_after_a_question_of_another_kind_a_short_answer_is_heard(ends: Ends) -> None:
    link = await ends.open()
    ends.missing = 40
    os.write(ends.master, b"begun")
    await eventually_async(lambda: ends.got == b"begun", "the first bytes arrive")
    ends.missing = 0
    assert link.write(b"version?")
    os.write(ends.master, b"1")
    await eventually_async(lambda: ends.got == b"begun1", "the answer arrives")
    link.close()
