"""Delay from board bytes on a pseudo-terminal to the message at a client, compared to a bare read and foxglove-sdk."""

from __future__ import annotations

import contextlib
import os
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Final

from bench import foxglove_peer
from bench.awake import awake
from bench.station import HEARTBEAT, Gateway, Line, WebSocket, percentile, station
from bench.table import Row
from epf_gcs.codec.encode import encode_telemetry

ROUNDS: Final = 8
SAMPLES: Final = 250
PERIOD_S: Final = 0.004
ADDED_MS: Final = 0.2

_FRAME: Final = encode_telemetry("ahrs", 123.0, 4.5, -6.75)


def run() -> list[Row]:
    """All three as the machine is, and with its cores kept awake: between the two is what waking them costs."""
    rows = _rows("", *_measure())
    with awake():
        return rows + _rows(", cores kept awake", *_measure())


def _measure() -> tuple[list[float], list[float], list[float]]:
    """Delays in ms of ours, the peer and a bare read, taken in turns, so that all meet the same load of the machine."""
    ours: list[float] = []
    peer: list[float] = []
    bare: list[float] = []
    with station() as (gateway, line), _peer() as (peer_line, peer_client), _bare() as (bare_line, answers):
        viewer = gateway.stream(0)
        for _ in range(ROUNDS):
            ours += measure(line, lambda: until_ahrs(viewer))
            keep_open(line, gateway)
            peer += measure(peer_line, lambda: _until_binary(peer_client))
            keep_open(line, gateway)
            bare += _measure_bare(bare_line, answers)
            keep_open(line, gateway)
        viewer.close()
    return ours, peer, bare


def _rows(how: str, ours: list[float], peer: list[float], bare: list[float]) -> list[Row]:
    rows = []
    for name, share in (("p50", 0.5), ("p99", 0.99)):
        our, their, floor = percentile(ours, share), percentile(peer, share), percentile(bare, share)
        what = f"board bytes to WebSocket message{how}, {name}"
        rows.append(Row(what, our, "ms", "<= peer", our <= their, their, foxglove_peer.NAME))
        reach = f"<= {ADDED_MS} ms over it" if name == "p50" else ""
        ok = our - floor <= ADDED_MS if name == "p50" else None
        rows.append(Row(f"the same beside a bare read{how}, {name}", our, "ms", reach, ok, floor, "bare PTY read"))
    return rows


def measure(line: Line, received: Callable[[], float]) -> list[float]:
    """Delays in ms of SAMPLES frames, sent one at a time; `received` returns the time of the message's arrival."""
    times = []
    for _ in range(SAMPLES):
        begun = time.perf_counter()
        line.write(_FRAME)
        times.append((received() - begun) * 1000.0)
        time.sleep(PERIOD_S)
    return times


def until_ahrs(viewer: WebSocket) -> float:
    """Receive and acknowledge until the sample came; returns the time."""
    while True:
        message = viewer.receive()
        received_s = time.perf_counter()
        viewer.acknowledge(message)
        if b'"topic":"ahrs"' in message:
            return received_s


def _until_binary(client: WebSocket) -> float:
    while client.receive()[:1] != b"\x01":
        pass
    return time.perf_counter()


def keep_open(line: Line, gateway: Gateway) -> None:
    """Send heartbeats, so that the session stays open while the others are measured."""
    line.write(HEARTBEAT)
    line.read(0.0)
    if gateway.process.poll() is not None:
        raise RuntimeError("the gateway ended")


@contextlib.contextmanager
def _peer() -> Iterator[tuple[Line, WebSocket]]:
    with tempfile.TemporaryDirectory() as folder, _child("bench.foxglove_peer", folder) as (line, process):
        assert process.stdout is not None
        client = foxglove_peer.subscribe(int(process.stdout.readline()))
        yield line, client
        client.close()


@contextlib.contextmanager
def _bare() -> Iterator[tuple[Line, int]]:
    """A process that only reads the line and prints the times."""
    with tempfile.TemporaryDirectory() as folder, _child("bench.bare_reader", folder) as (line, process):
        assert process.stdout is not None
        process.stdout.readline()
        yield line, process.stdout.fileno()


@contextlib.contextmanager
def _child(module: str, folder: str) -> Iterator[tuple[Line, subprocess.Popen[bytes]]]:
    line = Line(Path(folder))
    process = subprocess.Popen([sys.executable, "-m", module, line.path], stdout=subprocess.PIPE, bufsize=0)
    try:
        yield line, process
    finally:
        process.terminate()
        process.wait()
        if process.stdout is not None:
            process.stdout.close()
        line.close()


def _measure_bare(line: Line, answers: int) -> list[float]:
    times = []
    for _ in range(SAMPLES):
        begun_ns = time.monotonic_ns()
        line.write(_FRAME)
        read_ns = int(os.read(answers, 64))
        times.append((read_ns - begun_ns) * 1e-6)
        time.sleep(PERIOD_S)
    return times
