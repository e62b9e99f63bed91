"""What moves the simulator and what the board is told, as each datagram or frame comes; at times that the tests say."""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from typing import Any, cast

import pytest

from epf_gcs.bus.definition import Client
from epf_gcs.codec.encode import encode_telemetry
from epf_gcs.codec.frame import TO_BOARD, Frame, FrameDecoder
from epf_gcs.codec.messages_gen import TELEMETRY_BY_NAME
from epf_gcs.codec.values import single
from epf_gcs.contract.base import SimulatorProfile
from epf_gcs.error_log import ErrorLog
from epf_gcs.flight.hil.hil import Hil
from epf_gcs.flight.hil.stick import Stick
from epf_gcs.link.udp import UdpLink
from epf_gcs.vehicle.vehicle import Vehicle
from epf_gcs.xplane.datagram import Surfaces, surfaces_datagram
from tests.support.held import HeldClock
from tests.support.outlet import KeptOutlet
from tests.support.simulator import WHOLE
from tests.support.waiting import eventually_async

pytestmark = pytest.mark.anyio

SURFACES = Surfaces(0.25, -0.5, 0.125, 0.75)
CHANNELS = (-0.5, 0.25, 0.75, 0.125, *(0.0,) * 8)
HAND = Surfaces(-0.5, 0.3, -0.125, 0.6)
_FLAGS = TELEMETRY_BY_NAME["heartbeat"].size


def heartbeat(*, joystick: bool) -> bytes:
    return encode_telemetry("heartbeat", *(0,) * (_FLAGS - 2), 2 if joystick else 0, 0)


class Line:
    """The board's line, which keeps what is written to it."""

    baud = 115200
    backlog = 0

    def __init__(self) -> None:
        self.written: list[bytes] = []

    def write(self, data: bytes) -> bool:
        self.written.append(data)
        return True


class Socket:
    """The simulator's socket; one that is full sends nothing."""

    def __init__(self) -> None:
        self.sent: list[bytes] = []
        self.is_full = False

    def send(self, datagram: bytes) -> bool:
        if not self.is_full:
            self.sent.append(datagram)
        return not self.is_full


class Loop:
    """The HIL loop with a board that acknowledges and a simulator."""

    def __init__(self) -> None:
        self.clock, self.outlet = HeldClock(), KeptOutlet()
        self.vehicle = Vehicle(self.clock, self.outlet, ErrorLog(), lambda _: 0.02)
        self.stick = Stick(self.outlet, self.clock, lambda: None)
        self.hil = Hil(self.vehicle, self.clock, self.stick)
        self.vehicle.board.on_urgent = self.hil.on_urgent
        self.line, self.socket = Line(), Socket()
        self.begin()

    def begin(self, profile: SimulatorProfile = "xp10") -> None:
        self.hil.begin(cast(UdpLink, self.socket), profile)

    def board(self, *, joystick: bool, is_emulated: bool = False) -> None:
        self.vehicle.board.attach(self.line, is_emulated=is_emulated)
        self.says(heartbeat(joystick=joystick))
        self.says(encode_telemetry("capabilities", 1, 0, b"fake", b"1", 0))
        self.says(heartbeat(joystick=joystick))

    def says(self, frame: bytes, after_s: float = 0.0) -> None:
        self.clock.time_s += after_s
        self.vehicle.board.on_bytes(frame)
        self.vehicle.telemetry.catch_up()

    def surfaces(self, after_s: float = 0.0) -> None:
        self.says(encode_telemetry("hil_surfaces", *SURFACES), after_s)

    def flies(self, after_s: float = 0.02) -> None:
        self.clock.time_s += after_s
        assert self.hil.on_datagram(WHOLE)

    def told(self) -> list[tuple[float, ...]]:
        """What each command 50 told the board of the stick: elevator, aileron, rudder, throttle."""
        found = FrameDecoder(TO_BOARD).feed(b"".join(self.line.written[1:]))
        return [one.values[:4] for one in found if isinstance(one, Frame) and one.message.name == "xplane_info"]

    def shown(self, topic: str) -> list[Any]:
        return [values for name, _, values in self.outlet.samples if name == topic]

    async def has_shown(self, count: int) -> None:
        await eventually_async(lambda: len(self.shown("simulator")) >= count, f"{count} frames are shown")

    async def holds_gamepad(self) -> None:
        self.stick.control_changed(Client("ana", "Ana"))
        self.stick.take("ana", {**HAND._asdict(), "t_ms": self.clock.time_s * 1000.0})
        await self.stick.choose_gamepad("ana", "pad")


@pytest.mark.parametrize(
    ("source", "path", "moved_by"),
    [
        ("joystick", "manual", ["datagram"]),
        ("rc", "manual", ["channels"]),
        ("joystick", "assisted", ["surfaces"]),
        ("rc", "assisted", ["surfaces"]),
        (None, "manual", []),
    ],
)
async def test_one_hand_alone_moves_the_simulator(source: str | None, path: Any, moved_by: list[str]) -> None:
    loop = Loop()
    loop.hil.path = path
    if source is not None:
        loop.board(joystick=source == "joystick")
    by: list[str] = []
    coming: dict[str, Callable[[], None]] = {
        "datagram": loop.flies,
        "channels": lambda: loop.says(encode_telemetry("servos_in", *CHANNELS)),
        "surfaces": loop.surfaces,
    }
    for name, comes in coming.items():
        before = len(loop.socket.sent)
        comes()
        by += [name] * (len(loop.socket.sent) - before)
    assert by == moved_by
    assert loop.hil.frames_to_simulator == len(moved_by)
    assert set(loop.socket.sent) <= {surfaces_datagram(SURFACES)}


@pytest.mark.parametrize("path", ["manual", "assisted"])
async def test_what_an_emulated_board_says_or_a_gamepad_meanwhile_moves_nobody(path: Any) -> None:
    loop = Loop()
    await loop.holds_gamepad()
    loop.board(joystick=True, is_emulated=True)
    loop.hil.path = path
    written = len(loop.line.written)
    loop.surfaces()
    loop.flies()
    loop.says(heartbeat(joystick=False))
    loop.says(encode_telemetry("servos_in", *CHANNELS))
    await loop.has_shown(1)
    assert loop.socket.sent == []
    assert len(loop.line.written) == written
    assert loop.hil.last_surfaces_s is None, "the loop is not closed by examples"
    assert loop.shown("xplane_info")[-1]["elevator"] == 0.25, "the examples' own hand is shown"
    assert (loop.hil.skipped["emulation"], loop.hil.skipped["board_not_open"]) == (1, 0)


async def test_board_simulator_and_viewers_get_the_gamepads_position_as_the_wire_carries_it() -> None:
    loop = Loop()
    loop.board(joystick=True)
    await loop.holds_gamepad()
    loop.flies()
    await loop.has_shown(1)
    on_the_wire = Surfaces(*map(single, HAND))
    assert loop.told() == [on_the_wire]
    assert loop.socket.sent == [surfaces_datagram(HAND)]
    shown = loop.shown("xplane_info")[-1]
    assert {name: shown[name] for name in HAND._fields} == on_the_wire._asdict()
    assert on_the_wire != HAND


async def test_the_loops_times_are_those_of_the_newest_frames_on_either_path() -> None:
    loop = Loop()
    loop.board(joystick=True)
    first_s = None
    for path in ("manual", "assisted"):
        loop.hil.path = path
        loop.flies()
        asked_s = loop.clock.time_s
        loop.surfaces(after_s=0.005)
        assert (loop.hil.last_to_board_s, loop.hil.last_surfaces_s) == (asked_s, loop.clock.time_s)
        first_s = first_s or asked_s
        assert loop.hil.first_to_board_s == first_s
        assert loop.hil.round_trip.newest_ms == pytest.approx(5.0)
    assert loop.hil.round_trip.answers == loop.hil.frames_to_board == len(loop.told()) == 2


@pytest.mark.parametrize("how", ["begin", "rest"])
async def test_with_another_simulator_or_while_the_loop_rests_what_was_asked_and_answered_is_forgotten(
    how: str,
) -> None:
    loop = Loop()
    loop.board(joystick=True)
    loop.flies()
    loop.surfaces(after_s=0.005)
    loop.flies()
    if how == "begin":
        loop.begin()
    else:
        loop.hil.rest()
    assert loop.hil.first_to_board_s is loop.hil.last_to_board_s is loop.hil.last_surfaces_s is None
    assert loop.hil.round_trip.newest_ms is None
    loop.surfaces(after_s=0.005)
    assert loop.hil.round_trip.newest_ms is None, "an answer to a question that was forgotten is none"


async def test_what_the_earlier_simulator_said_last_is_not_shown_as_the_new_ones() -> None:
    loop = Loop()
    loop.flies()
    loop.begin("xp12")
    await asyncio.sleep(0.005)
    assert loop.outlet.samples == []
    assert loop.hil.profile == "xp12"
    for count, which in ((1, "the new one's first"), (2, "and its second")):
        loop.flies()
        await loop.has_shown(count)
        assert len(loop.shown("simulator")) == count, which
    assert loop.outlet.flushed >= 2, "and sent without waiting for the board"


async def test_only_surfaces_that_left_count_and_none_leave_once_the_socket_is_closed() -> None:
    loop = Loop()
    loop.board(joystick=True)
    loop.flies()
    loop.socket.is_full = True
    loop.flies()
    assert loop.hil.frames_to_simulator == 1
    loop.socket.is_full = False
    loop.flies()
    assert loop.hil.frames_to_simulator == 2
    loop.hil.end()
    loop.flies()
    assert (loop.hil.frames_to_simulator, len(loop.socket.sent)) == (2, 2)
