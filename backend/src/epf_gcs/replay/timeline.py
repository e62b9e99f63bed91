"""A recording as a line of time: its messages and notes in order, from any moment on, also while it grows."""

from __future__ import annotations

import copy
from bisect import bisect_left
from collections import OrderedDict
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Final, NamedTuple

from epf_gcs.recordings.notes import Note
from epf_gcs.recordings.reading import Part, Reader

# Pieces that a growing file gave are read again together, up to this size.
_PIECE_BYTES: Final = 1 << 20
_PIECES_AT_HAND: Final = 3


class Item(NamedTuple):
    """A message of one of the four topics (its bytes), or a note (`topic` 0)."""

    t_ns: int
    topic: int
    data: bytes
    note: Note | None


@dataclass(slots=True)
class _Piece:
    """A stretch of the file: where it begins, how many messages, its latest time and its notes."""

    place: int
    is_chunk: bool
    count: int
    bytes: int
    latest_ns: int
    notes: list[tuple[int, Note]] = field(default_factory=list)


class Timeline:
    """`look` reads what the file has got since; raises RecordingError if the file is no recording."""

    def __init__(self, path: Path) -> None:
        self._reader = Reader(path)
        self._loader: Reader | None = None
        self._pieces: list[_Piece] = []
        self._latest: list[int] = []
        self._loaded: OrderedDict[int, tuple[int, list[Item]]] = OrderedDict()
        self.starts_ns: int | None = None
        self.edge_ns = 0
        self.look()

    @property
    def size(self) -> int:
        """Bytes of the file that were read."""
        return self._reader.place

    @property
    def is_whole(self) -> bool:
        """The file is finished: nothing more will come."""
        return self._reader.is_whole

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
        latest_ns = max(self.edge_ns, int(messages.t_ns.max())) if count else self.edge_ns
        size = len(messages.data)
        last = self._pieces[-1] if self._pieces else None
        if last is not None and not part.is_chunk and not last.is_chunk and last.bytes + size <= _PIECE_BYTES:
            last.notes += [(last.count + before, note) for before, note in part.notes]
            last.count += count
            last.bytes = self._reader.place - last.place if self._reader.place > part.place else last.bytes + size
            last.latest_ns = self._latest[-1] = latest_ns
            self._loaded.pop(len(self._pieces) - 1, None)
        else:
            self._pieces.append(_Piece(part.place, part.is_chunk, count, size, latest_ns, list(part.notes)))
            self._latest.append(latest_ns)
        self.edge_ns = latest_ns

    def items(self, number: int) -> list[Item] | None:
        """The messages and notes of a piece in their order; None if there is no such piece yet."""
        if number >= len(self._pieces):
            return None
        piece = self._pieces[number]
        count = piece.count + len(piece.notes)
        held = self._loaded.get(number)
        if held is None or held[0] != count:
            held = self._loaded[number] = (count, self._load(piece))
            while len(self._loaded) > _PIECES_AT_HAND:
                self._loaded.popitem(last=False)
        self._loaded.move_to_end(number)
        return held[1]

    def first_at(self, t_ns: int) -> tuple[int, int]:
        """Piece and place in it of the first message at or after `t_ns`; the end if there is none."""
        number = bisect_left(self._latest, t_ns)
        items = self.items(number)
        if items is None:
            last = max(0, len(self._pieces) - 1)
            return last, len(self.items(last) or ())
        for place, item in enumerate(items):
            if item.topic and item.t_ns >= t_ns:
                return number, place
        return number, len(items)

    def notes_before(self, number: int, place: int) -> Iterator[Note]:
        """All notes before that place of a piece, in their order."""
        for piece in self._pieces[:number]:
            yield from (note for _, note in piece.notes)
        yield from (item.note for item in (self.items(number) or ())[:place] if item.note is not None)

    def _load(self, piece: _Piece) -> list[Item]:
        messages = self._read(piece)
        found: list[Item] = []
        done = 0
        for index, note in piece.notes:
            found += [Item(t_ns, topic, data, None) for topic, t_ns, data in messages[done:index]]
            done = max(done, index)
            # In its place in the file, whatever time it claims.
            latest_ns = messages[done][1] if done < len(messages) else piece.latest_ns
            found.append(Item(min(note.t_ns, latest_ns), 0, b"", note))
        return found + [Item(t_ns, topic, data, None) for topic, t_ns, data in messages[done:]]

    def _read(self, piece: _Piece) -> list[tuple[int, int, bytes]]:
        if not piece.count or self._loader is None:
            return []
        reader = copy.copy(self._loader)
        reader.place = piece.place
        reader.is_whole = False
        found: list[tuple[int, int, bytes]] = []
        for part in reader.parts():
            channels, times, starts, lengths, data = part.messages
            view = data.data
            for channel, t_ns, start, length in zip(
                channels.tolist(), times.tolist(), starts.tolist(), lengths.tolist(), strict=True
            ):
                found.append((channel, t_ns, bytes(view[start : start + length])))
            if len(found) >= piece.count:
                break
        return found[: piece.count]


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
        following = self._timeline.items(self._number + 1)
        if not following:
            return None
        self._number, self._place, self._items = self._number + 1, 0, following
        return following[0]

    def take(self) -> None:
        """Go to the item after the one that `peek` gave."""
        self._place += 1
