"""A long stream with flipped bytes: how many intact frames are found, and how many wrong ones."""

from __future__ import annotations

from collections import Counter

from bench import mavlink
from bench.table import Row
from tests.codec.streams import DamagedStream, damage, mixed_frames, placed
from tests.codec.vectors import CHUNKS, decode

FRAMES = 100_000
SHARE = 0.001


def run() -> list[Row]:
    """Our decoder at every chunk size; the peer at its best one, on its own stream with the same damage."""
    ours = damage(mixed_frames(FRAMES, seed=1), SHARE, seed=2)
    peer_found, peer_wrong = _peer()
    rows = []
    for chunk in CHUNKS:
        found, wrong = _ours(ours, chunk)
        what = f"damaged stream, {SHARE:.1%} of bytes, chunks of {chunk}"
        rows.append(Row(f"{what}: intact frames found", found, "%", "100 %", found == 100.0, peer_found, mavlink.NAME))
        rows.append(Row(f"{what}: wrong frames", wrong, "frames", "0", wrong == 0, peer_wrong, mavlink.NAME))
    return rows


def _ours(stream: DamagedStream, chunk: int) -> tuple[float, int]:
    """Percent of the intact frames that were found, and the number of accepted frames that were never sent."""
    found = placed(decode(stream.data, chunk))
    hit = sum(found.get(place) == frame for place, frame in stream.intact.items())
    return 100.0 * hit / len(stream.intact), len(found) - hit


def _peer() -> tuple[float, int]:
    stream = damage(mavlink.mixed_frames(FRAMES, seed=1), SHARE, seed=2)
    found = Counter(bytes(message.get_msgbuf()) for message in mavlink.decode([stream.data]))
    intact = Counter(stream.intact.values())
    hit = (found & intact).total()
    return 100.0 * hit / intact.total(), found.total() - hit
