"""Commands with proof on a line where answers come late, go astray, or where the line itself goes."""

from __future__ import annotations

import asyncio
from collections.abc import Callable, Mapping
from typing import Any, Literal

import pytest

from epf_gcs.clock import Clock
from epf_gcs.codec.encode import encode_telemetry
from epf_gcs.codec.messages_gen import COMMANDS, PARAMETERS
from epf_gcs.codec.tables import Message
from epf_gcs.contract.answers import CommandOutcome
from epf_gcs.contract.events import Event
from epf_gcs.error_log import ErrorLog
from epf_gcs.errors import ConflictError, LinkError
from epf_gcs.flight.board.commands import Commands
from epf_gcs.vehicle.board import Board
from epf_gcs.vehicle.telemetry import Telemetry
from tests.support.contract import as_told
from tests.support.held import ALL_FEATURES, HEARTBEAT, HeldClock, HeldLine, open_session
from tests.support.outlet import KeptOutlet
from tests.support.waiting import eventually_async

pytestmark = pytest.mark.anyio

WITH_GPS = encode_telemetry("heartbeat", 0, 0, 0, 0, 1, *[0] * 7)


def acknowledgement(name: str, result: int = 0) -> bytes:
    return encode_telemetry("acknowledgement", COMMANDS[name].id, result)


class Told(KeptOutlet):
    """An outlet that remembers what it told of commands."""

    def __init__(self) -> None:
        super().__init__()
        self.events: list[tuple[str, str, str | None]] = []
        self.stories: list[Mapping[str, Any]] = []

    def event(self, event: Event, /) -> None:
        kind, data = as_told(event)
        if kind == "command":
            self.events.append((data["name"], data["state"], data["reason"]))
            self.stories.append(data)


class World:
    """A board that acknowledges, on a line in the test's hand."""

    def __init__(self, clock: Clock | None = None, line: HeldLine | None = None) -> None:
        clock = clock or Clock()
        self.hub = Told()
        self.errors = ErrorLog()
        self.line = line or HeldLine()
        telemetry = Telemetry(self.hub, clock, lambda _: 1.0)
        self.board = Board(clock, self.hub, telemetry, ErrorLog())
        self.commands = Commands(self.board, telemetry, self.hub, clock, self.errors)
        self.open(self.line)

    def open(self, line: HeldLine) -> None:
        self.board.attach(line)
        open_session(self.board)
        line.sent.clear()

    def says(self, data: bytes) -> None:
        self.board.on_bytes(data)

    def begins(self, name: str, *arguments: float) -> asyncio.Task[CommandOutcome]:
        return asyncio.create_task(self.commands.run(name, arguments))

    async def waits_for(self, *sent: str) -> None:
        await eventually_async(lambda: tuple(self.line.sent) == sent, f"{sent} went out, not {self.line.sent}")


async def still_waits(task: asyncio.Task[CommandOutcome]) -> bool:
    """Whether a command has no end although the loop had time enough to bring it."""
    for _ in range(10):
        await asyncio.sleep(0)
    return not task.done()


async def test_an_acknowledgement_of_a_command_that_timed_out_does_not_confirm_the_next_one_of_its_type() -> None:
    world = World()
    assert (await world.commands.run("gps_on")).state == "timed_out"
    world.line.sent.clear()
    task = world.begins("gps_on")
    await world.waits_for("capabilities", "gps_on")
    world.says(acknowledgement("gps_on"))
    assert await still_waits(task), "this one belongs to what timed out"
    world.says(acknowledgement("capabilities"))
    assert await still_waits(task), "the fence says nothing of the command"
    world.says(acknowledgement("gps_on", 2))
    assert (await task).state == "rejected"


async def test_a_retry_of_a_command_that_got_lost_is_confirmed_at_once() -> None:
    world = World()
    assert (await world.commands.run("gps_on")).state == "timed_out"
    world.line.sent.clear()
    task = world.begins("gps_on")
    await world.waits_for("capabilities", "gps_on")
    world.says(acknowledgement("capabilities") + acknowledgement("gps_on"))
    assert (await task).state == "confirmed"
    world.line.sent.clear()
    task = world.begins("gps_on")
    await world.waits_for("gps_on")
    world.says(acknowledgement("gps_on"))
    assert (await task).state == "confirmed", "nothing is owed any more"


async def test_without_an_answer_to_the_fence_nothing_is_confirmed() -> None:
    world = World()
    await world.commands.run("gps_on")
    task = world.begins("gps_on")
    await world.waits_for("gps_on", "gps_on", "capabilities", "gps_on")
    world.says(acknowledgement("gps_on"))
    assert (await task).state == "timed_out"


async def test_the_second_sending_of_a_command_leaves_one_acknowledgement_owed() -> None:
    world = World()
    task = world.begins("gps_on")
    await world.waits_for("gps_on", "gps_on")
    world.says(acknowledgement("gps_on"))
    assert (await task).state == "confirmed"
    world.line.sent.clear()
    task = world.begins("gps_on")
    await world.waits_for("capabilities", "gps_on")
    world.says(acknowledgement("gps_on") + acknowledgement("capabilities") + acknowledgement("gps_on", 1))
    assert (await task).state == "rejected"


@pytest.mark.parametrize(("older", "newer"), [("autopilot_off", "autopilot_on"), ("stop", "gps_on")])
async def test_a_lost_command_is_not_sent_again_after_a_newer_one_for_the_same_switch(older: str, newer: str) -> None:
    world = World()
    lost = world.begins(older)
    await world.waits_for(older)
    task = world.begins(newer)
    await world.waits_for(older, newer)
    world.says(acknowledgement(newer))
    assert (await task).state == "confirmed"
    assert (await lost).state == "timed_out"
    assert world.line.sent == [older, newer]


async def test_a_lost_command_is_sent_again_whatever_was_asked_of_other_switches() -> None:
    world = World()
    lost = world.begins("autopilot_off")
    await world.waits_for("autopilot_off")
    task = world.begins("autotrim_on")
    await world.waits_for("autopilot_off", "autotrim_on")
    world.says(acknowledgement("autotrim_on"))
    assert (await task).state == "confirmed"
    await world.waits_for("autopilot_off", "autotrim_on", "autopilot_off")
    world.says(acknowledgement("autopilot_off"))
    assert (await lost).state == "confirmed"


async def test_a_late_acknowledgement_that_came_between_two_commands_is_not_owed_any_more() -> None:
    world = World()
    await world.commands.run("gps_on")
    world.says(acknowledgement("gps_on") * 2)
    world.line.sent.clear()
    task = world.begins("gps_on")
    await world.waits_for("gps_on")
    world.says(acknowledgement("gps_on"))
    assert (await task).state == "confirmed"


async def test_what_the_card_owes_is_counted_for_it_answers_when_it_likes() -> None:
    world = World()
    assert (await world.commands.run("store_parameters")).state == "timed_out"
    world.line.sent.clear()
    task = world.begins("store_parameters")
    await world.waits_for("store_parameters")
    world.says(acknowledgement("store_parameters") * 2)
    assert await still_waits(task), "two were owed"
    world.says(acknowledgement("store_parameters", 4))
    assert (await task).state == "rejected"


async def test_a_link_that_is_lost_on_the_way_is_called_lost_and_at_once() -> None:
    world = World()
    task = world.begins("gps_on")
    await world.waits_for("gps_on")
    world.board.detach()
    world.commands.link_changed()
    with pytest.raises(LinkError) as lost:
        await task
    assert lost.value.code == "command_link_lost"
    assert world.hub.events == [("gps_on", "pending", None), ("gps_on", "timed_out", None)]
    assert world.line.sent == ["gps_on"], "it waited for no time-out"


async def test_a_change_of_the_links_that_leaves_the_boards_own_ends_no_command() -> None:
    world = World()
    task = world.begins("gps_on")
    await world.waits_for("gps_on")
    world.commands.link_changed()
    world.says(acknowledgement("gps_on"))
    assert (await task).state == "confirmed"


async def test_a_proof_is_not_waited_for_on_a_link_that_another_has_replaced() -> None:
    world = World()
    task = world.begins("gps_on")
    await world.waits_for("gps_on")
    world.board.detach()
    world.open(HeldLine())
    world.commands.link_changed()
    with pytest.raises(LinkError):
        await task
    assert world.hub.events == [("gps_on", "pending", None), ("gps_on", "timed_out", None)]


async def test_a_link_that_was_opened_anew_meanwhile_gets_no_second_sending() -> None:
    world = World()
    task = world.begins("gps_on")
    await world.waits_for("gps_on")
    world.board.detach()
    other = HeldLine()
    world.open(other)
    with pytest.raises(LinkError):
        await task
    assert other.sent == []


async def test_a_line_that_is_full_is_called_full_and_ends_what_began() -> None:
    world = World()
    world.line.is_full = True
    with pytest.raises(ConflictError) as full:
        await world.commands.run("gps_on")
    assert full.value.code == "board_line_full"
    assert world.hub.events == [("gps_on", "pending", None), ("gps_on", "rejected", "not_sent")]


async def test_a_line_that_is_full_at_the_second_sending_is_no_news_of_the_first() -> None:
    world = World()
    task = world.begins("gps_on")
    await world.waits_for("gps_on")
    world.line.is_full = True
    assert (await task).state == "timed_out"
    world.line.is_full = False
    world.line.sent.clear()
    world.says(acknowledgement("gps_on"))
    task = world.begins("gps_on")
    await world.waits_for("gps_on")
    world.says(acknowledgement("gps_on"))
    assert (await task).state == "confirmed", "only one was sent, and its acknowledgement came late"


@pytest.mark.parametrize("breaks", [RuntimeError("a fault of ours"), asyncio.CancelledError()])
async def test_whatever_breaks_the_proof_the_command_does_not_stay_pending(
    breaks: BaseException, monkeypatch: pytest.MonkeyPatch
) -> None:
    world = World()
    monkeypatch.setattr(world.commands, "_attempt", _raising(breaks))
    with pytest.raises(type(breaks)):
        await world.commands.run("gps_on")
    assert world.hub.events == [("gps_on", "pending", None), ("gps_on", "timed_out", None)]


async def test_a_command_is_looked_at_once_whether_it_can_be_sent(monkeypatch: pytest.MonkeyPatch) -> None:
    world = World()
    looks: list[str] = []
    check = world.commands.check_ready

    def look(command: Message) -> None:
        looks.append(command.name)
        check(command)

    monkeypatch.setattr(world.commands, "check_ready", look)
    task = world.begins("gps_on")
    await world.waits_for("gps_on")
    world.says(acknowledgement("gps_on"))
    await task
    assert looks == ["gps_on"]


def _raising(error: BaseException) -> Callable[..., Any]:
    async def attempt(*_: object, **__: object) -> None:
        raise error

    return attempt


class SlowClock(Clock):
    """A clock that a test sets."""

    def __init__(self) -> None:
        super().__init__()
        self.ahead_s = 0.0

    def steady_s(self) -> float:
        return super().steady_s() + self.ahead_s

    def now_s(self) -> float:
        return super().now_s() + self.ahead_s


class LegacyWorld(World):
    """A board that acknowledges nothing: its heartbeat shows what a command did."""

    def __init__(self, *, baud: int = 115200, heartbeat_s: float = 0.1) -> None:
        self.heartbeat_s = heartbeat_s
        self.clock = SlowClock()
        super().__init__(self.clock, HeldLine(baud))

    def open(self, line: HeldLine) -> None:
        self.board.attach(line)
        for _ in range(6):
            self.clock.ahead_s += self.heartbeat_s
            self.says(HEARTBEAT)
            self.board.tick()
        self.clock.ahead_s += 0.6
        self.board.tick()
        assert self.board.is_open
        assert not self.board.session.is_extended
        line.sent.clear()


async def test_a_command_that_the_heartbeat_proves_waits_for_a_slow_heartbeat_or_a_slow_line_and_no_longer() -> None:
    worlds = {
        "slow heartbeat": LegacyWorld(heartbeat_s=0.8),
        "slow line": LegacyWorld(baud=38400),
        "neither": LegacyWorld(baud=57600),
    }
    tasks = {name: world.begins("gps_on") for name, world in worlds.items()}
    assert (await tasks["neither"]).state == "timed_out"
    assert worlds["neither"].line.sent == ["gps_on", "gps_on"]
    for name in ("slow heartbeat", "slow line"):
        assert worlds[name].line.sent == ["gps_on"], f"{name}: it still waits for the first sending's proof"
        worlds[name].says(HEARTBEAT)
        assert await still_waits(tasks[name]), "this heartbeat does not show it"
        worlds[name].says(encode_telemetry("gps", 27.9, -15.4, 30.0, 0.0, 0.0, 0x38, 0x31, 0x41))
        worlds[name].says(WITH_GPS)
        assert (await tasks[name]).state == "confirmed"
        assert (await tasks[name]).by == "heartbeat"


def a_plan_at(waypoint: int) -> bytes:
    return encode_telemetry("fms_plan", 90.0, 500.0, 60.0, 1000, waypoint)


def gains(**changed: float) -> bytes:
    """What the board says of its gains."""
    values = {parameter.name: parameter.default for parameter in PARAMETERS} | changed
    return encode_telemetry(
        "autopilot_parameters",
        *(int(values[one.name]) if one.is_integer else float(values[one.name]) for one in PARAMETERS),
    )


async def test_only_what_was_done_is_passed_on_as_done_and_only_what_was_not_is_counted() -> None:
    world = World()
    done: list[tuple[str, tuple[float, ...]]] = []
    world.commands.on_done = lambda name, arguments: done.append((name, arguments))
    for result in (2, 0):
        world.line.sent.clear()
        task = world.begins("control_source", 1)
        await world.waits_for("control_source")
        world.says(acknowledgement("control_source", result))
        await task
    assert done == [("control_source", (1,))]
    assert world.errors.counts == {"command_rejected": 1}


async def test_viewers_can_tell_two_commands_of_one_name_apart_and_see_what_was_asked() -> None:
    world = World()
    for source in (1, 0):
        world.line.sent.clear()
        task = world.begins("control_source", source)
        await world.waits_for("control_source")
        world.says(acknowledgement("control_source"))
        await task
    told = [(story["id"], story["value"], story["state"]) for story in world.hub.stories]
    first, second = told[0][0], told[2][0]
    assert first != second
    assert told == [
        (first, [1], "pending"),
        (first, [1], "confirmed"),
        (second, [0], "pending"),
        (second, [0], "confirmed"),
    ]


async def test_of_a_quiet_command_nothing_is_told_even_where_it_cannot_be_sent() -> None:
    world = World()
    world.line.is_full = True
    with pytest.raises(ConflictError):
        await world.commands.run("gps_on", quiet=True)
    assert world.hub.events == []


async def test_a_proof_that_comes_twice_counts_once() -> None:
    world = World()
    task = world.begins("gps_on")
    await world.waits_for("gps_on")
    world.says(acknowledgement("gps_on") + acknowledgement("gps_on", 2))
    assert (await task).state == "confirmed"


async def test_a_command_s_time_is_that_from_its_sending_to_its_proof() -> None:
    clock = HeldClock()
    world = World(clock)
    task = world.begins("gps_on")
    await world.waits_for("gps_on")
    clock.time_s += 0.25
    world.says(acknowledgement("gps_on"))
    assert await task == CommandOutcome("confirmed", "acknowledgement", 250.0)


async def test_an_extended_board_that_acknowledges_nothing_proves_by_its_heartbeat() -> None:
    world = World()
    open_session(world.board, ALL_FEATURES - 1)
    task = world.begins("gps_on")
    await world.waits_for("gps_on")
    world.says(acknowledgement("gps_on"))
    assert await still_waits(task), "it never said that its acknowledgements mean anything"
    world.says(WITH_GPS)
    result = await task
    assert (result.state, result.by) == ("confirmed", "heartbeat")


async def test_a_frame_proves_the_command_that_asks_for_it_and_no_other_frame_does() -> None:
    world = LegacyWorld()
    task = world.begins("fms_plan_on")
    await world.waits_for("fms_plan_on")
    world.says(HEARTBEAT + gains())
    assert await still_waits(task)
    world.says(a_plan_at(0))
    result = await task
    assert (result.state, result.by) == ("confirmed", "read_back")


async def test_the_next_waypoint_is_proved_by_a_plan_that_moved_on() -> None:
    world = LegacyWorld()
    world.says(a_plan_at(3))
    task = world.begins("fms_next_waypoint")
    await world.waits_for("fms_next_waypoint")
    world.says(a_plan_at(3) + HEARTBEAT)
    assert await still_waits(task), "it is still the waypoint of before"
    world.says(a_plan_at(4))
    result = await task
    assert (result.state, result.by) == ("confirmed", "read_back")


async def test_where_no_plan_is_streamed_the_next_waypoint_is_only_sent() -> None:
    world = LegacyWorld()
    result = await world.commands.run("fms_next_waypoint")
    assert result == CommandOutcome("sent", "none", 0.0)
    assert world.line.sent == ["fms_next_waypoint"]


async def test_a_board_without_acknowledgements_that_kept_its_gain_is_said_to_have_refused_it() -> None:
    world = LegacyWorld()
    task = world.begins("set_k_pitch", 2.5)
    await world.waits_for("set_k_pitch", "load_autopilot_parameters")
    world.says(gains(k_roll=2.5))
    result = await task
    assert (result.state, result.by, result.reason) == ("rejected", "read_back", "not_taken")


@pytest.mark.parametrize(
    ("proof", "heartbeat_s", "baud", "patience_s"),
    [
        ("acknowledgement", 2.0, 115200, 0.6),
        ("acknowledgement", 2.0, 9600, 3.0),
        ("read_back", 2.0, 115200, 0.6),
        ("heartbeat", 0.0625, 115200, 0.6),
        ("heartbeat", 0.5, 115200, 1.5),
        ("frame", 0.5, 115200, 1.5),
        ("frame", 0.5, 9600, 3.0),
    ],
)
async def test_what_is_proved_by_what_the_board_sends_is_waited_for_three_of_its_heartbeats(
    proof: Literal["acknowledgement", "heartbeat", "frame", "read_back"],
    heartbeat_s: float,
    baud: int,
    patience_s: float,
) -> None:
    world = LegacyWorld(baud=baud, heartbeat_s=heartbeat_s)
    assert world.commands._patience_s(proof) == pytest.approx(patience_s, rel=0.01)
