"""The page in the past of a flight of two hours: from letting the time bar go until every instrument shows that moment,
pictures a second at a hundred times real time, and plots from the wish until their last line is drawn."""

from __future__ import annotations

import json
import os
import subprocess
import tempfile
from pathlib import Path
from typing import Any, Final

import numpy as np

from bench.demonstration import make_demonstration
from bench.replay import FLIGHT_ID, FLIGHT_S, wait_for_keys, wait_until_indexed
from bench.table import Row
from epf_gcs.recordings.packing import pack
from tests.support.programs import gateway_process

LET_GO_REACH_MS: Final = 100.0
FRAMES_REACH: Final = 55.0
DRAWN_REACH_MS: Final = 300.0
ZOOM_REACH_MS: Final = 100.0
OPEN_REACH_S: Final = 2.0
_E2E: Final = Path(__file__).resolve().parents[2] / "e2e"


def run() -> list[Row]:
    """The gateway has no board: what is measured is the past alone."""
    with tempfile.TemporaryDirectory(prefix="epf-gcs-past-") as name:
        data = Path(name)
        pack(make_demonstration(data / "recordings" / f"{FLIGHT_ID}.mcap", FLIGHT_S))
        with gateway_process(data) as program:
            port = int(program.wait_for_words(r"url=http://\S+:(\d+)"))
            wait_until_indexed(port)
            wait_for_keys(port)
            results = data / "past.json"
            environment = {
                **os.environ,
                "BENCH_URL": f"http://127.0.0.1:{port}",
                "BENCH_FLIGHT": FLIGHT_ID,
                "BENCH_RESULTS": str(results),
            }
            subprocess.run(
                ["npm", "run", "--silent", "bench", "--", "bench/past.spec"], cwd=_E2E, env=environment, check=True
            )
            return _rows(json.loads(results.read_text()))


def _rows(found: dict[str, Any]) -> list[Row]:
    worst_s = max(found["opened_s"])
    reach = f"<= {OPEN_REACH_S:g} s"
    what = "page loaded with a flight of 2 h in its address, until it shows it, worst of 5"
    rows = [Row(what, worst_s, "s", reach, worst_s <= OPEN_REACH_S)]
    for tab, drags in found["drags"].items():
        p50, p95 = (float(np.percentile(drags, share)) for share in (50, 95))
        what = f"page, {tab}: bar let go, until the last instrument shows it"
        rows.append(Row(f"{what}: p50", p50, "ms"))
        rows.append(Row(f"{what}: p95", p95, "ms", f"<= {LET_GO_REACH_MS:g} ms", p95 <= LET_GO_REACH_MS))
    for tab, fast in found["fast"].items():
        frames, rate = float(fast["frames_per_s"]), float(fast["rate"])
        reach = f">= {FRAMES_REACH:g} of 60"
        rows.append(Row(f"page, {tab} at 100 x: frames", frames, "/s", reach, frames >= FRAMES_REACH))
        rows.append(Row(f"page, {tab} at 100 x: time flown over time", rate, "x"))
    drawn, zoom = float(max(found["drawn"])), float(np.percentile(found["zooms"], 95))
    rows.append(
        Row("page, plots over 2 h: drawn, worst", drawn, "ms", f"<= {DRAWN_REACH_MS:g} ms", drawn <= DRAWN_REACH_MS)
    )
    rows.append(Row("page, plots: zoom, p95", zoom, "ms", f"<= {ZOOM_REACH_MS:g} ms", zoom <= ZOOM_REACH_MS))
    return rows
