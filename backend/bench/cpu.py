"""CPU time of the gateway at a full 115200 baud line with one viewer, compared to the peer on the same bytes."""

from __future__ import annotations

import contextlib
import subprocess
import sys
import tempfile
import threading
import time
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import Final

from bench import foxglove_peer
from bench.station import HEARTBEAT, Line, WebSocket, cpu_s, station
from bench.table import Row
from tests.codec.streams import mixed_frames

LINE_BYTES_PER_S: Final = 11520
# A USB adapter in low latency mode delivers once a millisecond what arrived.
CHUNK_S: Final = 0.001
MEASURED_S: Final = 10.0
WARM_UP_S: Final = 2.0
REACH_PERCENT: Final = 5.0


def run() -> list[Row]:
    """Both get the same paced bytes, one after the other."""
    stream = _stream()
    with station() as (gateway, line):
        viewer = gateway.stream(60)
        with _reading(viewer, viewer.acknowledge):
            ours = _percent([gateway.process.pid, *gateway.parts.values()], line, stream)
        viewer.close()
    with _peer_process() as (line, process):
        assert process.stdout is not None
        viewer = foxglove_peer.subscribe(int(process.stdout.readline()))
        with _reading(viewer, lambda _: None):
            peer = _percent([process.pid], line, stream)
        viewer.close()
    what = "gateway's processor time at the full 115200 line, both processes, one viewer at 60 Hz"
    reach = f"<= {REACH_PERCENT:g} % of a core"
    return [Row(what, ours, "%", reach, ours <= REACH_PERCENT, peer, foxglove_peer.NAME)]


def _stream() -> bytes:
    """Half a second of the line: all streams, with heartbeats, so that the session stays open."""
    frames: list[bytes] = []
    size = 0
    for index, frame in enumerate(mixed_frames(1000, seed=3)):
        frames += [frame, HEARTBEAT] if index % 10 == 0 else [frame]
        size += sum(map(len, frames[-2:] if index % 10 == 0 else frames[-1:]))
        if size >= LINE_BYTES_PER_S / 2:
            break
    return b"".join(frames)


def _percent(pids: Sequence[int], line: Line, stream: bytes) -> float:
    """Feed the line as a serial port would, on an absolute schedule; returns percent of one core."""
    sent = 0
    begun_s = time.monotonic()
    before_s, measured_from_s = 0.0, 0.0
    while (passed_s := time.monotonic() - begun_s) < WARM_UP_S + MEASURED_S:
        if not measured_from_s and passed_s >= WARM_UP_S:
            before_s, measured_from_s = cpu_s(*pids), time.monotonic()
        due = int(passed_s * LINE_BYTES_PER_S)
        if due > sent:
            line.write(_cut(stream, sent, due))
            sent = due
        line.read(0.0)
        time.sleep(CHUNK_S)
    return 100.0 * (cpu_s(*pids) - before_s) / (time.monotonic() - measured_from_s)


def _cut(stream: bytes, start: int, stop: int) -> bytes:
    """Bytes start..stop of the endlessly repeated stream."""
    place = start % len(stream)
    repeated = stream[place:] + stream * (1 + (stop - start) // len(stream))
    return repeated[: stop - start]


@contextlib.contextmanager
def _reading(viewer: WebSocket, shown: Callable[[bytes], None]) -> Iterator[None]:
    """A viewer that reads every message."""

    def read() -> None:
        with contextlib.suppress(OSError):
            while True:
                shown(viewer.receive())

    thread = threading.Thread(target=read, daemon=True)
    thread.start()
    yield


@contextlib.contextmanager
def _peer_process() -> Iterator[tuple[Line, subprocess.Popen[bytes]]]:
    with tempfile.TemporaryDirectory() as folder:
        line = Line(Path(folder))
        process = subprocess.Popen(
            [sys.executable, "-m", "bench.foxglove_peer", line.path], stdout=subprocess.PIPE, bufsize=0
        )
        try:
            yield line, process
        finally:
            process.terminate()
            process.wait()
            if process.stdout is not None:
                process.stdout.close()
            line.close()
