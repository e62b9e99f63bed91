"""Cut a stream of bytes into frames, even if the line damages it."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from struct import Struct
from typing import Any, Final, Literal, NamedTuple

from epf_gcs.codec.checksum import MASK
from epf_gcs.codec.messages_gen import (
    COMMANDS_BY_ID,
    END,
    FORBIDDEN_TYPE_BITS,
    TELEMETRY,
    TO_BOARD_HEADER,
    TO_PC_HEADER,
    TO_PC_TYPE_BIT,
)
from epf_gcs.codec.tables import Message

DamageKind = Literal["noise", "remains", "unknown_type", "bad_type_bits", "bad_end", "bad_checksum", "cut_short"]

_HEADER_SIZE: Final = 4
_START_SIZE: Final = 8  # header and type: enough to know the length
_TAIL_SIZE: Final = 8  # checksum and end
_END_WORD: Final = int.from_bytes(END, "little")
_LONGEST_NOISE: Final = 256  # longer than any text line of the board; bounds what is kept until a line end comes
_LONGEST_REMAINS: Final = 256  # longer than the longest frame
_new_frame: Final = tuple.__new__


class Frame(NamedTuple):
    """An accepted frame: length, type bits, checksum and end marker are all correct."""

    message: Message
    payload: bytes

    @property
    def type_id(self) -> int:
        """Type without the direction bit."""
        return self.message.id

    @property
    def values(self) -> tuple[Any, ...]:
        """The raw wire values, in the order of the definition; `meaning` decodes them."""
        message, payload = self
        return message.struct.unpack(payload)


class Damage(NamedTuple):
    """Bytes that belong to no accepted frame. A candidate is a header that may begin a frame.

    noise: bytes without a header before them, such as the board's text lines; one event for each line.
    remains: the bytes after the header of a failed candidate.
    Every other kind says why a candidate failed. Its `data` is the header alone: the search continues right
    after it, because a good frame may lie inside the failed one.
    """

    kind: DamageKind
    data: bytes

    @property
    def is_failed_frame(self) -> bool:
        """True for a failed candidate; False for bytes that are only noise or remains."""
        return self.kind not in ("noise", "remains")

    @property
    def text(self) -> str | None:
        """A text line of the board's shell, "" for white space; None if the bytes are not printable text."""
        data = self.data.strip(b"\r\n\t ")
        if self.kind != "noise" or not data.isascii():
            return None
        text = data.decode("ascii")
        if not text:
            return "" if self.data else None
        return text if text.isprintable() else None


@dataclass(frozen=True, slots=True)
class Direction:
    """One direction of the line: its header, its type bit and its messages by type."""

    header: bytes
    type_bit: int
    messages: Mapping[int, Message]


FROM_BOARD: Final = Direction(TO_PC_HEADER, TO_PC_TYPE_BIT, TELEMETRY)
TO_BOARD: Final = Direction(TO_BOARD_HEADER, 0, COMMANDS_BY_ID)


class _Layout(NamedTuple):
    """What the scan needs for one message: frame size, and a reader of all words from the type to the end marker."""

    size: int
    words: Callable[[bytes, int], tuple[int, ...]]
    message: Message


def _layouts(direction: Direction, messages: Iterable[Message]) -> dict[bytes, _Layout]:
    """By header and type together: one look-up gives message and length, and rejects wrong type bits."""
    return {
        direction.header + (direction.type_bit | message.id).to_bytes(4, "little"): _Layout(
            _START_SIZE + message.size + _TAIL_SIZE, Struct(f"<{message.size // 4 + 3}I").unpack_from, message
        )
        for message in messages
    }


class FrameDecoder:
    """Turn chunks of any size into frames, finding the next header after damage.

    The wire is not trusted: no sequence of bytes makes `feed` raise, what it finds does not depend on how the
    bytes are cut into chunks, and rubbish around an intact frame, even a false header, does not lose that frame.
    """

    def __init__(self, direction: Direction = FROM_BOARD) -> None:
        self._direction = direction
        self._header = direction.header
        self._type_bit = direction.type_bit
        self._built_in = _layouts(direction, direction.messages.values())
        self._layouts = self._built_in
        self._smallest = min(layout.size for layout in self._layouts.values())
        self._buffer = b""
        self._need = 1  # buffer size from which anything new can be decided
        self._frame_was_last = False  # the last byte received was the last of a frame
        self._run = b""  # skipped bytes not yet handed out
        self._run_is_remains = False

    def learn(self, own: Iterable[Message]) -> None:
        """From the next byte on, frames of these messages are known beside the built-in ones, and no others."""
        self._layouts = {**self._built_in, **_layouts(self._direction, own)}
        self._smallest = min(layout.size for layout in self._layouts.values())

    @property
    def missing_bytes(self) -> int:
        """The least number of bytes still needed to complete a frame; 0 if unknown.

        After a frame another frame is expected; after text or noise the next bytes can be anything.
        """
        if not self._buffer and not self._frame_was_last:
            return 0
        return max(self._need, self._smallest) - len(self._buffer)

    def missing_with(self, ahead: bytes) -> int:
        """`missing_bytes` where `ahead` are the next bytes: all of the frame that they begin or go on."""
        layout = self._layouts.get((self._buffer[:_START_SIZE] + ahead)[:_START_SIZE])
        return self.missing_bytes if layout is None else layout.size - len(self._buffer)

    def feed(self, chunk: bytes) -> list[Frame | Damage]:
        """Take the next bytes of the line and return what they complete, in the order of the line."""
        buffer = self._buffer + chunk
        if len(buffer) < self._need:
            self._buffer = buffer
            return []
        return self._scan(buffer)

    def kept(self) -> list[Any]:
        """What waits for more bytes, as plain values for `restore`."""
        return [
            self._buffer.decode("latin-1"),
            self._need,
            self._frame_was_last,
            self._run.decode("latin-1"),
            self._run_is_remains,
        ]

    def restore(self, kept: list[Any]) -> None:
        """Go on from a state that `kept` gave."""
        buffer, self._need, self._frame_was_last, run, self._run_is_remains = kept
        self._buffer, self._run = buffer.encode("latin-1"), run.encode("latin-1")

    def flush(self) -> list[Frame | Damage]:
        """Call when the line is silent: returns waiting text, and frames that a false header holds back.

        A false header with a valid type makes the decoder wait for the length of that type. It is dropped here
        only if an intact frame follows it, so a pause in the middle of a good frame loses nothing.
        """
        found: list[Frame | Damage] = []
        while self._holds_frame_behind_candidate():
            found += self._give_up()
        found += self._take_run()
        return found

    def finish(self) -> list[Frame | Damage]:
        """The stream has ended: return all that still waits, an incomplete frame as `cut_short`."""
        found: list[Frame | Damage] = []
        while self._buffer:
            if self._buffer.startswith(self._header):
                found += self._give_up()
            else:
                self._skip(self._buffer, found)
                self._buffer = b""
        self._need = 1
        self._frame_was_last = False
        found += self._take_run()
        self._run_is_remains = False
        return found

    def _scan(self, buffer: bytes) -> list[Frame | Damage]:
        """Decode what `buffer` allows; the rest stays in self._buffer until that holds self._need bytes."""
        found: list[Frame | Damage] = []
        append = found.append
        layout_of = self._layouts.get
        end_word, mask = _END_WORD, MASK
        skipping = True  # bytes were, or may have been, skipped since the last frame
        position = 0
        length = len(buffer)
        while True:
            layout = layout_of(buffer[position : position + _START_SIZE])
            if layout is None:
                if position == length:
                    self._buffer = b""
                    self._need = 1
                    self._frame_was_last = not skipping
                    break
                skipping = True
                position = self._search(buffer, position, found)
                if position < 0:
                    break
                continue
            size, words_at, message = layout
            stop = position + size
            if stop > length:
                self._need = size
                self._buffer = buffer[position:]
                break
            words = words_at(buffer, position + _HEADER_SIZE)
            # Type, payload and checksum sum to 0, so with the end marker the sum is the end marker's word.
            if words[-1] == end_word and sum(words) & mask == end_word:
                if skipping:
                    found += self._take_run()
                    self._run_is_remains = skipping = False
                append(_new_frame(Frame, (message, buffer[position + _START_SIZE : stop - _TAIL_SIZE])))
                position = stop
            else:
                skipping = True
                self._fail("bad_checksum" if words[-1] == end_word else "bad_end", found)
                position += _HEADER_SIZE
        return found

    def _search(self, buffer: bytes, position: int, found: list[Frame | Damage]) -> int:
        """Skip from `position`, where no known frame begins, to the next place to try; -1 if the buffer ends first."""
        start = buffer.find(self._header, position)
        if start < 0:
            kept = self._header_begun(buffer, position)
            self._frame_was_last = False
            self._skip(buffer[position : len(buffer) - kept], found)
            self._buffer = buffer[len(buffer) - kept :]
            self._need = _HEADER_SIZE if kept else 1
            return -1
        if start > position:
            self._skip(buffer[position:start], found)
            return start
        if len(buffer) - position < _START_SIZE:
            self._buffer = buffer[position:]
            self._need = _START_SIZE
            return -1
        type_word = int.from_bytes(buffer[position + _HEADER_SIZE : position + _START_SIZE], "little")
        wrong_bits = type_word & FORBIDDEN_TYPE_BITS or type_word & TO_PC_TYPE_BIT != self._type_bit
        self._fail("bad_type_bits" if wrong_bits else "unknown_type", found)
        return position + _HEADER_SIZE

    def _header_begun(self, buffer: bytes, position: int) -> int:
        """Number of bytes at the end of `buffer`, from `position` on, that may be the start of a header."""
        for size in range(min(_HEADER_SIZE - 1, len(buffer) - position), 0, -1):
            if buffer.endswith(self._header[:size]):
                return size
        return 0

    def _fail(self, kind: DamageKind, found: list[Frame | Damage]) -> None:
        """Report a failed candidate: only its header is dropped, the caller searches the bytes after it again."""
        found += self._take_run()
        found.append(Damage(kind, self._header))
        self._run_is_remains = True

    def _skip(self, data: bytes, found: list[Frame | Damage]) -> None:
        """Report bytes outside frames. An event ends at an end mark or a length limit, never where a chunk ends."""
        run = self._run + data
        while True:
            if self._run_is_remains:
                mark, longest = END, _LONGEST_REMAINS
            else:
                mark, longest = b"\n", _LONGEST_NOISE
            place = run.find(mark, 0, longest)
            if place < 0 and len(run) < longest:
                break
            stop = place + len(mark) if place >= 0 else longest
            self._run = run[:stop]
            found += self._take_run()
            self._run_is_remains = False
            run = run[stop:]
        self._run = run

    def _take_run(self) -> list[Frame | Damage]:
        """The skipped bytes as one event, or none."""
        if not self._run:
            return []
        taken = Damage("remains" if self._run_is_remains else "noise", self._run)
        self._run = b""
        return [taken]

    def _give_up(self) -> list[Frame | Damage]:
        """Fail the waiting candidate and search the bytes after its header."""
        found: list[Frame | Damage] = []
        self._fail("cut_short", found)
        return found + self._scan(self._buffer[_HEADER_SIZE:])

    def _holds_frame_behind_candidate(self) -> bool:
        """Whether a complete, good frame lies after the header of the waiting candidate."""
        buffer = self._buffer
        position = buffer.find(self._header, _HEADER_SIZE) if buffer.startswith(self._header) else -1
        while position >= 0:
            layout = self._layouts.get(buffer[position : position + _START_SIZE])
            if layout is not None and position + layout.size <= len(buffer):
                words = layout.words(buffer, position + _HEADER_SIZE)
                if words[-1] == _END_WORD and sum(words) & MASK == _END_WORD:
                    return True
            position = buffer.find(self._header, position + 1)
        return False
