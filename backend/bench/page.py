"""The page in a real browser while twelve topics come at 50 Hz: frames, script, processor time, long tasks.

This process plays board and simulator with changing values, and each main tab is open for a while. The baseline is
a minimal page that shows the same stream: the cost of the browser itself on this machine.
"""

from __future__ import annotations

import contextlib
import json
import math
import os
import socket
import subprocess
import tempfile
import threading
import time
from collections.abc import Callable
from pathlib import Path
from typing import Final

from bench.station import HEARTBEAT, Line, station
from bench.table import Row
from epf_gcs.codec.encode import encode_telemetry
from epf_gcs.xplane.datagram import Record, build
from tests.support.ports import free_udp_port

PERIOD_S: Final = 0.02
FRAMES_REACH: Final = 55.0
SCRIPT_REACH_PERCENT: Final = 5.0
CPU_REACH_PERCENT: Final = 58.0
LONG_TASK_MS: Final = 50.0
_E2E: Final = Path(__file__).resolve().parents[2] / "e2e"
_ROWS: Final = (3, 4, 6, 8, 11, 16, 17, 18, 20, 25)


def run() -> list[Row]:
    """One row for each figure and tab."""
    with tempfile.TemporaryDirectory() as folder, station() as (gateway, line):
        results = Path(folder) / "page.json"
        port = free_udp_port()
        gateway.put("/links/simulator", {"receive_port": port, "send_host": "127.0.0.1", "send_port": free_udp_port()})
        stop = threading.Event()
        feeder = threading.Thread(target=_feed, args=(line, port, stop), daemon=True)
        feeder.start()
        try:
            environment = {
                **os.environ,
                "BENCH_URL": f"http://127.0.0.1:{gateway.port}",
                "BENCH_RESULTS": str(results),
            }
            subprocess.run(
                ["npm", "run", "--silent", "bench", "--", "bench/page.spec"], cwd=_E2E, env=environment, check=True
            )
        finally:
            stop.set()
            feeder.join()
        figures = json.loads(results.read_text())
    lean, *tabs = figures
    return [row for tab in tabs for row in _rows(tab, lean)]


def _rows(tab: dict[str, float | str], lean: dict[str, float | str]) -> list[Row]:
    frames, script = float(tab["frames_per_s"]), float(tab["script_percent"])
    cpu, task = float(tab["cpu_percent"]), float(tab["longest_task_ms"])
    where = f"page, {tab['tab']}"
    return [
        Row(f"{where}: frames", frames, "/s", f">= {FRAMES_REACH:g} of 60", frames >= FRAMES_REACH),
        Row(f"{where}: script", script, "%", f"<= {SCRIPT_REACH_PERCENT:g} %", script <= SCRIPT_REACH_PERCENT),
        Row(
            f"{where}: browser's processor time",
            cpu,
            "%",
            f"<= {CPU_REACH_PERCENT:g} % or the lean page",
            cpu <= max(CPU_REACH_PERCENT, float(lean["cpu_percent"])),
            float(lean["cpu_percent"]),
            "lean page",
        ),
        Row(f"{where}: longest task over 50 ms", task, "ms", "none", task <= LONG_TASK_MS),
        Row(f"{where}: heap", float(tab["heap_mb"]), "MB"),
    ]


def _feed(line: Line, port: int, stop: threading.Event) -> None:
    """Send every topic 50 times a second, as in a gentle flight in circles."""

    def send_board(t_s: float) -> None:
        # If the gateway is too slow to read, drop the bytes, as a real line would.
        with contextlib.suppress(BlockingIOError):
            line.write(board_frames(t_s))
        while line.read(0.0):
            pass

    send(port, stop, send_board, _datagram)


def send(
    port: int, stop: threading.Event, send_board: Callable[[float], None], datagram: Callable[[float], bytes | None]
) -> None:
    """Send board frames and simulator datagrams 50 times a second on an absolute schedule, until stopped."""
    simulator = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    begun_s = next_s = time.monotonic()
    while not stop.is_set():
        t_s = time.monotonic() - begun_s
        send_board(t_s)
        data = datagram(t_s)
        if data is not None:
            simulator.sendto(data, ("127.0.0.1", port))
        next_s = max(next_s + PERIOD_S, time.monotonic() - PERIOD_S)
        time.sleep(max(0.0, next_s - time.monotonic()))
    simulator.close()


def board_frames(t_s: float) -> bytes:
    """Eleven frames; the simulator's values are the twelfth topic."""
    wave, slow = math.sin(t_s), math.sin(0.2 * t_s)
    yaw_deg = (10.0 * t_s) % 360.0
    plan = (yaw_deg, 1000.0 + 50.0 * slow, 55.0, int(1500 + 500 * slow), 3)
    return HEARTBEAT + b"".join(
        (
            encode_telemetry("ahrs", yaw_deg, 8.0 * slow, 30.0 * wave),
            encode_telemetry("inertial", wave, slow, -wave, 2.0 * wave, slow, -9.8, 0.5 * wave, 0.4, slow),
            encode_telemetry("analog", 980 + wave, 300 + 50 * slow, 300.0, 640 + wave, 60 + 5 * wave,
                             2 * wave, wave, 26 + slow, 12 + 0.1 * wave, 500 * wave),
            encode_telemetry("servos_in", *(math.sin(t_s + 0.5 * channel) for channel in range(12))),
            encode_telemetry("fly_by_wire", wave, 0.5 + 0.4 * slow, slow, -wave),
            encode_telemetry("fms_plan", *plan),
            encode_telemetry("fms_hil_plan", *plan),
            encode_telemetry("statistics", int(40 + 30 * wave), int(50 + 30 * slow)),
            encode_telemetry("gps", 27.93 + 0.01 * slow, -15.38 + 0.01 * wave, 300 + 50 * slow, 60 + wave, yaw_deg,
                             0x3038, 0x33, 0x41),
            encode_telemetry("hil_surfaces", wave, slow, -wave, 0.5 + 0.4 * slow),
        )
    )  # fmt: skip


def _datagram(t_s: float) -> bytes:
    wave, slow = math.sin(t_s), math.sin(0.2 * t_s)
    values = {
        3: (60 + wave, 0, 0, 60 + wave, 0, 0, 0, 0),
        4: (0.1, 0, 500 * wave, 0, 1 + 0.2 * wave, 0.1 * slow, 0.05 * wave, 0),
        16: (slow, wave, -slow, 0, 0, 0, 0, 0),
        17: (8 * slow, 30 * wave, (10 * t_s) % 360, 0, 0, 0, 0, 0),
        18: (3 + wave, slow, (10 * t_s) % 360, slow, 0, 0, 0, 0),
        20: (27.93 + 0.01 * slow, -15.38 + 0.01 * wave, 1000 + 50 * slow, 0, 0, 1000 + 50 * slow, 0, 0),
        25: (0.5 + 0.4 * slow,) * 8,
    }
    return build([Record(row, tuple(map(float, values.get(row, (0.5 * wave,) * 8)))) for row in _ROWS])
