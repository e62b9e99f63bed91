"""A browser's gamepad in the place of the simulator's joystick: who may, what flies, and what flies when it is lost."""

from __future__ import annotations

import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

import orjson
import pytest
from websockets.exceptions import ConnectionClosed

from epf_gcs.access.roles import Role
from epf_gcs.xplane.datagram import Surfaces, surfaces_datagram
from tests.support.callers import program
from tests.support.fake_board import FakeBoard
from tests.support.gateway import Gateway, Stream
from tests.support.page import Page, page
from tests.support.ports import free_udp_port
from tests.support.simulator import ROWS, WHOLE, Simulator
from tests.support.waiting import eventually

TURN = Surfaces(-0.5, 0.25, -0.125, 0.5)
LET_GO = Surfaces(0.0, 0.0, 0.0, 0.5)
GLIDE = Surfaces(0.0, 0.0, 0.0, 0.0)
ROWS_STICK = Surfaces(*ROWS[8][:3], ROWS[25][0])


@pytest.fixture
def simulator(gateway: Gateway, board: FakeBoard) -> Iterator[Simulator]:
    """Everything is open, the joystick is the source and goes straight to the simulator."""
    gateway.open_board(board.url)
    with Simulator() as end:
        end.port = free_udp_port()
        link = {"receive_port": end.port, "send_host": "127.0.0.1", "send_port": end.own_port}
        gateway.http.put("/links/simulator", json=link).raise_for_status()
        gateway.http.put("/hil", json={"source": "joystick", "path": "manual"}).raise_for_status()
        yield end


def sample(position: Surfaces, **others: Any) -> dict[str, Any]:
    return {"type": "stick", **position._asdict(), "t_ms": time.monotonic() * 1000.0, **others}


@contextmanager
def hand_on(stream: Stream | Page, position: Surfaces) -> Iterator[None]:
    """A gamepad that is held in this position, as a page sends it."""
    stop = threading.Event()

    def hold() -> None:
        try:
            while not stop.wait(0.02):
                stream.send(sample(position))
        except ConnectionClosed:
            pass

    thread = threading.Thread(target=hold, name="hand", daemon=True)
    thread.start()
    try:
        yield
    finally:
        stop.set()
        thread.join()


def choose(gateway: Gateway, stream: Stream, stick: str = "gamepad") -> dict[str, Any]:
    answer = gateway.http.put(
        "/hil", json={"stick": stick, "gamepad": "Test Pad"}, headers={"X-Client": stream.hello["client"]}
    )
    body: dict[str, Any] = answer.json()
    return body


def flies(simulator: Simulator, board: FakeBoard, position: Surfaces) -> bool:
    """What the board was told last, and what moved the simulator last, is this position; one more frame is sent."""
    told = [
        values
        for name, values in zip(board.received, board.arguments, strict=False)
        if name == "xplane_info" and len(values) == 15
    ]
    simulator.heard(None)
    moved = bool(simulator.got) and simulator.got[-1] == surfaces_datagram(position)
    simulator.send(WHOLE)
    return moved and bool(told) and told[-1][:4] == position


def stands(gateway: Gateway, alarm_id: str) -> bool:
    """Whether this alarm is on now; the rows that a test sends may raise others."""
    return any(alarm["id"] == alarm_id and alarm["until_s"] is None for alarm in gateway.status()["alarms"])


def test_the_gamepad_takes_the_place_of_the_simulators_stick_for_board_and_simulator(
    gateway: Gateway, board: FakeBoard, simulator: Simulator
) -> None:
    with gateway.stream("?name=Tower") as stream, gateway.stream() as other:
        eventually(lambda: flies(simulator, board, ROWS_STICK), "the rows fly first")
        with hand_on(stream, TURN):
            chosen = choose(gateway, stream)["stick"]
            assert (chosen["source"], chosen["state"]) == ("gamepad", "live")
            assert (chosen["name"], chosen["gamepad"]) == ("Tower", "Test Pad")
            eventually(lambda: flies(simulator, board, TURN), "the gamepad flies")
            assert other.event("stick")["source"] == "gamepad"
            while other.sample("xplane_info")["aileron"] != 0.25:
                pass  # a frame from before may still come with the event
            choose(gateway, stream, "simulator")
            eventually(lambda: flies(simulator, board, ROWS_STICK), "the rows fly again")


def test_a_gamepad_that_falls_silent_lets_the_stick_go_then_closes_the_throttle_and_is_an_alarm_until_it_is_back(
    gateway: Gateway, board: FakeBoard, simulator: Simulator
) -> None:
    with gateway.stream() as stream, gateway.stream() as other:
        with hand_on(stream, TURN):
            choose(gateway, stream)
            eventually(lambda: flies(simulator, board, TURN), "the gamepad flies")
        eventually(lambda: flies(simulator, board, LET_GO), "the stick is let go")
        assert other.event("stick")["reason"] == "chosen"
        assert other.event("stick")["reason"] == "lost"
        eventually(lambda: "stick_lost" in [alarm["id"] for alarm in gateway.status()["alarms"]], "an alarm")
        assert gateway.status()["hil"]["stick"]["state"] == "lost"
        eventually(lambda: flies(simulator, board, GLIDE), "the throttle is closed")
        with hand_on(stream, TURN):
            eventually(lambda: flies(simulator, board, TURN), "it flies again")
            eventually(lambda: not stands(gateway, "stick_lost"), "the alarm goes")
        assert other.event("stick")["reason"] == "back"


def test_a_page_that_is_closed_leaves_no_hand_on_the_stick(
    gateway: Gateway, board: FakeBoard, simulator: Simulator
) -> None:
    with gateway.stream() as stream, hand_on(stream, TURN):
        choose(gateway, stream)
        eventually(lambda: flies(simulator, board, TURN), "the gamepad flies")
        stream.connection.close()
        eventually(lambda: flies(simulator, board, LET_GO), "the stick is let go")


def test_a_page_that_is_loaded_again_flies_on_with_its_gamepad(
    gateway: Gateway, board: FakeBoard, simulator: Simulator
) -> None:
    with gateway.stream() as other:
        with gateway.stream() as stream, hand_on(stream, TURN):
            gateway.http.post(
                "/control", json={"client": other.hello["client"], "action": "release"}
            ).raise_for_status()
            gateway.http.post("/control", json={"client": stream.hello["client"], "action": "take"}).raise_for_status()
            choose(gateway, stream)
            eventually(lambda: flies(simulator, board, TURN), "the gamepad flies")
        eventually(lambda: flies(simulator, board, LET_GO), "the stick is let go")
        with gateway.stream(f"?client={stream.hello['client']}") as again, hand_on(again, TURN):
            assert again.hello["has_control"]
            eventually(lambda: flies(simulator, board, TURN), "it flies again")
        assert [other.event("stick")["reason"] for _ in range(3)] == ["chosen", "lost", "back"]


def test_who_loses_control_loses_the_stick_and_the_simulators_rows_fly(
    gateway: Gateway, board: FakeBoard, simulator: Simulator
) -> None:
    with gateway.stream() as stream, gateway.stream() as other, hand_on(stream, TURN):
        choose(gateway, stream)
        eventually(lambda: flies(simulator, board, TURN), "the gamepad flies")
        for one, action in ((stream, "release"), (other, "take")):
            gateway.http.post("/control", json={"client": one.hello["client"], "action": action}).raise_for_status()
        eventually(lambda: flies(simulator, board, ROWS_STICK), "the rows fly")
        assert other.event("stick")["reason"] == "chosen"
        end = other.event("stick")
        assert (end["reason"], end["source"], end["gamepad"]) == ("control_lost", "simulator", "Test Pad")
        with hand_on(other, GLIDE):
            assert choose(gateway, other)["stick"]["client"] == other.hello["client"]
            eventually(lambda: flies(simulator, board, GLIDE), "the new operator's gamepad flies")
        eventually(
            lambda: gateway.status()["hil"]["stick"]["samples"]["not_operator"] > 0, "the old one's do not count"
        )


def test_a_pilot_that_an_owner_puts_out_lets_the_stick_go_as_if_the_network_had(
    gateway: Gateway, board: FakeBoard, simulator: Simulator
) -> None:
    pilot, key, program_id = program(gateway, Role.operator, gateway.http, "Pilot")
    with gateway.stream() as owner, pilot, page(gateway.base, key=key) as stream, hand_on(stream, TURN):
        gateway.http.post("/control", json={"client": owner.hello["client"], "action": "release"}).raise_for_status()
        stream.act("take").raise_for_status()
        stream.http.put("/hil", json={"stick": "gamepad", "gamepad": "Test Pad"}).raise_for_status()
        eventually(lambda: flies(simulator, board, TURN), "the gamepad flies")
        gateway.http.delete(f"/access/programs/{program_id}").raise_for_status()
        eventually(lambda: flies(simulator, board, LET_GO), "the stick is let go")
        assert gateway.status()["control"]["client"] is None
        eventually(lambda: flies(simulator, board, GLIDE), "the throttle is closed")
        eventually(lambda: flies(simulator, board, ROWS_STICK), "and the simulator's own stick flies on")
        assert [owner.event("stick")["reason"] for _ in range(3)] == ["chosen", "lost", "control_lost"]


def test_only_the_page_that_has_control_may_choose_and_only_with_a_gamepad_that_speaks(gateway: Gateway) -> None:
    with gateway.stream() as stream, gateway.stream() as other:
        assert choose(gateway, other)["code"] == "control_held"
        assert choose(gateway, stream)["code"] == "stick_silent"
        with hand_on(other, TURN):
            assert choose(gateway, stream)["code"] == "stick_silent"
        gateway.http.post("/control", json={"client": stream.hello["client"], "action": "release"})
        with hand_on(stream, TURN):
            assert choose(gateway, stream)["code"] == "stick_needs_control"
        assert gateway.status()["hil"]["stick"]["source"] == "simulator"


@pytest.mark.parametrize(
    "wrong",
    [{"aileron": None}, {"throttle": "full"}, {"rudder": True}, {"t_ms": []}, {"t_ms": 1e300}],
    ids=["nothing", "word", "flag", "list", "endless"],
)
def test_a_sample_that_is_none_is_answered_counted_and_not_used(gateway: Gateway, wrong: dict[str, Any]) -> None:
    with gateway.stream() as stream:
        stream.send(sample(TURN, **wrong))
        error = stream.event("error")
        assert error["code"] == "stick_invalid"
        assert error["detail"].endswith(".")
        status = gateway.status()
        assert status["errors"] == {"stick_invalid": 1}
        assert status["hil"]["stick"]["samples"] == {"invalid": 1}


def test_a_sample_without_a_position_is_answered_and_counted(gateway: Gateway) -> None:
    with gateway.stream() as stream:
        stream.send({"type": "stick"})
        assert stream.event("error")["code"] == "stick_invalid"
        assert gateway.status()["errors"] == {"stick_invalid": 1}


@pytest.mark.parametrize("number", ["NaN", "Infinity", "-Infinity", "1e999"])
def test_a_position_that_is_not_finite_is_counted_and_not_used(gateway: Gateway, number: str) -> None:
    with gateway.stream() as stream:
        stream.connection.send(orjson.dumps(sample(TURN, elevator=7)).decode().replace("7", number, 1))
        assert stream.event("error")["code"] in ("stick_invalid", "stream_message_invalid")
        assert "taken" not in gateway.status()["hil"]["stick"]["samples"]


def test_a_stick_beyond_its_end_is_at_its_end(gateway: Gateway, board: FakeBoard, simulator: Simulator) -> None:
    with gateway.stream() as stream, hand_on(stream, Surfaces(-9.0, 1.5, 3, -0.5)):
        choose(gateway, stream)
        eventually(lambda: flies(simulator, board, Surfaces(-1.0, 1.0, 1.0, 0.0)), "it is clamped")
