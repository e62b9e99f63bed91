"""Decoding in bulk equals the live decoder: frame for frame and damage for damage, on any bytes cut anywhere."""

from __future__ import annotations

import random
from collections.abc import Iterable

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from epf_gcs.codec.encode import frame_bytes
from epf_gcs.codec.frame import FROM_BOARD, TO_BOARD, Damage, Direction, Frame, FrameDecoder
from epf_gcs.codec.messages_gen import END, TELEMETRY
from epf_gcs.flights.bulk import BulkDecoder, StretchContents
from tests.codec.streams import BOTH, damage, mixed_frames

Heard = tuple[dict[str, list[tuple[int, bytes]]], list[Damage]]
HEADER = FROM_BOARD.header
AHRS = TELEMETRY[1]


def live(records: list[bytes], way: Direction) -> Heard:
    """What the live decoder finds, with the number of the record in which each frame was found."""
    decoder = FrameDecoder(way)
    frames: dict[str, list[tuple[int, bytes]]] = {}
    damages: list[Damage] = []
    last = len(records) - 1
    for index, record in enumerate([*records, None]):
        for event in decoder.finish() if record is None else decoder.feed(record):
            if isinstance(event, Frame):
                frames.setdefault(event.message.name, []).append((min(index, last), event.payload))
            else:
                damages.append(event)
    return frames, damages


def bulk(records: list[bytes], way: Direction, sizes: Iterable[int]) -> Heard:
    """What the bulk decoder finds when it gets so many records at a time."""
    decoder = BulkDecoder(way)
    found: list[StretchContents] = []
    at = 0
    for size in sizes:
        some = records[at : at + size]
        ends = np.cumsum([len(record) for record in some], dtype=np.int64)
        t_ns = np.arange(at, at + len(some), dtype=np.int64)
        found.append(decoder.feed(np.frombuffer(b"".join(some), dtype=np.uint8), ends, t_ns))
        at += size
        if at >= len(records):
            break
    found.append(decoder.finish())
    frames: dict[str, list[tuple[int, bytes]]] = {}
    for stretch in found:
        for message, (times, payload) in stretch.frames.items():
            data = payload.tobytes()
            cut = [data[index * message.size : (index + 1) * message.size] for index in range(len(times))]
            frames.setdefault(message.name, []).extend(zip(times.tolist(), cut, strict=True))
    return frames, [one.damage for stretch in found for one in stretch.damage]


def cut(data: bytes, rng: random.Random, longest: int) -> list[bytes]:
    records = []
    at = 0
    while at < len(data):
        size = rng.randrange(1, longest + 1)
        records.append(data[at : at + size])
        at += size
    return records


def check(data: bytes, way: Direction = FROM_BOARD, seed: int = 1) -> None:
    """Cut the bytes into records, and the records into stretches, of other lengths each time."""
    rng = random.Random(seed)
    for longest, most in ((rng.choice((1, 7)), 300), (60, 9), (4000, 1)):
        records = cut(data, rng, longest)
        sizes = (rng.randrange(1, most + 1) for _ in range(len(records) + 1))
        assert bulk(records, way, sizes) == live(records, way)


@pytest.mark.parametrize("name", BOTH)
def test_an_undamaged_stream_gives_every_frame(name: str) -> None:
    frames = mixed_frames(300, seed=3, way=BOTH[name])
    check(b"".join(frames), BOTH[name])
    found, damages = bulk([b"".join(frames)], BOTH[name], [1])
    assert sum(map(len, found.values())) == 300
    assert damages == []


@pytest.mark.parametrize("share", [0.0003, 0.003, 0.03, 0.3])
@pytest.mark.parametrize("name", BOTH)
def test_a_damaged_stream_gives_what_the_live_decoder_finds(name: str, share: float) -> None:
    for seed in range(4):
        check(damage(mixed_frames(60, seed, BOTH[name]), share, seed).data, BOTH[name], seed)


PIECES = [
    HEADER,
    HEADER[:2],
    END,
    b"text of the shell\r\n",
    b"#QT\n",
    HEADER + (0x80000001).to_bytes(4, "little"),  # a header that waits for a frame that does not come
    HEADER + (0x80000003).to_bytes(4, "little"),
    HEADER + (0x80000063).to_bytes(4, "little"),
    HEADER + (0x00000001).to_bytes(4, "little"),
    frame_bytes(FROM_BOARD, AHRS, bytes(12)),
    # A whole frame inside another's payload: only the outer one is accepted, unless it is damaged.
    frame_bytes(FROM_BOARD, TELEMETRY[11], frame_bytes(FROM_BOARD, AHRS, bytes(12)) + bytes(40)),
    frame_bytes(FROM_BOARD, TELEMETRY[11], frame_bytes(FROM_BOARD, AHRS, bytes(12)) + bytes(40))[:-3] + b"x",
    frame_bytes(FROM_BOARD, TELEMETRY[0], bytes(12)),
    b"".join(mixed_frames(12, seed=5)),
]


@settings(max_examples=200, deadline=None)
@given(st.lists(st.sampled_from(PIECES) | st.binary(max_size=200), max_size=30), st.integers(0, 1 << 30))
def test_any_bytes_give_what_the_live_decoder_finds(pieces: list[bytes], seed: int) -> None:
    check(b"".join(pieces), seed=seed)


def test_nested_and_overlapping_frames_are_resolved_from_the_left() -> None:
    """Frames that begin inside one another: each is good by itself, but only one of two can be accepted."""
    inner = frame_bytes(FROM_BOARD, AHRS, bytes(12))
    outer = frame_bytes(FROM_BOARD, TELEMETRY[4], inner + bytes(48 - len(inner)))
    check(outer + inner + outer[:-1] + outer + inner + HEADER + outer)


def test_memory_stays_bounded_on_noise() -> None:
    decoder = BulkDecoder()
    rng = random.Random(2)
    noise = np.frombuffer(rng.randbytes(10_000), dtype=np.uint8)
    for _ in range(20):
        decoder.feed(noise, np.array([10_000]), np.array([1]))
        assert len(decoder._left) < 200


@pytest.mark.parametrize("way", [FROM_BOARD, TO_BOARD], ids=["from board", "to board"])
def test_nothing_gives_nothing(way: Direction) -> None:
    assert bulk([b""], way, [1]) == ({}, [])
