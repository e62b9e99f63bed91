"""Delay that the gateway adds to the HIL loop: from datagram to frame on the line, and from frame to datagram.

This process plays board and simulator, at 50 Hz on an absolute schedule; the baseline is a process that only
relays the bytes. The viewers, in a separate process, get every topic at 60 Hz and acknowledge.
"""

from __future__ import annotations

import contextlib
import os
import select
import socket
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Final

from bench.station import HEARTBEAT, AnyLine, Gateway, Line, percentile, station
from bench.table import Row
from epf_gcs.codec.encode import encode_telemetry
from epf_gcs.codec.messages_gen import TO_BOARD_HEADER
from epf_gcs.xplane.datagram import Record, build
from tests.support.ports import free_udp_port

PERIOD_S: Final = 0.02
FRAMES: Final = 1500
VIEWERS: Final = 50
REACH_MS: Final = 0.5
_FRAME_BYTES: Final = 76
# A frame that took longer than this either way is lost: fifty times the slowest ever measured.
_LOST_S: Final = 1.0
_MOST_LOST: Final = 20
_SURFACES: Final = encode_telemetry("hil_surfaces", 0.25, -0.5, 0.125, 0.75)
_BACKGROUND: Final = (
    encode_telemetry("ahrs", 12.0, 3.0, -4.0)
    + encode_telemetry("servos_in", *([0.25] * 12))
    + encode_telemetry("fly_by_wire", 0.1, 0.5, 0.2, 0.0)
)
_ROWS: Final = build([Record(row, (0.1,) * 8) for row in (3, 4, 6, 8, 11, 16, 17, 18, 20, 25)])


def run() -> list[Row]:
    """Alone, and with fifty viewers on the stream."""
    floor_in, floor_out = _floor()
    rows: list[Row] = []
    for viewers in (0, VIEWERS):
        there, back = _gateway(viewers)
        ways = (("datagram in to frame out", there, floor_in), ("frame in to datagram out", back, floor_out))
        for way, times, floor in ways:
            for name, share in (("p50", 0.5), ("p99", 0.99)):
                ours, bare = percentile(times, share), percentile(floor, share)
                reach = f"<= {REACH_MS} ms over it" if name == "p99" else ""
                ok = ours - bare <= REACH_MS if name == "p99" else None
                rows.append(Row(f"HIL, {viewers} viewers: {way}, {name}", ours, "ms", reach, ok, bare, "bare relay"))
    return rows


def _gateway(viewers: int) -> tuple[list[float], list[float]]:
    simulator, port = simulator_socket()
    with contextlib.closing(simulator), station() as (gateway, line):
        receive_port = free_udp_port()
        address = {"receive_port": receive_port, "send_host": "127.0.0.1", "send_port": port}
        gateway.put("/links/simulator", address)
        gateway.put("/hil", {"path": "assisted"})
        with _crowd(gateway, viewers, line):
            return fly(simulator, receive_port, line)


def _floor() -> tuple[list[float], list[float]]:
    with bare_relay() as loop:
        fly_loops(loop)
    return loop.there, loop.back


@contextlib.contextmanager
def bare_relay(make_line: Callable[[Path], AnyLine] = Line) -> Iterator[Loop]:
    """A process that only relays the bytes, on a line and a socket of its own."""
    simulator, port = simulator_socket()
    receive_port = free_udp_port()
    with contextlib.closing(simulator), tempfile.TemporaryDirectory() as folder:
        line = make_line(Path(folder))
        process = subprocess.Popen(
            [sys.executable, "-m", "bench.bare_relay", line.path, str(receive_port), str(port)],
            stdout=subprocess.PIPE,
            bufsize=0,
        )
        try:
            assert process.stdout is not None
            process.stdout.readline()
            yield Loop(simulator, receive_port, line)
        finally:
            process.terminate()
            process.wait()
            if process.stdout is not None:
                process.stdout.close()
            line.close()


class Loop:
    """One relay between simulator and line: the delays in ms of both directions, and how many frames were lost."""

    def __init__(self, simulator: socket.socket, receive_port: int, line: AnyLine) -> None:
        self.there: list[float] = []
        self.back: list[float] = []
        self.lost = 0
        self._simulator = simulator
        self._receive_port = receive_port
        self._line = line

    def prepare(self, count: int) -> None:
        """Send what a board sends besides."""
        self._line.write(HEARTBEAT + _BACKGROUND if count % 5 == 0 else _BACKGROUND)

    def begin(self) -> None:
        """Send one datagram, so that this socket is known as the simulator before any other sends."""
        self._simulator.sendto(_ROWS, ("127.0.0.1", self._receive_port))

    def frame(self) -> None:
        """One datagram in and one out. Raises TimeoutError if nothing comes through any more."""
        self._forget_late()
        begun_s = time.perf_counter()
        self._simulator.sendto(_ROWS, ("127.0.0.1", self._receive_port))
        if not _until_frame(self._line):
            self._lose()
            return
        arrived_s = time.perf_counter()
        self._line.write(_SURFACES)
        if not select.select([self._simulator], [], [], _LOST_S)[0]:
            self._lose()
            return
        self._simulator.recv(2048)
        self.back.append((time.perf_counter() - arrived_s) * 1000.0)
        self.there.append((arrived_s - begun_s) * 1000.0)

    def _forget_late(self) -> None:
        """Discard what an earlier frame brought after it was given up: it would pass for this one's answer."""
        while self._line.read(0.0):
            pass
        while select.select([self._simulator], [], [], 0.0)[0]:
            self._simulator.recv(2048)

    def _lose(self) -> None:
        self.lost += 1
        if self.lost > _MOST_LOST:
            raise TimeoutError(f"{self.lost} of {len(self.there) + self.lost} frames were lost")


def fly_loops(*loops: Loop, frames: int = FRAMES) -> None:
    """`frames` of each loop, one loop after the other within each period, so that all meet the same load.

    This process goes first meanwhile, where permitted: its own waiting is not the loops' delay.
    """
    with going_first():
        next_s = time.perf_counter()
        for count in range(frames):
            for loop in loops:
                next_s += PERIOD_S / len(loops)
                loop.prepare(count)
                time.sleep(max(0.0, next_s - time.perf_counter()))
                loop.frame()


@contextlib.contextmanager
def going_first() -> Iterator[None]:
    """Real-time priority inside the block, if the system permits it; not for processes started meanwhile."""
    try:
        os.sched_setscheduler(0, os.SCHED_RR | os.SCHED_RESET_ON_FORK, os.sched_param(2))
    except (AttributeError, OSError):
        yield
        return
    try:
        yield
    finally:
        os.sched_setscheduler(0, os.SCHED_OTHER, os.sched_param(0))


def fly(simulator: socket.socket, receive_port: int, line: AnyLine) -> tuple[list[float], list[float]]:
    """FRAMES delays in ms for each direction."""
    loop = Loop(simulator, receive_port, line)
    fly_loops(loop)
    return loop.there, loop.back


def _until_frame(line: AnyLine) -> bool:
    """Read until a whole frame to the board came; False if none came in time."""
    give_up_s = time.monotonic() + _LOST_S
    got = b""
    while got.count(TO_BOARD_HEADER) == 0 or len(got) < _FRAME_BYTES:
        left_s = give_up_s - time.monotonic()
        if left_s <= 0.0:
            return False
        got += line.read(left_s)
    return True


@contextlib.contextmanager
def _crowd(gateway: Gateway, viewers: int, line: AnyLine) -> Iterator[None]:
    if not viewers:
        yield
        return
    process = subprocess.Popen(
        [sys.executable, "-m", "bench.crowd", str(gateway.port), str(viewers)], stdout=subprocess.PIPE, bufsize=0
    )
    try:
        assert process.stdout is not None
        # Keep sending the board's heartbeats while the viewers connect.
        while not select.select([process.stdout], [], [], 0.05)[0]:
            line.write(HEARTBEAT)
            line.read(0.0)
        process.stdout.readline()
        yield
    finally:
        process.terminate()
        process.wait()
        if process.stdout is not None:
            process.stdout.close()


def simulator_socket() -> tuple[socket.socket, int]:
    """The simulator's end, and its port."""
    simulator = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    simulator.bind(("127.0.0.1", 0))
    return simulator, simulator.getsockname()[1]
