"""The pieces of a recording, one after another: stretches of plain records, and chunks."""

from __future__ import annotations

from collections.abc import Generator, Iterator
from io import BytesIO
from pathlib import Path
from struct import Struct, error
from typing import BinaryIO, Final, NamedTuple

import numpy as np
from mcap.data_stream import ReadDataStream
from mcap.exceptions import EndOfFile
from mcap.opcode import Opcode
from mcap.records import Metadata
from numpy.typing import NDArray

from epf_gcs.recordings.chunks import chunk_begins, read_head, unpack
from epf_gcs.recordings.damage_log import DamageLog
from epf_gcs.recordings.ending import ending, zeros_to_end
from epf_gcs.recordings.limits import LIMITS, Limits, RecordingError
from epf_gcs.recordings.mcap_file import MAGIC
from epf_gcs.recordings.next_record import next_record
from epf_gcs.recordings.notes import Note, read
from epf_gcs.recordings.scan import (
    HEAD,
    PAYLOAD_AT,
    Bytes,
    Other,
    Places,
    ScanResult,
    channels_of,
    lengths_of,
    mended_times,
    scan,
    times_of,
)
from epf_gcs.recordings.topics import ALL_TOPICS

_BLOCK_BYTES: Final = 4 << 20
_BEHIND_DAMAGE_BYTES: Final = 1 << 14
_LATEST_NS: Final = (1 << 63) - 1
_CHANNEL: Final = Struct("<HHI")
_NUMBERS: Final = {topic: number for number, topic in ALL_TOPICS.items()}


class Messages(NamedTuple):
    """Messages in file order, as arrays of equal length; `data[start : start + length]` is a payload.

    channel: uint16, of `topics.py`. t_ns: int64, Unix ns. start, length: int64, bytes. data: uint8, read only.
    """

    channel: NDArray[np.uint16]
    t_ns: Places
    start: Places
    length: Places
    data: Bytes


class Part(NamedTuple):
    """A stretch of the file. `place`: the file's offset of the chunk, or of `messages.data` if it is no chunk.

    `notes`: each with the number of messages of this part that come before it.
    """

    messages: Messages
    notes: list[tuple[int, Note]]
    place: int
    is_chunk: bool


class Parts:
    """Reads a file part by part and remembers how far it came. See `epf_gcs.recordings.reading.Reader`."""

    def __init__(self, path: Path, *, limits: Limits = LIMITS, place: int = 0, with_chunks: bool = True) -> None:
        self.path = path
        # An open file is read in place of the one that has this name now: packing may have replaced that meanwhile.
        self.file: BinaryIO | None = None
        self.limits = limits
        self.place = 0
        # What is read at once; a reader that jumps about sets less.
        self.block_bytes = _BLOCK_BYTES
        self.is_whole = False
        self.topics: dict[int, str] = {}
        self._with_chunks = with_chunks
        self._numbers = np.zeros(1 << 16, dtype=np.uint16)  # our number of each channel of the file, 0 if none of ours
        self._damage = DamageLog()
        self._count = self._note_count = self._unpacked = 0
        self._foreign = 0
        self._last_ns = 0
        if place:
            self.skip_to(place)

    @property
    def damage(self) -> str | None:
        """What could not be read so far, in sentences; None if nothing was damaged."""
        return self._damage.sentences

    def skip_to(self, place: int) -> None:
        """Continue at this record of the file. The channels are learnt from the file's first records."""
        if place <= self.place:
            return
        if self.place == 0:
            for _ in self.parts():
                if self.topics:
                    break
            self._damage.clear()
            self._count = self._note_count = self._unpacked = self._foreign = 0
            self.is_whole = False
        self.place = place

    def passed(self, t_ns: int) -> None:
        """Messages up to this time (Unix ns) lie before what is read next."""
        self._last_ns = t_ns

    def end_at(self, place: int) -> None:
        """Nothing more is to be read of the file, whose data end at `place`."""
        self.place, self.is_whole = place, True

    def parts(self) -> Iterator[Part]:
        """The parts from `place` to the end that the file has now; `place` moves on with each."""
        try:
            if self.file is not None:
                yield from self._parts(self.file)
            else:
                with self.path.open("rb") as file:
                    yield from self._parts(file)
        except OSError as fault:
            raise RecordingError(
                "recording_unreadable",
                f"The recording cannot be read: {fault.strerror or fault}.",
                reason=fault.strerror or str(fault),
            ) from fault
        if self.is_whole and self._foreign and not self.topics:
            raise RecordingError(
                "recording_foreign",
                "This file holds messages, but none of a flight of this station: it is another program's.",
            )

    def _parts(self, file: BinaryIO) -> Iterator[Part]:
        if self.place == 0 and not self._begins(file):
            return
        need, usual = 0, self.block_bytes
        while not self.is_whole:
            file.seek(self.place)
            # With the head behind a long record, which says whether the length was right.
            size = max(usual, need + HEAD.size)
            data = file.read(size)
            block = np.frombuffer(data, dtype=np.uint8)
            begun = self.place
            usual = min(2 * usual, self.block_bytes)
            found = scan(block, max(self.limits.record_bytes, self.limits.chunk_bytes))
            goes_on = None
            if found.stop == "damage":
                goes_on = next_record(file, begun + found.last + 1)
                if goes_on is not None and goes_on < begun + found.end:
                    found = found.without_last()
                # The rest of the block is read again, so that it is not kept.
                block = block[: found.end].copy()
            if (yield from self._stretch(block, found, begun)):
                self._check_end(file)
                return
            self.place = begun + found.end
            need = found.need
            if len(data) < size or found.stop == "damage" or (found.stop == "zeros" and not need):
                if not self._skip(file, found, goes_on, begun + len(data)):
                    yield from self._cut_chunk(data[found.end :], begun + found.end)
                    return
                # Where there is damage there is often more: whole blocks would be read again and again.
                need, usual = 0, min(_BEHIND_DAMAGE_BYTES, self.block_bytes)

    def _skip(self, file: BinaryIO, found: ScanResult, goes_on: int | None, end: int) -> bool:
        """Leave out bytes that are no record and go on at the next one. False if no record follows.

        `end` is where the bytes that were read end.
        """
        is_blank = found.stop == "zeros" and not found.need
        if is_blank and (zeros := zeros_to_end(file, self.place)) is not None:
            self._damage.tell(f"the file ends in {zeros} zero bytes")
            return False
        if found.stop != "damage":
            # A record that was half there when it was read may be whole by now.
            goes_on = next_record(file, self.place + 1, None if is_blank else end)
        if goes_on is not None:
            self._damage.leave_out(self.place, goes_on - self.place)
            self.place = goes_on
        elif found.stop == "damage" or is_blank:
            self._damage.tell(f"byte {self.place} begins no record, what follows it was not read")
        return goes_on is not None

    def _begins(self, file: BinaryIO) -> bool:
        file.seek(0)
        magic = file.read(len(MAGIC))
        if not MAGIC.startswith(magic):
            raise RecordingError("recording_foreign", "This file is no recording: it does not begin as an MCAP file.")
        if len(magic) < len(MAGIC):
            return False
        self.place = len(MAGIC)
        return True

    def _stretch(self, data: Bytes, found: ScanResult, begun: int) -> Generator[Part, None, bool]:
        """The messages and notes of a block, with each of its chunks as a part of its own.

        Returns whether the data section ended in it.
        """
        first = 0
        notes: list[tuple[int, Note]] = []
        for other in found.others:
            before = other.messages_before
            if other.opcode == Opcode.CHUNK:
                yield from self._plain(data, found.messages[first:before], notes, begun)
                first, notes = before, []
                body = data.data[other.start : other.start + other.length]
                yield from self._chunk(body, begun + other.start - HEAD.size)
            elif other.opcode in (Opcode.DATA_END, Opcode.FOOTER):
                self.place = begun + other.start - HEAD.size
                yield from self._plain(data, found.messages[first:before], notes, begun)
                return True
            else:
                if other.opcode == Opcode.METADATA and (before > first or not self._last_ns):
                    near = found.messages[max(0, before - 1) : before + 1][:1]
                    times = times_of(data, near).tolist() or chunk_begins(data, found.others)
                    self._last_ns = int(min([*times, _LATEST_NS]))
                notes += [(before - first, note) for note in self.learn(data, other)]
        yield from self._plain(data, found.messages[first:], notes, begun)
        return False

    def _plain(self, data: Bytes, at: Places, notes: list[tuple[int, Note]], begun: int) -> Iterator[Part]:
        if len(at) or notes:
            messages, kept = self._messages(data, at)
            if kept is not None:
                passed = np.concatenate([[0], np.cumsum(kept)])
                notes = [(int(passed[before]), note) for before, note in notes]
            yield Part(messages, notes, begun, False)

    def _chunk(self, body: memoryview, place: int, *, is_cut: bool = False) -> Iterator[Part]:
        if not self._with_chunks:
            head = read_head(body)
            if head is not None and head.end_ns <= _LATEST_NS:
                self._last_ns = head.end_ns
            return
        data, damage = unpack(body, self.limits)
        self._unpacked += len(data)
        if self._unpacked > self.limits.unpacked_bytes:
            raise RecordingError(
                "recording_too_large",
                f"This file unpacks to more than {self.limits.unpacked_bytes} bytes.",
                most=self.limits.unpacked_bytes,
            )
        found = scan(data, self.limits.record_bytes)
        for other in found.others:
            if other.opcode == Opcode.CHANNEL:
                self._learn_channel(data, other)
        if damage is not None:
            self._damage.tell(damage)
        elif found.stop != "end":
            self._damage.tell("a chunk holds something that is no record")
        messages, _ = self._messages(data, found.messages)
        if len(messages.channel) or not is_cut:
            yield Part(messages, [], place, True)

    def _cut_chunk(self, rest: bytes, place: int) -> Iterator[Part]:
        """The file ends inside a record: of a chunk, what came of it still holds whole messages."""
        if len(rest) > HEAD.size and rest[0] == Opcode.CHUNK:
            yield from self._chunk(memoryview(rest)[HEAD.size :], place, is_cut=True)

    def _messages(self, data: Bytes, at: Places) -> tuple[Messages, NDArray[np.bool_] | None]:
        """The messages of ours among those at `at`, and which those are, None for all."""
        channel = self._numbers[channels_of(data, at)]
        times, mended = mended_times(data, at)
        if mended:
            self._damage.tell("a message has two times, the likelier one was taken", mended)
        possible = times <= _LATEST_NS
        kept = (channel > 0) & possible
        chosen = None
        if not kept.all():
            chosen = kept
            self._foreign += int(np.count_nonzero(channel == 0))
            if not possible.all():
                self._damage.tell(
                    "a message has a time that no clock gives, it was left out", int(np.count_nonzero(~possible))
                )
            at, channel, times = at[kept], channel[kept], times[kept]
        self._count += len(at)
        if self._count > self.limits.messages:
            raise RecordingError(
                "recording_too_large",
                f"This file holds more than {self.limits.messages} messages.",
                most=self.limits.messages,
            )
        t_ns = times.astype(np.int64)
        if len(t_ns):
            self._last_ns = int(t_ns[-1])
        return Messages(channel, t_ns, at + PAYLOAD_AT, lengths_of(data, at), data), chosen

    def learn(self, data: Bytes, other: Other) -> list[Note]:
        """Take a record that is neither message nor chunk; returns the note in it, if there is one."""
        if other.opcode == Opcode.CHANNEL:
            self._learn_channel(data, other)
        if other.opcode != Opcode.METADATA:
            return []
        self._note_count += 1
        if self._note_count > self.limits.notes:
            raise RecordingError(
                "recording_too_large", f"This file holds more than {self.limits.notes} notes.", most=self.limits.notes
            )
        body = data[other.start : other.start + other.length].tobytes()
        try:
            metadata = Metadata.read(ReadDataStream(BytesIO(body)))
        except (error, ValueError, EndOfFile):
            self._damage.tell("a note cannot be read")
            return []
        # A note of an earlier version of the station has no time of its own: it is from after the message before it.
        return [read(metadata.name, metadata.metadata) or Note(self._last_ns, metadata.name, dict(metadata.metadata))]

    def _learn_channel(self, data: Bytes, other: Other) -> None:
        body = data[other.start : other.start + other.length].tobytes()
        try:
            channel, _, length = _CHANNEL.unpack_from(body)
            topic = body[_CHANNEL.size : _CHANNEL.size + length].decode()
        except (error, UnicodeDecodeError):
            self._damage.tell("a channel cannot be read")
            return
        number = _NUMBERS.get(topic)
        if number is None or self._numbers[channel] == number:
            return
        if number in self.topics or self._numbers[channel]:
            raise RecordingError(
                "recording_two_boards",
                f"This file holds two recordings in one (two channels {topic}): their bytes cannot be told apart.",
                topic=topic,
            )
        self.topics[number] = topic
        self._numbers[channel] = number

    def _check_end(self, file: BinaryIO) -> None:
        end = ending(file, self.place)
        self.is_whole = end.is_whole
        if end.has_more:
            self._damage.tell("the file goes on after its end, what follows was not read")
