"""One end of a local connection: nothing is lost when the other side reads slowly, and it ends once."""

from __future__ import annotations

import asyncio
import socket
from typing import Any

import pytest

from epf_gcs.bus.channel import Channel
from tests.support.waiting import DEADLINE_S, eventually_async

_LONG = bytes(range(256)) * 20_000


def _pair() -> tuple[socket.socket, socket.socket]:
    ours, theirs = socket.socketpair()
    theirs.setblocking(False)
    return ours, theirs


@pytest.mark.anyio
async def test_what_the_system_does_not_take_at_once_follows_in_order() -> None:
    ours, theirs = _pair()
    channel = Channel(ours, lambda _: None, lambda: None)
    channel.send(_LONG)
    channel.send(b"the end")
    assert channel.unsent_bytes > 0, "more than fits at once"
    got, loop = bytearray(), asyncio.get_running_loop()
    while len(got) < len(_LONG) + 7:
        got += await asyncio.wait_for(loop.sock_recv(theirs, 65536), DEADLINE_S)
    assert bytes(got) == _LONG + b"the end"
    assert channel.unsent_bytes == 0
    channel.close()
    theirs.close()


@pytest.mark.anyio
async def test_an_end_of_our_own_is_silent_and_final() -> None:
    ours, theirs = _pair()
    losses: list[int] = []
    channel = Channel(ours, lambda _: None, lambda: losses.append(1))
    channel.close()
    channel.close()
    channel.lose()
    channel.send(b"late")
    assert channel.unsent_bytes == 0
    assert await asyncio.get_running_loop().sock_recv(theirs, 10) == b""
    assert losses == []
    theirs.close()


@pytest.mark.anyio
async def test_the_others_end_is_told_once() -> None:
    ours, theirs = _pair()
    losses: list[int] = []
    channel = Channel(ours, lambda _: None, lambda: losses.append(1))
    theirs.close()
    await eventually_async(lambda: losses == [1], "it is told")
    channel.lose()
    assert losses == [1]


@pytest.mark.anyio
async def test_a_single_long_message_arrives_whole_with_nothing_sent_after_it() -> None:
    ours, theirs = _pair()
    channel = Channel(ours, lambda _: None, lambda: None)
    channel.send(_LONG)
    got, loop = bytearray(), asyncio.get_running_loop()
    while len(got) < len(_LONG):
        got += await asyncio.wait_for(loop.sock_recv(theirs, 65536), DEADLINE_S)
    assert bytes(got) == _LONG
    channel.close()
    theirs.close()


class CountingSocket(socket.socket):
    """Counts how often something is sent."""

    sendings = 0

    def send(self, *arguments: Any) -> int:
        self.sendings += 1
        return super().send(*arguments)


@pytest.mark.anyio
async def test_a_channel_that_has_sent_everything_does_nothing_until_there_is_more() -> None:
    plain, theirs = _pair()
    ours = CountingSocket(fileno=plain.detach())
    channel = Channel(ours, lambda _: None, lambda: None)
    channel.send(_LONG)
    got, loop = 0, asyncio.get_running_loop()
    while got < len(_LONG):
        got += len(await asyncio.wait_for(loop.sock_recv(theirs, 65536), 10.0))
    await eventually_async(lambda: channel.unsent_bytes == 0, "all is sent")
    before = ours.sendings
    for _ in range(20):
        await asyncio.sleep(0)
    assert ours.sendings == before
    channel.close()
    theirs.close()
