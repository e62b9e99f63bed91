"""One operator at a time."""

from __future__ import annotations

import asyncio

import pytest

from epf_gcs.bus.definition import Client
from epf_gcs.errors import ConflictError, NotFoundError
from epf_gcs.web.access.control import Control
from tests.support.waiting import eventually_async

pytestmark = pytest.mark.anyio

ANA, BEA = Client("a", "Ana"), Client("b", "Bea")


class Desk:
    def __init__(self, grace_s: float = 0.05) -> None:
        self.changes: list[Client | None] = []
        self.control = Control(asyncio.get_running_loop(), self.changes.append, grace_s=grace_s)


@pytest.fixture
async def desk() -> Desk:
    return Desk()


async def test_the_first_browser_gets_control_and_the_second_watches(desk: Desk) -> None:
    desk.control.connect(ANA)
    desk.control.connect(BEA)
    assert desk.control.holder == ANA
    assert [desk.control.name_of(client) for client in ("a", "b", "x")] == ["Ana", "Bea", None]
    desk.control.check("a")
    with pytest.raises(ConflictError, match="Ana has control") as caught:
        desk.control.check("b")
    assert caught.value.params == {"client": "a", "name": "Ana"}
    with pytest.raises(ConflictError):
        desk.control.check(None)


async def test_only_the_same_id_is_the_same_browser(desk: Desk) -> None:
    desk.control.connect(BEA)
    for other in (ANA, Client("c", "Carla")):
        desk.control.connect(other)
        assert desk.control.holder == BEA
        for asked in (desk.control.check, desk.control.take, desk.control.release):
            with pytest.raises(ConflictError):
                asked(other.id)
        desk.control.disconnect(other)
        assert desk.control._timer is None, "Bea is still there: nothing ends her control"
    assert desk.changes == [BEA]


async def test_while_nobody_has_control_a_program_may_command(desk: Desk) -> None:
    desk.control.check(None)


async def test_what_is_given_back_can_be_taken(desk: Desk) -> None:
    desk.control.connect(ANA)
    desk.control.connect(BEA)
    with pytest.raises(ConflictError):
        desk.control.take("b")
    with pytest.raises(ConflictError):
        desk.control.release("b")
    desk.control.release("a")
    assert desk.control.holder is None
    assert desk.control.take("b") == BEA
    assert desk.changes == [ANA, None, BEA]


async def test_only_a_browser_on_the_stream_can_take_control(desk: Desk) -> None:
    with pytest.raises(NotFoundError, match="'x'"):
        desk.control.take("x")


async def test_a_page_that_comes_back_in_time_keeps_control() -> None:
    desk = Desk(grace_s=3600.0)
    desk.control.connect(ANA)
    desk.control.connect(BEA)
    desk.control.disconnect(ANA)
    assert desk.control.holder == ANA
    desk.control.connect(Client("a", "Ana"))
    assert desk.control.holder == ANA
    assert desk.changes == [ANA]


async def test_after_the_grace_whoever_watches_longest_has_control(desk: Desk) -> None:
    desk.control.connect(ANA)
    desk.control.connect(BEA)
    desk.control.disconnect(ANA)
    await eventually_async(lambda: desk.control.holder == BEA, "control passes on")


async def test_after_the_grace_control_is_free_where_nobody_watches(desk: Desk) -> None:
    desk.control.connect(ANA)
    desk.control.disconnect(ANA)
    await eventually_async(lambda: desk.control.holder is None, "control is free")
    desk.control.connect(BEA)
    assert desk.control.holder == BEA


async def test_a_viewer_that_goes_changes_nothing(desk: Desk) -> None:
    desk.control.connect(ANA)
    desk.control.connect(BEA)
    desk.control.disconnect(BEA)
    assert desk.control.holder == ANA
    assert not desk.control.is_connected("b")
