"""Whose hand is on the stick, as the flight process decides it. Time is what the tests say it is."""

from __future__ import annotations

import asyncio
from functools import partial
from typing import Any

import pytest

from epf_gcs.bus.definition import Client
from epf_gcs.contract.base import PageFacts
from epf_gcs.contract.events import Event
from epf_gcs.contract.notices import ControlChange, StickRelease, StickSample
from epf_gcs.errors import ConflictError
from epf_gcs.flight.hil import stick as stick_module
from epf_gcs.flight.hil.stick import Stick
from epf_gcs.flight.requests.hil import take_stick_notice
from epf_gcs.xplane.datagram import Surfaces
from tests.support.contract import as_told
from tests.support.waiting import DEADLINE_S

pytestmark = pytest.mark.anyio

TURN = Surfaces(-0.5, 0.25, -0.125, 0.5)
LET_GO = Surfaces(0.0, 0.0, 0.0, 0.5)
GLIDE = Surfaces(0.0, 0.0, 0.0, 0.0)
ABOUT = PageFacts("local", "local", 1)
ANA = {"client": "ana", "name": "Ana", "about": ABOUT}
BEA = {"client": "bea", "name": "Bea", "about": PageFacts()}
NOBODY = {"client": None, "name": None}


class Seat:
    """The stick, told what the web process tells; it is its own clock and outlet."""

    def __init__(self) -> None:
        self.time_s = 100.0
        self.reasons: list[str] = []
        self.told: list[dict[str, Any]] = []
        self.changes = 0
        self.holders: list[str | None] = []
        self.stick = Stick(self, self, self._changed, self._holder)
        self.notice = partial(take_stick_notice, self.stick)

    def steady_s(self) -> float:
        return self.time_s

    def now_s(self) -> float:
        return self.time_s

    def event(self, event: Event, /) -> None:
        kind, data = as_told(event)
        assert kind == "stick"
        self.reasons.append(data["reason"])
        self.told.append(data)

    def _changed(self) -> None:
        self.changes += 1

    def _holder(self) -> None:
        self.holders.append(self.stick.holder.name if self.stick.holder else None)

    def sample(self, topic: str, t_s: float, values: Any) -> None:
        raise AssertionError("the stick sends no samples")

    def flush(self) -> None:
        raise AssertionError("the stick sends no samples")

    def control(self, page: dict[str, Any], *, kept: bool = False) -> None:
        self.notice(ControlChange(**page, kept=kept))

    def move(self, client: str, position: Surfaces = TURN) -> None:
        self.notice(StickSample(client, {**position._asdict(), "t_ms": self.time_s * 1000.0}))

    def later(self, decode: Any) -> bool:
        raise AssertionError("the stick puts nothing off")

    def flies(self, after_s: float = 0.0) -> Surfaces | None:
        """What replaces the simulator's stick so many seconds later."""
        self.time_s += after_s
        self.stick.tick()
        return self.stick.now(self.time_s)


@pytest.fixture
async def seat() -> Seat:
    """Ana has control and flies with her gamepad."""
    made = Seat()
    made.control(ANA)
    made.move("ana")
    await made.stick.choose_gamepad("ana", "pad")
    assert made.flies() == TURN
    return made


@pytest.fixture
def patient(monkeypatch: pytest.MonkeyPatch) -> None:
    """The first sample is awaited as long as it takes."""
    monkeypatch.setattr(stick_module, "_FIRST_SAMPLE_S", DEADLINE_S)


async def test_a_lost_holders_hand_is_off_the_stick_at_once_and_on_it_again_when_control_is_back(seat: Seat) -> None:
    seat.control(ANA, kept=True)
    assert seat.flies() == LET_GO, "at once, not when the sample is old"
    assert (seat.stick.holder, seat.stick.source, seat.stick.state) == (None, "gamepad", "lost")
    seat.move("ana")
    assert seat.flies() == LET_GO, "nobody has control: no sample counts"
    assert seat.flies(2.1) == GLIDE
    seat.control(ANA)
    seat.move("ana")
    assert seat.flies() == TURN
    assert seat.reasons == ["chosen", "lost", "back"]
    assert seat.holders == ["Ana", None, "Ana"]


@pytest.mark.parametrize("then", [NOBODY, BEA])
async def test_when_control_is_kept_no_longer_or_another_has_it_the_simulators_stick_flies(
    seat: Seat, then: dict[str, Any]
) -> None:
    seat.control(ANA, kept=True)
    seat.control(then)
    assert seat.flies() is None
    assert seat.reasons == ["chosen", "lost", "control_lost"]
    seat.move("ana")
    assert seat.flies() is None


async def test_who_loses_control_to_another_loses_the_stick_in_the_same_moment(seat: Seat) -> None:
    seat.control(BEA)
    seat.notice(StickRelease("ana"))
    assert seat.flies() is None
    assert seat.reasons == ["chosen", "control_lost"]


async def test_where_the_web_process_dies_the_hand_is_off_the_stick_and_who_had_control_is_remembered(
    seat: Seat,
) -> None:
    seat.stick.let_go()
    assert seat.flies() == LET_GO
    last = seat.stick.last_holder
    assert last is not None
    assert (last.id, last.about) == ("ana", ABOUT)


async def test_a_web_process_that_dies_while_it_keeps_control_for_somebody_leaves_no_choice_for_ever(
    seat: Seat,
) -> None:
    seat.control(ANA, kept=True)
    assert seat.stick.last_holder == Client("ana", "Ana")
    seat.stick.let_go()
    assert seat.flies(14.9) == GLIDE
    assert seat.flies(0.2) is None
    assert seat.stick.last_holder is None


async def test_a_hung_web_process_leaves_the_hand_on_the_stick_no_longer_than_a_sample_lasts(seat: Seat) -> None:
    assert seat.flies(0.29) == TURN
    assert seat.flies(0.02) == LET_GO


async def test_the_hand_that_is_back_is_told_with_its_first_sample_and_no_other_sample_is(seat: Seat) -> None:
    seat.move("ana")
    seat.move("ana")
    assert seat.reasons == ["chosen"]
    assert seat.flies(0.4) == LET_GO
    seat.move("ana")
    assert seat.reasons == ["chosen", "lost", "back"], "before anybody looks at the clock"


async def test_nobody_chooses_a_gamepad_while_control_is_only_kept(seat: Seat) -> None:
    seat.stick.choose_simulator()
    seat.control(ANA, kept=True)
    with pytest.raises(ConflictError, match="Only the page that has control"):
        await seat.stick.choose_gamepad("ana", "pad")


async def test_a_page_that_has_no_control_and_goes_takes_nobodys_hand_off_the_stick(seat: Seat) -> None:
    seat.notice(StickRelease("bea"))
    assert seat.flies() == TURN
    seat.notice(StickRelease("ana"))
    assert seat.flies() == LET_GO


async def test_a_page_whose_connection_ended_must_move_its_gamepad_again_before_it_is_chosen() -> None:
    seat = Seat()
    seat.control(ANA)
    seat.move("ana")
    seat.notice(StickRelease("bea"))
    await seat.stick.choose_gamepad("ana", "pad")
    seat.stick.choose_simulator()
    seat.notice(StickRelease("ana"))
    with pytest.raises(ConflictError, match="nothing of it arrives"):
        await seat.stick.choose_gamepad("ana", "pad")


async def test_only_the_hand_of_whoever_has_control_counts_whatever_the_others_are_called() -> None:
    seat = Seat()
    for holder, others in ((ANA, ("bea", "zoe")), (BEA, ("ana", "zoe"))):
        seat.control(holder)
        for other in others:
            seat.move(other)
    assert (seat.stick.counts["taken"], seat.stick.counts["not_operator"]) == (0, 4)


@pytest.mark.usefixtures("patient")
async def test_a_gamepad_that_is_chosen_before_it_speaks_is_awaited_and_then_flies_from_its_first_sample_on() -> None:
    seat = Seat()
    seat.control(ANA)
    seat.move("ana")
    seat.time_s += 0.4
    for _ in range(2):
        choosing = asyncio.create_task(seat.stick.choose_gamepad("ana", "pad"))
        await asyncio.sleep(0)
        assert seat.flies() is None, "what came long before counts for nothing"
        seat.move("ana", GLIDE)
        await choosing
        assert seat.flies() == GLIDE
        seat.stick.choose_simulator()
        seat.stick.let_go()
    assert seat.reasons == ["chosen"] * 4, "the first sample of a new gamepad is no return of a lost one"


async def test_a_choice_waits_for_a_sample_of_its_own_and_not_for_one_that_ended_an_earlier_wait(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(stick_module, "_FIRST_SAMPLE_S", 0.01)
    seat = Seat()
    seat.control(ANA)
    seat.move("ana")
    await seat.stick.choose_gamepad("ana", "pad")
    seat.stick.choose_simulator()
    seat.time_s += 0.4
    with pytest.raises(ConflictError, match="nothing of it arrives"):
        await seat.stick.choose_gamepad("ana", "pad")
    assert seat.stick.source == "simulator"


@pytest.mark.usefixtures("patient")
async def test_a_gamepad_whose_pages_clock_was_set_back_meanwhile_can_be_chosen() -> None:
    seat = Seat()
    seat.control(ANA)
    seat.move("ana")
    seat.time_s += 0.4
    choosing = asyncio.create_task(seat.stick.choose_gamepad("ana", "pad"))
    await asyncio.sleep(0)
    seat.notice(StickSample("ana", {**TURN._asdict(), "t_ms": (seat.time_s - 60.0) * 1000.0}))
    await choosing
    assert seat.flies() == TURN


@pytest.mark.usefixtures("patient")
@pytest.mark.parametrize("then", [NOBODY, BEA])
async def test_who_loses_control_while_the_first_sample_is_awaited_does_not_fly(then: dict[str, Any]) -> None:
    seat = Seat()
    seat.control(ANA)
    choosing = asyncio.create_task(seat.stick.choose_gamepad("ana", "pad"))
    await asyncio.sleep(0)
    seat.move("ana")
    seat.control(then)
    with pytest.raises(ConflictError, match="Only the page that has control"):
        await choosing
    assert (seat.flies(), seat.reasons) == (None, [])


async def test_the_hand_of_who_had_control_before_does_not_count_as_the_gamepad_of_who_has_it_now(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(stick_module, "_FIRST_SAMPLE_S", 0.01)
    seat = Seat()
    seat.control(ANA)
    seat.move("ana")
    seat.control(BEA)
    with pytest.raises(ConflictError, match="nothing of it arrives"):
        await seat.stick.choose_gamepad("bea", "pad")


async def test_control_that_is_told_again_is_no_news_and_leaves_the_hand_on_the_stick(seat: Seat) -> None:
    seat.control(ANA)
    assert seat.flies() == TURN
    assert (seat.holders, seat.reasons) == (["Ana"], ["chosen"])


async def test_everybody_is_told_whose_gamepad_flies_whether_it_lives_and_which_one_has_ended(seat: Seat) -> None:
    seat.flies(0.4)
    assert seat.changes == 2
    seat.stick.choose_simulator()
    ana = {"client": "ana", "name": "Ana", "gamepad": "pad"}
    assert seat.told == [
        {"source": "gamepad", "state": "live", "reason": "chosen", **ana},
        {"source": "gamepad", "state": "lost", "reason": "lost", **ana},
        {"source": "simulator", "state": None, "reason": "chosen", "client": None, "name": None, "gamepad": "pad"},
    ]
    assert seat.changes == 3, "the status is sent with each of them"
    assert seat.stick.gamepad is None
    seat.stick.choose_simulator()
    assert seat.changes == len(seat.told) == 3, "what is so already is no news"


@pytest.mark.parametrize("how", ["control kept", "page gone"])
async def test_a_hand_that_is_taken_off_the_stick_is_told_at_once(seat: Seat, how: str) -> None:
    if how == "control kept":
        seat.control(ANA, kept=True)
    else:
        seat.notice(StickRelease("ana"))
    assert seat.reasons == ["chosen", "lost"], "before anybody looks at the clock"


async def test_samples_that_come_late_or_say_nothing_are_counted_and_move_nothing(seat: Seat) -> None:
    seat.time_s += 1.0
    late = {**GLIDE._asdict(), "t_ms": (seat.time_s - 0.5) * 1000.0}
    seat.notice(StickSample("ana", late))
    seat.notice(StickSample("ana", {**late, "throttle": None}))
    assert seat.stick.counts == {"taken": 1, "late": 1, "invalid": 1}
    assert seat.flies() == LET_GO
    assert seat.reasons == ["chosen", "lost"]
