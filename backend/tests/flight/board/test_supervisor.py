"""The state of the board's link and the identity of its device, on a line in the test's hand."""

from __future__ import annotations

import asyncio

import pytest

from epf_gcs.error_log import ErrorLog
from epf_gcs.errors import LinkError
from epf_gcs.flight.board.board_link import Supervisor
from epf_gcs.flight.clock.line_clock import LineClock
from epf_gcs.link.address import EMULATION, LinkAddress, parse_address
from epf_gcs.link.base import Link, LinkCallbacks
from epf_gcs.recordings.topics import BOARD_RECEIVED
from epf_gcs.vehicle.vehicle import Vehicle
from tests.support.held import HEARTBEAT, HeldLine, open_session
from tests.support.outlet import KeptOutlet
from tests.support.waiting import eventually_async

pytestmark = pytest.mark.anyio

SERIAL = parse_address("serial:///dev/ttyUSB0")
TCP = parse_address("tcp://h:1")


class Tap:
    """A recorder that keeps nothing."""

    def received(self, data: bytes, ago_s: float = 0.0) -> None: ...

    def sent(self, data: bytes) -> None: ...


class User:
    """Has the line for itself."""

    def on_bytes(self, data: bytes) -> None: ...

    def on_line_released(self) -> bytes:
        return b""


class AheadClock(LineClock):
    """A test sets how far it is ahead."""

    ahead_s = 0.0

    def steady_s(self) -> float:
        return super().steady_s() + self.ahead_s


class World:
    """A supervisor whose links are lines in the test's hand."""

    def __init__(self) -> None:
        self.clock = AheadClock()
        self.outlet = KeptOutlet()
        self.errors = ErrorLog()
        self.tap = Tap()
        self.board = Vehicle(self.clock, self.outlet, self.errors, lambda _: 1.0).board
        self.lines: list[HeldLine] = []
        self.opened: list[LinkAddress] = []
        self.identities: list[str | None] = []
        self.supervisor = Supervisor(
            self.board,
            self.clock,
            self.tap,
            report=self.errors.report,
            on_change=self._changed,
            may_wait=lambda: True,
            open_link=self._open,
        )
        self.finds("usb-1", None)

    def finds(self, identity: str | None, path: str | None) -> None:
        self.supervisor.find_devices_by(lambda _: identity, lambda _: path)

    @property
    def state(self) -> str:
        return self.supervisor.state

    @property
    def identity(self) -> str | None:
        return self.supervisor.identity

    @property
    def callbacks(self) -> LinkCallbacks:
        found = self.lines[-1].callbacks
        assert found is not None
        return found

    def _changed(self) -> None:
        self.identities.append(self.supervisor.identity)

    async def _open(self, address: LinkAddress) -> Link:
        self.opened.append(address)
        self.lines.append(HeldLine())
        return self.lines[-1]


async def test_a_link_is_open_once_its_board_answers_and_lost_once_it_stops() -> None:
    world = World()
    seen = [world.state]
    world.supervisor.want(TCP, None)
    seen.append(world.state)
    await world.supervisor.open(TCP)
    seen.append(world.state)
    open_session(world.board)
    seen.append(world.state)
    world.clock.ahead_s += 3.5
    world.board.tick()
    seen.append(world.state)
    open_session(world.board)
    seen.append(world.state)
    world.callbacks.on_lost(LinkError("link_lost", "The cable is out."))
    seen.append(world.state)
    assert seen == ["closed", "opening", "opening", "open", "lost", "open", "lost"]
    assert world.board.link is None
    assert world.errors.counts == {"link_lost": 1}


async def test_a_link_that_the_ahrs_test_has_is_open() -> None:
    world = World()
    await world.supervisor.open(TCP)
    open_session(world.board)
    world.board.acquire_line(User())
    assert world.state == "open"


async def test_a_link_that_is_closed_is_left_quiet_and_names_no_device_any_more() -> None:
    world = World()
    await world.supervisor.open(SERIAL)
    open_session(world.board)
    line = world.lines[0]
    line.sent.clear()
    named = [world.identity]
    await world.supervisor.close()
    assert line.sent == ["stop", "exit_binary_mode"]
    assert line.is_closed
    assert world.board.link is None
    assert world.state == "closed"
    assert [*named, world.identity] == ["usb-1", None]


async def test_the_device_of_another_link_is_not_taken_for_that_of_this_one() -> None:
    world = World()
    await world.supervisor.open(SERIAL)
    assert world.identities[-1] == "usb-1", "who looks at the links hears of the device"
    await world.supervisor.open(TCP)
    assert world.supervisor.identity is None


async def test_a_device_that_cannot_be_asked_who_it_is_is_used_all_the_same() -> None:
    def refuse(_: str) -> str:
        raise PermissionError

    world = World()
    world.supervisor.find_devices_by(refuse, lambda _: None)
    await world.supervisor.open(SERIAL)
    open_session(world.board)
    assert (world.state, world.supervisor.identity) == ("open", None)


@pytest.mark.parametrize(
    ("wanted", "identity", "path", "opened"),
    [
        (SERIAL, "usb-1", "/dev/ttyUSB7", "serial:///dev/ttyUSB7?baud=115200"),
        (SERIAL, "usb-1", None, SERIAL.url),
        (SERIAL, None, "/dev/ttyUSB7", SERIAL.url),
        (TCP, "usb-1", "/dev/ttyUSB7", TCP.url),
    ],
)
async def test_a_wanted_device_is_opened_where_it_is_found_and_else_under_its_name(
    wanted: LinkAddress, identity: str | None, path: str | None, opened: str
) -> None:
    world = World()
    world.finds(identity, path)
    world.supervisor.want(wanted, identity)
    task = asyncio.create_task(world.supervisor.run())
    await eventually_async(lambda: bool(world.lines), "it is opened")
    task.cancel()
    assert [address.url for address in world.opened] == [opened]


async def test_the_emulation_is_never_recorded_and_its_values_have_the_present_time() -> None:
    world = World()
    await world.supervisor.open(SERIAL)
    taps = [world.callbacks.tap]
    long_ago_ns = world.clock.received(BOARD_RECEIVED, ago_s=3600.0)
    world.callbacks.on_bytes(HEARTBEAT)
    await world.supervisor.open(EMULATION)
    taps.append(world.callbacks.tap)
    world.callbacks.on_bytes(HEARTBEAT)
    assert taps == [world.tap, None]
    times_s = [t_s for topic, t_s, _ in world.outlet.samples if topic == "heartbeat"]
    assert times_s[0] == pytest.approx(long_ago_ns * 1e-9)
    assert times_s[-1] > times_s[0] + 3000.0
    assert world.board.is_emulated


async def test_who_waits_for_an_answer_first_gets_what_the_line_holds_back() -> None:
    world = World()
    await world.supervisor.open(TCP)
    before = world.lines[0].delivered
    with world.board.listening(lambda _frame, _meant: None):
        assert world.lines[0].delivered == before + 1
