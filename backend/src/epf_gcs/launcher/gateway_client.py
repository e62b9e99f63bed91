"""The launcher's client of the gateway, which uses its public HTTP interface only."""

import contextlib
import json
import time
import urllib.error
import urllib.request
from collections.abc import Callable
from pathlib import Path
from typing import Any, Final

from epf_gcs.launcher.encryption import trusting
from epf_gcs.launcher.errors import LaunchError
from epf_gcs.launcher.options import XPlane

_REQUEST_TIMEOUT_S: Final = 10.0
_POLL_S: Final = 0.05
_COMMAND_TRIES: Final = 5

Status = dict[str, Any]
Problem = dict[str, Any]


class RefusedError(LaunchError):
    """The gateway answered with a problem document, whose `detail` is the message."""

    def __init__(self, request: str, problem: Problem) -> None:
        super().__init__(f"The gateway refused {request}: {problem.get('detail', 'it does not say why')}")
        self.code = problem.get("code")
        self.params = problem.get("params") or {}


class UnreachableError(LaunchError):
    """No answer from the gateway's address."""


class GatewayClient:
    """Requests to one gateway. Proxy settings are ignored, because the gateway is on this computer.

    `key`: what the gateway was given by us to know us by. `trusted`: under TLS, the file of the certificate or of its
    authority; the gateway may still be making it.
    """

    def __init__(self, base_url: str, key: str | None = None, trusted: Path | None = None) -> None:
        self._base_url = base_url
        self._headers = {} if key is None else {"Authorization": f"Bearer {key}"}
        self._trusted = trusted

    def status(self) -> Status:
        """State of links, recording and control."""
        return self._request("GET", "/api/v1/status")

    def end_first_start(self) -> None:
        """Have the page never ask for what this program sets up."""
        self._request("DELETE", "/api/v1/first-start")

    def open_board(self, url: str) -> None:
        """Have the gateway open the board's link, and keep it open."""
        self._request("PUT", "/api/v1/links/board", {"url": url})

    def open_simulator(self, simulator: XPlane) -> None:
        """Have the gateway listen for the simulator and send to it."""
        body = {
            "receive_port": simulator.receive_port,
            "send_host": simulator.host,
            "send_port": simulator.port,
            "profile": simulator.profile,
        }
        self._request("PUT", "/api/v1/links/simulator", body)

    def select_hil(self, source: str, path: str) -> None:
        """Choose who moves the simulator's surfaces."""
        self._request("PUT", "/api/v1/hil", {"source": source, "path": path})

    def command(self, name: str, value: float | None = None) -> None:
        """Send a command to the board, again if no answer came; raises LaunchError unless the board has accepted it.

        Only for commands that are idempotent: they may arrive twice.
        """
        body = {} if value is None else {"value": value}
        state = "timed_out"
        for _ in range(_COMMAND_TRIES):
            if state == "timed_out":
                state = self._request("POST", f"/api/v1/commands/{name}", body)["state"]
        if state not in {"confirmed", "sent"}:
            raise LaunchError(f"The board did not take the command {name} ({state}).")

    def wait(
        self, what: str, condition: Callable[[Status], bool], timeout_s: float, check: Callable[[], None]
    ) -> Status:
        """Ask for the status until `condition` holds; `check` is called in between and may raise.

        Raises LaunchError after the timeout, which says what was waited for.
        """
        deadline_s = time.monotonic() + timeout_s
        status: Status | None = None
        while time.monotonic() < deadline_s:
            check()
            try:
                status = self.status()
            except UnreachableError:
                status = None
            if status is not None and condition(status):
                return status
            time.sleep(_POLL_S)
        seen = "the gateway does not answer" if status is None else f"the gateway's last answer was {_short(status)}"
        raise LaunchError(f"Waited {timeout_s:.0f} s in vain until {what}; {seen}.")

    def _request(self, method: str, path: str, body: object = None) -> Status:
        """One request. If an open page has the controls, the request is repeated in that page's name.

        Page and launcher belong to the same person, who has just started this.
        """
        try:
            return self._ask(method, path, body, {})
        except RefusedError as refused:
            if refused.code != "control_held":
                raise
            return self._ask(method, path, body, {"X-Client": str(refused.params["client"])})

    def _ask(self, method: str, path: str, body: object, headers: dict[str, str]) -> Status:
        data = None if body is None else json.dumps(body).encode()
        request = urllib.request.Request(  # noqa: S310 (the address is made here, from a host and a port)
            self._base_url + path,
            data=data,
            method=method,
            headers=headers | self._headers | {"Content-Type": "application/json"},
        )
        try:
            with self._opener().open(request, timeout=_REQUEST_TIMEOUT_S) as response:
                answer: Status = json.loads(response.read() or b"{}")
                return answer
        except urllib.error.HTTPError as error:
            raise RefusedError(f"{method} {path}", _problem(error)) from error
        except OSError as error:
            raise UnreachableError(f"The gateway does not answer at {self._base_url} ({error}).") from error

    def _opener(self) -> urllib.request.OpenerDirector:
        """Raises OSError while the gateway has no certificate yet."""
        handlers: list[urllib.request.BaseHandler] = [urllib.request.ProxyHandler({})]
        if self._trusted is not None:
            handlers.append(urllib.request.HTTPSHandler(context=trusting(self._trusted)))
        return urllib.request.build_opener(*handlers)


def _problem(error: urllib.error.HTTPError) -> Problem:
    with error, contextlib.suppress(ValueError):
        problem = json.loads(error.read())
        if isinstance(problem, dict):
            return problem
    return {"detail": f"status {error.code}"}


def _short(status: Status) -> str:
    return json.dumps({name: status.get(name) for name in ("board", "simulator")})[:400]
