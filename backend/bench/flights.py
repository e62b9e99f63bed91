"""Recordings after the flight: frames decoded in bulk each second, and the time to index two hours of full line.

The peers are pymavlink's reader of its own log files, as its program mavlogdump uses it, and our live decoder.
"""

from __future__ import annotations

import tempfile
import time
from pathlib import Path
from struct import Struct
from typing import Any

import numpy as np
from pymavlink import mavutil

from bench import mavlink
from bench.demonstration import make_demonstration
from bench.table import Row
from epf_gcs.codec.frame import TO_BOARD, Frame, FrameDecoder
from epf_gcs.codec.values import meaning
from epf_gcs.flights.bulk import BulkDecoder
from epf_gcs.flights.columns import write_columns
from epf_gcs.flights.convert import table
from epf_gcs.recordings.mcap_file import Tally, closing, data_end, message_record, opening
from epf_gcs.recordings.reading import read_file
from epf_gcs.recordings.topics import BOARD_RECEIVED, BOARD_SENT, SIMULATOR_RECEIVED, TOPICS
from epf_gcs.xplane.datagram import Record, build
from tests.codec.streams import mixed_frames

FRAMES = 50_000  # of each peer
BULK_FRAMES = 1_000_000
RECORD_BYTES = 115  # 10 ms of a full line at 115200 baud
RATE = 3e6
HOURS = 2
LINE_BYTES_S = 11_520
INDEX_S = 8.0
START_NS = 1_769_860_800_000_000_000
ROUNDS = 3
_STAMP = Struct(">Q")  # before each frame in the peer's log files: microseconds
_ROWS = (3, 4, 8, 16, 17, 18, 20, 25)


def run() -> list[Row]:
    """Processor time of this process, one core; the best of some rounds."""
    with tempfile.TemporaryDirectory() as folder:
        peer = _peer(Path(folder))
        live = _live()
        rows = [
            _bulk("bulk decode into columns with ranges", True, live, "our live decoder"),
            _bulk("bulk decode, frames and times alone", False, peer, "mavlogdump's reader"),
        ]
        return rows + _index(Path(folder)) + _index_demonstration(Path(folder))


def _bulk(what: str, with_values: bool, peer: float, name: str) -> Row:  # noqa: FBT001
    stream = np.frombuffer(b"".join(mixed_frames(1000, seed=1)) * (BULK_FRAMES // 1000), dtype=np.uint8)
    ends = np.append(np.arange(RECORD_BYTES, len(stream), RECORD_BYTES), len(stream))
    t_ns = START_NS + np.arange(len(ends)) * 10_000_000
    best = 0.0
    for _ in range(ROUNDS):
        begun = time.process_time()
        count = 0
        decoder = BulkDecoder()
        # In stretches of the size that a recording is read in.
        step = (4 << 20) // RECORD_BYTES
        for first in range(0, len(ends), step):
            some = ends[first : first + step]
            start = int(ends[first - 1]) if first else 0
            decoded = decoder.feed(stream[start : int(some[-1])], some - start, t_ns[first : first + step])
            for message, frames in decoded.frames.items():
                count += len(frames.t_ns)
                if with_values:
                    table(message, frames)
        spent = time.process_time() - begun
        assert count == BULK_FRAMES
        best = max(best, count / spent)
    return Row(f"{what}, {BULK_FRAMES} mixed frames", best, "frames/s", f">= {RATE:g}", best >= RATE, peer, name)


def _live() -> float:
    stream = b"".join(mixed_frames(FRAMES, seed=1))
    begun = time.process_time()
    decoder, count = FrameDecoder(), 0
    for at in range(0, len(stream), 4096):
        for event in decoder.feed(stream[at : at + 4096]):
            if isinstance(event, Frame):
                meaning(event)
                count += 1
    assert count == FRAMES
    return count / (time.process_time() - begun)


def _peer(folder: Path) -> float:
    path = folder / "peer.tlog"
    frames = mavlink.mixed_frames(FRAMES, seed=1)
    path.write_bytes(b"".join(_STAMP.pack(START_NS // 1000 + index * 500) + one for index, one in enumerate(frames)))
    begun = time.process_time()
    log: Any = mavutil.mavlink_connection(str(path))
    count = 0
    while log.recv_match() is not None:
        count += 1
    spent = time.process_time() - begun
    log.close()
    assert count >= FRAMES - 1
    return count / spent


def _index(folder: Path) -> list[Row]:
    path = folder / "recordings" / "20260131T120000Z.mcap"
    path.parent.mkdir()
    frames = _two_hours(path)
    megabytes = path.stat().st_size / 1e6
    begun = time.process_time()
    recording = read_file(path)
    reading_s = time.process_time() - begun
    count = len(recording.messages.channel)
    del recording
    begun = time.process_time()
    written = write_columns(path, folder / "columns", lambda _progress, _doing: None)
    index_s = time.process_time() - begun
    assert written.counts.frames_heard == frames
    size = sum(one.stat().st_size for one in written.folder.iterdir()) / 1e6
    return [
        Row(f"read {count} records of {megabytes:.0f} MB whole", count / reading_s, "records/s"),
        Row(f"index {HOURS} h, {frames} frames", index_s, "s", f"<= {INDEX_S:g} s", index_s <= INDEX_S),
        Row(f"columns of {HOURS} h", size, "MB"),
    ]


def _index_demonstration(folder: Path) -> list[Row]:
    path = make_demonstration(folder / "demonstration" / "20260101T120000Z.mcap", HOURS * 3600.0)
    begun = time.process_time()
    written = write_columns(path, folder / "columns", lambda _progress, _doing: None)
    index_s = time.process_time() - begun
    frames = written.counts.frames_heard
    what = f"index {HOURS} h of the demonstration, {frames} frames"
    return [Row(what, index_s, "s", f"<= {INDEX_S:g} s", index_s <= INDEX_S)]


def _two_hours(path: Path) -> int:
    """A full line, a simulator at 20 Hz and the commands that answer it; returns the number of the board's frames."""
    block = mixed_frames(1000, seed=1)
    stream = b"".join(block)
    repeats = HOURS * 3600 * LINE_BYTES_S // len(stream)
    stream *= repeats
    told = [one for one in mixed_frames(500, seed=2, way=TO_BOARD) if len(one) == 76]
    datagrams = [_datagram(index) for index in range(200)]
    tally = Tally()
    with path.open("wb") as file:
        file.write(opening("bench", TOPICS))
        for index, at in enumerate(range(0, len(stream), RECORD_BYTES)):
            t_ns = START_NS + index * 10_000_000
            some = [(BOARD_RECEIVED, stream[at : at + RECORD_BYTES])]
            if index % 5 == 0:
                some += [(SIMULATOR_RECEIVED, datagrams[index % 200]), (BOARD_SENT, told[index % len(told)])]
            for channel, data in some:
                file.write(message_record(channel, tally.add(channel, t_ns), t_ns, data))
        end = data_end()
        file.write(end + closing(TOPICS, tally, file.tell() + len(end)))
    return len(block) * repeats


def _datagram(index: int) -> bytes:
    values = (0.5, 0.4, 0.3 + index / 1000, 0.2, 0.1, 600.0, 1.0, 1.0)
    return build([Record(row, values) for row in _ROWS], 0x40)
