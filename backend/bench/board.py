"""Whether the board's periodic tasks stay on time while the line is full in both directions.

Two boards of this computer run side by side for ten minutes (BENCH_MINUTES changes it), each in the HIL loop at 50 Hz
with every stream on at its fastest. One's line is full both ways; the other is flooded with garbage at the line's full
rate. The board itself counts the periods that began late, by its own clock (`tasks` in the shell).
"""

from __future__ import annotations

import os
import random
import re
import threading
import time
from collections.abc import Callable, Iterator
from typing import Final

from bench.table import Row
from board_tests.line.station import LEVEL_FLIGHT, Board, Station
from epf_gcs.codec.encode import encode_command
from epf_gcs.codec.messages_gen import TO_BOARD_HEADER
from tests.support.firmware import make

LINE_BYTES_PER_S: Final = 11520
STEP_S: Final = 0.002
HIL_PERIOD_S: Final = 0.02
MINUTES: Final = float(os.environ.get("BENCH_MINUTES", "10"))
PERIODIC: Final = ("sensorTask", "controlTask")
_LATE: Final = re.compile(r"^(\w+) .*late (\d+)$")

Filler = Callable[[], Iterator[bytes]]


def run() -> list[Row]:
    """Both boards at the same time."""
    make("board")
    rows: dict[str, list[Row]] = {}
    fillers: dict[str, Filler] = {"line full both ways": _commands, "flooded with garbage": _garbage}
    threads = [
        threading.Thread(target=lambda name=name, filler=filler: rows.update({name: _fly(name, filler)}))
        for name, filler in fillers.items()
    ]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    return [row for name in fillers for row in rows[name]]


def _fly(name: str, filler: Filler) -> list[Row]:
    """Ten minutes of one board: how often its tasks were late, and the bytes it received and sent."""
    board = Board("posix", "--tcp", "0")
    station = Station.on_tcp(board.tcp_port)
    try:
        station.open_binary()
        station.extend()
        station.command("start")
        for task, period_ms in (("parameter", 20), ("fms", 50), ("servos", 20)):
            station.command(f"set_{task}_task_rate", period_ms)
        sent, received = _fill(station, filler())
        station.command("stop")
        # The shell answers only in text mode; its time-out discards garbage left in the frame decoder.
        station.command("exit_binary_mode")
        late = _late(station)
    finally:
        station.close()
        code, complaint = board.stop()
    if code != 0:
        raise RuntimeError(f"the board ended with {code}: {complaint}")
    rows = [
        Row(f"board, {name}: {task} late in {MINUTES:g} min", late[task], "", "never", late[task] == 0)
        for task in PERIODIC
    ]
    rate = f"board, {name}: bytes a second"
    return [
        *rows,
        Row(
            f"{rate} to the board",
            sent / (60.0 * MINUTES),
            "B/s",
            f">= {0.98 * LINE_BYTES_PER_S:.0f}",
            sent >= 0.98 * 60.0 * MINUTES * LINE_BYTES_PER_S,
        ),
        Row(f"{rate} from the board", received / (60.0 * MINUTES), "B/s"),
    ]


def _fill(station: Station, filler: Iterator[bytes]) -> tuple[int, int]:
    """Send and receive at the line's rate, HIL frames first; returns the bytes sent and received."""
    begun_s = time.monotonic()
    hil = encode_command("xplane_info", *LEVEL_FLIGHT)
    hil_frames = sent = received = 0
    while (passed_s := time.monotonic() - begun_s) < 60.0 * MINUTES:
        if passed_s >= hil_frames * HIL_PERIOD_S:
            station.send(hil)
            sent += len(hil)
            hil_frames += 1
        while sent < passed_s * LINE_BYTES_PER_S:
            piece = next(filler)
            station.send(piece)
            sent += len(piece)
        room = int(passed_s * LINE_BYTES_PER_S) - received
        if room > 0:
            received += station.pump(0.0, room)
        station.frames.clear()
        station.received.clear()
        time.sleep(STEP_S)
    return sent, received


def _commands() -> Iterator[bytes]:
    """Commands that the board executes and acknowledges, endlessly."""
    while True:
        for value in (1.0, 2.0):
            yield encode_command("set_k_roll", value)


def _garbage() -> Iterator[bytes]:
    """Random bytes, with frame headers among them that no valid frame follows."""
    source = random.Random(7)
    while True:
        yield source.randbytes(source.randrange(1, 60))
        yield TO_BOARD_HEADER + source.randbytes(3)


def _late(station: Station) -> dict[str, int]:
    """Task -> number of periods that began late, as the shell prints it."""
    found = (_LATE.match(line) for line in station.lines("tasks"))
    return {match[1]: int(match[2]) for match in found if match}
