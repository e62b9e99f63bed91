"""The vectors of protocol/vectors, and streams made from them."""

from __future__ import annotations

import json
from collections import Counter
from pathlib import Path
from typing import Any

from epf_gcs.codec.frame import FROM_BOARD, TO_BOARD, Damage, Direction, Frame, FrameDecoder

FOLDER = Path(__file__).parents[3] / "protocol" / "vectors"
CHUNKS = (1, 2, 3, 8, 64, 4096)


def load(name: str) -> list[dict[str, Any]]:
    """The lines of one vector file."""
    return [json.loads(line) for line in (FOLDER / name).read_text("utf-8").splitlines()]


def good_frames() -> list[bytes]:
    """Every captured telemetry frame that must be accepted, each payload once."""
    accepted = [bytes.fromhex(vector["hex"]) for vector in load("telemetry.jsonl") if "message" in vector]
    return list(dict.fromkeys(accepted))


def direction(name: str) -> Direction:
    return {"to_pc": FROM_BOARD, "to_board": TO_BOARD}[name]


def decode(stream: bytes, chunk: int, way: Direction = FROM_BOARD) -> list[Frame | Damage]:
    """All events of a stream that arrives in chunks of one size and then ends."""
    decoder = FrameDecoder(way)
    found: list[Frame | Damage] = []
    for start in range(0, len(stream), chunk):
        found += decoder.feed(stream[start : start + chunk])
    return found + decoder.finish()


def frames(events: list[Frame | Damage]) -> list[tuple[int, str]]:
    """Type and payload of the frames among events."""
    return [(event.type_id, event.payload.hex()) for event in events if isinstance(event, Frame)]


def failures(events: list[Frame | Damage]) -> Counter[str]:
    """How many candidates failed, by kind."""
    return Counter(event.kind for event in events if isinstance(event, Damage) and event.is_failed_frame)


def dropped(events: list[Frame | Damage]) -> bytes:
    """The bytes that are in no frame, in the order of the line."""
    return b"".join(event.data for event in events if isinstance(event, Damage))
