"""The stream between a vehicle and a station: its records and how they are packed, for any transport.

Every record is a header (u32 length of the body, u8 kind, little endian) and a body.

From the vehicle:
  HELLO    JSON of `contract.hello.Hello`
  SAMPLE   f64 Unix time, u8 length of the topic's name, the name, then the JSON text
           {"topic": ..., "t_s": ..., "values": {...}} as viewers get it
  EVENT    as SAMPLE, with the event's kind as the name and {"type": "event", "event": ..., "t_s": ..., "data": {...}}
  STATUS   JSON of `contract.status.Status`
  ANSWER   u32 number of the request, then JSON: {"result": ...} of the request's type, or {"fault": {...}} (see
           `faults.py`)
  BYE      empty; the vehicle's process ends because it was told to
  PLAYBACK JSON of `contract.playback.Playback`, from a replayed vehicle. When its `jumps` has changed, the samples
           before it are of another moment; the newest sample of every topic follows
To the vehicle:
  REQUEST  u32 number, then JSON: {"name": ..., "arguments": {...}, "by": {"client": ..., "name": ...} or null}; the
           name is a class of `contract.requests`, the arguments are its fields
  NOTICE   JSON: {"name": ..., "arguments": {...}}, of a class of `contract.notices`; it has no answer

A connection begins with HELLO, followed by the newest SAMPLE of every topic. Every SAMPLE is sent as soon as it is
heard, unless the station has said that it looks only so many times a second: then samples are gathered and sent
together, at most `rate_hz` times a second and none left out, until it says 0. A station works with any vehicle that
sends this stream: the live one, a replayed one, or one on another machine.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from enum import IntEnum
from struct import Struct
from typing import Any, Final, NamedTuple, TypeVar

import msgspec
import orjson

from epf_gcs.contract.base import PageFacts
from epf_gcs.contract.events import Event
from epf_gcs.contract.notices import Notice
from epf_gcs.contract.requests import Request

# An answer that holds all gains, plans or the inspector's tables is some 100 kB.
MAX_BODY_BYTES: Final = 8_000_000

_HEADER: Final = Struct("<IB")
_STAMP: Final = Struct("<dB")
_NUMBER: Final = Struct("<I")

# A NamedTuple's own constructor is a Python function; this is half of the cost of cutting out a record.
_new_tuple: Final = tuple.__new__


class Kind(IntEnum):
    """What a record is."""

    HELLO = 1
    SAMPLE = 2
    EVENT = 3
    STATUS = 4
    ANSWER = 5
    BYE = 6
    PLAYBACK = 7
    REQUEST = 16
    NOTICE = 17


@dataclass(frozen=True, slots=True)
class Asker:
    """Who asks: the id of a browser or program, and the name that is shown to others. Both may be unknown."""

    client: str | None = None
    name: str | None = None


@dataclass(frozen=True, slots=True)
class Client:
    """A page on the stream. `name` is its name as others see it."""

    id: str
    name: str
    about: PageFacts = field(default_factory=PageFacts, compare=False)


class BusError(Exception):
    """The other side sent something that is not this stream: the connection must be closed."""


class Record(NamedTuple):
    """One record as it came."""

    kind: int
    body: bytes


class NamedText(NamedTuple):
    """The body of a SAMPLE or an EVENT. `text` is JSON, ready for a viewer."""

    t_s: float
    name: str
    text: bytes


def pack(kind: Kind, body: bytes) -> bytes:
    """One record."""
    return _HEADER.pack(len(body), kind) + body


def pack_sample(topic: str, t_s: float, values: Any) -> bytes:
    """The newest values of a topic."""
    name = topic.encode()
    text = b'{"topic":"%b","t_s":%.6f,"values":%b}' % (name, t_s, orjson.dumps(values))
    return _HEADER.pack(_STAMP.size + len(name) + len(text), Kind.SAMPLE) + _STAMP.pack(t_s, len(name)) + name + text


def event_text(name: str, t_s: float, data: Any) -> bytes:
    """An event as viewers are told it: JSON."""
    return orjson.dumps({"type": "event", "event": name, "t_s": t_s, "data": data})


def pack_event(event: Event, t_s: float) -> bytes:
    """Something that happened."""
    name = event.NAME.encode()
    text = event_text(event.NAME, t_s, event)
    return pack(Kind.EVENT, _STAMP.pack(t_s, len(name)) + name + text)


def unpack_named(body: bytes) -> NamedText:
    """The body of a SAMPLE or an EVENT. Raises BusError."""
    if len(body) < _STAMP.size:
        raise BusError("a record is shorter than its fields")
    t_s, length = _STAMP.unpack_from(body)
    end = _STAMP.size + length
    if len(body) < end:
        raise BusError("a record is shorter than its name")
    try:
        return _new_tuple(NamedText, (t_s, body[_STAMP.size : end].decode(), body[end:]))
    except UnicodeDecodeError as error:
        raise BusError("a record's name is not text") from error


def pack_numbered(kind: Kind, number: int, value: Any) -> bytes:
    """A REQUEST or an ANSWER."""
    return pack(kind, _NUMBER.pack(number) + orjson.dumps(value))


def unpack_numbered(body: bytes) -> tuple[int, dict[str, Any]]:
    """Number and object of a REQUEST or an ANSWER. Raises BusError."""
    if len(body) < _NUMBER.size:
        raise BusError("a record is shorter than its fields")
    return int(_NUMBER.unpack_from(body)[0]), unpack_object(body[_NUMBER.size :])


def pack_request(number: int, request: Request[Any], by: Asker | None) -> bytes:
    """A REQUEST."""
    return pack_numbered(Kind.REQUEST, number, {"name": type(request).__name__, "arguments": request, "by": by})


def pack_notice(notice: Notice) -> bytes:
    """A NOTICE."""
    return pack(Kind.NOTICE, orjson.dumps({"name": type(notice).__name__, "arguments": notice}))


T = TypeVar("T")


def unpack_as(kind: type[T], body: bytes) -> T:
    """Decode a body that is JSON of this type: the one place where what came is held against the contract.

    Raises BusError.
    """
    try:
        return msgspec.json.decode(body, type=kind)
    except msgspec.DecodeError as error:
        raise BusError(f"a record is no {kind.__name__}: {error}") from error


def converted(kind: Any, value: Any) -> Any:
    """Plain values as a type of the contract. Raises BusError."""
    try:
        return msgspec.convert(value, kind)
    except msgspec.ValidationError as error:
        raise BusError(f"a record does not fit {getattr(kind, '__name__', kind)}: {error}") from error


def unpack_object(body: bytes) -> dict[str, Any]:
    """Decode a body that is a JSON object. Raises BusError."""
    return unpack_as(dict[str, Any], body)


class Decoder:
    """Cuts a stream of bytes into records, in whatever pieces it arrives."""

    def __init__(self) -> None:
        self._held = bytearray()

    def feed(self, data: bytes) -> list[Record]:
        """The records that are complete now. Raises BusError if a record is announced that is too long."""
        if self._held:
            self._held += data
            data = bytes(self._held)
        found: list[Record] = []
        start, size = 0, len(data)
        while size - start >= _HEADER.size:
            length, kind = _HEADER.unpack_from(data, start)
            if length > MAX_BODY_BYTES:
                raise BusError(f"a record of {length} bytes is announced")
            end = start + _HEADER.size + length
            if end > size:
                break
            found.append(_new_tuple(Record, (kind, data[start + _HEADER.size : end])))
            start = end
        if start < size or self._held:
            self._held = bytearray(data[start:])
        return found
