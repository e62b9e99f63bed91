"""A long stream with flipped bytes: no intact frame is lost, at any chunk size, here and in the board's C."""

from __future__ import annotations

import subprocess
from functools import cache
from pathlib import Path

import pytest

from epf_gcs.codec.frame import FROM_BOARD, Damage, Direction, Frame, FrameDecoder
from tests.codec.streams import BOTH, DamagedStream, damage, mixed_frames, placed
from tests.codec.vectors import CHUNKS, decode, direction, failures, frames, load
from tests.support.firmware import FIRMWARE, make
from tests.support.waiting import DEADLINE_S

pytestmark = pytest.mark.uncounted

FRAMES = 25_000
SHARE = 0.001


@cache
def _stream(name: str) -> DamagedStream:
    return damage(mixed_frames(FRAMES, seed=1, way=BOTH[name]), SHARE, seed=2)


@cache
def _reference(name: str) -> list[Frame | Damage]:
    return decode(_stream(name).data, 1 << 30, BOTH[name])


@pytest.mark.parametrize("name", BOTH)
def test_no_intact_frame_is_lost_and_none_is_wrong(name: str) -> None:
    stream = _stream(name)
    found = placed(_reference(name), BOTH[name])
    assert len(stream.intact) > FRAMES * 0.9
    assert stream.intact.items() <= found.items()
    wrong = {place: frame for place, frame in found.items() if stream.intact.get(place) != frame}
    # A frame that is hit and still accepted must be one that the checksum cannot tell: two or more hits that
    # cancel out in the sum. One hit never does.
    for place, frame in wrong.items():
        hits = sum(a != b for a, b in zip(frame, stream.sent.get(place, b""), strict=False))
        assert hits >= 2, (place, frame.hex())
    assert len(wrong) <= 2


@pytest.mark.parametrize("chunk", CHUNKS)
def test_every_chunking_gives_the_same_events(chunk: int) -> None:
    assert decode(_stream("board-to-pc").data, chunk) == _reference("board-to-pc")


def test_each_damaged_frame_is_counted() -> None:
    stream = _stream("board-to-pc")
    hit = FRAMES - len(stream.intact)
    counted = failures(_reference("board-to-pc"))
    # A hit header leaves noise and no candidate; there is no other way for a damaged frame to go uncounted.
    headers = sum(
        stream.data[place : place + 4] != FROM_BOARD.header for place in stream.sent if place not in stream.intact
    )
    assert counted.total() >= hit - headers
    assert set(counted) == {"bad_checksum", "bad_end", "bad_type_bits", "unknown_type"}


@pytest.fixture(scope="session")
def decode_stream() -> Path:
    """The firmware's decoder as a program."""
    make("decode-stream")
    return FIRMWARE / "build" / "tests" / "decode-stream"


def _decode_in_c(program: Path, data: bytes, chunk: int, name: str) -> tuple[list[tuple[int, str]], int]:
    made = subprocess.run(
        [str(program), str(chunk), name], input=data, capture_output=True, check=True, timeout=DEADLINE_S
    ).stdout.decode("ascii")
    *lines, last = made.splitlines()
    found = [(int(line.split(" ")[0]), line.split(" ")[1]) for line in lines]
    return found, int(last.removeprefix("damaged "))


def _decode_here(data: bytes, way: Direction) -> tuple[list[tuple[int, str]], int]:
    """Without the end of the stream, which the program does not know either."""
    events = FrameDecoder(way).feed(data)
    return frames(events), failures(events).total()


@pytest.mark.parametrize("name", BOTH)
@pytest.mark.parametrize("chunk", CHUNKS)
def test_the_boards_decoder_finds_the_same(decode_stream: Path, name: str, chunk: int) -> None:
    data = _stream(name).data
    assert _decode_in_c(decode_stream, data, chunk, name) == _decode_here(data, BOTH[name])


@pytest.mark.parametrize("vector", load("stream.jsonl"), ids=lambda vector: vector["case"])
def test_the_boards_decoder_agrees_on_the_vectors(decode_stream: Path, vector: dict[str, object]) -> None:
    parts = vector["parts"]
    assert isinstance(parts, list)
    data = bytes.fromhex("".join(part["hex"] for part in parts))
    way = direction(str(vector["direction"]))
    name = next(name for name, other in BOTH.items() if other is way)
    assert _decode_in_c(decode_stream, data, 3, name) == _decode_here(data, way)
