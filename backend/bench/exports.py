"""A gigabyte of recording, made from the demonstration: prepared, and exported in every format in bounded memory.

`exports:100` takes 100 MB.
"""

from __future__ import annotations

import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from typing import Final, NamedTuple

import orjson

from bench.demonstration import make_demonstration
from bench.table import Row

FORMATS: Final = ("mcap", "mcap-decoded", "csv", "parquet", "kml", "kmz", "gpx", "czml")
MEMORY_REACH_MB: Final = 300.0
_BYTES: Final = 1_000_000_000
_PROBE_S: Final = 60.0
_ID: Final = "20260101T120000Z"


class _Done(NamedTuple):
    took_s: float
    peak_mb: float


def run(megabytes: str = "") -> list[Row]:
    """Time, peak memory and size of each worker program."""
    with tempfile.TemporaryDirectory(prefix="epf-gcs-exports-") as name:
        data = Path(name)
        recording = _recording(data / "recordings" / f"{_ID}.mcap", int(megabytes) * 1_000_000 if megabytes else _BYTES)
        size = f"{recording.stat().st_size / 1e6:.0f} MB"
        rows = _rows(f"prepare {size}", _worker("index", str(recording)))
        for one in FORMATS:
            target = data / "exports" / one
            done = _worker("export", str(recording), one, str(target))
            written = Row(f"export {size} as {one}: size", target.stat().st_size / 1e6, "MB")
            rows += [*_rows(f"export {size} as {one}", done), written]
            target.unlink()
        return rows


def _rows(what: str, done: _Done) -> list[Row]:
    reach = f"<= {MEMORY_REACH_MB:g} MB"
    peak = Row(f"{what}: peak memory", done.peak_mb, "MB", reach, done.peak_mb <= MEMORY_REACH_MB)
    return [Row(what, done.took_s, "s"), peak]


def _recording(path: Path, size: int) -> Path:
    """Of this size or a little less."""
    probe = make_demonstration(path, _PROBE_S).stat().st_size
    return make_demonstration(path, _PROBE_S * size / probe)


def _worker(*words: str) -> _Done:
    begun_s = time.monotonic()
    process = subprocess.Popen(
        [sys.executable, "-m", "epf_gcs.flights", *words], stdin=subprocess.PIPE, stdout=subprocess.PIPE
    )
    assert process.stdout is not None
    last = process.stdout.read().splitlines()[-1]
    _, status, used = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    said = orjson.loads(last)
    assert "done" in said, said
    # Linux counts kilobytes here, macOS bytes.
    unit = 1e3 if sys.platform == "linux" else 1e6
    return _Done(time.monotonic() - begun_s, used.ru_maxrss / unit)
