"""Long mixed streams, and damage whose place is known."""

from __future__ import annotations

import random
from dataclasses import dataclass
from itertools import accumulate

from epf_gcs.codec.encode import frame_bytes
from epf_gcs.codec.frame import FROM_BOARD, TO_BOARD, Damage, Direction, Frame
from epf_gcs.codec.messages_gen import COMMANDS, TELEMETRY
from epf_gcs.codec.tables import Message, Value


def mixed_frames(count: int, seed: int, way: Direction = FROM_BOARD) -> list[bytes]:
    """Frames of all kinds that a deployed board (or station) sends, in turn, with plausible random values."""
    rng = random.Random(seed)
    source = TELEMETRY if way is FROM_BOARD else {command.id: command for command in COMMANDS.values()}
    kinds = [message for message in source.values() if not message.extension]
    return [frame_bytes(way, message, _payload(message, rng)) for message in _turns(kinds, count)]


@dataclass(frozen=True)
class DamagedStream:
    """A stream with flipped bytes, and the frames that were hit by none, by their place in it."""

    data: bytes
    intact: dict[int, bytes]
    sent: dict[int, bytes]


def damage(frames: list[bytes], share: float, seed: int) -> DamagedStream:
    """Replace this share of all bytes by other ones."""
    rng = random.Random(seed)
    data = bytearray(b"".join(frames))
    hit = sorted(rng.sample(range(len(data)), round(len(data) * share)))
    for place in hit:
        data[place] ^= rng.randrange(1, 256)
    starts = list(accumulate((len(frame) for frame in frames), initial=0))[:-1]
    sent = dict(zip(starts, frames, strict=True))
    intact = {start: frame for start, frame in sent.items() if bytes(data[start : start + len(frame)]) == frame}
    return DamagedStream(bytes(data), intact, sent)


def placed(events: list[Frame | Damage], way: Direction = FROM_BOARD) -> dict[int, bytes]:
    """The frames among events by their place in the stream: every byte is in exactly one event."""
    found: dict[int, bytes] = {}
    position = 0
    for event in events:
        if isinstance(event, Frame):
            found[position] = frame_bytes(way, event.message, event.payload)
            position += len(found[position])
        else:
            position += len(event.data)
    return found


def _turns(kinds: list[Message], count: int) -> list[Message]:
    return [kinds[index % len(kinds)] for index in range(count)]


def _payload(message: Message, rng: random.Random) -> bytes:
    by_slot = {value.slot: value for value in message.values}
    numbers = [_number(value, rng) for _, value in sorted(by_slot.items())]
    return message.struct.pack(*numbers)


def _number(value: Value, rng: random.Random) -> float:
    if value.minimum is None or value.maximum is None:
        return ord("A")
    if value.encoding == "ascii_digits":
        return ord(rng.choice("0123456789"))
    if value.kind == "number":
        return rng.uniform(value.minimum, value.maximum)
    return rng.randint(int(value.minimum), int(value.maximum))


BOTH = {"board-to-pc": FROM_BOARD, "pc-to-board": TO_BOARD}
"""The two directions by the names that the firmware's stream decoder takes."""
