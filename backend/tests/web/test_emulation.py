"""The emulation: everything to look at, nothing to command, and the former link comes back."""

from __future__ import annotations

import socket
from pathlib import Path
from typing import Any

import orjson
import pytest

from epf_gcs.codec.messages_gen import TELEMETRY
from tests.support.fake_board import FakeBoard
from tests.support.gateway import Gateway, running_gateway
from tests.support.waiting import eventually

TOPICS = {message.name for message in TELEMETRY.values() if message.topic} | {
    "simulator",
    "xplane_info",
    "xplane_rows",
}


def emulate(gateway: Gateway) -> dict[str, Any]:
    gateway.open_board("emulation:")
    board: dict[str, Any] = gateway.status()["board"]
    return board


def live_topics(gateway: Gateway) -> set[str]:
    return {name for name, sample in gateway.http.get("/telemetry").json().items() if not sample["stale"]}


def test_every_topic_is_live_and_marked_as_emulated(gateway: Gateway) -> None:
    assert gateway.status()["board"]["emulated"] is False
    board = emulate(gateway)
    assert (board["emulated"], board["url"], board["before_emulation_url"]) == (True, "emulation:", None)
    eventually(lambda: live_topics(gateway) == TOPICS, "all topics are live")
    status = gateway.status()
    assert status["board"]["frames_damaged"] == 0
    assert all(not topic["implausible"] for topic in status["topics"].values())
    assert status["simulator"]["state"] == "closed"
    assert status["alarms"] == []
    heartbeat = gateway.http.get("/telemetry").json()["heartbeat"]["values"]
    assert all(value in (True, False) for value in heartbeat.values())
    assert heartbeat["ahrs"] is True


def test_values_move(gateway: Gateway) -> None:
    emulate(gateway)
    with gateway.stream() as stream:
        first = stream.sample("ahrs")["yaw_deg"]
        eventually(lambda: stream.sample("ahrs")["yaw_deg"] != first, "the heading changes")


@pytest.mark.parametrize(
    ("method", "path", "body"),
    [
        ("POST", "/commands/ahrs_off", {}),
        ("POST", "/commands/reset", {}),
        ("POST", "/commands/servo_out", {"value": [3, 0.5]}),
        ("POST", "/parameters/load", {}),
        ("PATCH", "/parameters", {"k_pitch": 2.5}),
        ("POST", "/parameters/store", {}),
        ("GET", "/missions/flight", None),
        ("PUT", "/hil", {"source": "joystick"}),
        ("PUT", "/hil", {"path": "assisted"}),
        ("POST", "/console", {"text": "help"}),
    ],
)
def test_nothing_can_be_commanded(gateway: Gateway, method: str, path: str, body: dict[str, Any] | None) -> None:
    emulate(gateway)
    answer = gateway.http.request(method, path, json=body)
    assert (answer.status_code, answer.json()["code"]) == (409, "emulation_running")
    assert gateway.http.get("/hil").json()["path"] == "manual"


def test_the_simulators_stick_can_be_taken_back_all_the_same(gateway: Gateway) -> None:
    emulate(gateway)
    assert gateway.http.put("/hil", json={"stick": "simulator"}).status_code == 200
    for more in ({"source": "joystick"}, {"path": "manual"}):
        answer = gateway.http.put("/hil", json={"stick": "simulator"} | more)
        assert (answer.status_code, answer.json()["code"]) == (409, "emulation_running")


def test_closing_it_gives_back_the_link_that_was_open(gateway: Gateway, board: FakeBoard) -> None:
    gateway.open_board(board.url)
    gateway.http.post("/commands/ahrs_on").raise_for_status()
    assert emulate(gateway)["before_emulation_url"] == board.url
    eventually(lambda: not board.in_binary_mode, "the board was left quiet")
    gateway.http.delete("/links/board").raise_for_status()
    eventually(lambda: gateway.status()["board"]["state"] == "open", "the board is open again")
    after = gateway.status()["board"]
    assert (after["url"], after["emulated"], after["before_emulation_url"]) == (board.url, False, None)
    eventually(lambda: board.flags["ahrs"] == 1, "what was asked of the board is asked again")


def test_the_former_link_can_be_opened_in_its_place(gateway: Gateway, board: FakeBoard) -> None:
    gateway.open_board(board.url)
    former = emulate(gateway)["before_emulation_url"]
    gateway.open_board(former)
    after = gateway.status()["board"]
    assert (after["url"], after["emulated"], after["before_emulation_url"]) == (board.url, False, None)


def test_a_link_that_cannot_be_opened_leaves_the_emulation(gateway: Gateway, board: FakeBoard) -> None:
    gateway.open_board(board.url)
    emulate(gateway)
    assert gateway.http.put("/links/board", json={"url": "tcp://127.0.0.1:1"}).status_code == 409
    assert gateway.status()["board"]["emulated"] is True
    assert gateway.status()["board"]["before_emulation_url"] == board.url


def test_opened_twice_it_still_knows_what_was_before(gateway: Gateway, board: FakeBoard) -> None:
    gateway.open_board(board.url)
    emulate(gateway)
    assert emulate(gateway)["before_emulation_url"] == board.url


def test_no_example_value_stays_when_it_is_over(gateway: Gateway) -> None:
    emulate(gateway)
    eventually(lambda: live_topics(gateway) == TOPICS, "all topics are live")
    with gateway.stream() as stream:
        gateway.http.delete("/links/board", headers={"X-Client": stream.hello["client"]}).raise_for_status()
        assert gateway.http.get("/telemetry").json() == {}
        eventually(lambda: set(stream.sample("gps").values()) == {None}, "viewers are told that there is no data")
    assert gateway.status()["board"]["state"] == "closed"
    parameters = gateway.http.get("/parameters").json()["parameters"]
    assert {parameter["value"] for parameter in parameters} == {None}


def test_it_is_neither_remembered_nor_recorded(tmp_path: Path, board: FakeBoard) -> None:
    data = tmp_path / "data"
    with running_gateway(data) as gateway:
        emulate(gateway)
        eventually(lambda: gateway.status()["board"]["frames_received"] > 50, "frames come")
        assert gateway.status()["recording"]["active"] is False
        assert gateway.http.get("/recordings").json()["recordings"] == []
    with running_gateway(data) as gateway:
        assert gateway.status()["board"]["url"] is None
        gateway.open_board(board.url)
        emulate(gateway)
    assert orjson.loads((data / "state.json").read_bytes())["board_url"] == board.url
    with running_gateway(data) as gateway:
        eventually(lambda: gateway.status()["board"]["state"] == "open", "the board is open")
        assert gateway.status()["board"]["url"] == board.url


def test_it_never_moves_a_simulator(gateway: Gateway) -> None:
    """The surfaces of the examples would fly somebody's aircraft."""
    gateway.http.put("/hil", json={"path": "assisted"}).raise_for_status()
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as simulator:
        simulator.bind(("127.0.0.1", 0))
        simulator.setblocking(False)
        port = simulator.getsockname()[1]
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as free:
            free.bind(("127.0.0.1", 0))
            receive_port = free.getsockname()[1]
        body = {"receive_port": receive_port, "send_host": "127.0.0.1", "send_port": port}
        gateway.http.put("/links/simulator", json=body).raise_for_status()
        emulate(gateway)
        eventually(lambda: gateway.status()["topics"].get("hil_surfaces", {}).get("count", 0) > 20, "surfaces come")
        with pytest.raises(BlockingIOError):
            simulator.recv(1000)
        assert gateway.status()["simulator"]["frames_to_simulator"] == 0
        assert "simulator" not in gateway.http.get("/telemetry").json(), "a connected simulator speaks for itself"


def test_a_station_can_be_started_with_it(tmp_path: Path) -> None:
    with running_gateway(tmp_path / "data", board="emulation:") as gateway:
        eventually(lambda: live_topics(gateway) == TOPICS, "all topics are live")
        gateway.http.delete("/links/board").raise_for_status()
        assert gateway.status()["board"]["state"] == "closed"


def test_a_rate_that_was_chosen_for_the_board_changes_nothing_here(gateway: Gateway, board: FakeBoard) -> None:
    gateway.open_board(board.url)
    gateway.http.post("/commands/set_parameter_task_rate", json={"value": 10000}).raise_for_status()
    emulate(gateway)
    eventually(lambda: gateway.status()["topics"].get("ahrs", {}).get("count", 0) > 5, "frames come")
    gateway.open_board(board.url)
    assert gateway.status()["board"]["periods_ms"]["parameters"] == {"ms": 10000, "chosen": True}
