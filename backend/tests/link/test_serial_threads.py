"""Where the event loop cannot wait for a serial port, threads carry its bytes: tried here on a pseudo-terminal."""

from __future__ import annotations

import asyncio
import os
import pty
import tty
from collections.abc import Iterator
from dataclasses import dataclass, field

import pytest

from epf_gcs.errors import LinkError
from epf_gcs.link.address import LinkAddress
from epf_gcs.link.base import LinkCallbacks
from epf_gcs.link.descriptor import DescriptorLink
from epf_gcs.link.serial_threads import open_pty, open_serial
from tests.support.waiting import eventually_async

pytestmark = pytest.mark.anyio


@dataclass
class Ends:
    """The board's end of a line, and the name of ours."""

    board: int
    name: str
    heard: bytearray = field(default_factory=bytearray)
    lost: list[LinkError] = field(default_factory=list)


@pytest.fixture
def line() -> Iterator[Ends]:
    board, ours = pty.openpty()
    tty.setraw(ours)
    ends = Ends(board, os.ttyname(ours))
    yield ends
    os.close(ours)
    os.close(ends.board)


async def opened(line: Ends) -> DescriptorLink:
    link = DescriptorLink(open_serial(LinkAddress("serial", line.name)))
    link.start(LinkCallbacks(line.heard.extend, line.lost.append))
    return link


async def test_bytes_go_both_ways_whole_and_in_order(line: Ends) -> None:
    link = await opened(line)
    sent = bytes(range(256)) * 20
    os.write(line.board, sent[:2000])
    os.write(line.board, sent[2000:])
    await eventually_async(lambda: len(line.heard) == len(sent), "all arrive")
    assert bytes(line.heard) == sent
    assert link.write(b"to the board")
    assert await asyncio.to_thread(os.read, line.board, 100) == b"to the board"
    link.close()


async def test_a_line_that_is_gone_is_told_once(line: Ends) -> None:
    link = await opened(line)
    board, line.board = line.board, os.open(os.devnull, os.O_RDONLY)
    os.close(board)
    await eventually_async(lambda: bool(line.lost), "it is told")
    assert [error.code for error in line.lost] == ["link_lost"]
    link.close()


async def test_what_was_said_last_still_leaves_when_the_line_is_closed(line: Ends) -> None:
    os.set_blocking(line.board, False)
    for _ in range(20):
        link = await opened(line)
        assert link.write(b"leave your mode")
        link.close()
        assert os.read(line.board, 100) == b"leave your mode"


async def test_bytes_that_no_port_has_taken_are_counted(line: Ends) -> None:
    link = await opened(line)
    for _ in range(40):
        assert link.write(bytes(1000))
    await eventually_async(lambda: link.backlog >= 20_000, "what waits for the port is counted")
    link.close()


async def test_after_closing_the_port_can_be_opened_again(line: Ends) -> None:
    for _ in range(2):
        link = await opened(line)
        link.close()
    assert line.lost == []


def test_a_port_that_is_not_there_is_told_as_such() -> None:
    with pytest.raises(LinkError) as told:
        open_serial(LinkAddress("serial", "/dev/no-such-port"))
    assert told.value.code == "link_no_device"
    with pytest.raises(LinkError, match="does not have"):
        open_pty(LinkAddress("pty", "/tmp/board"))  # noqa: S108
