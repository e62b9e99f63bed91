"""Answers questions about flights, one after the other: `python -m epf_gcs.flights serve DATA_FOLDER`.

Requests come on standard input, answers go to standard output, each a JSON head and bytes (`workers/pipe.py`). A
request is one of `contract/flight_questions.py`. The answer's bytes are what the interface sends on; its head is empty,
or has the fault.
"""

from __future__ import annotations

import signal
import sys
from collections import OrderedDict
from dataclasses import dataclass, field
from pathlib import Path
from typing import BinaryIO, Final, cast

import msgspec
import orjson

from epf_gcs.contract.flight_questions import (
    AnyFlightQuestion,
    EventsQuestion,
    KnownQuestion,
    OverviewQuestion,
    PathQuestion,
    SignalsQuestion,
    SpanQuestion,
    TopicsQuestion,
    TrackQuestion,
)
from epf_gcs.contract.flights import FlightTimes
from epf_gcs.errors import GatewayError
from epf_gcs.flights import answers
from epf_gcs.flights.derived import split_names
from epf_gcs.flights.events import FILE, Event, as_answer, find_events, read_events
from epf_gcs.flights.flight_data import PeriodCache
from epf_gcs.flights.flown_path import flown_path
from epf_gcs.flights.growing import GrowingFlight
from epf_gcs.flights.indexed import Columns, IndexedFlight, not_indexed, open_indexed
from epf_gcs.flights.worker import be_modest
from epf_gcs.recordings.places import Places, is_id
from epf_gcs.workers.lines import ToldFault
from epf_gcs.workers.pipe import ReplyHead, receive, send

_MOST_OPEN: Final = 8


@dataclass(slots=True)
class _Open:
    """A flight that was asked for lately. `made` is when its columns were made; 0 while it is recorded."""

    data: IndexedFlight | GrowingFlight
    made: int
    folder: Path | None = None
    periods: PeriodCache = field(default_factory=PeriodCache)


class Flights:
    """The flights that were asked for last."""

    def __init__(self, places: Places) -> None:
        self._places = places
        self._columns = Columns()
        self._open: OrderedDict[str, _Open] = OrderedDict()

    def answer(self, question: AnyFlightQuestion) -> bytes:
        """The answer's bytes. Raises GatewayError, OSError."""
        flight = question.flight
        if not is_id(flight):
            raise not_indexed(flight)
        opened = self._growing(flight) if question.growing else self._indexed(flight)
        self._open.move_to_end(flight)
        while len(self._open) > _MOST_OPEN:
            self._open.popitem(last=False)
        return _answer(opened, question)

    def _indexed(self, flight: str) -> _Open:
        folder = self._places.made_of(flight)
        if folder is None:
            raise not_indexed(flight)
        found = self._open.get(flight)
        made = folder.stat().st_mtime_ns
        if found is None or found.made != made:
            data = open_indexed(folder, self._places.recording(flight), self._columns)
            found = self._open[flight] = _Open(data, made, folder)
        return found

    def _growing(self, flight: str) -> _Open:
        found = self._open.get(flight)
        if found is None or not isinstance(found.data, GrowingFlight):
            found = self._open[flight] = _Open(GrowingFlight(self._places.recording(flight)), 0)
        if isinstance(found.data, GrowingFlight):
            found.data.advance()
        return found


def main(arguments: list[str]) -> int:
    """Answer until standard input closes, as it does when the parent dies."""
    # Ctrl-C in a terminal reaches all its processes: the web process ends this one.
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    be_modest(most_cpu_s=None, is_waited_for=True)
    send(sys.stdout.buffer, ReplyHead())
    serve(Flights(Places(Path(arguments[0]))), sys.stdin.buffer, sys.stdout.buffer)
    return 0


def serve(flights: Flights, requests: BinaryIO, replies: BinaryIO) -> None:
    """Answer one request after the other."""
    while (message := receive(requests)) is not None:
        head = ReplyHead()
        body = b""
        try:
            body = flights.answer(msgspec.json.decode(message[0], type=AnyFlightQuestion))
        except GatewayError as error:
            head = ReplyHead(ToldFault.of(error))
        except (OSError, ValueError, ArithmeticError, LookupError, TypeError, AttributeError) as error:
            # A stranger's recording may hold notes of any shape: none may end this program.
            why = getattr(error, "strerror", None) or str(error) or type(error).__name__
            head = ReplyHead(ToldFault("recording_unreadable", f"The flight cannot be read: {why}.", {"reason": why}))
        send(replies, head, body)


def _answer(opened: _Open, question: AnyFlightQuestion) -> bytes:
    data = opened.data
    match question:
        case SignalsQuestion(names=names, from_s=from_s, to_s=to_s, points=points):
            found = answers.signals(data, opened.periods, split_names(names), from_s, to_s, points)
            return answers.as_arrow(found) if question.arrow else orjson.dumps(found)
        case TopicsQuestion():
            return orjson.dumps(answers.topics(data))
        case EventsQuestion():
            return orjson.dumps(as_answer(_events(opened), data.start_ns))
        case OverviewQuestion(points=points):
            return orjson.dumps(answers.overview(data, opened.periods, points))
        case TrackQuestion(source=source):
            return answers.track(data, source, question.points)
        case PathQuestion(source=source, most=most):
            return orjson.dumps(flown_path(data, source, most))
        case KnownQuestion(at_s=at_s):
            return orjson.dumps(answers.known(data, at_s))
        case SpanQuestion():
            return orjson.dumps(FlightTimes(data.start_ns * 1e-9, data.end_ns * 1e-9))


def _events(opened: _Open) -> list[Event]:
    data = opened.data
    if isinstance(data, GrowingFlight):
        return find_events(data, data.silences, data.damage())
    return read_events(cast(Path, opened.folder) / FILE)
