"""/api/v1/stream, live or of a recording (`?flight=`): who gets which; and the conversation with a live browser."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from http import HTTPStatus
from typing import Any, Final

import orjson

from epf_gcs import __version__
from epf_gcs.access.caller import Caller
from epf_gcs.access.changes import Page
from epf_gcs.access.control import Control, fields
from epf_gcs.access.roles import Role, name_of
from epf_gcs.bus.station_end import StationEnd
from epf_gcs.clock import Clock
from epf_gcs.contract.events import AccessEvent, ErrorEvent
from epf_gcs.contract.notices import StickSample
from epf_gcs.error_log import ErrorLog
from epf_gcs.errors import ErrorCode, GatewayError, InvalidInputError
from epf_gcs.web.replays.busy_replay import BusyReplay
from epf_gcs.web.replays.replay_conversation import ReplayConversation
from epf_gcs.web.replays.replays import Replays
from epf_gcs.web.serving.origins import Access
from epf_gcs.web.state.whole import WholeStatus
from epf_gcs.web.stream.handshake import Refusal
from epf_gcs.web.stream.hub import Hub
from epf_gcs.web.stream.messages import INVALID, RATE_SENTENCE, TOPICS
from epf_gcs.web.stream.open_streams import OpenStreams
from epf_gcs.web.stream.socket import Conversation, SocketConnection
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
    streams: OpenStreams


class StreamEndpoint:
    """Makes a viewer for each browser that is accepted. Implements `epf_gcs.web.stream.socket.Endpoint`."""

    def __init__(self, parts: StreamParts, access: Access) -> None:
        self._parts = parts
        self._access = access

    def check(self, values: Callable[[str], Sequence[str]]) -> None:
        """`values` gives all values of a header. Raise Refusal if Host is not a name of this server, if the page is
        another server's, or if one of the two comes twice."""
        try:
            self._access.check(values, reads=False)
        except GatewayError as error:
            self._parts.errors.count(error.code)
            is_none = isinstance(error, InvalidInputError)
            raise Refusal(HTTPStatus.BAD_REQUEST if is_none else HTTPStatus.FORBIDDEN, error.detail) from error

    def open(self, connection: SocketConnection, path: str, query: dict[str, str]) -> Conversation:
        """Read path and query of the URL. Raises Refusal for a stranger, an unknown path or an invalid rate."""
        caller = connection.caller
        if caller is None:
            raise Refusal(HTTPStatus.UNAUTHORIZED, "This station answers only to those who were let in.")
        if path != STREAM_PATH:
            raise Refusal(HTTPStatus.NOT_FOUND, f"The stream is at {STREAM_PATH}.")
        rate_hz = _read_rate(query.get("rate", str(MAX_RATE_HZ)))
        if rate_hz is None:
            self._parts.errors.count("rate_invalid")
            raise Refusal(HTTPStatus.BAD_REQUEST, RATE_SENTENCE)
        if "flight" in query:
            leave = self._parts.streams.add(caller.session, connection)
            try:
                return self._parts.replays.open(connection, caller, query, rate_hz, leave)
            except Refusal:
                leave()
                raise
        wished, name = query.get("client", ""), query.get("name", "")
        return StreamConversation(
            self._parts,
            connection,
            caller,
            wished=wished if _CLIENT_ID.fullmatch(wished) else None,
            own_name=name if len(name) <= _MAX_NAME and name.isprintable() else "",
            rate_hz=rate_hz,
        )

    def opened(self, conversation: Conversation) -> None:
        """The handshake is done: send the hello."""
        if isinstance(conversation, StreamConversation | ReplayConversation | BusyReplay):
            conversation.greet()


class StreamConversation:
    """One browser. Implements `epf_gcs.web.stream.socket.Conversation` and `epf_gcs.access.watch.Line`."""

    def __init__(
        self,
        parts: StreamParts,
        connection: SocketConnection,
        caller: Caller,
        *,
        wished: str | None,
        own_name: str,
        rate_hz: int,
    ) -> None:
        """`wished`: the id that it had before; `own_name`: what it calls itself, or nothing."""
        self._parts = parts
        self._connection = connection
        self._caller = caller
        self._wished = wished
        self._own_name = own_name
        self._rate_hz = rate_hz
        self._open: _Open | None = None
        self.said = 0

    def greet(self) -> None:
        """Send the hello: the browser's id and role, the topics and the status."""
        parts, caller = self._parts, self._caller
        client = parts.control.client_for(self._wished, caller)
        page = parts.control.connect(client, caller, self._own_name, self)
        viewer = Viewer(client, page.name, self._connection, parts.hub.state, self._rate_hz)
        self._open = _Open(page, viewer, parts.streams.add(caller.session, self._connection))
        hello = {
            "type": "hello",
            "version": __version__,
            **fields(page),
            "role": page.role.name,
            "has_control": parts.control.holder == page,
            "server_time_s": parts.clock.now_s(),
            "topics": TOPICS,
            "status": orjson.Fragment(parts.status.text()),
        }
        viewer.greet(orjson.dumps(hello))
        parts.hub.add(viewer)
        parts.status.changed()

    @property
    def heard(self) -> int:
        """Pieces of anything that came."""
        return self._connection.heard

    @property
    def is_waited_for(self) -> bool:
        """Whether a batch is under way."""
        return self._open is not None and self._open.viewer.is_under_way

    def ping(self) -> None:
        """Make the browser answer."""
        self._connection.ping()

    def drop(self) -> None:
        """Close it at once: another stream takes its place."""
        self._connection.abort()
        self.on_closed()

    def renew(self, page: Page) -> None:
        """Its page has another role or name: say so to it."""
        if self._open is not None:
            self._open = replace(self._open, page=page)
            event = self._parts.hub.event_text(AccessEvent(name_of(page.role), page.name))
            self._open.viewer.offer_event(event)
            self._parts.hub.serve(self._open.viewer)

    def on_text(self, text: str) -> None:
        """An acknowledgement, a rate or a stick; anything else is counted and answered with an error event."""
        self.said += 1
        if self._open is None:
            return
        fault = self._take(self._open, text)
        if fault is not None:
            code, detail = fault
            self._parts.errors.count(code)
            event = self._parts.hub.event_text(ErrorEvent(code, detail, {}))
            self._open.viewer.offer_event(event)
            self._parts.hub.serve(self._open.viewer)

    def on_closed(self) -> None:
        """The browser disconnected. Idempotent."""
        opened, self._open = self._open, None
        if opened is not None:
            self._parts.hub.remove(opened.viewer)
            opened.leave()
            self._parts.control.disconnect(opened.page.client, self)
            self._parts.status.changed()

    def _take(self, opened: _Open, text: str) -> tuple[ErrorCode, str] | None:
        """Handle a message; code and sentence of the error, None if it was valid."""
        try:
            message: Any = orjson.loads(text)
        except orjson.JSONDecodeError:
            return INVALID, 'A message on the stream was not JSON: send {"type": "ack", "seq": n} or a rate.'
        match message:
            case {"type": "ack", "seq": int(seq)} if opened.viewer.acknowledge(seq):
                if opened.viewer.waiting:
                    self._parts.hub.serve(opened.viewer)
                return None
            case {"type": "ack"}:
                return INVALID, "An acknowledgement named a batch that is not under way: send the seq of a batch."
            case {"type": "rate", "rate": int(rate)} if 0 <= rate <= MAX_RATE_HZ:
                self._parts.hub.change_rate(opened.viewer, rate)
                return None
            case {"type": "rate"}:
                return INVALID, RATE_SENTENCE
            case {"type": "stick"}:
                return self._take_stick(opened.page, message)
            case _:
                return INVALID, "A message on the stream has no known type: send an ack, a rate or a stick."

    def _take_stick(self, page: Page, message: dict[str, Any]) -> tuple[ErrorCode, str] | None:
        if page.role < Role.operator:
            return "role_too_low", "The stick needs the role 'operator': ask an owner of this station."
        sample, control = read_sample(message), self._parts.control
        if sample is not None and not control.stick(page, sample[0]):
            # Not an error of the page: it learns only from the next status that it lost control.
            self._parts.status.strange_samples += 1
        elif control.holder == page:
            # The flight process counts even an invalid sample; only this process can answer the sender.
            self._parts.vehicle.notice(StickSample(page.client, message))
        return ("stick_invalid", SAMPLE_FAULT) if sample is None else None


@dataclass(frozen=True, slots=True)
class _Open:
    """A conversation that has begun."""

    page: Page
    viewer: Viewer
    leave: Callable[[], None]


def _read_rate(text: str) -> int | None:
    if not text.isascii() or not text.isdigit() or len(text) > _MAX_DIGITS or int(text) > MAX_RATE_HZ:
        return None
    return int(text)
