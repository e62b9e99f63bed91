"""Answers questions about flights, one after the other: `python -m epf_gcs.flights serve DATA_FOLDER`.

Requests come on standard input, answers go to standard output, each a JSON head and bytes (`worker_pipe`). A request
is {"do": a key of _ANSWERS, "flight": id, "growing": bool, and what the question needs}. The answer's bytes are what
the interface sends on; its head is empty, or the fault.
"""

from __future__ import annotations

import signal
import sys
from collections import OrderedDict
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, BinaryIO, Final, cast

import orjson

from epf_gcs.errors import GatewayError
from epf_gcs.flights import answers
from epf_gcs.flights.derived import split_names
from epf_gcs.flights.events import FILE, as_answer, find_events, read_events
from epf_gcs.flights.flight_data import PeriodCache
from epf_gcs.flights.growing import GrowingFlight
from epf_gcs.flights.indexed import Columns, IndexedFlight, not_indexed, open_indexed
from epf_gcs.flights.worker import be_modest
from epf_gcs.recordings.places import Places, is_id
from epf_gcs.workers.pipe import receive, send

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

    def answer(self, asked: dict[str, Any]) -> bytes:
        """The answer's bytes. Raises GatewayError, OSError."""
        flight = asked["flight"]
        if not is_id(flight):
            raise not_indexed(flight)
        opened = self._growing(flight) if asked["growing"] else self._indexed(flight)
        self._open.move_to_end(flight)
        while len(self._open) > _MOST_OPEN:
            self._open.popitem(last=False)
        return _ANSWERS[asked["do"]](opened, asked)

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
    send(sys.stdout.buffer, {})
    serve(Flights(Places(Path(arguments[0]))), sys.stdin.buffer, sys.stdout.buffer)
    return 0


def serve(flights: Flights, requests: BinaryIO, replies: BinaryIO) -> None:
    """Answer one request after the other."""
    while (message := receive(requests)) is not None:
        head: dict[str, Any] = {}
        body = b""
        try:
            body = flights.answer(message[0])
        except GatewayError as error:
            head = error.as_dict()
        except (OSError, ValueError, ArithmeticError, LookupError, TypeError, AttributeError) as error:
            # A stranger's recording may hold notes of any shape: none may end this program.
            why = getattr(error, "strerror", None) or str(error) or type(error).__name__
            head = {
                "code": "recording_unreadable",
                "detail": f"The flight cannot be read: {why}.",
                "params": {"reason": why},
            }
        send(replies, head, body)


def _signals(opened: _Open, asked: dict[str, Any]) -> bytes:
    names = split_names(asked["names"])
    found = answers.signals(opened.data, opened.periods, names, asked["from_s"], asked["to_s"], asked["points"])
    return answers.as_arrow(found) if asked["arrow"] else _json(found)


def _topics(opened: _Open, _asked: dict[str, Any]) -> bytes:
    return _json(answers.topics(opened.data))


def _events(opened: _Open, _asked: dict[str, Any]) -> bytes:
    data = opened.data
    if isinstance(data, GrowingFlight):
        events = find_events(data, data.silences, data.damage())
    else:
        events = read_events(cast(Path, opened.folder) / FILE)
    return _json(as_answer(events, data.start_ns))


def _overview(opened: _Open, asked: dict[str, Any]) -> bytes:
    return _json(answers.overview(opened.data, opened.periods, asked["points"]))


def _track(opened: _Open, asked: dict[str, Any]) -> bytes:
    return answers.track(opened.data, asked["source"], asked["points"])


def _known(opened: _Open, asked: dict[str, Any]) -> bytes:
    return _json(answers.known(opened.data, asked["at_s"]))


def _span(opened: _Open, _asked: dict[str, Any]) -> bytes:
    return _json({"start_s": opened.data.start_ns * 1e-9, "end_s": opened.data.end_ns * 1e-9})


def _json(found: Any) -> bytes:
    return orjson.dumps(found, option=orjson.OPT_SERIALIZE_NUMPY)


_ANSWERS: Final[dict[str, Callable[[_Open, dict[str, Any]], bytes]]] = {
    "events": _events,
    "known": _known,
    "overview": _overview,
    "signals": _signals,
    "span": _span,
    "topics": _topics,
    "track": _track,
}
