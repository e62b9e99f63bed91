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
from bench.station import HEARTBEAT, Line, WebSocket, run_s, station
from bench.table import Row
from tests.codec.streams import mixed_frames

LINE_BYTES_PER_S: Final = 11520
# A USB adapter in low latency mode delivers once a millisecond what arrived.
CHUNK_S: Final = 0.001
ROUNDS: Final = 5
MEASURED_S: Final = 2.0
WARM_UP_S: Final = 0.5
_HEARTBEAT_S: Final = 0.3
REACH_PERCENT: Final = 5.0


def run() -> list[Row]:
    """Both get the same paced bytes, in turns, so that both meet the same load of the machine."""
    stream = stream_of_line()
    ours, peer = 0.0, 0.0
    with station() as (gateway, line), _peer_process() as (peer_line, process):
        assert process.stdout is not None
        viewer = gateway.stream(60)
        peer_viewer = foxglove_peer.subscribe(int(process.stdout.readline()))
        with reading(viewer, viewer.acknowledge), reading(peer_viewer, lambda _: None):
            for _ in range(ROUNDS):
                ours += percent_used([gateway.process.pid, *gateway.parts.values()], line, stream) / ROUNDS
                peer += percent_used([process.pid], peer_line, stream, line) / ROUNDS
        viewer.close()
        peer_viewer.close()
    what = "gateway's processor time at the full 115200 line, both processes, one viewer at 60 Hz"
    reach = f"<= {REACH_PERCENT:g} % of a core, or <= peer"
    return [Row(what, ours, "%", reach, ours <= max(REACH_PERCENT, peer), peer, foxglove_peer.NAME)]


def stream_of_line() -> bytes:
    """Half a second of the line: all streams, with heartbeats, so that the session stays open."""
    frames: list[bytes] = []
    size = 0
    for index, frame in enumerate(mixed_frames(1000, seed=3)):
        frames += [frame, HEARTBEAT] if index % 10 == 0 else [frame]
        size += sum(map(len, frames[-2:] if index % 10 == 0 else frames[-1:]))
        if size >= LINE_BYTES_PER_S / 2:
            break
    return b"".join(frames)


def percent_used(pids: Sequence[int], line: Line, stream: bytes, waiting: Line | None = None) -> float:
    """Feed the line as a serial port would, on an absolute schedule; returns percent of one core.

    `waiting` gets heartbeats meanwhile, so that its session stays open.
    """
    sent = 0
    begun_s = time.monotonic()
    before_s, measured_from_s, beat_s = 0.0, 0.0, 0.0
    while (passed_s := time.monotonic() - begun_s) < WARM_UP_S + MEASURED_S:
        if not measured_from_s and passed_s >= WARM_UP_S:
            before_s, measured_from_s = run_s(*pids), time.monotonic()
        due = int(passed_s * LINE_BYTES_PER_S)
        if due > sent:
            line.write(_cut(stream, sent, due))
            sent = due
        line.read(0.0)
        if waiting is not None and passed_s - beat_s >= _HEARTBEAT_S:
            beat_s = passed_s
            waiting.write(HEARTBEAT)
            waiting.read(0.0)
        time.sleep(CHUNK_S)
    used = 100.0 * (run_s(*pids) - before_s) / (time.monotonic() - measured_from_s)
    # Complete the last frame, so that the next turn does not begin with a damaged one.
    line.write(_cut(stream, sent, sent + -sent % len(stream)))
    return used


def _cut(stream: bytes, start: int, stop: int) -> bytes:
    """Bytes start..stop of the endlessly repeated stream."""
    place = start % len(stream)
    repeated = stream[place:] + stream * (1 + (stop - start) // len(stream))
    return repeated[: stop - start]


@contextlib.contextmanager
def reading(viewer: WebSocket, shown: Callable[[bytes], None]) -> Iterator[None]:
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
