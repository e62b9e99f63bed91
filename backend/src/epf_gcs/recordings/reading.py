"""Read any recording of ours: finished, being written, cut anywhere, packed into chunks, or damaged.

Two ways. In bulk: `read_file` (all of it in one buffer) or `Reader.parts` (piece by piece, in bounded memory) give
arrays with the place of each payload. As a stream: `walk` gives message after message, from a time on.
Whatever a file says of its own content (counts, sizes, indexes) is checked before it is used: files may be strangers'.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path
from typing import NamedTuple

import numpy as np

from epf_gcs.recordings.limits import LIMITS, Limits, RecordingError
from epf_gcs.recordings.notes import Note
from epf_gcs.recordings.parts import Messages, Part, Parts
from epf_gcs.recordings.scan import PAYLOAD_AT
from epf_gcs.recordings.summary import chunk_before

__all__ = [
    "LIMITS",
    "Limits",
    "Message",
    "Messages",
    "Part",
    "Reader",
    "Recording",
    "RecordingError",
    "notes_of",
    "place_of",
    "read_file",
    "walk",
]


class Message(NamedTuple):
    """One message: a channel of `topics.py`, its time (Unix ns) and its bytes."""

    channel: int
    t_ns: int
    data: bytes


@dataclass(frozen=True)
class Recording:
    """A whole file in memory. `notes` are in file order; `damage` says in sentences what could not be read, or None.

    `is_whole`: the writer closed the file. One that is being written or was cut is not whole, yet need not be damaged.
    `clock_steps`: how many messages have an earlier time than the one before them in the file.
    """

    messages: Messages
    notes: list[Note]
    topics: dict[int, str]
    is_whole: bool
    damage: str | None
    clock_steps: int


class Reader(Parts):
    """Reads a recording on; ask again later and it continues where the file ended.

    `place` (bytes) is where to begin: 0, or the place of a record that a `Part` gave. Raises RecordingError
    (also from the methods) if the file is no recording, or is larger than the limits.
    """

    def items(self, from_ns: int | None = None) -> Iterator[Message | Note]:
        """Messages and notes in file order, from the first message at or after `from_ns` (Unix ns) on.

        With an index in the file it begins near `from_ns`: use `notes_of` for what was noted before.
        """
        if from_ns is not None and self.place == 0:
            self.skip_to(chunk_before(self.path, from_ns, self.limits))
        waiting = from_ns is not None
        for part in self.parts():
            first = 0
            if waiting and from_ns is not None:
                late = np.flatnonzero(part.messages.t_ns >= from_ns)
                if not len(late):
                    continue
                first, waiting = int(late[0]), False
            yield from _one_by_one(part, first)


def _one_by_one(part: Part, first: int) -> Iterator[Message | Note]:
    """The messages of a part from `first` on, and the notes between them."""
    channels, t_ns, starts, lengths, data = part.messages
    view = data.data
    edges = [first, *(before for before, _ in part.notes if before > first), len(channels)]
    notes = [note for before, note in part.notes if before >= first]
    early = sum(1 for before, _ in part.notes if before == first)
    yield from notes[:early]
    remaining = iter(notes[early:])
    for begin, end in pairwise(edges):
        stretch = slice(begin, end)
        for channel, time_ns, start, length in zip(
            channels[stretch].tolist(),
            t_ns[stretch].tolist(),
            starts[stretch].tolist(),
            lengths[stretch].tolist(),
            strict=True,
        ):
            yield Message(channel, time_ns, bytes(view[start : start + length]))
        note = next(remaining, None)
        if note is not None:
            yield note


def walk(
    path: Path, from_ns: int | None = None, *, place: int = 0, limits: Limits = LIMITS
) -> Iterator[Message | Note]:
    """Messages and notes one by one in bounded memory, up to what the file has now; see `Reader.items`.

    With `place` it begins at that record of the file. Raises RecordingError as `Reader` does.
    """
    yield from Reader(path, limits=limits, place=place).items(from_ns)


def notes_of(path: Path, limits: Limits = LIMITS) -> list[Note]:
    """All notes of a file, in its order. Chunks are stepped over, so this is quick for a packed file."""
    reader = Reader(path, limits=limits, with_chunks=False)
    return [note for part in reader.parts() for _, note in part.notes]


def read_file(path: Path, *, limits: Limits = LIMITS) -> Recording:
    """All of a file at once. Raises RecordingError if it is no recording, or larger than `limits` allow."""
    reader = Reader(path, limits=limits)
    parts: list[Part] = []
    notes: list[Note] = []
    size = 0
    for part in reader.parts():
        size += len(part.messages.data)
        if size > limits.whole_bytes:
            raise RecordingError(
                "recording_too_large",
                f"This file holds more than {limits.whole_bytes} bytes, too many to read at once.",
                most=limits.whole_bytes,
            )
        parts.append(part)
        notes += [note for _, note in part.notes]
    messages = _joined(parts)
    steps = int(np.count_nonzero(np.diff(messages.t_ns) < 0))
    return Recording(messages, notes, reader.topics, reader.is_whole, reader.damage, steps)


def _joined(parts: list[Part]) -> Messages:
    if not parts:
        none = np.empty(0, dtype=np.int64)
        return Messages(none.astype(np.uint16), none, none, none, none.astype(np.uint8))
    starts, offset = [], 0
    for part in parts:
        starts.append(part.messages.start + offset)
        offset += len(part.messages.data)
    return Messages(
        np.concatenate([part.messages.channel for part in parts]),
        np.concatenate([part.messages.t_ns for part in parts]),
        np.concatenate(starts),
        np.concatenate([part.messages.length for part in parts]),
        np.concatenate([part.messages.data for part in parts]),
    )


def place_of(part: Part, message: int) -> int:
    """Where to begin reading to get this message of the part first: its own record, or the chunk that holds it."""
    return part.place if part.is_chunk else part.place + int(part.messages.start[message]) - PAYLOAD_AT
