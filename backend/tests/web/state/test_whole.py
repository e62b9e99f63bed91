"""The status is told at once, and then only so often, however often it changes."""

from __future__ import annotations

import asyncio
from types import SimpleNamespace
from typing import Any, cast

import pytest

from epf_gcs.contract.status import Status
from epf_gcs.error_log import ErrorLog
from epf_gcs.shares.table import STATUS_PER_S
from epf_gcs.web.state.whole import WholeStatus
from tests.support.held_loop import HeldLoop


class Told:
    """A hub that notes when it was told a status."""

    def __init__(self, loop: HeldLoop) -> None:
        self.viewers = ["one"]
        self.at_s: list[float] = []
        self._loop = loop

    def status(self, text: bytes) -> None:
        assert text.startswith(b'{"type":"status"')
        self.at_s.append(self._loop.now_s)


@pytest.fixture
def loop() -> HeldLoop:
    return HeldLoop(100.0)


@pytest.fixture
def told(loop: HeldLoop) -> Told:
    return Told(loop)


@pytest.fixture
def status(loop: HeldLoop, told: Told) -> WholeStatus:
    known = Status()
    around: Any = SimpleNamespace(state=lambda: known.control)
    return WholeStatus(
        lambda: known,
        around,
        ErrorLog(),
        cast(Any, told),
        lambda: known.surroundings,
        loop=cast(asyncio.AbstractEventLoop, loop),
    )


def test_one_change_is_told_at_once(loop: HeldLoop, told: Told, status: WholeStatus) -> None:
    for at_s in (100.0, 101.0, 102.5):
        loop.run_until(at_s)
        status.changed()
        loop.run_until(at_s)
    assert told.at_s == [100.0, 101.0, 102.5]


def test_many_changes_are_told_so_often_and_the_last_is_told(loop: HeldLoop, told: Told, status: WholeStatus) -> None:
    for number in range(290):
        loop.run_until(100.0 + number / 290)
        status.changed()
    loop.run_until(102.0)
    assert len(told.at_s) == STATUS_PER_S + 1
    assert told.at_s[0] == 100.0
    assert told.at_s[-1] == pytest.approx(101.0)
    loop.run_until(110.0)
    assert len(told.at_s) == STATUS_PER_S + 1, "nothing has changed since"
