"""One flight's samples, of whatever kind it is: `indexed.py` reads a finished one, `growing.py` the one in the air.

Questions (`answers.py`) are the same for both.
"""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Callable, Mapping
from typing import Any, Final, NamedTuple, Protocol, TypeVar

import numpy as np

from epf_gcs.errors import NotFoundError
from epf_gcs.flights.fields import FieldMeaning, fields_of
from epf_gcs.flights.signals import Array, usual_period_s
from epf_gcs.recordings.notes import Note

# Of two hours at 50 Hz one takes 6 MB.
_MOST_COMPUTED: Final = 8
T = TypeVar("T")


class TopicSpan(NamedTuple):
    """A topic that a flight has: the number of its samples and the Unix times (ns) of the first and the last."""

    name: str
    samples: int
    first_ns: int
    last_ns: int


Damage = tuple[int, str]
"""Unix time (ns) and kind of what the line damaged."""


class Samples(NamedTuple):
    """One field: times in seconds since the flight's start, in order, and values (NaN: no value), both (n,)."""

    t_s: Array
    values: Array


class FlightData(Protocol):
    """What is asked of a flight. Raises RecordingError or OSError where its files cannot be read."""

    @property
    def start_ns(self) -> int:
        """Unix time of the first message."""

    @property
    def end_ns(self) -> int:
        """Unix time of the last message so far."""

    def topics(self) -> list[TopicSpan]:
        """The topics that have samples."""

    def fields(self, topic: str) -> Mapping[str, FieldMeaning]:
        """The fields of a topic by name; empty for one that is neither defined nor of the flight's own."""

    def samples(self, topic: str, field: str) -> Samples:
        """All samples of one field that is a number or a flag. Raises NotFoundError."""

    def notes(self) -> list[Note]:
        """All notes, in order of the file."""


class PeriodCache:
    """The usual period of each topic of one flight, which changes too little to be asked for again and again; and the
    signals that were computed last."""

    def __init__(self) -> None:
        self._found: dict[str, tuple[int, float | None]] = {}
        self._computed: OrderedDict[str, tuple[int, Any]] = OrderedDict()

    def computed(self, name: str, end_ns: int, compute: Callable[[], T]) -> T:
        """A signal of a flight that reaches to `end_ns`: as it was computed last, or anew if the flight has grown."""
        held = self._computed.get(name)
        if held is None or held[0] != end_ns:
            held = self._computed[name] = (end_ns, compute())
            while len(self._computed) > _MOST_COMPUTED:
                self._computed.popitem(last=False)
        self._computed.move_to_end(name)
        found: T = held[1]
        return found

    def of(self, topic: str, t_s: Array) -> float | None:
        """The usual period of these times (seconds); found anew when there are twice as many samples."""
        count, period_s = self._found.get(topic, (0, None))
        if len(t_s) > 2 * count or len(t_s) < count:
            count, period_s = len(t_s), usual_period_s(t_s)
            self._found[topic] = (count, period_s)
        return period_s


def in_order(t_s: Array, values: Array) -> Samples:
    """Samples in order of time; a clock that was set back leaves a file that is not."""
    if len(t_s) > 1 and np.any(np.diff(t_s) < 0):
        order = np.argsort(t_s, kind="stable")
        return Samples(t_s[order], values[order])
    return Samples(t_s, values)


def read_field(flight: FlightData, topic: str, field: str) -> Samples:
    """All samples of one field; empty where the flight does not have the topic.

    Raises KeyError for a name that the definition does not have: it is a fault of the caller.
    """
    fields_of(topic)[field]
    try:
        return flight.samples(topic, field)
    except NotFoundError:
        return Samples(np.empty(0), np.empty(0))


def split_name(flight: FlightData, name: str) -> tuple[str, str]:
    """Topic and field of `topic.field`. Raises NotFoundError where there is no such number or flag."""
    topic, _, field = name.partition(".")
    meaning = flight.fields(topic).get(field)
    if meaning is None or meaning.kind == "text":
        raise unknown_signal(name)
    return topic, field


def unknown_signal(name: str) -> NotFoundError:
    """There is no such signal in this flight."""
    return NotFoundError(
        "signal_unknown", f"This flight has no signal '{name}': its topics list those that it has.", signal=name
    )
