"""A WebSocket connection straight on the server's transport: no task, no queue and no copy for each viewer.

uvicorn hands every upgrade to one of these (`ws=`). The handshake and the frames from the browser go through
the sans-I/O protocol of `websockets`; texts to the browser are framed here, for they are never masked or split.
"""

from __future__ import annotations

import asyncio
import os
from collections.abc import Callable, Sequence
from http import HTTPStatus
from typing import Any, Final, Protocol, cast
from urllib.parse import parse_qsl

from uvicorn.config import Config
from uvicorn.server import ServerState
from websockets.frames import Frame, Opcode
from websockets.http11 import Request
from websockets.protocol import State
from websockets.server import ServerProtocol
from websockets.utils import apply_mask

from epf_gcs.access.caller import Caller
from epf_gcs.repeating import Repeating
from epf_gcs.shares.allowance import Allowance
from epf_gcs.web.stream.handshake import Refusal, address_parts

_MAX_MESSAGE_BYTES: Final = 16384
_KEEPALIVE_S: Final = 10.0
_ENDED: Final = 1011  # something unexpected on our side: the reason says what
_GONE: Final = 1012  # service restart: the page tries again
PINGS_PER_S: Final = 20
"""Largest rate of a browser's control frames; its pongs to our pings are one in ten seconds."""
MESSAGES_PER_S: Final = 1000
"""Largest rate of a browser's messages; acknowledgements of every sample and a stick are well below."""
_TOO_MUCH: Final = 1008  # policy violation: too many frames, or a session or key that is no longer good
BYTES_PER_TURN: Final = 1024
"""Bytes of one connection handled in one turn of the loop: fewer than two hundred frames."""
_LAST_WORDS_S: Final = 2.0
# Less than a second after a session or key was ended nothing of it is left.
_DISMISSAL_S: Final = 0.5
# Of a frame's head (RFC 6455, 5.2): final text without extension, control frame, mask bit, least size with more bytes.
_WHOLE_TEXT: Final = 0x81
_CONTROL: Final = 0x88
_MASKED: Final = 0x80
_LONG: Final = 126
_SHORT_HEAD_BYTES: Final = 6


class Conversation(Protocol):
    """The handler of an open connection; constructed by the endpoint."""

    def on_text(self, text: str) -> None:
        """A message of the browser."""

    def on_closed(self) -> None:
        """The connection is over."""


class Endpoint(Protocol):
    """Answers a handshake."""

    def open(self, connection: SocketConnection, path: str, query: dict[str, str]) -> Conversation:
        """Begin a conversation; `connection.send` works only after this returned. Raises Refusal."""

    def opened(self, conversation: Conversation) -> None:
        """The handshake is done."""

    def check(self, values: Callable[[str], Sequence[str]]) -> None:
        """Raise Refusal if this Host or Origin may not connect; `values` gives all values of a header."""


class SocketConnection(asyncio.Protocol):
    """One browser. Implements `epf_gcs.web.stream.viewer.Outlet`."""

    def __init__(
        self, config: Config, server_state: ServerState, app_state: dict[str, Any], _loop: object = None
    ) -> None:
        self._endpoint = cast(Endpoint, app_state["socket_endpoint"])
        self._connections = server_state.connections
        self._loop = asyncio.get_running_loop()
        self._protocol = ServerProtocol(max_size=_MAX_MESSAGE_BYTES)
        self._transport: asyncio.Transport | None = None
        self._fd = -1
        self._is_open = False
        self._conversation: Conversation | None = None
        self._keepalive = Repeating(self._loop, "the keepalive of a stream", self._check_alive, _KEEPALIVE_S)
        self._working = Repeating(self._loop, "the messages of a stream", self._work_on, 0.0)
        self._answered = True
        self._fragments: list[bytes] = []
        # What comes next begins a frame. False for good once the protocol got a part of one.
        self._is_aligned = False
        # Bytes received and not handled yet; reading pauses until it is empty.
        self._pending = b""
        self._given_up = False
        self._pings = Allowance(PINGS_PER_S, 2 * PINGS_PER_S)
        self._messages = Allowance(MESSAGES_PER_S, 2 * MESSAGES_PER_S)
        self.on_lost: Callable[[], None] = _nothing
        # Who opened it; set before the handshake, which strangers do not reach.
        self.caller: Caller | None = None
        self.heard = 0
        """Pieces of anything that came since the handshake; from then on it only grows."""

    def connection_made(self, transport: asyncio.BaseTransport) -> None:
        """uvicorn hands over the transport of the HTTP connection."""
        self._transport = cast(asyncio.Transport, transport)
        self._connections.add(cast(Any, self))

    def data_received(self, data: bytes) -> None:
        """Take bytes from the browser: first the handshake, then frames."""
        self._answered = True
        self.heard += 1
        if self._given_up:
            return
        if not self._pending and len(data) <= BYTES_PER_TURN:
            if self._is_aligned and self._is_open:
                data = self._take_short_texts(data)
                if not data:
                    return
            self._protocol.receive_data(data)
            self._work()
            return
        self._is_aligned = False
        if self._transport is not None and not self._pending and not self._transport.is_closing():
            self._transport.pause_reading()
            self._working.arm()
        self._pending += data

    def eof_received(self) -> bool:
        """The browser closed its side."""
        self._pending = b""
        self._protocol.receive_eof()
        self._work()
        return False

    def connection_lost(self, exc: Exception | None) -> None:
        """Nothing more can be sent."""
        self._connections.discard(cast(Any, self))
        self._keepalive.stop()
        conversation, self._conversation = self._conversation, None
        self._is_open = False
        self._transport = None
        self._pending = b""
        self.on_lost()
        self._fd = -1
        if conversation is not None:
            conversation.on_closed()

    def shutdown(self) -> None:
        """Close because the server stops."""
        if self._transport is not None:
            if self._is_open:
                self._protocol.send_close(_GONE)
                self._write_protocol_output()
            self._is_open = False
            self._transport.close()

    def end(self, reason: str) -> None:
        """Close because what was shown has ended; `reason` is short, for a log of the browser."""
        self._close_with(_ENDED, reason, _LAST_WORDS_S)

    def dismiss(self, reason: str) -> None:
        """Close because whoever opened it may not any longer: nothing more is sent, or taken from it."""
        self._given_up = True
        self._pending = b""
        self._close_with(_TOO_MUCH, reason, _DISMISSAL_S)

    def abort(self) -> None:
        """Close at once and without a word: nothing is heard of the other side."""
        if self._transport is not None:
            self._transport.abort()

    def ping(self) -> None:
        """Make the browser answer."""
        if self._is_open:
            self._protocol.send_ping(b"")
            self._write_protocol_output()

    def _close_with(self, code: int, reason: str, lasts_s: float) -> None:
        if self._transport is None or not self._is_open:
            return
        self._protocol.send_close(code, reason)
        self._write_protocol_output()
        self._is_open = False
        self._loop.call_later(lasts_s, self._transport.abort)

    def send(self, messages: list[bytes]) -> None:
        """Send texts, all in one write."""
        if not self._is_open or self._transport is None:
            return
        if len(messages) == 1:
            data = text_header(len(messages[0])) + messages[0]
        else:
            data = b"".join([text_header(len(text)) + text for text in messages])
        # The transport would send at the end of the loop's turn; writing to the socket directly is 0.1 ms sooner on
        # a busy machine. What the system does not take at once goes to the transport.
        if self._fd >= 0 and self._transport.get_write_buffer_size() == 0:
            try:
                written = os.write(self._fd, data)
            except BlockingIOError:
                written = 0
            except OSError:
                return  # the transport notices too, and calls connection_lost
            if written == len(data):
                return
            data = data[written:]
        self._transport.write(data)

    def unsent_bytes(self) -> int:
        """Bytes that wait in this process."""
        return 0 if self._transport is None else self._transport.get_write_buffer_size()

    def _take_short_texts(self, data: bytes) -> bytes:
        """Take the whole, short texts that `data` begins with, and return what the protocol has to take.

        Nearly all that a browser sends is an acknowledgement; the protocol takes ten times as long for each.
        """
        start = 0
        while (body := start + _SHORT_HEAD_BYTES) <= len(data) and data[start] == _WHOLE_TEXT and not self._fragments:
            size = data[start + 1] - _MASKED
            end = body + size
            if not 0 <= size < _LONG or end > len(data) or not self._messages.take(self._loop.time()):
                break
            if self._conversation is not None:
                text = apply_mask(data[body:end], data[start + 2 : body])
                self._conversation.on_text(text.decode("utf-8", "replace"))
            start = end
        rest = data[start:]
        if rest:
            # A control frame that is whole leaves the next frame's beginning known.
            is_control = len(rest) >= _SHORT_HEAD_BYTES and rest[0] & _CONTROL == _CONTROL
            self._is_aligned = is_control and len(rest) == _SHORT_HEAD_BYTES + rest[1] - _MASKED
        return rest

    def _work_on(self) -> float | None:
        """Handle one turn's share of the pending bytes; the rest waits for the loop's next turn."""
        transport = self._transport
        piece, self._pending = self._pending[:BYTES_PER_TURN], self._pending[BYTES_PER_TURN:]
        if transport is None:
            return None
        if piece:
            self._protocol.receive_data(piece)
            self._work()
        if transport.is_closing():
            return None
        if self._pending:
            return 0.0
        transport.resume_reading()  # also after giving up: later bytes are discarded
        return None

    def _work(self) -> None:
        for event in self._protocol.events_received():
            if isinstance(event, Request):
                self._shake_hands(event)
            elif isinstance(event, Frame):
                self._take_frame(event)
        self._write_protocol_output()
        if self._is_open and self._protocol.state is not State.OPEN:
            self._is_open = False
        if self._protocol.close_expected() and self._transport is not None:
            self._transport.close()

    def _write_protocol_output(self) -> None:
        for data in self._protocol.data_to_send():
            if self._transport is None:
                return
            if data:
                self._transport.write(data)
            elif self._transport.can_write_eof():
                self._transport.write_eof()

    def _shake_hands(self, request: Request) -> None:
        transport = self._transport
        if transport is None:
            return
        try:
            parts = address_parts(request.path)
            self._endpoint.check(request.headers.get_all)
            query = dict(parse_qsl(parts.query, keep_blank_values=True))
            conversation = self._endpoint.open(self, parts.path, query)
        except Refusal as refusal:
            self._protocol.send_response(self._protocol.reject(refusal.status, f"{refusal.text}\n"))
            return
        response = self._protocol.accept(request)
        self._protocol.send_response(response)
        if response.status_code != HTTPStatus.SWITCHING_PROTOCOLS:
            conversation.on_closed()
            return
        self._write_protocol_output()
        self._conversation = conversation
        self._is_open = True
        self._is_aligned = not self._protocol.reader.buffer
        # Under TLS -1: the transport alone may write, or plain text would get between the records.
        is_tls = transport.get_extra_info("sslcontext") is not None
        self._fd = -1 if is_tls else transport.get_extra_info("socket").fileno()
        self.heard = 0  # the handshake is the browser's, and says nothing of its page
        self._keepalive.arm(_KEEPALIVE_S)
        self._endpoint.opened(conversation)

    def _take_frame(self, frame: Frame) -> None:
        """Pass messages to the conversation; give the connection up if frames come faster than allowed."""
        is_message = frame.opcode in (Opcode.TEXT, Opcode.CONT, Opcode.BINARY)
        if self._given_up:
            return
        if not (self._messages if is_message else self._pings).take(self._loop.time()):
            self._give_up()
            return
        if is_message:
            self._fragments.append(bytes(frame.data))
            if frame.fin:
                data, self._fragments = b"".join(self._fragments), []
                if self._conversation is not None:
                    self._conversation.on_text(data.decode("utf-8", "replace"))

    def _give_up(self) -> None:
        """Send the reason, ignore further input, and close later: closing at once could lose the reason on its way."""
        self._given_up = True
        self._pending = b""
        self._protocol.fail(_TOO_MUCH, "more frames than this station takes")
        if self._transport is not None:
            self._loop.call_later(_LAST_WORDS_S, self._transport.abort)

    def _check_alive(self) -> float | None:
        """Close the connection if nothing arrived since the last ping; else ping again."""
        if self._transport is None:
            return None
        if not self._answered:
            self._transport.abort()
            return None
        self._answered = False
        self.ping()
        return _KEEPALIVE_S


def _nothing() -> None:
    """Default for `on_lost`: do nothing."""


def text_header(size: int) -> bytes:
    """The head of an unmasked, unsplit text frame of this size (RFC 6455, 5.2)."""
    if size < 126:
        return bytes((0x81, size))
    if size < 65536:
        return b"\x81\x7e" + size.to_bytes(2, "big")
    return b"\x81\x7f" + size.to_bytes(8, "big")
