"""Rewrite a finished recording into compressed chunks with indexes: a fraction of its size, and quick to search.

Every message and note stays what it was and where it was, which is read back and compared before the new file takes
the old one's place. Until then the old file is untouched: a kill at any moment leaves one or the other.
Only the sequence numbers go, which count the messages of a channel and say nothing that their order does not.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator
from hashlib import blake2b
from pathlib import Path
from typing import Any, Final, NamedTuple

import numpy as np

from epf_gcs.disk import sync_folder
from epf_gcs.recordings.limits import LIMITS, Limits, RecordingError
from epf_gcs.recordings.notes import Note
from epf_gcs.recordings.packed_file import PackedFile
from epf_gcs.recordings.parts import Messages
from epf_gcs.recordings.places import PACKING
from epf_gcs.recordings.reading import Reader
from epf_gcs.recordings.scan import HEAD, PAYLOAD_AT, SEQUENCE_AT, Bytes, Other, Places

# Of the work, how much is packing; the rest is reading back.
_PACKING_SHARE: Final = 0.8
_LIBRARY: Final = "epf-gcs packing"


class PackingCancelledError(Exception):
    """The caller's `is_over` became true; the files are as they were."""


class PackingResult(NamedTuple):
    """What packing did: sizes in bytes, counts, and what of the source could not be read (None: nothing)."""

    bytes_before: int
    bytes_after: int
    messages: int
    notes: int
    damage: str | None


class Block(NamedTuple):
    """Message records one after another, ready for a file; `at`: where each begins. `note`: the record after them."""

    records: Bytes
    at: Places
    messages: Messages
    note: tuple[str, bytes] | None


class RecordReader(Reader):
    """Also keeps the bytes of each note's record, so that they can be written again as they are."""

    def __init__(self, path: Path, limits: Limits = LIMITS) -> None:
        super().__init__(path, limits=limits)
        self._records: list[bytes] = []
        self.has_plain = False

    def blocks(self) -> Iterator[Block]:
        """All of the file; no block is larger than a part of the reader."""
        for part in self.parts():
            self.has_plain = self.has_plain or (not part.is_chunk and len(part.messages.channel) > 0)
            first = 0
            for before, note in part.notes:
                yield _block(part.messages, first, before, (note.name, self._records.pop(0)))
                first = before
            yield _block(part.messages, first, len(part.messages.channel), None)

    def learn(self, data: Bytes, other: Other) -> list[Note]:
        """As its base does; keeps the bytes of a note's record, which are written as they are."""
        found = super().learn(data, other)
        if found:
            self._records.append(data[other.start - HEAD.size : other.start + other.length].tobytes())
        return found


def pack(
    source: Path,
    target: Path | None = None,
    *,
    limits: Limits = LIMITS,
    is_over: Callable[[], bool] = lambda: False,
    progress: Callable[[float], object] = lambda _: None,
) -> PackingResult:
    """Pack `source` into `target`, which must not exist, or in its own place if None. Blocks; memory is bounded.

    In its own place only a finished and undamaged recording is packed; with a target, whatever can be read.
    `progress` gets 0 to 1. Raises RecordingError if it cannot or must not be packed, PackingCancelledError, OSError.
    """
    into = source if target is None else target
    temporary = into.with_name(into.name + PACKING)
    before = source.stat()
    steps = _Steps(is_over, progress, max(1, before.st_size))
    try:
        packed = _write(source, temporary, limits, steps, in_place=target is None)
        if packed is None:
            return PackingResult(before.st_size, before.st_size, 0, 0, None)
        _compare(temporary, packed, limits, steps)
        os.utime(temporary, ns=(before.st_atime_ns, before.st_mtime_ns))
        now = source.stat()
        if (now.st_ino, now.st_size, now.st_mtime_ns) != (before.st_ino, before.st_size, before.st_mtime_ns):
            raise RecordingError("recording_changed", "This recording was changed while it was packed: it was left.")
        size = temporary.stat().st_size
        if target is not None and target.exists():
            raise FileExistsError(target)
        temporary.replace(into)
    finally:
        temporary.unlink(missing_ok=True)
    sync_folder(into.parent)
    return PackingResult(before.st_size, size, packed.messages, packed.notes, packed.damage)


class _PackTotals(NamedTuple):
    digest: bytes
    messages: int
    notes: int
    damage: str | None


class _Steps:
    """Says how far it is, and stops where the caller wants it."""

    def __init__(self, is_over: Callable[[], bool], progress: Callable[[float], object], size: int) -> None:
        self._is_over = is_over
        self._progress = progress
        self._size = size

    def packed(self, place: int) -> None:
        self._step(_PACKING_SHARE * min(1.0, place / self._size))

    def compared(self, share: float) -> None:
        self._step(_PACKING_SHARE + (1.0 - _PACKING_SHARE) * min(1.0, share))

    def _step(self, share: float) -> None:
        if self._is_over():
            raise PackingCancelledError
        self._progress(share)


def _write(source: Path, temporary: Path, limits: Limits, steps: _Steps, *, in_place: bool) -> _PackTotals | None:
    """Write the packed file and sync it. None if `source` is packed already, and would take its own place."""
    reader, digest = RecordReader(source, limits), _Digest()
    with temporary.open("wb") as file:
        packed = PackedFile(file, _LIBRARY)
        for block in reader.blocks():
            digest.add(block)
            packed.put(block.records, block.at, block.messages)
            if block.note is not None:
                packed.note(*block.note)
            steps.packed(reader.place)
        if in_place:
            if not reader.is_whole or reader.damage is not None:
                raise RecordingError(
                    "recording_not_whole", "This recording is unfinished or damaged, so it was left as it is."
                )
            if not reader.has_plain:
                return None
        packed.finish()
        file.flush()
        os.fsync(file.fileno())
    return _PackTotals(digest.value(), digest.messages, digest.notes, reader.damage)


def _compare(temporary: Path, written: _PackTotals, limits: Limits, steps: _Steps) -> None:
    """Read the packed file back. Raises RecordingError unless all of it is what was read from the source."""
    reader, digest = RecordReader(temporary, limits), _Digest()
    size = temporary.stat().st_size
    for block in reader.blocks():
        digest.add(block)
        steps.compared(reader.place / size)
    steps.compared(1.0)
    if not reader.is_whole or reader.damage is not None or digest.value() != written.digest:
        raise RecordingError(
            "recording_not_packed", "What was packed did not read back as it was, so the recording was left as it is."
        )


class _Digest:
    """Of all messages and notes in their order, however they are cut into blocks."""

    def __init__(self) -> None:
        self._hash: Any = blake2b()
        self.messages = 0
        self.notes = 0

    def add(self, block: Block) -> None:
        # A record has its length, channel, time and bytes: two different rows of them never look alike.
        self._hash.update(block.records)
        self.messages += len(block.at)
        if block.note is not None:
            self._hash.update(block.note[1])
            self.notes += 1

    def value(self) -> bytes:
        found: bytes = self._hash.digest()
        return found


def _block(messages: Messages, first: int, end: int, note: tuple[str, bytes] | None) -> Block:
    """The records of the messages from `first` to `end`, with our channel numbers and no sequence numbers."""
    part = slice(first, end)
    chosen = Messages(
        messages.channel[part], messages.t_ns[part], messages.start[part], messages.length[part], messages.data
    )
    sizes = chosen.length + PAYLOAD_AT
    starts = chosen.start - PAYLOAD_AT
    # Where a record follows right upon the one before it, both are copied at once.
    breaks = np.flatnonzero(starts[1:] != starts[:-1] + sizes[:-1]) + 1
    runs = np.concatenate([[0], breaks, [len(starts)]]).astype(np.int64)
    pieces = [
        messages.data[starts[begin] : starts[stop - 1] + sizes[stop - 1]]
        for begin, stop in zip(runs[:-1].tolist(), runs[1:].tolist(), strict=True)
        if stop > begin
    ]
    records = np.concatenate(pieces) if pieces else np.empty(0, dtype=np.uint8)
    at = np.concatenate([[0], np.cumsum(sizes)[:-1]]).astype(np.int64) if len(sizes) else sizes
    if len(at):
        records[at + HEAD.size] = chosen.channel & 0xFF
        records[at + HEAD.size + 1] = chosen.channel >> 8
        # MCAP's word for "no sequence": a number that grows would cost a byte or two of each message.
        records[(at + SEQUENCE_AT)[:, np.newaxis] + np.arange(4)] = 0
    return Block(records, at, chosen, note)
