"""A line is read no faster than any board's line carries."""

from __future__ import annotations

import asyncio
import socket

import pytest

from epf_gcs.link.address import parse_address
from epf_gcs.link.base import LinkCallbacks
from epf_gcs.link.descriptor import DescriptorLink
from epf_gcs.link.open import open_link
from epf_gcs.link.read_budget import AT_ONCE_BYTES, MOST_BYTES_PER_S, ReadBudget
from tests.support.waiting import eventually_async


@pytest.mark.parametrize("bytes_per_s", [1_000.0, 11_520.0, 92_160.0, 300_000.0])
def test_a_board_s_line_is_never_held_back(bytes_per_s: float) -> None:
    budget, now_s = ReadBudget(0.0), 0.0
    for _ in range(10_000):
        now_s += 0.01
        assert budget.take(round(bytes_per_s * 0.01), now_s) == 0.0


def test_whatever_comes_no_more_is_read_than_the_budget_allows_and_what_came_at_once_after_silence_is() -> None:
    budget, now_s, read = ReadBudget(0.0), 100.0, 0
    while now_s < 110.0:
        read += 4096
        now_s += budget.take(4096, now_s) or 0.0001
    assert read <= AT_ONCE_BYTES + 10.0 * MOST_BYTES_PER_S + 4096
    assert read >= 0.9 * 10.0 * MOST_BYTES_PER_S


@pytest.mark.anyio
async def test_a_flood_over_tcp_waits_at_its_end_and_every_byte_that_is_read_comes_in_order() -> None:
    """The clock stands still: what the budget holds is read, then nothing until time passes."""
    now_s = [0.0]
    sent = bytes(range(256)) * 4096
    with socket.create_server(("127.0.0.1", 0)) as server:
        opening = asyncio.ensure_future(open_link(parse_address(f"tcp://127.0.0.1:{server.getsockname()[1]}")))
        accepted, _ = await asyncio.to_thread(server.accept)
        link = await opening
        assert isinstance(link, DescriptorLink)
        link._now_s, link._budget = lambda: now_s[0], ReadBudget(0.0)
        got = bytearray()
        link.start(LinkCallbacks(got.extend, lambda _: None))
        flood = asyncio.ensure_future(asyncio.to_thread(accepted.sendall, sent))
        await eventually_async(lambda: link.held_back > 0, "it is held back")
        assert len(got) <= AT_ONCE_BYTES + 4096
        while len(got) < len(sent):
            before = len(got)
            now_s[0] += 1.0
            await eventually_async(lambda: len(got) > before or len(got) == len(sent), "it reads on")  # noqa: B023
        await flood
        assert bytes(got) == sent
        link.close()
        accepted.close()
