"""One HTTP connection with limits: time for the request head, least rate of the body, time without reading.

uvicorn parses and answers but has none of these limits; `watch` enforces them once a second for all connections.
"""

from __future__ import annotations

import asyncio
from http import HTTPStatus
from typing import Any, Final, Literal, cast

import structlog
from uvicorn.protocols.http.httptools_impl import HttpToolsProtocol, RequestResponseCycle

from epf_gcs.access.admission import Admission
from epf_gcs.access.caller import Caller, Credentials, Peer
from epf_gcs.access.limits import CallerLimits, standing_of
from epf_gcs.errors import GatewayError
from epf_gcs.repeating import repeat
from epf_gcs.shares.table import STREAM_COSTS_REQUESTS
from epf_gcs.web.serving.access_table import STREAMS
from epf_gcs.web.serving.guard import admitted
from epf_gcs.web.serving.problems import problem_of
from epf_gcs.web.serving.visitors import Visitor, Visitors
from epf_gcs.web.stream.socket import SocketConnection

_BUSY: Final = (
    b"503 Service Unavailable",
    "This station has too many connections: close some, then try again.\n"
    "Esta estación tiene demasiadas conexiones: cierra alguna y vuelve a intentarlo.\n".encode(),
)
_SLOW_HEAD: Final = b"408 Request Timeout", b"The request's head did not come in time.\n"
_SLOW_BODY: Final = b"408 Request Timeout", b"The request's body comes too slowly.\n"
_LONG_HEAD: Final = b"431 Request Header Fields Too Large", b"The request's head is too long.\n"

log = structlog.get_logger("gateway")


class Connection(HttpToolsProtocol):
    """Implements `visitors.Visitor`."""

    def __init__(self, visitors: Visitors, arrival: Visitor | None = None, **uvicorns: Any) -> None:
        """`arrival` has held this connection's place so far."""
        super().__init__(**uvicorns)
        self._arrival = arrival
        self.host = ""
        self.idle_since_s: float | None = None
        self.since_s = 0.0
        self.has_shown_key = False
        self._is_strangers = True
        self._visitors = visitors
        self._stage: Literal["head", "body", "answer"] = "head"
        self._rate_since_s = 0.0
        self._head_bytes = 0
        self._body_bytes = 0
        self._unread: tuple[int, float] = (0, 0.0)
        self._is_refused = False
        self._was_asked = False
        self._is_between = False

    def connection_made(self, transport: asyncio.Transport) -> None:  # type: ignore[override]
        """Accept the connection, or answer that there are too many."""
        super().connection_made(transport)
        self.host = self.client[0] if self.client is not None else ""
        self._peer = Peer(self.client, self.server)
        self._enter_head()
        if self._arrival is not None:
            self._visitors.leave(self._arrival)
            self._arrival = None
        if not self._visitors.come_in(self):
            log.warning("a connection was refused", host=self.host)
            self._end(*_BUSY)

    def connection_lost(self, exc: Exception | None) -> None:
        """Free its place."""
        self._visitors.leave(self)
        super().connection_lost(exc)

    def data_received(self, data: bytes) -> None:
        """Take bytes of a request and limit the size of its head."""
        if self._is_refused:
            return
        if self._stage == "head":
            self._head_bytes += len(data)
        super().data_received(data)
        if self._stage == "head" and self._head_bytes > self._visitors.limits.head_bytes and self._is_up():
            self._end(*_LONG_HEAD)

    def on_message_begin(self) -> None:
        """A request begins."""
        super().on_message_begin()
        cast(Any, self.scope)["state"].update(peer=self._peer, connection=self)
        if self._stage == "head":
            # The time for the head starts with the connection, or for later requests with their first byte.
            if self._was_asked:
                self._enter_head()
            self._is_between = False

    def on_headers_complete(self) -> None:
        """The head is complete."""
        self._stage = "body"
        self._was_asked = True
        self.idle_since_s = None
        self.since_s = self._rate_since_s = self.loop.time()
        self._body_bytes = 0
        super().on_headers_complete()

    def on_body(self, body: bytes) -> None:
        """A part of the body arrived."""
        self._body_bytes += len(body)
        super().on_body(body)

    def on_message_complete(self) -> None:
        """The whole request arrived."""
        self._stage = "answer"
        self.since_s = self.loop.time()
        super().on_message_complete()
        if self._is_answered():  # refused before the whole body arrived
            self._enter_head()
            self._is_between = True

    def on_response_complete(self) -> None:
        """The request is answered; uvicorn closes the connection if no other request follows."""
        if self._stage == "answer" and not self.pipeline:
            self._enter_head()
            self._is_between = True
        super().on_response_complete()

    def handle_websocket_upgrade(self) -> None:
        """Hand the transport to a WebSocket, if its caller may open one."""
        self.idle_since_s = None
        self._stage = "answer"
        self.since_s = self.loop.time()
        shown = Credentials.of(self.scope["headers"], self._peer)
        try:
            caller = self._admission.admit(shown)
        except GatewayError as error:
            self._refuse(error)
            return
        self.show(caller)
        self._upgrade(caller)

    def show(self, caller: Caller | None) -> None:
        """Whose request this is; None: a stranger's. Called by the guard."""
        self._is_strangers = caller is None
        self.has_shown_key = caller is not None and caller.has_key
        if caller is not None and caller.has_key:
            self._visitors.know(self.host, standing_of(caller))

    @property
    def _admission(self) -> Admission:
        return cast(Admission, self.app_state["admission"])

    def _upgrade(self, caller: Caller | None) -> None:
        """The WebSocket keeps this connection's place."""
        entry = STREAMS["/stream?flight" if b"flight=" in self.url else "/stream"]
        limits = cast(CallerLimits, self.app_state["limits"])
        try:
            asker = admitted(caller, entry.least)
            limits.request(asker, self.host, STREAM_COSTS_REQUESTS)
            limits.open_stream(self, asker)
        except GatewayError as error:
            self._refuse(error)
            return
        if not self._visitors.become_socket(self):
            log.warning("a stream was refused", host=self.host)
            limits.close_stream(self)
            self._end(*_BUSY)
            return
        # A stream makes room for nobody, also where anybody may fly and nobody has a key.
        self.has_shown_key = True
        self.connections.discard(self)
        head = [self.scope["method"].encode(), b" ", self.url, b" HTTP/1.1\r\n"]
        for name, value in self.scope["headers"]:
            head += [name, b": ", value, b"\r\n"]
        head.append(b"\r\n")
        stream = cast(
            SocketConnection,
            cast(Any, self.ws_protocol_class)(
                config=self.config, server_state=self.server_state, app_state=self.app_state
            ),
        )
        stream.caller = asker

        def lost() -> None:
            limits.close_stream(self)
            self._visitors.leave(self)

        stream.on_lost = lost
        stream.connection_made(self.transport)
        stream.data_received(b"".join(head))
        self.transport.set_protocol(stream)

    def _unsupported_upgrade_warning(self) -> None:
        """Say nothing: the request is answered, and anybody may send it as often as they like."""

    def _refuse(self, error: GatewayError) -> None:
        """Answer a handshake with a problem document."""
        answer = problem_of(error)
        headers = b"".join(b"%b: %b\r\n" % header for header in answer.raw_headers)
        self._answer_and_close(
            b"%d %b" % (answer.status_code, HTTPStatus(answer.status_code).phrase.encode()), headers, bytes(answer.body)
        )

    def make_room(self) -> None:
        """Close without an answer; the browser opens a new connection when it needs one."""
        self.transport.abort()

    def look(self, now_s: float) -> None:
        """Close the connection if it exceeds a time limit; called once a second."""
        if self._is_refused or not self._is_up():
            return
        limits = self._visitors.limits
        if self._stage == "head":
            # Between requests uvicorn closes idle connections, except those that send bare line ends and no request.
            if now_s - self.since_s > limits.head_s + (limits.idle_s if self._is_between else 0.0):
                self._end(*_SLOW_HEAD)
        elif self._stage == "body":
            self._look_at_body(now_s)
        elif self._stage == "answer":
            self._look_at_answer(now_s)

    def _look_at_body(self, now_s: float) -> None:
        limits = self._visitors.limits
        if self._is_strangers and now_s - self.since_s > limits.strangers_body_s:
            self._end(*_SLOW_BODY)
        elif self.flow.read_paused:
            # The disk is slow, not the browser: restart the measurement.
            self._rate_since_s, self._body_bytes = now_s, 0
        elif now_s - self._rate_since_s > limits.rate_looked_at_s:
            if self._body_bytes < limits.least_bytes_per_s * limits.rate_looked_at_s:
                self._end(*_SLOW_BODY)
            self._rate_since_s, self._body_bytes = now_s, 0

    def _look_at_answer(self, now_s: float) -> None:
        unsent = self.transport.get_write_buffer_size()
        if unsent == 0 or unsent != self._unread[0]:
            self._unread = (unsent, now_s)
        elif now_s - self._unread[1] > self._visitors.limits.unread_s:
            self.transport.abort()

    def _enter_head(self) -> None:
        self._stage = "head"
        self.since_s = self.idle_since_s = self.loop.time()
        self._head_bytes = 0

    def _is_answered(self) -> bool:
        """Whether uvicorn has sent the whole answer; never true for a WebSocket upgrade."""
        answer = cast(RequestResponseCycle | None, self.cycle)
        return answer is not None and answer.response_complete

    def _is_up(self) -> bool:
        return not self.transport.is_closing()

    def _end(self, status: bytes, words: bytes) -> None:
        headers = b"Content-Type: text/plain; charset=utf-8\r\nContent-Length: %d\r\nRetry-After: 5\r\n" % len(words)
        self._answer_and_close(status, headers, words)

    def _answer_and_close(self, status: bytes, headers: bytes, words: bytes) -> None:
        self._is_refused = True
        self._visitors.leave(self)
        answer = cast(RequestResponseCycle | None, self.cycle)
        if answer is None or not answer.response_started or answer.response_complete:
            self.transport.write(b"HTTP/1.1 %b\r\n%bConnection: close\r\n\r\n%b" % (status, headers, words))
        self.transport.close()


async def watch(visitors: Visitors, every_s: float) -> None:
    """Check the limits of all connections every `every_s`, forever."""
    loop = asyncio.get_running_loop()

    def look() -> None:
        now_s = loop.time()
        for visitor in tuple(visitors):
            if isinstance(visitor, Connection):
                visitor.look(now_s)

    await repeat(every_s, "the limits of connections", look)
