"""CPU time of the gateway at a full 115200 baud line with one viewer, and how often its processes are woken.

The peer gets the same bytes. On a line that is nearly full bytes cannot be read late: it has rows of its own.
"""

from __future__ import annotations

import contextlib
import subprocess
import sys
import tempfile
import threading
import time
from collections.abc import Callable, Iterator, Mapping
from pathlib import Path
from typing import Final, NamedTuple

from bench import foxglove_peer
from bench.station import HEARTBEAT, Line, WebSocket, run_s, station, wakes
from bench.table import Row
from epf_gcs.codec.frame import Frame, FrameDecoder
from tests.codec.streams import mixed_frames

LINE_BYTES_PER_S: Final = 11520
# A USB adapter in low latency mode delivers once a millisecond what arrived.
CHUNK_S: Final = 0.001
ROUNDS: Final = 5
MEASURED_S: Final = 2.0
WARM_UP_S: Final = 0.5
_HEARTBEAT_S: Final = 0.3
# A board's fastest stream is sent 50 times a second, and what it sends then comes without a pause.
_PERIOD_S: Final = 0.02
REACH_PERCENT: Final = 5.0
FULL: Final = 1.0
NEARLY_FULL: Final = 0.8


class Used(NamedTuple):
    """What one process took: percent of a core, and how often a second a thread of it began to run after waiting."""

    percent: float
    wakes: float


def run() -> list[Row]:
    """Both get the same paced bytes, in turns, so that both meet the same load of the machine."""
    with station() as (gateway, line), _peer_process() as (peer_line, process):
        assert process.stdout is not None
        viewer = gateway.stream(60)
        peer_viewer = foxglove_peer.subscribe(int(process.stdout.readline()))
        ours = {"launcher": gateway.process.pid, **gateway.parts}
        peer = {foxglove_peer.NAME: process.pid}
        rows: list[Row] = []
        with reading(viewer, viewer.acknowledge), reading(peer_viewer, lambda _: None):
            for share in (FULL, NEARLY_FULL):
                rounds = [
                    (measure(ours, line, share=share), measure(peer, peer_line, line, share)) for _ in range(ROUNDS)
                ]
                rows += _rows(share, _means([one for one, _ in rounds]), _means([other for _, other in rounds]))
        viewer.close()
        peer_viewer.close()
    return rows


def _rows(share: float, parts: Mapping[str, Used], peers: Mapping[str, Used]) -> list[Row]:
    peer = peers[foxglove_peer.NAME]
    whole = sum(part.percent for part in parts.values())
    if share == FULL:
        what = "gateway's processor time at the full 115200 line, both processes, one viewer at 60 Hz"
        reach, ok = f"<= {REACH_PERCENT:g} % of a core, or <= peer", whole <= max(REACH_PERCENT, peer.percent)
    else:
        what, reach, ok = f"the same with {100 * share:g} % of the line in use", "", None
    rows = [Row(what, whole, "%", reach, ok, peer.percent, foxglove_peer.NAME)]
    for name, part in parts.items():
        rows.append(Row(f"of it the {name} process", part.percent, "%"))
        rows.append(
            Row(f"wakes a second of it in the {name} process", part.wakes, "", "", None, peer.wakes, foxglove_peer.NAME)
        )
    return rows


def _means(rounds: list[dict[str, Used]]) -> dict[str, Used]:
    return {
        name: Used(*(sum(one[name][column] for one in rounds) / len(rounds) for column in range(len(Used._fields))))
        for name in rounds[0]
    }


def _stream() -> bytes:
    """Half a second of the line: all streams, with heartbeats, so that the session stays open.

    The gains are the same each time: a board sends what it has, not others twenty times a second.
    """
    frames: list[bytes] = []
    gains: dict[str, bytes] = {}
    size = 0
    for index, made in enumerate(mixed_frames(1000, seed=3)):
        frame = gains.setdefault("all", made) if _name(made) == "autopilot_parameters" else made
        frames += [frame, HEARTBEAT] if index % 10 == 0 else [frame]
        size += sum(map(len, frames[-2:] if index % 10 == 0 else frames[-1:]))
        if size >= LINE_BYTES_PER_S / 2:
            break
    return b"".join(frames)


def _name(data: bytes) -> str:
    (frame,) = FrameDecoder().feed(data)
    assert isinstance(frame, Frame)
    return frame.message.name


def measure(
    processes: Mapping[str, int], line: Line, waiting: Line | None = None, share: float = FULL
) -> dict[str, Used]:
    """Feed the line as a serial port would, on an absolute schedule; returns what each process took.

    `waiting` gets heartbeats meanwhile, so that its session stays open. `share` of the line is in use: the rest is a
    pause in each period.
    """
    stream = _stream()
    sent = 0
    begun_s = time.monotonic()
    before: dict[str, tuple[float, int]] = {}
    measured_from_s, beat_s = 0.0, 0.0
    while (passed_s := time.monotonic() - begun_s) < WARM_UP_S + MEASURED_S:
        if not measured_from_s and passed_s >= WARM_UP_S:
            before, measured_from_s = (
                {name: (run_s(pid), wakes(pid)) for name, pid in processes.items()},
                time.monotonic(),
            )
        due = _due(passed_s, share)
        if due > sent:
            line.write(_cut(stream, sent, due))
            sent = due
        line.read(0.0)
        if waiting is not None and passed_s - beat_s >= _HEARTBEAT_S:
            beat_s = passed_s
            waiting.write(HEARTBEAT)
            waiting.read(0.0)
        time.sleep(CHUNK_S)
    lasted_s = time.monotonic() - measured_from_s
    used = {
        name: Used(100.0 * (run_s(pid) - before[name][0]) / lasted_s, (wakes(pid) - before[name][1]) / lasted_s)
        for name, pid in processes.items()
    }
    # Complete the last frame, so that the next turn does not begin with a damaged one.
    line.write(_cut(stream, sent, sent + -sent % len(stream)))
    return used


def _due(passed_s: float, share: float) -> int:
    """Bytes that a board has sent by now, at the line's rate for the first part of each period."""
    periods, within_s = divmod(passed_s, _PERIOD_S)
    return int((periods * share * _PERIOD_S + min(within_s, share * _PERIOD_S)) * LINE_BYTES_PER_S)


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
