"""Plots of a flight of two hours as a page asks for them: over HTTP, recorded signals and computed ones."""

from __future__ import annotations

import random
import tempfile
import time
from pathlib import Path
from typing import Final

import httpx
import numpy as np

from bench.demonstration import make_demonstration
from bench.replay import FLIGHT_ID, FLIGHT_S, wait_until_indexed
from bench.table import Row
from epf_gcs.recordings.packing import pack
from tests.support.programs import gateway_process

FIRST_LIMIT_MS: Final = 300.0
ZOOM_LIMIT_MS: Final = 100.0
_ZOOMS: Final = 100
_NAMES: Final = (
    "ahrs.yaw_deg,ahrs.pitch_deg,ahrs.roll_deg,gps.speed_kt",
    "rate(ahrs.yaw_deg),diff(ahrs.yaw_deg,gps.heading_deg),ahrs.roll_deg,analog.altitude_m",
)


def run() -> list[Row]:
    """The gateway has no board: what is measured is the past alone."""
    with tempfile.TemporaryDirectory(prefix="epf-gcs-past-") as name:
        data = Path(name)
        pack(make_demonstration(data / "recordings" / f"{FLIGHT_ID}.mcap", FLIGHT_S))
        with gateway_process(data) as program:
            port = int(program.wait_for_words(r"url=http://\S+:(\d+)"))
            wait_until_indexed(port)
            return _over_http(port)


def _over_http(port: int) -> list[Row]:
    rng = random.Random(5)
    rows: list[Row] = []
    with httpx.Client(base_url=f"http://127.0.0.1:{port}/api/v1/flights/{FLIGHT_ID}", timeout=30) as client:
        # The worker that answers is started by the first question; what follows is what a person waits for.
        client.get("/topics").raise_for_status()
        for names, what in zip(_NAMES, ("4 signals", "4 signals, 2 of them computed"), strict=True):
            first_ms = _ask_ms(client, names, 0.0, FLIGHT_S)
            zooms_ms = []
            for _ in range(_ZOOMS):
                from_s = rng.uniform(0.0, 5000.0)
                zooms_ms.append(_ask_ms(client, names, from_s, from_s + rng.uniform(10.0, 2000.0)))
            zoom_ms = float(np.percentile(zooms_ms, 95))
            limit = f"<= {FIRST_LIMIT_MS:g} ms"
            rows.append(Row(f"{what} over 2 h by HTTP, first", first_ms, "ms", limit, first_ms <= FIRST_LIMIT_MS))
            limit = f"<= {ZOOM_LIMIT_MS:g} ms"
            rows.append(Row(f"{what} by HTTP, zoom p95", zoom_ms, "ms", limit, zoom_ms <= ZOOM_LIMIT_MS))
    return rows


def _ask_ms(client: httpx.Client, names: str, from_s: float, to_s: float) -> float:
    begun_s = time.perf_counter()
    wanted: dict[str, str | float] = {"names": names, "from_s": from_s, "to_s": to_s, "points": 2000}
    client.get("/signals", params=wanted).raise_for_status()
    return (time.perf_counter() - begun_s) * 1e3
