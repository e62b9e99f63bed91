"""The Gando circuit at real time, flown by the STM32F405's own image under QEMU, as `make run BOARD=qemu` flies it."""

from __future__ import annotations

import contextlib
import signal
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any, Final

import httpx

from bench.table import Row
from board_tests.closed_loop.reference import ALTITUDE_LIMIT_FT, CROSS_TRACK_LIMIT_M, ROUTE_REFERENCES
from epf_gcs.codec.messages_gen import ROUTES
from epf_gcs.lab.figures import RouteEnd, measure
from epf_gcs.lab.truth import Truth
from epf_gcs.launcher.ports import LOOPBACK, free_tcp_port
from tests.support.firmware import make

ROUTE: Final = "gando"
LONGEST_SHARE: Final = 1.3
SAMPLE_S: Final = 0.1
ROW_PERIOD_MS: Final = 20.0
"""X-Plane's rows at 50 Hz."""
P50_LIMIT_MS: Final = 2 * 3.2
"""Twice the delay measured in the deployed board's loop."""


@dataclass(frozen=True, slots=True)
class _State:
    latitude_deg: float
    longitude_deg: float
    altitude_ft: float
    airspeed_indicated_kt: float


@dataclass(frozen=True, slots=True)
class _Sample:
    time_s: float
    state: _State
    waypoint: int


def run() -> list[Row]:
    """One circuit: ten minutes."""
    make("images")
    route = ROUTES[ROUTE].waypoints
    reference = ROUTE_REFERENCES[ROUTE]
    end = RouteEnd(route)
    samples: list[_Sample] = []
    trips_ms: list[float] = []
    with _station() as client:
        is_over = False
        while not is_over:
            telemetry, status = (client.get(name).json() for name in ("telemetry", "status"))
            samples.append(_sample(telemetry))
            trips_ms.append(status["simulator"]["hil_round_trip_ms"]["newest"])
            flown_s = samples[-1].time_s - samples[0].time_s
            is_over = end.reached(samples[-1]) or flown_s > LONGEST_SHARE * reference.time_s
            time.sleep(SAMPLE_S)
    figures = measure(Truth.of(samples), route)
    cuts = statistics.quantiles(trips_ms, n=100)
    what = "image under QEMU, gando"
    return [
        Row(
            f"{what}: waypoints",
            figures.waypoints_reached,
            "",
            f"{len(route)}",
            figures.waypoints_reached == len(route),
        ),
        Row(f"{what}: time", figures.time_s, "s", peer=reference.time_s, peer_name="reference"),
        Row(
            f"{what}: steady altitude error, rms",
            figures.altitude.settled.rms_ft,
            "ft",
            f"<= {ALTITUDE_LIMIT_FT:g}",
            figures.altitude.settled.rms_ft <= ALTITUDE_LIMIT_FT,
        ),
        Row(
            f"{what}: cross-track, rms",
            figures.cross_track.rms_m,
            "m",
            f"<= {CROSS_TRACK_LIMIT_M:g}",
            figures.cross_track.rms_m <= CROSS_TRACK_LIMIT_M,
        ),
        Row(f"{what}: HIL round trip p50", cuts[49], "ms", f"<= {P50_LIMIT_MS:g}", cuts[49] <= P50_LIMIT_MS),
        Row(f"{what}: HIL round trip p99", cuts[98], "ms", f"<= {ROW_PERIOD_MS:g}", cuts[98] <= ROW_PERIOD_MS),
    ]


def _sample(telemetry: dict[str, Any]) -> _Sample:
    flown = telemetry["simulator"]["values"]
    return _Sample(
        time_s=telemetry["simulator"]["t_s"],
        state=_State(
            flown["latitude_deg"],
            flown["longitude_deg"],
            flown["altitude_msl_ft"],
            flown["indicated_airspeed_kt"],
        ),
        waypoint=telemetry["fms_hil_plan"]["values"]["waypoint"],
    )


@contextlib.contextmanager
def _station() -> Iterator[httpx.Client]:
    """The demonstration with the image as its board, the route loaded and the loop closed."""
    port = free_tcp_port()
    with tempfile.TemporaryDirectory() as data:
        words = [sys.executable, "-m", "epf_gcs.launcher", "--board", "qemu", "--port", str(port), "--data-dir", data]
        with subprocess.Popen(words, stdout=subprocess.PIPE, text=True) as launcher:
            try:
                assert launcher.stdout is not None
                if not launcher.stdout.readline():
                    raise RuntimeError("the demonstration did not start")
                with httpx.Client(base_url=f"http://{LOOPBACK}:{port}/api/v1/") as client:
                    yield client
            finally:
                launcher.send_signal(signal.SIGINT)
