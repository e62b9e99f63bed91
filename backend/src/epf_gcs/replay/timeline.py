"""A recording as a line of time: its messages and notes in order, from any moment on, also while it grows."""

from __future__ import annotations

import copy
import weakref
from bisect import bisect_left
from collections import OrderedDict
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import BinaryIO, Final, NamedTuple

import numpy as np

from epf_gcs.recordings.limits import RecordingError
from epf_gcs.recordings.notes import EVENT, IDENTITY, Note
from epf_gcs.recordings.reading import Messages, Part, Reader
from epf_gcs.recordings.skim import ChunkAt, skim

# A piece has at most so many messages: a seek makes objects of no more than one.
_PIECE_MESSAGES: Final = 2000
_BLOCK_BYTES: Final = 1 << 19
# For each reader.
_PIECES_AT_HAND: Final = 2
_PARTS_AT_HAND: Final = 2
# Pieces have numbers: this many times the place in the list, plus which piece of the chunk it is.
_TELLING: Final = frozenset({EVENT, IDENTITY})
_OF_ONE: Final = 1 << 20


class Item(NamedTuple):
    """A message of one of the four topics (its bytes), or a note (`topic` 0)."""

    t_ns: int
    topic: int
    data: bytes
    note: Note | None


@dataclass(slots=True)
class _Piece:
    """Messages of the part of the file at `place`: how many are before them in it, how many they are, and their notes.

    Each note comes with the number of messages of the piece before it. A chunk that was not unpacked yet has `count`
    None: it is one entry of many pieces, and has no notes.
    """

    place: int
    is_chunk: bool
    skipped: int
    count: int | None
    latest_ns: int
    notes: list[tuple[int, Note]] = field(default_factory=list)


class Timeline:
    """`look` reads what the file has got since; raises RecordingError if the file is no recording."""

    def __init__(self, path: Path) -> None:
        self._reader = Reader(path)
        self._reader.block_bytes = _BLOCK_BYTES
        # Held open: packing puts another file in its place, and what is known of its places is of this one.
        self._file = _opened(path)
        self._reader.file = self._file
        weakref.finalize(self, self._file.close)
        self._loader: Reader | None = None
        self._pieces: list[_Piece] = []
        self._latest: list[int] = []
        self._loaded: OrderedDict[int, tuple[int, list[Item]]] = OrderedDict()
        self._parts: OrderedDict[int, Messages] = OrderedDict()
        # How many go along it, each at another place: what they read is kept at hand.
        self.readers = 2
        self.starts_ns: int | None = None
        self.edge_ns = 0
        self._skim()
        self.look()

    @property
    def size(self) -> int:
        """Bytes of the file that were read."""
        return self._reader.place

    @property
    def is_whole(self) -> bool:
        """The file is finished: nothing more will come."""
        return self._reader.is_whole

    def _skim(self) -> None:
        """Of a packed file only where its chunks are is read: each is unpacked when something in it is needed."""
        found = skim(self._reader, self._file)
        if found is None:
            self._reader.place = 0
            return
        self._loader = copy.copy(self._reader)
        for one in found:
            if isinstance(one, ChunkAt):
                if self.starts_ns is None:
                    self.starts_ns = one.start_ns
                self.edge_ns = max(self.edge_ns, one.end_ns)
                self._pieces.append(_Piece(one.place, True, 0, None, self.edge_ns))
            else:
                self._pieces.append(_Piece(0, True, 0, 0, self.edge_ns, [(0, one)]))
            self._latest.append(self.edge_ns)

    @property
    def has_event_notes(self) -> bool:
        """Whether this recording tells the events of its flight: those of now begin with such a note."""
        return any(note.name in _TELLING for piece in self._pieces for _, note in piece.notes)

    def look(self) -> bool:
        """Take in what was written since the last look. True if that was anything."""
        before = self._reader.place
        for part in self._reader.parts():
            self._add(part)
            if self._loader is None and self._reader.topics:
                self._loader = copy.copy(self._reader)
        return self._reader.place != before

    def _add(self, part: Part) -> None:
        messages = part.messages
        count = len(messages.t_ns)
        if count and self.starts_ns is None:
            self.starts_ns = self.edge_ns = int(messages.t_ns[0])
        skipped = self._join(part) if self._pieces else 0
        notes = [(before - skipped, note) for before, note in part.notes if before >= skipped]
        while True:
            taken = min(count - skipped, _PIECE_MESSAGES)
            is_last = skipped + taken == count
            latest_ns = self._later(part, skipped, taken)
            here = [one for one in notes if is_last or one[0] < taken]
            if taken or here:
                self._pieces.append(_Piece(part.place, part.is_chunk, skipped, taken, latest_ns, here))
                self._latest.append(latest_ns)
            if is_last:
                return
            notes = [(before - taken, note) for before, note in notes[len(here) :]]
            skipped += taken

    def _join(self, part: Part) -> int:
        """Add the first messages of a part to the last piece, if they are read together and it is not full.

        Returns how many; the notes before them are added too.
        """
        last = self._pieces[-1]
        count = len(part.messages.t_ns)
        if part.is_chunk or last.is_chunk or last.skipped or last.count is None or last.count + count > _PIECE_MESSAGES:
            return 0
        last.notes += [(last.count + before, note) for before, note in part.notes]
        last.count += count
        last.latest_ns = self._latest[-1] = self._later(part, 0, count)
        self._loaded.pop(len(self._pieces) - 1, None)
        part.notes.clear()
        return count

    def _later(self, part: Part, skipped: int, taken: int) -> int:
        """The latest time up to the end of this stretch, which is the edge then."""
        if taken:
            self.edge_ns = max(self.edge_ns, int(part.messages.t_ns[skipped : skipped + taken].max()))
        return self.edge_ns

    def items(self, number: int) -> list[Item] | None:
        """The messages and notes of a piece in their order; None if there is no such piece yet."""
        index, part = divmod(number, _OF_ONE)
        if index >= len(self._pieces):
            return None
        piece = self._pieces[index]
        if piece.count is None:
            skipped = part * _PIECE_MESSAGES
            count = min(_PIECE_MESSAGES, len(self._part(piece.place, 0).t_ns) - skipped)
            piece = _Piece(piece.place, True, skipped, count, piece.latest_ns)
        count = (piece.count or 0) + len(piece.notes)
        held = self._loaded.get(number)
        if held is None or held[0] != count:
            held = self._loaded[number] = (count, self._load(piece))
            while len(self._loaded) > _PIECES_AT_HAND * self.readers:
                self._loaded.popitem(last=False)
        self._loaded.move_to_end(number)
        return held[1]

    def following(self, number: int) -> int | None:
        """The number of the piece after this one; None while nothing follows."""
        index, part = divmod(number, _OF_ONE)
        piece = self._pieces[index] if index < len(self._pieces) else None
        if (
            piece is not None
            and piece.count is None
            and len(self._part(piece.place, 0).t_ns) > (part + 1) * _PIECE_MESSAGES
        ):
            return number + 1
        return (index + 1) * _OF_ONE if index + 1 < len(self._pieces) else None

    def first_at(self, t_ns: int) -> tuple[int, int]:
        """Piece and place in it of the first message at or after `t_ns`; the end if there is none."""
        index = bisect_left(self._latest, t_ns)
        number = index * _OF_ONE
        if index < len(self._pieces) and self._pieces[index].count is None:
            late = np.flatnonzero(self._part(self._pieces[index].place, 0).t_ns >= t_ns)
            number += (int(late[0]) if len(late) else 0) // _PIECE_MESSAGES
        items = self.items(number)
        if items is None:
            last = max(0, len(self._pieces) - 1) * _OF_ONE
            while last % _OF_ONE + 1 < _OF_ONE and (after := self.following(last)) is not None:
                last = after
            return last, len(self.items(last) or ())
        for place, item in enumerate(items):
            if item.topic and item.t_ns >= t_ns:
                return number, place
        return number, len(items)

    def notes_before(self, number: int, place: int) -> Iterator[Note]:
        """All notes before that place of a piece, in their order."""
        for piece in self._pieces[: number // _OF_ONE]:
            yield from (note for _, note in piece.notes)
        yield from (item.note for item in (self.items(number) or ())[:place] if item.note is not None)

    def _load(self, piece: _Piece) -> list[Item]:
        messages = self._read(piece) if piece.count else []
        found: list[Item] = []
        done = 0
        for index, note in piece.notes:
            found += [Item(t_ns, topic, data, None) for topic, t_ns, data in messages[done:index]]
            done = max(done, index)
            # In its place in the file, whatever time it claims.
            latest_ns = messages[done][1] if done < len(messages) else piece.latest_ns
            found.append(Item(min(note.t_ns, latest_ns) if latest_ns else note.t_ns, 0, b"", note))
        return found + [Item(t_ns, topic, data, None) for topic, t_ns, data in messages[done:]]

    def _read(self, piece: _Piece) -> list[tuple[int, int, bytes]]:
        stretch = slice(piece.skipped, piece.skipped + (piece.count or 0))
        channels, times, starts, lengths, data = self._part(piece.place, stretch.stop)
        view = data.data
        return [
            (channel, t_ns, bytes(view[start : start + length]))
            for channel, t_ns, start, length in zip(
                channels[stretch].tolist(),
                times[stretch].tolist(),
                starts[stretch].tolist(),
                lengths[stretch].tolist(),
                strict=True,
            )
        ]

    def _part(self, place: int, count: int) -> Messages:
        """At least so many messages of the part at a place of the file."""
        held = self._parts.get(place)
        if held is None or len(held.t_ns) < count:
            if self._loader is None:
                raise LookupError("the file has no messages")
            reader = copy.copy(self._loader)
            reader.place = place
            reader.is_whole = False
            held = self._parts[place] = next(part.messages for part in reader.parts())
            while len(self._parts) > _PARTS_AT_HAND * self.readers:
                self._parts.popitem(last=False)
        self._parts.move_to_end(place)
        return held


def _opened(path: Path) -> BinaryIO:
    """The file. Raises RecordingError."""
    try:
        return path.open("rb")
    except OSError as fault:
        why = fault.strerror or str(fault)
        raise RecordingError("recording_unreadable", f"The recording cannot be read: {why}.", reason=why) from fault


class Cursor:
    """Goes along a timeline, item by item."""

    def __init__(self, timeline: Timeline, from_ns: int | None = None) -> None:
        """Begin at the first message at or after `from_ns`, or at the very beginning with its notes."""
        self._timeline = timeline
        self._number, self._place = (0, 0) if from_ns is None else timeline.first_at(from_ns)
        self._items: list[Item] = timeline.items(self._number) or []

    @property
    def notes_before(self) -> Iterator[Note]:
        """All notes before the next item."""
        return self._timeline.notes_before(self._number, self._place)

    def peek(self) -> Item | None:
        """The next item; None at the edge of what is recorded."""
        if self._place < len(self._items):
            return self._items[self._place]
        items = self._timeline.items(self._number)
        if items is not None and len(items) > self._place:
            self._items = items
            return items[self._place]
        number = self._timeline.following(self._number)
        while number is not None:
            if following := self._timeline.items(number):
                self._number, self._place, self._items = number, 0, following
                return following[0]
            number = self._timeline.following(number)
        return None

    def take(self) -> None:
        """Go to the item after the one that `peek` gave."""
        self._place += 1
