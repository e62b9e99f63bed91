"""Checks of each request (Host, Origin, who asks, length of the body), and the security headers of the answers.

Who asks is found before the request is routed, and held against the table of access: what is not in it is refused.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import MutableMapping
from dataclasses import dataclass
from http import HTTPStatus
from typing import Any, Final

import structlog
from starlette.datastructures import Headers, MutableHeaders
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from epf_gcs.access.admission import Admission
from epf_gcs.access.caller import Caller, Credentials, Peer
from epf_gcs.access.limits import CallerLimits
from epf_gcs.access.roles import OPEN, Role
from epf_gcs.error_log import ErrorLog
from epf_gcs.errors import (
    ConflictError,
    GatewayError,
    InvalidInputError,
    NotAdmittedError,
    RoleError,
    TooManyError,
)
from epf_gcs.web.serving.access_table import API, Entry, Gate
from epf_gcs.web.serving.body_limits import BodyLimits
from epf_gcs.web.serving.origins import Access
from epf_gcs.web.serving.problems import problem_of, problem_response

_READING: Final = frozenset({"GET", "HEAD", "OPTIONS"})
_CONTENT_POLICY: Final = (
    "default-src 'self'; script-src 'self' 'wasm-unsafe-eval'; style-src 'self'; img-src 'self' data: blob:; "
    "worker-src 'self' blob:; object-src 'none'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'"
)
# Swagger UI writes style attributes into its markup.
_DOCS_CONTENT_POLICY: Final = _CONTENT_POLICY.replace("style-src 'self'", "style-src 'self' 'unsafe-inline'")
_DOCS_PATH: Final = "/api/docs"
_MOST_SAID: Final = 400
_OF_GOOGLE_EARTH: Final = (".kml", ".kmz", ".dae")

log = structlog.get_logger("gateway")


@dataclass(frozen=True, slots=True)
class Entrance:
    """Who may ask what, and how much."""

    access: Access
    admission: Admission
    gate: Gate
    limits: CallerLimits


class Guard:
    """ASGI middleware around all HTTP requests."""

    def __init__(
        self,
        app: ASGIApp,
        entrance: Entrance,
        bodies: BodyLimits,
        errors: ErrorLog,
        answers: Counter[int] | None = None,
    ) -> None:
        """`answers`: counts the answers of each status."""
        self._app = app
        self._access = entrance.access
        self._admission = entrance.admission
        self._gate = entrance.gate
        self._limits = entrance.limits
        self._bodies = bodies
        self._errors = errors
        self._answers: Counter[int] = Counter() if answers is None else answers

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Check the request, then pass it on."""
        if scope["type"] != "http":
            await self._app(scope, receive, send)
            return
        path: str = scope["path"]
        started = False

        async def send_guarded(message: Message) -> None:
            nonlocal started
            if message["type"] == "http.response.start":
                started = True
                self._answers[message["status"]] += 1
                _add_headers(message, path)
            await send(message)

        try:
            await self._check_and_hand_on(scope, receive, send_guarded)
        except _SessionEnd:
            return  # the server closes the connection of an answer that is not whole
        except Exception as error:
            log.exception("a request failed", method=scope["method"], path=path)
            if started:
                raise
            fault = GatewayError(
                "internal",
                f"{scope['method']} {path} failed inside the station ({type(error).__name__}): see its log.",
            )
            await self._refuse(HTTPStatus.INTERNAL_SERVER_ERROR, fault, scope, receive, send_guarded)

    async def _check_and_hand_on(self, scope: Scope, receive: Receive, send: Send) -> None:
        headers = Headers(scope=scope)
        reading = scope["method"] in _READING
        try:
            self._access.check(headers.getlist, reads=reading)
            caller, entry = self._admit(scope)
        except InvalidInputError as error:
            await self._refuse(HTTPStatus.BAD_REQUEST, error, scope, receive, send)
            return
        except (NotAdmittedError, TooManyError) as error:
            await self._turn_away(error, scope, receive, send)
            return
        except GatewayError as error:
            await self._refuse(HTTPStatus.FORBIDDEN, error, scope, receive, send)
            return
        if reading:
            await self._app(scope, receive, send if caller is None else self._while_admitted(caller, send))
            return
        if entry is not None and entry.deed is not None and caller is not None:
            deed = _Deed(self._admission, caller, entry.deed, scope, send)
            send = deed.send
        else:
            deed = None
        if caller is not None and scope["path"] in self._bodies.streamed:
            await self._stream(caller, scope, receive, send)
            return
        most_bytes = self._bodies.of(scope["path"], is_strangers=caller is None)
        body = await _read_body(receive, most_bytes)
        if body is None:
            too_large = GatewayError(
                "body_too_large", f"The body is longer than {most_bytes} bytes: send less.", limit=most_bytes
            )
            await self._refuse(HTTPStatus.REQUEST_ENTITY_TOO_LARGE, too_large, scope, receive, send)
            return
        if deed is not None and entry is not None and not entry.secret:
            deed.body = body
        await self._app(scope, _replay(body, receive), send)

    def _admit(self, scope: Scope) -> tuple[Caller | None, Entry | None]:
        """Who asks, and the row of the table. Raises NotAdmittedError, RoleError, TooManyError."""
        state = scope.setdefault("state", {})
        shown = Credentials.of(scope["headers"], state.get("peer") or Peer(scope.get("client"), scope.get("server")))
        caller = self._admission.admit(shown)
        if (connection := state.get("connection")) is not None:
            connection.show(caller)
        entry = self._gate.entry(scope["method"], scope["path"])
        least = Role.viewer if entry is None else entry.least
        if least != OPEN:
            admitted(caller, least)
        self._limits.request(caller, shown.peer.host)
        state["caller"] = caller
        state["shown"] = shown
        return caller, entry

    def _while_admitted(self, caller: Caller, send: Send) -> Send:
        """A long answer ends in the middle once its session has ended."""

        async def send_on(message: Message) -> None:
            if self._admission.current(caller.session) is None:
                raise _SessionEnd
            await send(message)

        return send_on

    async def _stream(self, caller: Caller, scope: Scope, receive: Receive, send: Send) -> None:
        async def counted() -> Message:
            message = await receive()
            self._limits.upload(caller, len(message.get("body", b"")))
            return message

        try:
            with self._limits.one_upload(caller):
                await self._app(scope, counted, send)
        except ConflictError as error:
            await self._refuse(HTTPStatus.CONFLICT, error, scope, receive, send)

    async def _turn_away(self, error: GatewayError, scope: Scope, receive: Receive, send: Send) -> None:
        self._errors.count(error.code)
        answer = problem_of(error)
        if isinstance(error, NotAdmittedError) and scope["path"].endswith(_OF_GOOGLE_EARTH):
            # It asks its user for a password when it is told so, and sends the key no other way.
            answer.headers["WWW-Authenticate"] = 'Basic realm="EPF GCS", charset="UTF-8"'
        await answer(scope, receive, send)

    async def _refuse(
        self, status: HTTPStatus, error: GatewayError, scope: Scope, receive: Receive, send: Send
    ) -> None:
        self._errors.count(error.code)
        await problem_response(status, error.code, error.detail, error.params)(scope, receive, send)


def admitted(caller: Caller | None, least: int) -> Caller:
    """The caller, if the role suffices. Raises NotAdmittedError for a stranger, RoleError if the role is too low."""
    if caller is None:
        raise NotAdmittedError(
            "not_admitted", "This station answers only to those who were let in: enter a key, or ask to be let in."
        )
    if caller.role < least:
        needed = Role(least).name
        raise RoleError(
            "role_too_low",
            f"This needs the role '{needed}', and you are '{caller.role.name}': ask an owner of this station.",
            least=needed,
            role=caller.role.name,
        )
    return caller


class _SessionEnd(Exception):  # noqa: N818 - nothing failed
    """The session ended while its answer was being sent."""


class _Deed:
    """Notes a request in the log of people's deeds as soon as its answer begins."""

    def __init__(self, admission: Admission, caller: Caller, name: str, scope: Scope, send: Send) -> None:
        self._admission = admission
        self._caller = caller
        self._name = name
        self._what = f"{scope['method']} {scope['path'].removeprefix(API)}"
        self._address = scope["client"][0] if scope.get("client") else ""
        self._send = send
        self.body = b""

    async def send(self, message: Message) -> None:
        """Pass the answer on."""
        if message["type"] == "http.response.start":
            what = f"{self._what} {self.body[:_MOST_SAID].decode('utf-8', 'replace')}".rstrip()
            self._admission.log.note(self._caller, self._address, self._name, what, str(message["status"]))
        await self._send(message)


async def _read_body(receive: Receive, most_bytes: int) -> bytes | None:
    """The whole body; None if it is too long. Bodies here are small, so each is read before its route runs."""
    body = bytearray()
    while True:
        message = await receive()
        body += message.get("body", b"")
        if len(body) > most_bytes:
            return None
        if message["type"] != "http.request" or not message.get("more_body", False):
            return bytes(body)


def _replay(body: bytes, receive: Receive) -> Receive:
    pending: list[MutableMapping[str, Any]] = [{"type": "http.request", "body": body, "more_body": False}]

    async def replay() -> Message:
        return pending.pop() if pending else await receive()

    return replay


def _add_headers(message: Message, path: str) -> None:
    headers = MutableHeaders(scope=message)
    # A route whose page has a style of its own says a stricter policy with that style's hash.
    headers.setdefault("Content-Security-Policy", _DOCS_CONTENT_POLICY if path == _DOCS_PATH else _CONTENT_POLICY)
    headers["X-Content-Type-Options"] = "nosniff"
    headers["Referrer-Policy"] = "no-referrer"
    headers["Cross-Origin-Resource-Policy"] = "same-origin"
    headers["Cross-Origin-Opener-Policy"] = "same-origin"
    if path.startswith("/api/v1/"):
        headers.setdefault("Cache-Control", "no-store")
