"""Links over REST: opened, refused with one sentence, and closed."""

from __future__ import annotations

import socket
from pathlib import Path
from typing import Any

import pytest

from tests.support.fake_board import FakeBoard
from tests.support.gateway import Gateway
from tests.support.waiting import eventually


def test_a_board_is_opened_and_closed(gateway: Gateway, board: FakeBoard) -> None:
    answer = gateway.http.put("/links/board", json={"url": board.url}).raise_for_status().json()
    assert answer["url"] == board.url
    eventually(lambda: gateway.status()["board"]["state"] == "open", "it opens")
    assert gateway.http.delete("/links/board").status_code == 204
    assert gateway.status()["board"]["state"] == "closed"
    assert gateway.status()["board"]["url"] is None
    assert gateway.http.delete("/links/board").status_code == 204


@pytest.mark.parametrize(
    ("url", "status", "code"),
    [
        ("carrier-pigeon", 422, "link_address_invalid"),
        ("serial:///dev/ttyUSB0?baud=7", 422, "link_address_invalid"),
        ("serial:///dev/no-such-port", 409, "link_no_device"),
        ("tcp://127.0.0.1:1", 409, "link_refused"),
        ("tcp://no.such.host.invalid:1", 409, "link_unknown_host"),
        ("", 422, "invalid_request"),
    ],
)
def test_a_wrong_link_is_one_sentence_and_changes_nothing(
    gateway: Gateway, board: FakeBoard, url: str, status: int, code: str
) -> None:
    gateway.open_board(board.url)
    answer = gateway.http.put("/links/board", json={"url": url})
    assert (answer.status_code, answer.json()["code"]) == (status, code)
    assert answer.json()["detail"].count(". ") <= 1
    after = gateway.status()
    assert (after["board"]["state"], after["board"]["url"]) == ("open", board.url)
    assert after["errors"] == {code: 1}


def test_a_port_that_another_program_has_is_busy(gateway: Gateway, board: FakeBoard, tmp_path: Path) -> None:
    gateway.open_board(board.url)
    alias = tmp_path / "alias"
    alias.symlink_to(board.path)
    answer = gateway.http.put("/links/board", json={"url": f"pty://{alias}"})
    assert (answer.status_code, answer.json()["code"]) == (409, "link_busy")
    assert gateway.status()["board"]["state"] == "open"


def test_a_taken_receive_port_is_one_sentence(gateway: Gateway) -> None:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as other:
        other.bind(("127.0.0.1", 0))
        port = other.getsockname()[1]
        answer = gateway.http.put("/links/simulator", json={"receive_port": port})
    assert (answer.status_code, answer.json()["code"]) == (409, "port_taken")
    assert answer.json()["detail"].startswith(f"UDP port {port} is taken by another program")
    assert gateway.status()["simulator"]["state"] == "closed"


@pytest.mark.parametrize(
    "body",
    [
        {"receive_port": 0},
        {"receive_port": 65536},
        {"send_port": "many"},
        {"send_host": "a host"},
        {"send_host": ""},
        {"profile": "xp9"},
        {"recieve_port": 49003},
        [],
    ],
)
def test_a_wrong_simulator_link_is_named(gateway: Gateway, body: Any) -> None:
    answer = gateway.http.put("/links/simulator", json=body)
    assert (answer.status_code, answer.json()["code"]) == (422, "invalid_request")
    assert gateway.status()["simulator"]["state"] == "closed"


def test_a_simulator_is_opened_told_what_is_missing_and_closed(gateway: Gateway) -> None:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as simulator:
        simulator.bind(("127.0.0.1", 0))
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as probe:
            probe.bind(("127.0.0.1", 0))
            port = probe.getsockname()[1]
        body = {"receive_port": port, "send_host": "127.0.0.1", "send_port": simulator.getsockname()[1]}
        answer = gateway.http.put("/links/simulator", json=body).raise_for_status().json()
        assert answer == {"state": "opening", "url": f"udp://127.0.0.1:{body['send_port']}"}
        status = gateway.status()["simulator"]
        assert (status["state"], status["profile"]) == ("opening", "xp10")
        assert str(port) in status["advice"]
        row3 = b"DATA@" + (3).to_bytes(4, "little") + b"\0" * 32

        def heard() -> bool:
            simulator.sendto(row3, ("127.0.0.1", port))
            return bool(gateway.status()["simulator"]["state"] == "open")

        eventually(heard, "it is heard")
        status = gateway.status()["simulator"]
        assert status["rows"] == [3]
        assert status["missing_rows"] == [4, 8, 16, 17, 20, 25]
        assert "Rows 4, 8, 16, 17, 20, 25 are missing" in status["advice"]
        assert gateway.http.delete("/links/simulator").status_code == 204
        assert gateway.status()["simulator"]["state"] == "closed"


def test_the_serial_ports_are_listed(gateway: Gateway) -> None:
    for port in gateway.http.get("/ports").raise_for_status().json()["ports"]:
        assert port["url"].startswith("serial:///")


def test_the_switches_are_set_and_confirmed(gateway: Gateway, board: FakeBoard) -> None:
    before = gateway.http.get("/hil").json()
    assert (before["source"], before["path"], before["stick"]["source"]) == (None, "manual", "simulator")
    gateway.open_board(board.url)
    assert gateway.http.get("/hil").json() == before | {"source": "rc"}
    answer = gateway.http.put("/hil", json={"source": "joystick", "path": "assisted"}).raise_for_status().json()
    assert answer == before | {"source": "joystick", "path": "assisted"}
    eventually(lambda: gateway.http.get("/hil").json() == answer, "the board reports it")
    board.refuse["control_source"] = 2
    refused = gateway.http.put("/hil", json={"source": "rc"})
    assert (refused.status_code, refused.json()["code"]) == (502, "source_not_taken")
    assert "The control source is still joystick" in refused.json()["detail"]
    assert refused.json()["params"] == {"reason": "bad_state"}
    again = gateway.http.put("/hil", json={"source": "joystick"})
    assert (again.status_code, again.json()["code"]) == (502, "source_not_taken"), "the last heartbeat is no proof"
    assert gateway.http.get("/hil").json() == answer
