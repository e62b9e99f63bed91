"""A ground station of others (pymavlink) over UDP: what it sees of a station, and what it gets for what it asks."""

from __future__ import annotations

import asyncio
import socket
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any, Self

import pytest

from epf_gcs.codec.messages_gen import ROUTES
from epf_gcs.mavlink.choice import Aircraft, Choice
from epf_gcs.mavlink.dialect import WIRE
from epf_gcs.mavlink.plan_items import items_of
from epf_gcs.mavlink.program import Ports, serve
from tests.support.fake_board import FakeBoard
from tests.support.gateway import Gateway
from tests.support.waiting import DEADLINE_S, eventually, first_of

GANDO = list(ROUTES["gando"].waypoints)
SET_MODE = WIRE.MAV_CMD_DO_SET_MODE


class GroundStation:
    """Hears one vehicle and asks it. `copies`: how often each of its datagrams arrives."""

    def __init__(self, system: int = 255) -> None:
        self._socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self._socket.bind(("127.0.0.1", 0))
        self._socket.settimeout(DEADLINE_S)
        self.port: int = self._socket.getsockname()[1]
        self.copies = 1
        self.make = WIRE.MAVLink(None, system, 190)
        self._address: tuple[str, int] | None = None
        self.texts: list[str] = []

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self._socket.close()

    def meet(self, other: GroundStation) -> None:
        """Speak with the vehicle that another one knows."""
        other.next("HEARTBEAT")
        self._address = other._address
        self.say(self.make.heartbeat_encode(WIRE.MAV_TYPE_GCS, WIRE.MAV_AUTOPILOT_INVALID, 0, 0, 4))

    def say(self, message: Any) -> None:
        """Send a message."""
        assert self._address is not None, "hear it first"
        data = bytes(message.pack(self.make))
        self.make.seq = (self.make.seq + 1) % 256
        for _ in range(self.copies):
            self._socket.sendto(data, self._address)

    def next(self, *kinds: str) -> Any:
        """The next message of one of these kinds."""
        return first_of(self._receive, lambda message: message if message.get_type() in kinds else None, str(kinds))

    def command(self, command: int, *params: float, confirmation: int = 0) -> int:
        """The result of a command."""
        given = [*params, *[0.0] * (7 - len(params))]
        self.say(self.make.command_long_encode(1, 1, command, confirmation, *given))
        ack = self.next("COMMAND_ACK")
        assert ack.command == command
        return int(ack.result)

    def plan(self) -> list[Any]:
        """The plan, item by item."""
        self.say(self.make.mission_request_list_encode(1, 1))
        items = []
        for number in range(self.next("MISSION_COUNT").count):
            self.say(self.make.mission_request_int_encode(1, 1, number))
            items.append(self.next("MISSION_ITEM_INT"))
        return items

    def send_plan(self, items: list[Any]) -> int:
        """The result of sending a plan."""
        self.say(self.make.mission_count_encode(1, 1, len(items)))
        while (asked := self.next("MISSION_REQUEST_INT", "MISSION_ACK")).get_type() == "MISSION_REQUEST_INT":
            self.say(items[asked.seq])
        return int(asked.type)

    def _receive(self) -> Any:
        while True:
            data, self._address = self._socket.recvfrom(65536)
            for message in self.make.parse_buffer(data) or ():
                if message.get_type() == "STATUSTEXT":
                    self.texts.append(message.text)
                return message


@contextmanager
def bridge(gateway: Gateway, ground: GroundStation, aircraft: Aircraft = "hil", **chosen: Any) -> Iterator[None]:
    """The program in a thread."""
    loop = asyncio.new_event_loop()
    serving = loop.create_task(
        serve(
            gateway.base,
            None,
            Choice(aircraft, usual_speed_kt=chosen.get("speed_kt")),
            Ports(("127.0.0.1", ground.port)),
        )
    )
    thread = threading.Thread(target=lambda: loop.run_until_complete(asyncio.wait([serving])), daemon=True)
    thread.start()
    try:
        yield
    finally:
        loop.call_soon_threadsafe(serving.cancel)
        thread.join(DEADLINE_S)
        loop.close()


@pytest.fixture
def ground(gateway: Gateway, board: FakeBoard) -> Iterator[GroundStation]:
    """A ground station that hears the board's HIL aircraft."""
    gateway.open_board(board.url)
    with GroundStation() as station, bridge(gateway, station):
        station.next("HEARTBEAT")
        yield station


def test_all_gains_are_read_and_one_is_written_with_the_boards_own_answer(
    ground: GroundStation, board: FakeBoard
) -> None:
    ground.say(ground.make.param_request_list_encode(1, 1))
    gains = [ground.next("PARAM_VALUE") for _ in range(17)]
    assert [gain.param_index for gain in gains] == list(range(17))
    assert {gain.param_id: gain.param_value for gain in gains} == pytest.approx(board.gains)
    ground.say(ground.make.param_set_encode(1, 1, b"k_roll", 2.4, WIRE.MAV_PARAM_TYPE_REAL32))
    answer = ground.next("PARAM_VALUE")
    assert (answer.param_id, answer.param_value) == ("k_roll", pytest.approx(2.4))
    assert board.gains["k_roll"] == pytest.approx(2.4)
    ground.say(ground.make.param_request_read_encode(1, 1, b"", 3))
    assert ground.next("PARAM_VALUE").param_id == gains[3].param_id


def test_a_gain_that_the_board_refuses_is_answered_with_what_it_has(ground: GroundStation, board: FakeBoard) -> None:
    board.refuse["set_k_roll"] = 1
    for value in (2.4, 1e9):
        ground.say(ground.make.param_set_encode(1, 1, b"k_roll", value, WIRE.MAV_PARAM_TYPE_REAL32))
        assert ground.next("PARAM_VALUE").param_value == pytest.approx(2.0)
    ground.next("STATUSTEXT")
    assert "k_roll" in " ".join(ground.texts)


def test_a_gain_is_written_once_although_its_datagram_comes_twice(ground: GroundStation, board: FakeBoard) -> None:
    ground.copies = 2
    ground.say(ground.make.param_set_encode(1, 1, b"k_roll", 2.4, WIRE.MAV_PARAM_TYPE_REAL32))
    ground.next("PARAM_VALUE")
    ground.say(ground.make.param_set_encode(1, 1, b"k_roll", 2.4, WIRE.MAV_PARAM_TYPE_REAL32))
    ground.next("PARAM_VALUE")
    assert board.count("set_k_roll") == 1


def test_a_plan_goes_down_and_comes_back_as_it_was(ground: GroundStation, board: FakeBoard) -> None:
    items = items_of(GANDO, None).items
    assert ground.send_plan(list(items)) == WIRE.MAV_MISSION_ACCEPTED
    assert len(board.plans[1]) == len(GANDO)
    back = ground.plan()
    assert [(item.command, item.frame, item.x, item.y) for item in back] == [
        (item.command, item.frame, item.x, item.y) for item in items
    ]
    assert [item.z for item in back] == pytest.approx([item.z for item in items], abs=1e-3)


def test_a_plan_that_the_board_cannot_fly_changes_nothing(ground: GroundStation, board: FakeBoard) -> None:
    (item,) = items_of(GANDO[:1], GANDO[0].speed_kt).items
    assert ground.send_plan([item]) == WIRE.MAV_MISSION_INVALID
    assert board.plans[1] == []


def test_two_stations_do_not_mix_their_plans(ground: GroundStation, board: FakeBoard) -> None:
    items = list(items_of(GANDO, None).items)
    with GroundStation(system=254) as second:
        second.meet(ground)
        ground.say(ground.make.mission_count_encode(1, 1, len(items)))
        ground.next("MISSION_REQUEST_INT")
        second.say(second.make.mission_count_encode(1, 1, 2))
        assert second.next("MISSION_ACK").type == WIRE.MAV_MISSION_DENIED
        ground.say(items[0])
        assert ground.next("MISSION_REQUEST_INT").seq == 1
        assert ground.send_plan(items) == WIRE.MAV_MISSION_ACCEPTED
        assert len(second.plan()) == len(items)
    assert len(board.plans[1]) == len(GANDO)


def test_a_mode_is_accepted_when_the_board_has_it(ground: GroundStation, board: FakeBoard) -> None:
    assert ground.command(SET_MODE, 1, 2) == WIRE.MAV_RESULT_ACCEPTED
    assert board.flags["autopilot_hil"] == 1
    first_of(lambda: ground.next("HEARTBEAT"), lambda told: told.custom_mode == 2 or None, "mode autopilot")
    board.refuse["autopilot_off"] = 2
    assert ground.command(SET_MODE, 1, 1) == WIRE.MAV_RESULT_FAILED
    assert ground.command(SET_MODE, 1, 9) == WIRE.MAV_RESULT_DENIED


def test_a_repeated_command_is_run_once(ground: GroundStation, board: FakeBoard) -> None:
    assert ground.command(SET_MODE, 1, 2) == WIRE.MAV_RESULT_ACCEPTED
    for confirmation in (1, 2):
        assert ground.command(SET_MODE, 1, 2, confirmation=confirmation) == WIRE.MAV_RESULT_ACCEPTED
    assert board.count("autopilot_on") == 1


@pytest.mark.parametrize("command", [WIRE.MAV_CMD_COMPONENT_ARM_DISARM, WIRE.MAV_CMD_NAV_TAKEOFF, 60_000])
def test_a_command_that_the_board_does_not_have_is_unsupported(ground: GroundStation, command: int) -> None:
    assert ground.command(command, 1) == WIRE.MAV_RESULT_UNSUPPORTED


def test_its_modes_are_told_with_their_names(ground: GroundStation) -> None:
    ground.say(ground.make.command_long_encode(1, 1, WIRE.MAV_CMD_REQUEST_MESSAGE, 0, 435, 0, 0, 0, 0, 0, 0))
    modes = [ground.next("AVAILABLE_MODES") for _ in range(3)]
    assert [(mode.custom_mode, mode.mode_name) for mode in modes] == [(0, "Manual"), (1, "Assisted"), (2, "Autopilot")]


def test_while_another_has_control_nothing_is_commanded_and_the_holder_is_asked(
    ground: GroundStation, gateway: Gateway, board: FakeBoard
) -> None:
    with gateway.stream() as page:
        body = {"client": page.hello["client"], "action": "take"}
        gateway.http.post("/control", json=body).raise_for_status()
        assert ground.command(SET_MODE, 1, 2) == WIRE.MAV_RESULT_TEMPORARILY_REJECTED
        assert board.count("autopilot_on") == 0
        ground.say(ground.make.param_set_encode(1, 1, b"k_roll", 2.4, WIRE.MAV_PARAM_TYPE_REAL32))
        asked = page.event("control_request")
        assert asked["name"].startswith("epf-mavlink")


def test_a_board_that_is_gone_has_no_heartbeat(ground: GroundStation, gateway: Gateway, board: FakeBoard) -> None:
    gateway.http.delete("/links/board").raise_for_status()
    eventually(lambda: gateway.status()["board"]["state"] == "closed", "the line is closed")
    gateway.open_board(board.url)
    ground.next("HEARTBEAT")


def test_the_real_aircrafts_mode_is_its_transmitters(gateway: Gateway, board: FakeBoard) -> None:
    gateway.open_board(board.url)
    gateway.http.post("/commands/ahrs_on").raise_for_status()
    with GroundStation() as station, bridge(gateway, station, "flight"):
        attitude = station.next("ATTITUDE")
        assert attitude.roll == pytest.approx(-3.0 * 3.14159265 / 180)
        assert station.command(SET_MODE, 1, 2) == WIRE.MAV_RESULT_DENIED


def test_what_this_vehicle_said_itself_comes_back_without_effect(ground: GroundStation, board: FakeBoard) -> None:
    ours = WIRE.MAVLink(None, 1, 1)
    looped = GroundStation(system=1)
    with looped:
        looped.make = ours
        looped._address = ground._address
        looped.say(ours.param_set_encode(1, 1, b"k_roll", 9.0, WIRE.MAV_PARAM_TYPE_REAL32))
    ground.say(ground.make.param_request_read_encode(1, 1, b"k_roll", -1))
    assert ground.next("PARAM_VALUE").param_value == 2.0
