"""Change the code in one small place at a time and see whether its tests notice: `python -m mutation [module ...]`.

cosmic-ray makes the changes, in a copy of the tree. Those that no test notices are printed with their difference: each
is a test that is missing, or a line that is not needed.
"""

from __future__ import annotations

import argparse
import random
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path
from typing import Final

from cosmic_ray.work_db import WorkDB, use_db
from cosmic_ray.work_item import TestOutcome, WorkerOutcome, WorkResult

_BACKEND: Final = Path(__file__).parents[1]
_NEEDED: Final = ("src", "tests", "conftest.py", "pyproject.toml")
_TIMEOUT_S: Final = 120.0

MODULES: Final[dict[str, tuple[str, ...]]] = {
    "bus/definition.py": ("tests/bus",),
    "codec/checksum.py": ("tests/codec",),
    "codec/encode.py": ("tests/codec",),
    "codec/frame.py": ("tests/codec",),
    "codec/session.py": ("tests/codec", "tests/vehicle/test_board.py"),
    "codec/values.py": ("tests/codec",),
    "flight/board/acknowledgements.py": (
        "tests/flight/board/test_acknowledgements.py",
        "tests/flight/board/test_commands.py",
    ),
    "flight/hil/stick.py": ("tests/web/test_stick.py", "tests/flight/hil"),
    "flight/hil/hil.py": ("tests/flight/hil",),
    "recordings/mcap_file.py": ("tests/recordings", "tests/flight/recording"),
    "vehicle/alarms.py": ("tests/vehicle",),
    "vehicle/judges.py": ("tests/vehicle",),
    "vehicle/proof.py": ("tests/vehicle",),
    "vehicle/restart.py": ("tests/vehicle",),
    "web/access/authority.py": ("tests/web/access/test_authority.py", "tests/web/access/test_authority_walk.py"),
    "web/access/control.py": ("tests/web/access/test_control.py",),
    "xplane/datagram.py": ("tests/xplane",),
    "xplane/gather.py": ("tests/xplane",),
    "xplane/mapping.py": ("tests/xplane",),
    "xplane/stick.py": ("tests/xplane",),
    "xplane/whole.py": ("tests/xplane",),
}
"""Module below `epf_gcs` -> the tests that should notice."""


@dataclass(frozen=True, slots=True)
class Count:
    """What became of the changes of one module."""

    killed: int
    survivors: tuple[str, ...]


def main() -> int:
    """Print a line for each module, the survivors, and the sum. Ends with 1 where fewer were noticed than asked."""
    parser = argparse.ArgumentParser(prog="mutation", description=__doc__)
    parser.add_argument("modules", nargs="*", metavar="module", help="such as codec/frame.py; all by default")
    parser.add_argument("--most", type=int, default=5, help="changes of each module, drawn at random")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--reach", type=float, default=0.0, help="percent that must be noticed")
    options = parser.parse_args()
    killed = survived = 0
    for module in options.modules or MODULES:
        count = _try(module, options.most, random.Random(f"{options.seed} {module}"))
        killed += count.killed
        survived += len(count.survivors)
        print(f"{module}: {count.killed} noticed, {len(count.survivors)} not", flush=True)
        for difference in count.survivors:
            print(difference, flush=True)
    share = 100.0 * killed / max(1, killed + survived)
    print(f"{killed} of {killed + survived} changes were noticed ({share:.0f} %)")
    return 0 if share >= options.reach else 1


def _try(module: str, most: int, draw: random.Random) -> Count:
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        for needed in _NEEDED:
            source = _BACKEND / needed
            if source.is_dir():
                shutil.copytree(source, folder / needed, ignore=shutil.ignore_patterns("__pycache__", "*.egg-info"))
            else:
                shutil.copy(source, folder / needed)
        tests = " ".join(MODULES.get(module, ("tests",)))
        (folder / "session.toml").write_text(
            "[cosmic-ray]\n"
            f'module-path = "src/epf_gcs/{module}"\n'
            f"timeout = {_TIMEOUT_S}\n"
            "excluded-modules = []\n"
            f'test-command = "env PYTHONPATH=src {sys.executable} -m pytest -q -x -p no:cacheprovider {tests}"\n'
            '[cosmic-ray.distributor]\nname = "local"\n'
        )
        _cosmic_ray(folder, "init", "session.toml", "session.sqlite")
        with use_db(str(folder / "session.sqlite"), WorkDB.Mode.open) as work:
            _draw(work, most, draw)
        _cosmic_ray(folder, "exec", "session.toml", "session.sqlite")
        with use_db(str(folder / "session.sqlite"), WorkDB.Mode.open) as work:
            results = [result for _, result in work.completed_work_items]
    tried = [result for result in results if result.worker_outcome is not WorkerOutcome.SKIPPED]
    survivors = tuple(str(result.diff) for result in tried if result.test_outcome is TestOutcome.SURVIVED)
    return Count(len(tried) - len(survivors), survivors)


def _draw(work: WorkDB, most: int, draw: random.Random) -> None:
    """Leave out all but `most`."""
    jobs = [item.job_id for item in work.pending_work_items]
    kept = set(draw.sample(jobs, min(most, len(jobs))))
    _skip(work, (job for job in jobs if job not in kept))


def _skip(work: WorkDB, jobs: Iterable[str]) -> None:
    for job in jobs:
        work.set_result(job, WorkResult(worker_outcome=WorkerOutcome.SKIPPED, output="not drawn"))


def _cosmic_ray(folder: Path, *arguments: str) -> None:
    program = Path(sys.executable).with_name("cosmic-ray")
    subprocess.run([str(program), *arguments], cwd=folder, check=True)


if __name__ == "__main__":
    sys.exit(main())
