"""All frames of a line at once: the same frames, damage and times as the live decoder finds, with numpy.

The live decoder walks: at a header it waits for the length of its type, accepts a good frame and goes on behind it, or
drops the header and goes on after it. So of all headers with a good frame, those are accepted that do not lie inside
one accepted before; and a frame is known as soon as every byte has come that it, or a header tried before it, needs.
Both can be said of all headers together. The few bytes between frames are handed to the live decoder itself, which
names their damage.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final, NamedTuple

import numpy as np
from numpy.typing import NDArray

from epf_gcs.codec.frame import FROM_BOARD, Damage, Direction, Frame, FrameDecoder
from epf_gcs.codec.messages_gen import END
from epf_gcs.codec.tables import Message

Bytes = NDArray[np.uint8]
Places = NDArray[np.int64]

_HEADER_SIZE: Final = 4
_START_SIZE: Final = 8
_TAIL_SIZE: Final = 8
_END_WORD: Final = int.from_bytes(END, "little")
_BYTE: Final = 1  # of the header, the one that is searched for: rarer in frames than its first


class Frames(NamedTuple):
    """The frames of one type, in the order of the line. `t_ns`: when each was complete; `payload`: one void a frame."""

    t_ns: Places
    payload: NDArray[np.void]


class DamageReport(NamedTuple):
    """Bytes that are no frame, as the live decoder reports them, and when they had come (Unix ns)."""

    t_ns: int
    damage: Damage


@dataclass(frozen=True)
class StretchContents:
    """What a stretch of the line held: the frames of each message that came, and the damage, in order."""

    frames: dict[Message, Frames]
    damage: list[DamageReport]


class BulkDecoder:
    """Takes the line's bytes in stretches of any length, and keeps what the next stretch may complete."""

    def __init__(self, direction: Direction = FROM_BOARD) -> None:
        self._built_in = list(direction.messages.values())
        self._type_bit = direction.type_bit
        self._header = int.from_bytes(direction.header, "little")
        self._letter = direction.header[_BYTE]
        self._namer = FrameDecoder(direction)
        self._left = np.empty(0, dtype=np.uint8)
        self._left_ns = np.empty(0, dtype=np.int64)
        # Offsets from the first byte of what is left: bytes that `_namer` was given, and that its events account for.
        self._fed = 0
        self._named = 0
        self.learn(())

    def learn(self, own: Sequence[Message]) -> None:
        """From the next stretch on, frames of these messages are known beside the built-in ones, and no others."""
        self._messages = [*self._built_in, *own]
        # By number of the type; one more for all types that are not known.
        largest = max(message.id for message in self._messages)
        self._kind = np.full(largest + 2, -1, dtype=np.int16)
        self._size = np.zeros(len(self._messages) + 1, dtype=np.int64)
        self._size[-1] = _START_SIZE
        for index, message in enumerate(self._messages):
            self._kind[message.id] = index
            self._size[index] = _START_SIZE + message.size + _TAIL_SIZE
        self._longest = int(self._size.max())
        self._namer.learn(own)

    def feed(self, data: Bytes, ends: Places, t_ns: Places) -> StretchContents:
        """Take the next bytes of the line: `data` of shape (n,).

        They came in records: `ends` has the offset in `data` after the last byte of each, ascending, and `t_ns` its
        time. A frame gets the time of the record that completed it.
        """
        times = _Times(self._left_ns, ends, t_ns)
        joined = np.concatenate((self._left, data)) if len(self._left) else data
        return self._decode(joined, times, is_over=False)

    def finish(self) -> StretchContents:
        """The stream has ended: what still waits is decoded as far as it goes, and the next bytes begin anew."""
        none = np.empty(0, dtype=np.int64)
        return self._decode(self._left, _Times(self._left_ns, none, none), is_over=True)

    def _decode(self, data: Bytes, times: _Times, *, is_over: bool) -> StretchContents:
        found = self._candidates(data, is_over=is_over)
        accepted = _not_inside(found.places, found.stops, found.good)
        stop = len(data) if is_over else self._undecided(data, found, accepted)
        accepted = accepted[found.places[accepted] < stop]
        # At the end of the stream nothing is waited for any longer.
        known_at = np.minimum(self._known_at(found, accepted, stop), len(data))
        frames = self._frames(data, found, accepted, times.of(known_at - 1))
        damage = self._name(data, found.places[accepted], found.stops[accepted], times)
        if is_over:
            damage += self._take(self._namer.finish(), len(data), times)
            self._fed = self._named = len(data)
        self._left = data[stop:].copy()
        self._left_ns = times.of(np.arange(stop, len(data)))
        self._fed -= stop
        self._named -= stop
        return StretchContents(frames, damage)

    def _candidates(self, data: Bytes, *, is_over: bool) -> _Candidates:
        """Every header, whether a good frame begins at it, and the offset after the last byte that decides this."""
        size = len(data)
        places = np.flatnonzero(data[_BYTE:] == self._letter)
        places = places[places <= size - _HEADER_SIZE]
        if len(places):
            places = places[_words(data)[places] == self._header]
        kinds = np.full(len(places), -1, dtype=np.int16)
        typed = np.flatnonzero(places <= size - _START_SIZE)
        if len(typed):
            words = _words(data)[places[typed] + _HEADER_SIZE]
            numbers = words ^ np.uint32(self._type_bit)
            kinds[typed] = self._kind[np.minimum(numbers, len(self._kind) - 1)]
        stops = places + self._size[kinds]
        good = np.zeros(len(places), dtype=bool)
        for kind in range(len(self._messages)):
            of_kind = np.flatnonzero((kinds == kind) & (stops <= size))
            if len(of_kind):
                good[of_kind] = _is_good(_rows(data, places[of_kind] + _HEADER_SIZE, int(self._size[kind]) - 4))
        return _Candidates(places, stops, kinds, good)

    def _undecided(self, data: Bytes, found: _Candidates, accepted: Places) -> int:
        """Where the first header begins that waits for more bytes; else where the bytes end that can be decided."""
        size = len(data)
        waiting = np.flatnonzero(found.stops > size)
        after = 0
        for index in waiting.tolist():
            place = int(found.places[index])
            before = accepted[found.places[accepted] < place]
            after = int(found.stops[before[-1]]) if len(before) else 0
            if after <= place:
                return place
        # The beginning of a header may be at the end.
        after = int(found.stops[accepted[-1]]) if len(accepted) else 0
        return max(after, size - _HEADER_SIZE + 1)

    def _known_at(self, found: _Candidates, accepted: Places, stop: int) -> Places:
        """For each accepted frame the offset after the last byte that had to come before it was known."""
        tried = found.places < stop
        if len(accepted):
            # Headers inside accepted frames are never tried.
            before = np.searchsorted(found.places[accepted], found.places, side="right") - 1
            covered = (before >= 0) & (found.places < found.stops[accepted][before])
            covered[accepted] = False
            tried &= ~covered
        needed = np.where(tried, found.stops, 0)
        known: Places = np.maximum.accumulate(needed)[accepted] if len(needed) else needed
        return known

    def _frames(self, data: Bytes, found: _Candidates, accepted: Places, t_ns: Places) -> dict[Message, Frames]:
        kinds = found.kinds[accepted]
        places = found.places[accepted]
        frames = {}
        for kind, message in enumerate(self._messages):
            chosen = np.flatnonzero(kinds == kind)
            if len(chosen):
                payload = _rows(data, places[chosen] + _START_SIZE, message.size) if message.size else _nothing(chosen)
                frames[message] = Frames(t_ns[chosen], payload)
        return frames

    def _name(self, data: Bytes, starts: Places, stops: Places, times: _Times) -> list[DamageReport]:
        """The damage between the accepted frames, and what is known of it after the last of them."""
        damage: list[DamageReport] = []
        befores = np.concatenate(([self._named], stops[:-1])) if len(stops) else stops
        gaps = np.flatnonzero(befores < starts).tolist()
        if self._fed > 0 and len(starts) and gaps[:1] != [0]:
            self._namer.finish()  # what it was given turned out to be a frame
        for gap in gaps:
            begin, end = max(int(befores[gap]), self._fed if gap == 0 else 0), int(starts[gap])
            self._named = int(befores[gap])
            # The bytes after the gap too: headers in it are judged by them.
            damage += self._take(self._namer.feed(data[begin : end + 2 * self._longest].tobytes()), end, times)
            damage += self._take(self._namer.finish(), end, times)
        if len(stops):
            self._named = self._fed = int(stops[-1])
        damage += self._take(self._namer.feed(data[self._fed :].tobytes()), len(data), times)
        self._fed = len(data)
        return damage

    def _take(self, events: list[Frame | Damage], end: int, times: _Times) -> list[DamageReport]:
        """The damage among the next events, up to offset `end`."""
        taken: list[Damage] = []
        offsets: list[int] = []
        for event in events:
            if self._named >= end or isinstance(event, Frame):
                break
            self._named += len(event.data)
            taken.append(event)
            offsets.append(max(0, self._named - 1))
        at_ns = times.of(np.array(offsets, dtype=np.int64)).tolist() if taken else []
        return [DamageReport(t_ns, damage) for t_ns, damage in zip(at_ns, taken, strict=True)]


class _Candidates(NamedTuple):
    """Every header: place, offset after the last byte that decides it, index of its message (or -1), good."""

    places: Places
    stops: Places
    kinds: NDArray[np.int16]
    good: NDArray[np.bool_]


class _Times:
    """When each byte came: what was left of earlier stretches byte by byte, then records by their ends."""

    def __init__(self, left_ns: Places, ends: Places, t_ns: Places) -> None:
        self._left_ns = left_ns
        self._ends = ends + len(left_ns)
        self._t_ns = t_ns

    def of(self, offsets: Places) -> Places:
        """The time of the bytes at `offsets`."""
        if not len(self._t_ns):
            return self._left_ns[offsets]
        record = np.searchsorted(self._ends, offsets, side="right")
        times = self._t_ns[np.minimum(record, len(self._t_ns) - 1)]
        is_left = offsets < len(self._left_ns)
        if is_left.any():
            times[is_left] = self._left_ns[offsets[is_left]]
        return times


def _words(data: Bytes) -> NDArray[np.uint32]:
    """The 32-bit word that begins at each byte: a view, not a copy."""
    return np.ndarray((len(data) - 3,), "<u4", data, 0, (1,))


def _rows(data: Bytes, places: Places, size: int) -> NDArray[np.void]:
    """`size` bytes from each place, one void element each."""
    return np.ndarray((len(data) - size + 1,), f"V{size}", data, 0, (1,))[places]


def _nothing(chosen: Places) -> NDArray[np.void]:
    return np.zeros(len(chosen), dtype="V1")


def _is_good(rows: NDArray[np.void]) -> NDArray[np.bool_]:
    """Whether each frame (from its type to its end marker) has a right sum and end.

    Type, payload and checksum sum to 0, so with the end marker the sum is the end marker's word.
    """
    words = rows.view("<u4").reshape(len(rows), -1)
    total = words[:, 0].copy()
    for column in range(1, words.shape[1] - 1):
        total += words[:, column]
    good: NDArray[np.bool_] = (total == 0) & (words[:, -1] == _END_WORD)
    return good


def _not_inside(places: Places, stops: Places, good: NDArray[np.bool_]) -> Places:
    """The indexes of the good frames that do not begin inside one accepted before."""
    chosen = np.flatnonzero(good)
    starts, ends = places[chosen], stops[chosen]
    overlaps = np.flatnonzero(ends[:-1] > starts[1:]).tolist()
    if not overlaps:
        return chosen
    kept = np.ones(len(chosen), dtype=bool)
    free = 0
    for index in overlaps:
        if index < free:
            continue  # dropped itself, or known to end before the next
        free = int(np.searchsorted(starts, ends[index]))
        kept[index + 1 : free] = False
    return chosen[kept]
