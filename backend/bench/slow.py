"""The station on a quarter of one core: a stand-in for a core of a Raspberry Pi, which is not here.

A cgroup gives both processes and the launcher 25 ms of one core in each 100 ms. Nothing else of a Pi is imitated,
and the flight process has no real-time priority meanwhile.
"""

from __future__ import annotations

import contextlib
import os
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Final

from bench.cpu import measure, reading
from bench.station import station
from bench.table import Row

SHARE_PERCENT: Final = 25
_PERIOD_US: Final = 100_000
_CGROUPS: Final = Path("/sys/fs/cgroup")
ROUNDS: Final = 5
REACH_PERCENT: Final = 75.0
REACH_HELD_UP_PERCENT: Final = 10.0
REACH_MB: Final = 300.0


def run() -> list[Row]:
    """At the full 115200 line with one viewer at 60 Hz. No row where no cgroup can be made: that needs root."""
    with station() as (gateway, line), contextlib.ExitStack() as held:
        processes = {"launcher": gateway.process.pid, **gateway.parts}
        pids = list(processes.values())
        try:
            group = held.enter_context(limited(pids))
        except OSError as error:
            print(f"slow: no cgroup can be made here ({error}): not measured.", file=sys.stderr)
            return []
        viewer = gateway.stream(60)
        with reading(viewer, viewer.acknowledge):
            before = stopped(group)
            rounds = [measure(processes, line) for _ in range(ROUNDS)]
            used = sum(part.percent for one in rounds for part in one.values()) / ROUNDS
            periods, held_up = (after - earlier for after, earlier in zip(stopped(group), before, strict=True))
        memory_mb = sum(map(own_mb, pids))
        viewer.close()
    share, stops = 100.0 * used / SHARE_PERCENT, 100.0 * held_up / max(1, periods)
    where = f"on {SHARE_PERCENT} % of one core (cgroup, for a core of a Pi), full 115200 line, one viewer at 60 Hz"
    return [
        Row(f"of its time used, {where}", share, "%", f"<= {REACH_PERCENT:g} %", share <= REACH_PERCENT),
        Row(
            f"periods of 100 ms in which it had to wait, {where}",
            stops,
            "%",
            f"<= {REACH_HELD_UP_PERCENT:g} %",
            stops <= REACH_HELD_UP_PERCENT,
        ),
        Row(
            "memory of launcher, flight and web process (proportional set)",
            memory_mb,
            "MB",
            f"<= {REACH_MB:g} MB",
            memory_mb <= REACH_MB,
        ),
    ]


@contextlib.contextmanager
def limited(pids: list[int]) -> Iterator[Path]:
    """These processes on their share of one core. Raises OSError."""
    first = _CGROUPS / "cpu" if (_CGROUPS / "cpu").is_dir() else _CGROUPS
    group = first / f"epf-bench-{os.getpid()}"
    core = min(os.sched_getaffinity(0))
    group.mkdir()
    try:
        quota_us = _PERIOD_US * SHARE_PERCENT // 100
        if (group / "cpu.cfs_quota_us").exists():
            (group / "cpu.cfs_period_us").write_text(str(_PERIOD_US))
            (group / "cpu.cfs_quota_us").write_text(str(quota_us))
        else:
            (group / "cpu.max").write_text(f"{quota_us} {_PERIOD_US}")
        for pid in pids:
            for thread in Path(f"/proc/{pid}/task").iterdir():
                with contextlib.suppress(ProcessLookupError):
                    # A share holds for ordinary threads alone; the flight's goes first where it is real time.
                    os.sched_setscheduler(int(thread.name), os.SCHED_OTHER, os.sched_param(0))
                    os.sched_setaffinity(int(thread.name), {core})
            (group / "cgroup.procs").write_text(str(pid))
        yield group
    finally:
        for pid in pids:
            with contextlib.suppress(OSError):
                (first / "cgroup.procs").write_text(str(pid))
        group.rmdir()


def stopped(group: Path) -> tuple[int, int]:
    """How many periods there were, and in how many its share was used up."""
    told = dict(line.split() for line in (group / "cpu.stat").read_text().splitlines())
    return int(told["nr_periods"]), int(told["nr_throttled"])


def own_mb(pid: int) -> float:
    """Memory of a process, what it shares counted by its part of it."""
    for line in Path(f"/proc/{pid}/smaps_rollup").read_text().splitlines():
        if line.startswith("Pss:"):
            return int(line.split()[1]) / 1000
    return 0.0
