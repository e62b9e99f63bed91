"""What the launcher makes of the gateway's answers. A small server says what a gateway would."""

import json
import threading
from collections.abc import Callable, Iterator
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from typing import Any

import pytest

from epf_gcs.launcher.errors import LaunchError
from epf_gcs.launcher.gateway_client import GatewayClient, RefusedError, UnreachableError

HELD = {
    "status": 409,
    "detail": "Ana has control.",
    "code": "control_held",
    "params": {"client": "browser-7", "name": "Ana"},
}


class Answers:
    """Requests that came, and the answer to each path: status and body."""

    def __init__(self) -> None:
        self.requests: list[tuple[str, str, Any, str | None]] = []
        self.of: dict[str, Callable[[str | None], tuple[int, Any]]] = {}


@pytest.fixture
def gateway() -> Iterator[tuple[GatewayClient, Answers]]:
    answers = Answers()

    class Handler(BaseHTTPRequestHandler):
        def answer(self) -> None:
            size = int(self.headers.get("Content-Length") or 0)
            body = json.loads(self.rfile.read(size)) if size else None
            client = self.headers.get("X-Client")
            answers.requests.append((self.command, self.path, body, client))
            status, answer = answers.of[self.path](client)
            data = json.dumps(answer).encode()
            self.send_response(status)
            self.send_header("Content-Length", str(len(data)))
            self.end_headers()
            self.wfile.write(data)

        do_GET = do_PUT = do_POST = do_DELETE = answer  # noqa: N815 (http.server's names)

        def log_message(self, *_: object) -> None:
            """Quietly."""

    with ThreadingHTTPServer(("127.0.0.1", 0), Handler) as server:
        threading.Thread(target=server.serve_forever, kwargs={"poll_interval": 0.01}).start()
        try:
            yield GatewayClient(f"http://127.0.0.1:{server.server_port}"), answers
        finally:
            server.shutdown()


def test_a_command_goes_out_with_its_value_and_is_taken(gateway: tuple[GatewayClient, Answers]) -> None:
    client, answers = gateway
    answers.of["/api/v1/commands/control_source"] = lambda _: (200, {"state": "confirmed"})
    client.command("control_source", 1)
    assert answers.requests == [("POST", "/api/v1/commands/control_source", {"value": 1}, None)]


@pytest.mark.parametrize("state", ["rejected", "timed_out"])
def test_a_command_that_the_board_does_not_take_is_told(gateway: tuple[GatewayClient, Answers], state: str) -> None:
    client, answers = gateway
    answers.of["/api/v1/commands/autopilot_on"] = lambda _: (200, {"state": state})
    with pytest.raises(LaunchError, match=f"did not take the command autopilot_on \\({state}\\)"):
        client.command("autopilot_on")


def test_a_command_without_an_answer_is_given_again(gateway: tuple[GatewayClient, Answers]) -> None:
    client, answers = gateway
    states = iter(["timed_out", "timed_out", "confirmed"])
    answers.of["/api/v1/commands/autopilot_on"] = lambda _: (200, {"state": next(states)})
    client.command("autopilot_on")
    assert len(answers.requests) == 3


def test_a_command_that_is_rejected_is_not_given_again(gateway: tuple[GatewayClient, Answers]) -> None:
    client, answers = gateway
    answers.of["/api/v1/commands/autopilot_on"] = lambda _: (200, {"state": "rejected"})
    with pytest.raises(LaunchError):
        client.command("autopilot_on")
    assert len(answers.requests) == 1


def test_a_refusal_is_told_in_the_gateways_own_words(gateway: tuple[GatewayClient, Answers]) -> None:
    client, answers = gateway
    problem = {"status": 422, "detail": "/dev/nothing does not exist.", "code": "port_missing"}
    answers.of["/api/v1/links/board"] = lambda _: (422, problem)
    with pytest.raises(RefusedError, match=r"PUT /api/v1/links/board: /dev/nothing does not exist\."):
        client.open_board("serial:///dev/nothing")
    assert len(answers.requests) == 1


def test_the_first_start_is_ended(gateway: tuple[GatewayClient, Answers]) -> None:
    client, answers = gateway
    answers.of["/api/v1/first-start"] = lambda _: (200, {})
    client.end_first_start()
    assert answers.requests == [("DELETE", "/api/v1/first-start", None, None)]


def test_while_a_page_has_control_the_request_is_made_in_its_name(gateway: tuple[GatewayClient, Answers]) -> None:
    client, answers = gateway
    answers.of["/api/v1/hil"] = lambda name: (200, {}) if name == "browser-7" else (409, HELD)
    client.select_hil("joystick", "assisted")
    assert [request[3] for request in answers.requests] == [None, "browser-7"]


def test_waiting_ends_when_the_condition_holds(gateway: tuple[GatewayClient, Answers]) -> None:
    client, answers = gateway
    counted = iter(range(100))
    answers.of["/api/v1/status"] = lambda _: (200, {"n": next(counted)})
    assert client.wait("three", lambda status: status["n"] == 3, timeout_s=20.0, check=lambda: None) == {"n": 3}


def test_waiting_in_vain_says_for_what_and_what_was_seen(gateway: tuple[GatewayClient, Answers]) -> None:
    client, answers = gateway
    answers.of["/api/v1/status"] = lambda _: (200, {"board": {"state": "lost"}})
    with pytest.raises(LaunchError, match=r"in vain until the board answers; .*\"state\": \"lost\""):
        client.wait("the board answers", lambda _: False, timeout_s=0.2, check=lambda: None)


def test_waiting_is_given_up_when_the_check_says_so(gateway: tuple[GatewayClient, Answers]) -> None:
    client, answers = gateway
    answers.of["/api/v1/status"] = lambda _: (200, {})

    def a_child_died() -> None:
        raise LaunchError("The board ended at once.")

    with pytest.raises(LaunchError, match="The board ended at once"):
        client.wait("anything", lambda _: True, timeout_s=20.0, check=a_child_died)


def test_nobody_there_is_told_with_the_address() -> None:
    client = GatewayClient("http://127.0.0.1:9")
    with pytest.raises(UnreachableError, match=r"does not answer at http://127\.0\.0\.1:9"):
        client.status()
    with pytest.raises(LaunchError, match="the gateway does not answer"):
        client.wait("it is up", lambda _: True, timeout_s=0.2, check=lambda: None)
