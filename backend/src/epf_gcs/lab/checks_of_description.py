"""What a board that describes itself must do."""

from __future__ import annotations

import math
import zlib
from typing import Final

from epf_gcs.codec.encode import frame_bytes
from epf_gcs.codec.frame import TO_BOARD, Frame
from epf_gcs.codec.messages_gen import COMMANDS, TELEMETRY_BY_NAME
from epf_gcs.lab.peer import Check, Lack, Peer, must_be
from epf_gcs.vehicle.own_gains import SNAKE_CASE

_DONE, _BAD_VALUE = 0, 1
_GAIN: Final = 1
_ENUM: Final = 5
_SETTING: Final = COMMANDS["own_gain_set"]


def _row(peer: Peer, row: int) -> Frame:
    peer.frames.clear()
    must_be(peer.result("describe_item", row), _DONE, f"the result of describing row {row}")
    return peer.awaited("description_row", f"in answer to describe_item {row}")


def _count(peer: Peer) -> tuple[int, int]:
    """Rows and the checksum over them."""
    peer.frames.clear()
    peer.command("describe")
    count, crc32 = peer.awaited("description", "in answer to describe").values
    return int(count), int(crc32)


def _text(raw: bytes) -> str:
    return raw.split(b"\0", 1)[0].decode("ascii", "replace")


def _describes(peer: Peer) -> None:
    count, wanted = _count(peer)
    crc32, names = 0, set()
    for row in range(count):
        values = _row(peer, row).values
        number, kind, _, _, minimum, maximum, step, default, name, *_ = values
        crc32 = zlib.crc32(TELEMETRY_BY_NAME["description_row"].struct.pack(*values), crc32)
        must_be(number, row, f"the number in row {row}")
        must_be(kind, _GAIN, f"the kind of row {row}: only gains are in use")
        if not SNAKE_CASE.fullmatch(_text(name)) or name in names:
            raise Lack(f"row {row} is called {_text(name)!r}: a name is in snake_case and there is one of it")
        if not (minimum <= default <= maximum and 0.0 < step < math.inf):
            raise Lack(f"{_text(name)}: range {minimum:g}..{maximum:g}, step {step:g} and default {default:g} disagree")
        names.add(name)
    must_be(crc32, wanted, "the CRC-32 in the description: that of the rows as they were told")
    must_be(peer.result("describe_item", count), _BAD_VALUE, "the result of describing a row that is not there")


def _reads_back(peer: Peer) -> None:
    for row in range(_count(peer)[0]):
        values = _row(peer, row).values
        kind, minimum, maximum = values[2], values[4], values[5]
        before = _told(peer, row)
        if not minimum <= before <= maximum:
            raise Lack(f"row {row} has the value {before:g}, which is not in {minimum:g}..{maximum:g}")
        must_be(_set(peer, row, maximum), _DONE, f"the result of setting row {row} to its largest value")
        must_be(_told(peer, row), maximum, f"the value of row {row} after it was set")
        refused = (math.nan, math.inf, maximum + max(1.0, abs(maximum)), *((0.5,) if kind == _ENUM else ()))
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
    ("the board describes itself, with the checksum of its rows", _describes),
    ("its own gains are set and read back, or refused", _reads_back),
)
"""Names, and what raises Lack where a board that says it describes itself does not do so."""
