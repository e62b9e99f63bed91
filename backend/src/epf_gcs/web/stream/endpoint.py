"""/api/v1/stream, live or of a recording (`?flight=`): who gets which; and the conversation with a live browser."""

from __future__ import annotations

import re
import secrets
from dataclasses import dataclass
from http import HTTPStatus
from typing import Any, Final

import orjson

from epf_gcs import __version__
from epf_gcs.bus.definition import Client
from epf_gcs.bus.station_end import StationEnd
from epf_gcs.clock import Clock
from epf_gcs.error_log import ErrorLog
from epf_gcs.errors import ErrorCode, GatewayError
from epf_gcs.web.access.control import Control
from epf_gcs.web.access.guard import Access
from epf_gcs.web.flights.replay_conversation import ReplayConversation
from epf_gcs.web.flights.replays import Replays
from epf_gcs.web.state.whole import WholeStatus
from epf_gcs.web.stream.hub import Hub
from epf_gcs.web.stream.messages import INVALID, RATE_SENTENCE, TOPICS
from epf_gcs.web.stream.socket import Conversation, Refusal, SocketConnection
from epf_gcs.web.stream.viewer import MAX_RATE_HZ, Viewer
from epf_gcs.xplane.stick import SAMPLE_FAULT, read_sample

STREAM_PATH: Final = "/api/v1/stream"
_CLIENT_ID: Final = re.compile(r"[0-9a-f]{16}")
_MAX_NAME: Final = 40
_MAX_DIGITS: Final = 4


@dataclass(frozen=True, slots=True)
class StreamParts:
    """The parts that a conversation uses."""

    hub: Hub
    control: Control
    vehicle: StationEnd
    status: WholeStatus
    errors: ErrorLog
    clock: Clock
    replays: Replays


class StreamEndpoint:
    """Makes a viewer for each browser that is accepted. Implements `epf_gcs.web.stream.socket.Endpoint`."""

    def __init__(self, parts: StreamParts, access: Access) -> None:
        self._parts = parts
        self._access = access

    def check(self, host: str | None, origin: str | None) -> None:
        """Raise Refusal if Host is not a name of this server, or if the page is another server's."""
        try:
            self._access.check_host(host)
            self._access.check_origin(origin, host)
        except GatewayError as error:
            self._parts.errors.count(error.code)
            raise Refusal(HTTPStatus.FORBIDDEN, error.detail) from error

    def open(self, connection: SocketConnection, path: str, query: dict[str, str], peer: str) -> Conversation:
        """Read path and query of the URL. Raises Refusal for an unknown path or an invalid rate."""
        if path != STREAM_PATH:
            raise Refusal(HTTPStatus.NOT_FOUND, f"The stream is at {STREAM_PATH}.")
        rate_hz = _read_rate(query.get("rate", str(MAX_RATE_HZ)))
        if rate_hz is None:
            self._parts.errors.count("rate_invalid")
            raise Refusal(HTTPStatus.BAD_REQUEST, RATE_SENTENCE)
        if "flight" in query:
            return self._parts.replays.open(connection, query, rate_hz, peer)
        wished = query.get("client", "")
        known = _CLIENT_ID.fullmatch(wished) is not None and not self._parts.control.is_connected(wished)
        name = query.get("name", "")
        client = Client(
            wished if known else secrets.token_hex(8),
            name if 0 < len(name) <= _MAX_NAME and name.isprintable() else peer,
        )
        return StreamConversation(self._parts, connection, client, rate_hz)

    def opened(self, conversation: Conversation) -> None:
        """The handshake is done: send the hello."""
        if isinstance(conversation, StreamConversation | ReplayConversation):
            conversation.greet()


class StreamConversation:
    """One browser. Implements `epf_gcs.web.stream.socket.Conversation`."""

    def __init__(self, parts: StreamParts, connection: SocketConnection, client: Client, rate_hz: int) -> None:
        self._parts = parts
        self._client = client
        self._viewer = Viewer(client.id, client.name, connection, parts.hub.state, rate_hz)
        self._greeted = False

    def greet(self) -> None:
        """Send the hello: the browser's id and role, the topics and the status."""
        parts = self._parts
        self._greeted = True
        parts.control.connect(self._client)
        parts.vehicle.notice("stick_gone", client=self._client.id)
        holder = parts.control.holder
        hello = {
            "type": "hello",
            "version": __version__,
            "client": self._client.id,
            "name": self._client.name,
            "role": "operator" if holder is not None and holder.id == self._client.id else "viewer",
            "server_time_s": parts.clock.now_s(),
            "topics": TOPICS,
            "status": orjson.Fragment(parts.status.text()),
        }
        self._viewer.greet(orjson.dumps(hello))
        parts.hub.add(self._viewer)
        parts.status.changed()

    def on_text(self, text: str) -> None:
        """An acknowledgement, a rate or a stick; anything else is counted and answered with an error event."""
        fault = self._take(text)
        if fault is not None:
            code, detail = fault
            self._parts.errors.count(code)
            event = self._parts.hub.event_text("error", {"code": code, "detail": detail, "params": {}, "count": 1})
            self._viewer.offer_event(event)
            self._parts.hub.serve(self._viewer)

    def on_closed(self) -> None:
        """The browser disconnected."""
        self._parts.hub.remove(self._viewer)
        if self._greeted:
            self._parts.vehicle.notice("stick_gone", client=self._client.id)
            self._parts.control.disconnect(self._client)
            self._parts.status.changed()

    def _take(self, text: str) -> tuple[ErrorCode, str] | None:
        """Handle a message; code and sentence of the error, None if it was valid."""
        try:
            message: Any = orjson.loads(text)
        except orjson.JSONDecodeError:
            return INVALID, 'A message on the stream was not JSON: send {"type": "ack", "seq": n} or a rate.'
        match message:
            case {"type": "ack", "seq": int(seq)} if self._viewer.acknowledge(seq):
                if self._viewer.waiting:
                    self._parts.hub.serve(self._viewer)
                return None
            case {"type": "ack"}:
                return INVALID, "An acknowledgement named a batch that is not under way: send the seq of a batch."
            case {"type": "rate", "rate": int(rate)} if 0 <= rate <= MAX_RATE_HZ:
                self._parts.hub.change_rate(self._viewer, rate)
                return None
            case {"type": "rate"}:
                return INVALID, RATE_SENTENCE
            case {"type": "stick"}:
                # The flight process counts even an invalid sample; only this process can answer the sender.
                self._parts.vehicle.notice("stick", client=self._client.id, sample=message)
                return ("stick_invalid", SAMPLE_FAULT) if read_sample(message) is None else None
            case _:
                return INVALID, "A message on the stream has no known type: send an ack, a rate or a stick."


def _read_rate(text: str) -> int | None:
    if not text.isascii() or not text.isdigit() or len(text) > _MAX_DIGITS or int(text) > MAX_RATE_HZ:
        return None
    return int(text)
