"""Frames a second of the live decoder, compared to pymavlink on its own stream of the same kind."""

from __future__ import annotations

import time
from collections.abc import Callable

from bench import mavlink
from bench.table import Row
from epf_gcs.codec.frame import Frame, FrameDecoder
from tests.codec.streams import mixed_frames

FRAMES = 250
CHUNKS = (4096, 256, 64, 16, 4, 1)
ROUNDS = 30
ROUND_S = 0.03
REACH = 5.0
SHARE_AT_ONE_BYTE = 1.0 / 20.0


def run() -> list[Row]:
    """Our best round against the peer's best round; they alternate, so that both meet the same load.

    Measured in CPU time of this process, so that other programs on the machine do not count.
    """
    rates = {chunk: frames_a_second(chunk) for chunk in CHUNKS}
    return [_row(chunk, rates) for chunk in CHUNKS]


def _row(chunk: int, rates: dict[int, tuple[float, float]]) -> Row:
    ours, peer = rates[chunk]
    reach, ok = "", None
    if chunk == CHUNKS[0]:
        reach, ok = f">= {REACH:g} x peer", ours >= REACH * peer
    elif chunk == 1:
        reach = f">= 1/20 of ours at {CHUNKS[0]}"
        ok = ours >= SHARE_AT_ONE_BYTE * rates[CHUNKS[0]][0]
    what = f"live decode with values, {FRAMES} mixed frames, chunks of {chunk}"
    return Row(what, ours, "frames/s", reach, ok, peer, mavlink.NAME)


def frames_a_second(chunk: int) -> tuple[float, float]:
    """Ours and the peer's, for one size of chunk."""
    our_chunks = _cut(b"".join(mixed_frames(FRAMES, seed=1)), chunk)
    peer_chunks = _cut(b"".join(mavlink.mixed_frames(FRAMES, seed=1)), chunk)
    assert _decode(our_chunks) == FRAMES
    assert len(mavlink.decode(peer_chunks)) == FRAMES
    ours = peer = 0.0
    for _ in range(ROUNDS):
        ours = max(ours, _rate(lambda: _decode(our_chunks)))
        peer = max(peer, _rate(lambda: len(mavlink.decode(peer_chunks))))
    return ours, peer


def _decode(chunks: list[bytes]) -> int:
    """Decode everything, the values of each frame too, as the peer does; returns the number of frames."""
    decoder = FrameDecoder()
    count = 0
    for chunk in chunks:
        for found in decoder.feed(chunk):
            if isinstance(found, Frame) and found.values:
                count += 1
    return count


def _rate(decode: Callable[[], int]) -> float:
    count = 0
    begun = time.process_time()
    while (spent := time.process_time() - begun) < ROUND_S:
        count += decode()
    return count / spent


def _cut(stream: bytes, chunk: int) -> list[bytes]:
    return [stream[start : start + chunk] for start in range(0, len(stream), chunk)]
