"""What a board that describes itself must do."""

from __future__ import annotations

import math
import zlib
from collections.abc import Iterable
from typing import Final

from epf_gcs.codec.description import BLOCK_SIZE, GainRow, Row, block_count, block_questions, rows_of
from epf_gcs.codec.encode import frame_bytes
from epf_gcs.codec.frame import TO_BOARD
from epf_gcs.codec.messages_gen import COMMANDS
from epf_gcs.codec.values import meaning, single
from epf_gcs.contract.own_gains import LeftOutRow
from epf_gcs.lab.peer import Check, Lack, Peer, must_be
from epf_gcs.vehicle.own_gains import usable_rows
from epf_gcs.vehicle.own_topics import own_messages, usable_topics

_DONE, _BAD_VALUE = 0, 1
_ENUM: Final = 5
_SETTING: Final = COMMANDS["own_gain_set"]


def _summary(peer: Peer) -> tuple[int, int]:
    """Size of the table and the checksum over it."""
    peer.frames.clear()
    peer.command("describe")
    size, crc32 = peer.awaited("description", "in answer to describe").values
    return int(size), int(crc32)


def _blocks(peer: Peer, first: int, count: int) -> bytes:
    must_be(peer.result("describe_blocks", first, count), _DONE, f"the result of describing {count} from block {first}")
    peer.wait(
        lambda: peer.count("description_block") >= count,
        f"not all of {count} description_blocks came in answer to describe_blocks from {first}",
    )
    found = [frame for frame in peer.frames if frame.message.name == "description_block"]
    must_be([frame.values[0] for frame in found], list(range(first, first + count)), "the numbers of the blocks")
    return b"".join(frame.payload[-BLOCK_SIZE:] for frame in found)


def _table(peer: Peer) -> tuple[bytes, bytes, int]:
    """The table, what fills its last block, and its checksum as the board tells it."""
    size, crc32 = _summary(peer)
    blocks = b"".join(_blocks(peer, first, count) for first, count in block_questions(size))
    return blocks[:size], blocks[size:], crc32


def _rows(peer: Peer) -> list[Row]:
    return rows_of(_table(peer)[0])


def _describes(peer: Peer) -> None:
    table, filling, wanted = _table(peer)
    must_be(zlib.crc32(table), wanted, "the CRC-32 in the description: that of the table as it was told")
    must_be(any(filling), False, "whether anything but zeros is behind the table's end")
    _must_be_usable(usable_rows(rows_of(table))[1])
    behind = block_count(len(table))
    must_be(peer.result("describe_blocks", behind, 1), _BAD_VALUE, "the result of describing a block that is not there")


def _describes_topics(peer: Peer) -> None:
    _must_be_usable(usable_topics(_rows(peer))[1])


def _must_be_usable(left_out: Iterable[LeftOutRow]) -> None:
    # A topic that lacks a field is told by what is wrong with the field.
    for one in sorted(left_out, key=lambda one: one.reason == "fields"):
        name = "" if one.name is None else f" ({one.name})"
        raise Lack(f"row {one.row}{name} of the description cannot be used: {one.reason.replace('_', ' ')}")


def _sends_topics(peer: Peer) -> None:
    definitions = usable_topics(_rows(peer))[0]
    topics = own_messages(definitions)
    peer.know(topics)
    must_be(_switch(peer, 2), _BAD_VALUE, "the result of own_topics with 2")
    must_be(_switch(peer, 1), _DONE, "the result of own_topics with 1")
    for topic in topics:
        peer.wait(
            lambda name=topic.name: peer.count(name) > 0,  # type: ignore[misc]
            f"no frame of {topic.name} (type {topic.id:#x}) of the length of its fields came after own_topics 1",
        )
        frame = next(frame for frame in peer.frames if frame.message is topic)
        must_be(meaning(frame).implausible, (), f"the fields of {topic.name} with a value that cannot be")
    must_be(_switch(peer, 0), _DONE, "the result of own_topics with 0")
    peer.frames.clear()
    peer.look(2.0 * max((topic.period_ms for topic in definitions), default=0) / 1000.0)
    for topic in topics:
        must_be(peer.count(topic.name), 0, f"frames of {topic.name} after own_topics 0")


def _switch(peer: Peer, on: int) -> int:
    command = COMMANDS["own_topics"]
    return peer.result_of(command.id, frame_bytes(TO_BOARD, command, command.struct.pack(on)))


def _reads_back(peer: Peer) -> None:
    for gain in (row for row in _rows(peer) if isinstance(row, GainRow)):
        row, minimum, maximum = gain.row, single(gain.minimum), single(gain.maximum)
        before = _told(peer, row)
        if not minimum <= before <= maximum:
            raise Lack(f"row {row} has the value {before:g}, which is not in {minimum:g}..{maximum:g}")
        must_be(_set(peer, row, maximum), _DONE, f"the result of setting row {row} to its largest value")
        must_be(_told(peer, row), maximum, f"the value of row {row} after it was set")
        refused = (math.nan, math.inf, maximum + max(1.0, abs(maximum)), *((0.5,) if gain.type == _ENUM else ()))
        for value in refused:
            must_be(_set(peer, row, value), _BAD_VALUE, f"the result of setting row {row} to {value:g}")
            must_be(peer.awaited("own_gain", "after a refused value").values[1], maximum, f"row {row} once refused")
        must_be(_set(peer, row, before), _DONE, f"the result of setting row {row} back")
        must_be(_told(peer, row), before, f"the value of row {row} after it was set back")


def _set(peer: Peer, row: int, value: float) -> int:
    # Not by the encoder, which refuses what a board must refuse too.
    peer.frames.clear()
    return peer.result_of(_SETTING.id, frame_bytes(TO_BOARD, _SETTING, _SETTING.struct.pack(row, value)))


def _told(peer: Peer, row: int) -> float:
    peer.frames.clear()
    peer.command("own_gain_get", row)
    told, value = peer.awaited("own_gain", f"in answer to own_gain_get {row}").values
    must_be(told, row, "the row in own_gain")
    return float(value)


DESCRIBED: Final[tuple[tuple[str, Check], ...]] = (
    ("the board describes itself, with the checksum of its table", _describes),
    ("its own gains are set and read back, or refused", _reads_back),
    ("its own topics are described with their fields", _describes_topics),
    ("its own topics come when they are switched on, and end", _sends_topics),
)
"""Names, and what raises Lack where a board that says it describes itself does not do so."""
