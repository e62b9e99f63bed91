"""Who waits for a turn: owners go first, then who has least, then who came first."""

from __future__ import annotations

import asyncio

import pytest

from epf_gcs.shares.holder import Holder, Standing
from epf_gcs.shares.places import Part, Places
from epf_gcs.shares.turns import Turns

ROW = Places({Standing.viewer: Part(1, 2), Standing.owner: Part(2, 3)})


class Work:
    """Work of people, by name, each until it is ended."""

    def __init__(self) -> None:
        self.turns = Turns(ROW)
        self.begun: list[str] = []
        self.ends: dict[str, asyncio.Event] = {}
        self.tasks: dict[str, asyncio.Task[None]] = {}

    async def ask(self, name: str, by: str, standing: Standing) -> None:
        """Wait for a turn, and have it if there is one."""
        self.ends[name] = asyncio.Event()
        self.tasks[name] = asyncio.create_task(self._work(name, Holder(by, standing)))
        await settle()

    async def end(self, name: str) -> None:
        self.ends[name].set()
        await settle()

    async def _work(self, name: str, holder: Holder) -> None:
        async with self.turns.turn(holder):
            self.begun.append(name)
            await self.ends[name].wait()


async def settle() -> None:
    """Let everything happen that is due."""
    for _ in range(10):
        await asyncio.sleep(0)


@pytest.mark.anyio
async def test_viewers_leave_a_turn_to_owners_and_each_has_one() -> None:
    work = Work()
    for name in ("ana 1", "ana 2", "eva 1", "leo 1"):
        await work.ask(name, name[:3], Standing.viewer)
    assert work.begun == ["ana 1", "eva 1"]
    await work.ask("boss", "boss", Standing.owner)
    assert work.begun == ["ana 1", "eva 1", "boss"]


@pytest.mark.anyio
async def test_owners_go_first_then_who_has_least_then_who_came_first() -> None:
    work = Work()
    for name, standing in (("a 1", 3), ("a 2", 3), ("b 1", 3), ("b 2", 3), ("v", 1), ("b 3", 3), ("c 1", 3)):
        await work.ask(name, name[0], Standing(standing))
    assert work.begun == ["a 1", "a 2", "b 1"]
    await work.end("a 1")
    assert work.begun[3:] == ["c 1"], "who has none, though it came last"
    await work.end("b 1")
    assert work.begun[4:] == ["b 2"]
    for name in ("a 2", "c 1", "b 2"):
        await work.end(name)
    assert work.begun[5:] == ["b 3", "v"]


@pytest.mark.anyio
@pytest.mark.parametrize("settles", [True, False])
async def test_a_turn_that_is_cancelled_is_another_s(settles: bool) -> None:
    """Also one that was given and not yet begun."""
    work = Work()
    await work.ask("a", "a", Standing.viewer)
    await work.ask("b", "b", Standing.viewer)
    await work.ask("c", "c", Standing.viewer)
    await work.ask("d", "d", Standing.viewer)
    work.ends["a"].set()
    if settles:
        work.tasks["c"].cancel()
        await settle()
    else:
        for _ in range(10):
            if not work.turns._at_work.count("c"):
                await asyncio.sleep(0)
        work.tasks["c"].cancel()
        await settle()
    assert work.begun == ["a", "b", "d"]
    await work.end("b")
    await work.end("d")
    assert len(work.turns._at_work) == 0
