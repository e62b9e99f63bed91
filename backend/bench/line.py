"""Reading and decoding a full 115200 baud line: CPU time and latency, woken for each piece or for each frame.

A pseudo-terminal is fed in pieces of a millisecond, as a USB adapter delivers them. A separate process reads it through
the gateway's link and decoder, with and without waiting for the number of missing bytes; nothing else runs in it.
The two modes alternate, so that both meet the same load. Latency is from the write of a frame's last byte.
"""

from __future__ import annotations

import asyncio
import json
import os
import random
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Final

import uvloop

from bench.station import HEARTBEAT, Line, percentile
from bench.table import Row
from epf_gcs.codec.encode import encode_telemetry
from epf_gcs.codec.frame import Frame, FrameDecoder
from epf_gcs.errors import LinkError
from epf_gcs.link.address import parse_address
from epf_gcs.link.base import LinkCallbacks
from epf_gcs.link.open import open_link
from tests.codec.streams import mixed_frames

LINE_BYTES_PER_S: Final = 11520
CHUNK_S: Final = 0.001
ROUNDS: Final = 4
ROUND_S: Final = 3.0
ADDED_MS: Final = 0.02
_MARK: Final = encode_telemetry("hil_surfaces", 0.25, -0.5, 0.125, 0.75)
_EVERY: Final = "woken for every piece"


def run() -> list[Row]:
    """Pieces of a millisecond, and frames that are written whole, as the board of this computer writes them."""
    rows: list[Row] = []
    for what, feed in (("1 ms pieces", _in_pieces), ("whole frames", _in_frames)):
        times: dict[str, list[float]] = {"every": [], "whole": []}
        percents: dict[str, list[float]] = {"every": [], "whole": []}
        wakes: dict[str, list[float]] = {"every": [], "whole": []}
        for _ in range(ROUNDS):
            for mode in times:
                percent, woken, latencies = _measure(mode, feed)
                percents[mode].append(percent)
                wakes[mode].append(woken)
                times[mode] += latencies
        name = f"line, {what}:"
        ours, theirs = _mean(percents["whole"]), _mean(percents["every"])
        rows.append(Row(f"{name} processor time", ours, "%", "<= every piece", ours <= theirs, theirs, _EVERY))
        ours, theirs = _mean(wakes["whole"]), _mean(wakes["every"])
        rows.append(Row(f"{name} reads a second", ours, "", "<= every piece", ours <= theirs, theirs, _EVERY))
        for label, share in (("p50", 0.5), ("p99", 0.99)):
            ours, theirs = percentile(times["whole"], share), percentile(times["every"], share)
            what_time = f"{name} HIL frame's last byte to decoded, {label}"
            ok = ours <= theirs + ADDED_MS
            rows.append(Row(what_time, ours, "ms", f"<= {ADDED_MS} ms over it", ok, theirs, _EVERY))
    return rows


def _ran_s(pid: int) -> float:
    """CPU time in s of the process's only thread; the clock ticks of `cpu_s` are too coarse for one percent."""
    return int(Path(f"/proc/{pid}/schedstat").read_text().split()[0]) * 1e-9


def _mean(values: Sequence[float]) -> float:
    return sum(values) / len(values)


def _frames() -> list[bytes]:
    """Half a second of the line, mixed, with the frame that the HIL loop waits for among them."""
    mixed = mixed_frames(1000, seed=3)
    random.Random(5).shuffle(mixed)
    frames: list[bytes] = []
    for index, frame in enumerate(mixed):
        frames.append(frame)
        if index % 6 == 0:
            frames.append(_MARK)
        if index % 30 == 0:
            frames.append(HEARTBEAT)
        if sum(map(len, frames)) >= LINE_BYTES_PER_S / 2:
            break
    return frames


_Feed = Callable[[Line, float], list[int]]


def _in_pieces(line: Line, for_s: float) -> list[int]:
    """Write pieces on an absolute schedule; returns the steady time in ns of each marked frame's last byte."""
    frames = _frames()
    ends: list[int] = []
    stream = b""
    while len(stream) < (for_s + 1.0) * LINE_BYTES_PER_S:
        for frame in frames:
            stream += frame
            if frame is _MARK:
                ends.append(len(stream))
    written_ns: list[int] = []
    sent = 0
    begun_s = time.monotonic()
    while (passed_s := time.monotonic() - begun_s) < for_s:
        due = int(passed_s * LINE_BYTES_PER_S)
        if due > sent:
            now_ns = time.monotonic_ns()
            line.write(stream[sent:due])
            sent = due
            while ends[len(written_ns)] <= sent:
                written_ns.append(now_ns)
        time.sleep(CHUNK_S)
    return written_ns


def _in_frames(line: Line, for_s: float) -> list[int]:
    """The same, but a frame is written as a whole when its last byte is due."""
    written_ns: list[int] = []
    due_s = begun_s = time.monotonic()
    while due_s - begun_s < for_s:
        for frame in _frames():
            due_s += len(frame) / LINE_BYTES_PER_S
            time.sleep(max(0.0, due_s - time.monotonic()))
            if frame is _MARK:
                written_ns.append(time.monotonic_ns())
            line.write(frame)
    return written_ns


def _measure(mode: str, feed: _Feed) -> tuple[float, float, list[float]]:
    """Percent of a core, reads a second, and each marked frame's latency in ms."""
    with tempfile.TemporaryDirectory() as folder:
        line = Line(Path(folder))
        process = subprocess.Popen(
            [sys.executable, "-m", "bench.line", line.path, mode], stdin=subprocess.PIPE, stdout=subprocess.PIPE
        )
        assert process.stdin is not None
        assert process.stdout is not None
        process.stdout.readline()
        before_s, begun_s = _ran_s(process.pid), time.monotonic()
        written_ns = feed(line, ROUND_S)
        time.sleep(0.1)
        percent = 100.0 * (_ran_s(process.pid) - before_s) / (time.monotonic() - begun_s)
        output, _ = process.communicate(b"\n")
        line.close()
    heard = json.loads(output)
    pairs = zip(written_ns, heard["decoded_ns"], strict=True)
    return percent, heard["reads"] / ROUND_S, [(decoded - written) * 1e-6 for written, decoded in pairs]


async def _read(path: str, mode: str) -> None:
    """The process that is measured."""
    decoder = FrameDecoder()
    decoded_ns: list[int] = []
    reads = 0

    def take(data: bytes) -> None:
        nonlocal reads
        reads += 1
        found = decoder.feed(data)
        marked = sum(isinstance(one, Frame) and one.payload == _MARK[8:-8] for one in found)
        decoded_ns.extend([time.monotonic_ns()] * marked)

    def lost(error: LinkError) -> None:
        raise error

    link = await open_link(parse_address(f"pty://{path}"))
    if mode == "whole":
        link.start(LinkCallbacks(take, lost, missing_bytes=decoder.missing_with))
    else:
        link.start(LinkCallbacks(take, lost))
    os.write(1, b"ready\n")
    loop = asyncio.get_running_loop()
    asked = asyncio.Event()
    loop.add_reader(0, asked.set)
    await asked.wait()
    loop.remove_reader(0)
    link.close()
    os.write(1, json.dumps({"reads": reads, "decoded_ns": decoded_ns}).encode())


if __name__ == "__main__":
    uvloop.run(_read(sys.argv[1], sys.argv[2]))
