"""/api/v1/stream: hello, then batches, events and status to a browser; acknowledgements, rate and stick back."""

from __future__ import annotations

import re
import secrets
from http import HTTPStatus
from typing import Any, Final

import orjson

from epf_gcs import __version__
from epf_gcs.codec.messages_gen import TELEMETRY
from epf_gcs.errors import ErrorCode, GatewayError
from epf_gcs.flight.station import Station
from epf_gcs.web.access.control import Client
from epf_gcs.web.access.guard import Access
from epf_gcs.web.state.routes import status_json
from epf_gcs.web.stream.socket import Conversation, Refusal, SocketConnection
from epf_gcs.web.stream.viewer import MAX_RATE_HZ, Viewer

STREAM_PATH: Final = "/api/v1/stream"
TOPICS: Final = sorted(
    {message.name for message in TELEMETRY.values() if message.topic}
    | {"xplane_info", "simulator", "xplane_rows", "ahrs_test"}
)
_CLIENT_ID: Final = re.compile(r"[0-9a-f]{16}")
_MAX_NAME: Final = 40
_MAX_DIGITS: Final = 4
_INVALID: Final = "stream_message_invalid"
_RATE_SENTENCE: Final = f"rate must be 0 (every sample) or 1..{MAX_RATE_HZ} batches a second."


class StreamEndpoint:
    """Makes a viewer of each browser that may come in. Implements `epf_gcs.web.stream.socket.Endpoint`."""

    def __init__(self, station: Station, access: Access) -> None:
        self._station = station
        self._access = access

    def check(self, host: str | None, origin: str | None) -> None:
        """Raise Refusal for a foreign name or page."""
        try:
            self._access.check_host(host)
            self._access.check_origin(origin, host)
        except GatewayError as error:
            self._station.errors.count(error.code)
            raise Refusal(HTTPStatus.FORBIDDEN, error.detail) from error

    def open(self, connection: SocketConnection, path: str, query: dict[str, str], peer: str) -> StreamConversation:
        """Read the address. Raises Refusal where it is another one or the rate is none."""
        if path != STREAM_PATH:
            raise Refusal(HTTPStatus.NOT_FOUND, f"The stream is at {STREAM_PATH}.")
        rate_hz = _read_rate(query.get("rate", str(MAX_RATE_HZ)))
        if rate_hz is None:
            self._station.errors.count("rate_invalid")
            raise Refusal(
                HTTPStatus.BAD_REQUEST, f"rate must be 0 (every sample) or 1..{MAX_RATE_HZ} batches a second."
            )
        wished = query.get("client", "")
        known = _CLIENT_ID.fullmatch(wished) is not None and not self._station.control.is_connected(wished)
        name = query.get("name", "")
        client = Client(
            wished if known else secrets.token_hex(8),
            name if 0 < len(name) <= _MAX_NAME and name.isprintable() else peer,
        )
        return StreamConversation(self._station, connection, client, rate_hz)

    def opened(self, conversation: Conversation) -> None:
        """The handshake is done: greet."""
        if isinstance(conversation, StreamConversation):
            conversation.greet()


class StreamConversation:
    """One browser. Implements `epf_gcs.web.stream.socket.Conversation`."""

    def __init__(self, station: Station, connection: SocketConnection, client: Client, rate_hz: int) -> None:
        self._station = station
        self._client = client
        self._viewer = Viewer(client.id, client.name, connection, station.hub.state, rate_hz)
        self._greeted = False

    def greet(self) -> None:
        """Who it is, what there is, and how everything stands."""
        station = self._station
        self._greeted = True
        station.control.connect(self._client)
        station.stick.gone(self._client.id)
        holder = station.control.holder
        hello = {
            "type": "hello",
            "version": __version__,
            "client": self._client.id,
            "name": self._client.name,
            "role": "operator" if holder is not None and holder.id == self._client.id else "viewer",
            "server_time_s": station.clock.now_s(),
            "topics": TOPICS,
            "status": orjson.Fragment(status_json(station)),
        }
        self._viewer.greet(orjson.dumps(hello))
        station.hub.add(self._viewer)
        station.changed()

    def on_text(self, text: str) -> None:
        """An acknowledgement, a rate or a stick; anything else is counted and answered with an error event."""
        fault = self._take(text)
        if fault is not None:
            code, detail = fault
            self._station.errors.count(code)
            event = self._station.hub.event_text("error", {"code": code, "detail": detail, "params": {}, "count": 1})
            self._viewer.offer_event(event)
            self._station.hub.serve(self._viewer)

    def on_closed(self) -> None:
        """The browser went."""
        self._station.hub.remove(self._viewer)
        if self._greeted:
            self._station.stick.gone(self._client.id)
            self._station.control.disconnect(self._client)
            self._station.changed()

    def _take(self, text: str) -> tuple[ErrorCode, str] | None:
        """Code and sentence of what is wrong with a message; None where nothing is."""
        try:
            message: Any = orjson.loads(text)
        except orjson.JSONDecodeError:
            return _INVALID, 'A message on the stream was not JSON: send {"type": "ack", "seq": n} or a rate.'
        match message:
            case {"type": "ack", "seq": int(seq)} if self._viewer.acknowledge(seq):
                if self._viewer.waiting:
                    self._station.hub.serve(self._viewer)
                return None
            case {"type": "ack"}:
                return _INVALID, "An acknowledgement named a batch that is not under way: send the seq of a batch."
            case {"type": "rate", "rate": int(rate)} if 0 <= rate <= MAX_RATE_HZ:
                self._station.hub.change_rate(self._viewer, rate)
                return None
            case {"type": "rate"}:
                return _INVALID, _RATE_SENTENCE
            case {"type": "stick"}:
                fault = self._station.stick.take(self._client.id, message)
                return None if fault is None else ("stick_invalid", fault)
            case _:
                return _INVALID, "A message on the stream has no known type: send an ack, a rate or a stick."


def _read_rate(text: str) -> int | None:
    if not text.isascii() or not text.isdigit() or len(text) > _MAX_DIGITS or int(text) > MAX_RATE_HZ:
        return None
    return int(text)
