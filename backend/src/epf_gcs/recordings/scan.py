"""Find the records in a buffer of an MCAP file: exactly as a walk from length to length would, but in bulk.

Records are chained by their lengths, so the walk is sequential. Here every place that looks like a message is found
at once, each is linked to the place where it says that it ends, and whole runs of links are accepted together. Only
where a run breaks (a note, a chunk, a byte of a payload that looks like a message) one step is taken by hand.
"""

from __future__ import annotations

from struct import Struct
from typing import Final, Literal, NamedTuple

import numpy as np
from mcap.opcode import Opcode
from numpy.typing import NDArray

Bytes = NDArray[np.uint8]
Places = NDArray[np.int64]

HEAD: Final = Struct("<BQ")
# Channel, sequence, log time and publish time before the payload of a message.
MESSAGE_FIELDS: Final = 22
PAYLOAD_AT: Final = HEAD.size + MESSAGE_FIELDS
_CHANNEL_AT: Final = HEAD.size
SEQUENCE_AT: Final = HEAD.size + 2
_TIME_AT: Final = HEAD.size + 6
# A message at least this long is stepped over by hand. Ours are datagrams and reads of a line: all are shorter.
_LONG: Final = 1 << 16
# The share of messages whose two times may differ by damage.
_MOST_MENDED: Final = 0.05
KNOWN: Final = frozenset(int(opcode) for opcode in Opcode)
_FIRST_PRIVATE: Final = 0x80  # records of other programs, which a reader steps over

Stop = Literal["end", "cut", "zeros", "damage"]


class Other(NamedTuple):
    """A record that is no message: its opcode, where its content is, and how many messages were before it."""

    opcode: int
    start: int
    length: int
    messages_before: int


class ScanResult(NamedTuple):
    """The records of a buffer. `end`: the offset after the last whole one; `need`: bytes that the next one takes.

    `stop` says why the walk ended: at the buffer's end, in a record that is longer than the rest of the buffer
    (`cut`), at zeros, or at something that is no record.
    """

    messages: Places
    others: list[Other]
    end: int
    need: int
    stop: Stop

    @property
    def last(self) -> int:
        """Where the last record begins, or `end` if no record was found."""
        begins = [int(self.messages[-1])] if len(self.messages) else []
        begins += [self.others[-1].start - HEAD.size] if self.others else []
        return max(begins, default=self.end)

    def without_last(self) -> ScanResult:
        """The same without its last record."""
        last = self.last
        others = [one for one in self.others if one.start < last]
        return self._replace(messages=self.messages[self.messages < last], others=others, end=last)


def scan(data: Bytes, longest: int) -> ScanResult:
    """All whole records of `data` (shape (n,), uint8), which begins with one; none may be longer than `longest`."""
    walk = _Walk(data, longest)
    return walk.found()


def channels_of(data: Bytes, messages: Places) -> NDArray[np.uint16]:
    """The channel of each message at `messages`."""
    return _words(data, "<u2")[messages + _CHANNEL_AT]


def times_of(data: Bytes, messages: Places) -> NDArray[np.uint64]:
    """The log time of each message at `messages`, in ns."""
    return _words(data, "<u8")[messages + _TIME_AT]


def mended_times(data: Bytes, messages: Places) -> tuple[NDArray[np.uint64], int]:
    """The times of these messages, and how many of them were damaged.

    Every message of this station has its time twice. Where the two differ, the one nearer to the message before it is
    taken; a file in which they often do was written by another program.
    """
    times = times_of(data, messages)
    other = _words(data, "<u8")[messages + _TIME_AT + 8]
    differ = np.flatnonzero(times != other)
    if len(differ) > _MOST_MENDED * len(messages):
        return times, 0
    before = times[np.where(differ > 0, differ - 1, 1)].astype(np.float64)
    nearer = differ[np.abs(other[differ] - before) < np.abs(times[differ] - before)]
    times[nearer] = other[nearer]
    return times, len(differ)


def lengths_of(data: Bytes, messages: Places) -> Places:
    """The length of each message's payload."""
    return _words(data, "<u8")[messages + 1].astype(np.int64) - MESSAGE_FIELDS


def _words(data: Bytes, kind: str) -> NDArray[np.unsignedinteger]:
    """The number that begins at each byte: a view, not a copy."""
    size = np.dtype(kind).itemsize
    return np.ndarray((max(0, len(data) - size + 1),), kind, data, 0, (1,))


class _Walk:
    def __init__(self, data: Bytes, longest: int) -> None:
        self._data = data
        self._view = data.data
        self._longest = longest
        self._runs: list[Places] = []
        self._count = 0
        self._others: list[Other] = []
        self._places, self._ends = _candidates(data)
        linked = np.zeros(len(self._places), dtype=bool)
        linked[:-1] = self._ends[:-1] == self._places[1:]
        self._breaks = np.flatnonzero(~linked)

    def found(self) -> ScanResult:
        at = 0
        while True:
            at = self._run(at)
            if at == len(self._data):
                return self._ended(at, 0, "end")
            step = self._step(at)
            if isinstance(step, ScanResult):
                return step
            at = step

    def _run(self, at: int) -> int:
        """Take the run of messages that begins at `at`, if any; returns where it ends."""
        first = int(np.searchsorted(self._places, at))
        if first == len(self._places) or self._places[first] != at:
            return at
        last = int(self._breaks[np.searchsorted(self._breaks, first)])
        self._take(self._places[first : last + 1])
        return int(self._ends[last])

    def _take(self, run: Places) -> None:
        self._runs.append(run)
        self._count += len(run)

    def _step(self, at: int) -> int | ScanResult:
        """Step over one record; returns where the next begins, or what was found if none does."""
        rest = len(self._data) - at
        if rest < HEAD.size:
            return self._ended(at, HEAD.size, "cut" if self._data[at:].any() else "zeros")
        opcode, length = HEAD.unpack_from(self._view, at)
        if opcode == 0 and length == 0:
            return self._ended(at, 0, "zeros" if not self._data[at:].any() else "damage")
        is_known = opcode in KNOWN or opcode >= _FIRST_PRIVATE
        if not is_known or length > self._longest or (opcode == Opcode.MESSAGE and length < MESSAGE_FIELDS):
            return self._ended(at, 0, "damage")
        if HEAD.size + length > rest:
            return self._ended(at, HEAD.size + length, "cut")
        if opcode == Opcode.MESSAGE:
            self._take(np.array([at], dtype=np.int64))
        else:
            self._others.append(Other(opcode, at + HEAD.size, length, self._count))
        return at + HEAD.size + int(length)

    def _ended(self, end: int, need: int, stop: Stop) -> ScanResult:
        messages = np.concatenate(self._runs) if self._runs else np.empty(0, dtype=np.int64)
        return ScanResult(messages, self._others, end, need, stop)


def _candidates(data: Bytes) -> tuple[Places, Places]:
    """Where a whole message of less than 64 KiB may begin, and where it would end; mostly without the false ones."""
    if len(data) < PAYLOAD_AT:
        return np.empty(0, dtype=np.int64), np.empty(0, dtype=np.int64)
    places = np.flatnonzero(data[: len(data) - PAYLOAD_AT + 1] == Opcode.MESSAGE)
    # The third byte of the length comes first: it drops nearly all false places.
    places = places[data[places + 3] == 0]
    lengths = _words(data, "<u8")[places + 1].astype(np.int64)
    ends = places + HEAD.size + lengths
    kept = (lengths >= MESSAGE_FIELDS) & (lengths < _LONG) & (ends <= len(data))
    places, ends = places[kept], ends[kept]
    # A message begins where the one before it ends. Other records come before few messages; those become breaks.
    reached = np.zeros(len(places), dtype=bool)
    following = np.searchsorted(places, ends)
    inside = following < len(places)
    hit = following[inside]
    reached[hit[places[hit] == ends[inside]]] = True
    if len(places):
        reached[0] = True
    return places[reached], ends[reached]
