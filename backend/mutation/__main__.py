"""Change the code in one small place at a time and see whether its tests notice: `python -m mutation [module ...]`.

cosmic-ray makes the changes, in a copy of the tree. What no test notices is shown to lint and types, which `make test`
runs as well; it is counted for itself. What nothing notices is printed with its difference: each is a test that is
missing, a line that is not needed, or a change that nobody can see (`decisions/tests/changes-that-no-test-sees.md`).
Checks that fail without a change would notice everything: they end the run.
"""

from __future__ import annotations

import argparse
import ast
import itertools
import random
import shutil
import subprocess
import sys
import tempfile
import warnings
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Final

from cosmic_ray.mutating import mutate_code
from cosmic_ray.plugins import get_operator
from cosmic_ray.work_db import WorkDB, use_db
from cosmic_ray.work_item import TestOutcome, WorkerOutcome, WorkItem, WorkResult

_BACKEND: Final = Path(__file__).resolve().parents[1]
_NEEDED: Final = ("src", "tests", "conftest.py", "pyproject.toml")
# What tests only read or run: the vectors of the wire, the board's program.
_BESIDE: Final = ("protocol", "firmware")
_TIMEOUT_S: Final = 120.0
_PYTEST: Final = ("-m", "pytest", "-q", "-x", "-p", "no:cacheprovider")
# What holds for every module.
_RULES: Final = ("tests/test_values.py",)

MODULES: Final[dict[str, tuple[str, ...]]] = {
    "bus/address.py": ("tests/bus",),
    "bus/channel.py": ("tests/bus",),
    "bus/definition.py": ("tests/bus",),
    "bus/faults.py": ("tests/bus",),
    "bus/station_end.py": ("tests/bus",),
    "bus/vehicle_end.py": ("tests/bus",),
    "codec/ahrs_test.py": ("tests/codec/test_ahrs_test.py",),
    "codec/checksum.py": ("tests/codec",),
    "codec/encode.py": ("tests/codec",),
    "codec/frame.py": ("tests/codec",),
    "codec/session.py": ("tests/codec", "tests/vehicle/test_board.py"),
    "codec/tables.py": ("tests/codec",),
    "codec/values.py": ("tests/codec",),
    "flight/state/advised.py": ("tests/flight/state/test_advised.py",),
    "flight/state/alarm_history.py": ("tests/flight/state/test_alarm_history.py",),
    "flight/board/acknowledgements.py": (
        "tests/flight/board/test_acknowledgements.py",
        "tests/flight/board/test_commands.py",
    ),
    "flight/board/ahrs_test.py": (
        "tests/flight/board/test_ahrs_test.py",
        "tests/web/interface/commands/test_ahrs_test_routes.py",
    ),
    "flight/board/board_link.py": ("tests/flight/board",),
    "flight/board/commands.py": ("tests/flight/board/test_commands.py", "tests/web/interface/commands/test_routes.py"),
    "flight/board/journal.py": ("tests/flight/board/test_journal.py", "tests/flight/board/test_parameters.py"),
    "flight/board/missions.py": (
        "tests/flight/board/test_missions.py",
        "tests/web/interface/parameters/test_routes.py",
        "tests/flight/recording/test_flight_notes.py",
    ),
    "flight/board/parameters.py": (
        "tests/flight/board/test_parameters.py",
        "tests/web/interface/parameters/test_routes.py",
    ),
    "flight/board/rearming.py": ("tests/flight/board/test_rearming.py", "tests/flight/board/test_board_link.py"),
    "flight/clock/clock_watch.py": ("tests/flight/clock/test_clock_watch.py",),
    "flight/flight.py": (
        "tests/flight/test_flight.py",
        "tests/web/interface/state/test_routes.py",
        "tests/web/interface/links/test_routes.py",
        "tests/web/interface/parameters/test_routes.py",
        "tests/flight/recording/test_flight_notes.py",
        "tests/web/interface/alarms/test_routes.py",
        "tests/web/test_emulation.py",
        "tests/flight/state/test_watch.py",
    ),
    "flight/memory/flight_log.py": ("tests/flight/memory/test_flight_log.py",),
    "flight/hil/emulation.py": ("tests/flight/hil/test_emulation.py", "tests/web/test_emulation.py"),
    "flight/hil/hil.py": ("tests/flight/hil",),
    "flight/hil/simulator.py": ("tests/flight/hil",),
    "flight/hil/stick.py": ("tests/flight/hil/test_stick.py", "tests/web/test_stick.py", "tests/flight/hil"),
    "flight/state/housekeeping.py": (
        "tests/flight/state/test_housekeeping.py",
        "tests/web/interface/state/test_routes.py",
        "tests/web/interface/recordings/test_routes.py",
        "tests/flight/memory/test_flight_log.py",
    ),
    "flight/state/inspection.py": ("tests/flight/state/test_inspection.py",),
    "flight/clock/line_clock.py": ("tests/flight/clock/test_line_clock.py",),
    "flight/state/line_rates.py": ("tests/flight/state/test_line_rates.py",),
    "flight/state/lines.py": (
        "tests/flight/state/test_lines.py",
        "tests/flight/board/test_board_link.py",
        "tests/flight/hil/test_simulator.py",
        "tests/web/test_emulation.py",
    ),
    "flight/memory/lines_file.py": (
        "tests/flight/memory/test_lines_file.py",
        "tests/flight/state/test_alarm_history.py",
    ),
    "flight/memory/memory.py": ("tests/flight/memory/test_memory.py", "tests/flight/memory/test_lines_file.py"),
    "flight/recording/flight_notes.py": (
        "tests/flight/test_requests.py",
        "tests/flight/recording/test_flight_notes.py",
        "tests/flight/recording",
    ),
    "flight/recording/known_notes.py": (
        "tests/flight/test_requests.py",
        "tests/flight/recording/test_flight_notes.py",
        "tests/flight/recording",
    ),
    "flight/recording/recorder.py": ("tests/flight/recording/test_rounds.py", "tests/flight/recording"),
    "flight/recording/recording_file.py": ("tests/flight/recording/test_rounds.py", "tests/flight/recording"),
    "flight/recording/repair.py": ("tests/flight/recording/test_repair.py", "tests/flight/recording"),
    "flight/recording/taps.py": ("tests/flight/recording",),
    "flight/requests/client_names.py": ("tests/flight/test_client_names.py", "tests/web/test_journal.py"),
    "flight/requests/commands.py": ("tests/web/commands", "tests/flight/test_requests.py"),
    "flight/requests/hil.py": (
        "tests/flight/test_requests.py",
        "tests/web/interface/links/test_routes.py",
        "tests/web/test_stick.py",
    ),
    "flight/requests/lines.py": ("tests/web/interface/links/test_routes.py",),
    "flight/requests/notices.py": (
        "tests/flight/test_requests.py",
        "tests/flight/hil/test_stick.py",
        "tests/web/test_stick.py",
        "tests/web/surroundings",
    ),
    "flight/requests/parameters.py": ("tests/web/interface/parameters/test_routes.py", "tests/web/test_journal.py"),
    "flight/requests/recording.py": ("tests/flight/test_requests.py", "tests/flight/recording/test_flight_notes.py"),
    "flight/requests/state.py": (
        "tests/web/interface/state/test_routes.py",
        "tests/web/interface/alarms/test_routes.py",
    ),
    "flight/state/status.py": (
        "tests/flight/state/test_status.py",
        "tests/web/interface/state/test_routes.py",
        "tests/web/interface/links/test_routes.py",
        "tests/web/test_emulation.py",
    ),
    "flight/state/watch.py": ("tests/flight/state/test_watch.py",),
    "recordings/mcap_file.py": ("tests/recordings", "tests/flight/recording"),
    "vehicle/advice.py": ("tests/vehicle/test_advice.py", "tests/vehicle"),
    "vehicle/ahrs_test_samples.py": ("tests/web/interface/commands/test_ahrs_test_routes.py",),
    "vehicle/alarms.py": ("tests/vehicle",),
    "vehicle/arrivals.py": ("tests/vehicle",),
    "vehicle/board.py": (
        "tests/vehicle/test_board_dialogue.py",
        "tests/vehicle/test_board.py",
        "tests/vehicle/test_restart.py",
        "tests/flight/board",
        "tests/flight/hil/test_hil.py",
        "tests/web/interface/links/test_routes.py",
    ),
    "vehicle/example_flight.py": ("tests/vehicle/test_example_flight.py", "tests/flight/hil/test_emulation.py"),
    "vehicle/frame_statistics.py": ("tests/vehicle/test_frame_statistics.py", "tests/vehicle"),
    "vehicle/health.py": ("tests/vehicle",),
    "vehicle/inspection.py": (
        "tests/vehicle/test_inspection.py",
        "tests/flight/state/test_inspection.py",
        "tests/vehicle",
    ),
    "vehicle/journal.py": ("tests/vehicle/test_journal.py", "tests/vehicle"),
    "vehicle/judges.py": ("tests/vehicle",),
    "vehicle/limits.py": ("tests/vehicle",),
    "vehicle/mission.py": ("tests/vehicle",),
    "vehicle/noted.py": ("tests/vehicle/test_noted.py",),
    "vehicle/parameters.py": ("tests/vehicle",),
    "vehicle/proof.py": ("tests/vehicle",),
    "vehicle/rates.py": ("tests/vehicle/test_rates.py", "tests/vehicle"),
    "vehicle/restart.py": ("tests/vehicle",),
    "vehicle/round_trip.py": ("tests/vehicle",),
    "vehicle/simulator_samples.py": ("tests/vehicle",),
    "vehicle/surroundings.py": ("tests/vehicle/test_surroundings.py", "tests/vehicle"),
    "vehicle/telemetry.py": ("tests/vehicle/test_telemetry.py", "tests/vehicle"),
    "vehicle/thresholds.py": ("tests/vehicle/test_thresholds.py", "tests/vehicle"),
    "vehicle/vehicle.py": ("tests/vehicle/test_vehicle.py",),
    "vehicle/wanted.py": ("tests/vehicle",),
    "vehicle/watch.py": ("tests/vehicle/test_watch.py", "tests/flight/state/test_watch.py", "tests/vehicle"),
    "access/authority.py": ("tests/access/test_authority.py", "tests/access/test_authority_walk.py"),
    "access/control.py": ("tests/access/test_control_alone.py", "tests/access/test_control.py"),
    "xplane/datagram.py": ("tests/xplane",),
    "xplane/gather.py": ("tests/xplane",),
    "xplane/mapping.py": ("tests/xplane",),
    "xplane/stick.py": ("tests/xplane",),
    "xplane/whole.py": ("tests/xplane",),
}
"""Module below `epf_gcs` -> the tests that should notice."""

Range = tuple[tuple[int, int], tuple[int, int]]
"""First and last place, each a line and a column."""


@dataclass(frozen=True, slots=True)
class Count:
    """What became of the changes of one module: noticed by its tests; by lint or types alone; by nothing."""

    killed: int
    refused: int
    survivors: tuple[str, ...]


def main() -> int:
    """Print a line for each module, the survivors, and the sum. Ends with 1 where fewer were noticed than asked."""
    parser = argparse.ArgumentParser(prog="mutation", description=__doc__)
    parser.add_argument("modules", nargs="*", metavar="module", help="such as codec/frame.py; all by default")
    parser.add_argument("--most", type=int, default=5, help="changes of each module, drawn at random")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--reach", type=float, default=0.0, help="percent that must be noticed")
    options = parser.parse_args()
    killed = refused = survived = 0
    with tempfile.TemporaryDirectory() as cache:
        for module in options.modules or MODULES:
            count = _try(module, options.most, random.Random(f"{options.seed} {module}"), cache)
            killed += count.killed
            refused += count.refused
            survived += len(count.survivors)
            print(
                f"{module}: {count.killed} noticed by tests, {count.refused} by lint or types,"
                f" {len(count.survivors)} not",
                flush=True,
            )
            for difference in count.survivors:
                print(difference, flush=True)
    total = max(1, killed + refused + survived)
    share = 100.0 * (killed + refused) / total
    print(
        f"{killed + refused} of {total} changes were noticed ({share:.0f} %); by tests {killed}"
        f" ({100.0 * killed / total:.0f} %), by lint or types alone {refused}"
    )
    return 0 if share >= options.reach else 1


def _try(module: str, most: int, draw: random.Random, cache: str) -> Count:
    with tempfile.TemporaryDirectory() as name:
        folder = _copy(Path(name))
        source = folder / "src" / "epf_gcs" / module
        # Absolute: tests also start programs in other folders.
        command = ["env", f"PYTHONPATH={folder / 'src'}", sys.executable, *_PYTEST, *tests_of(module)]
        if subprocess.run(command, cwd=folder, check=False).returncode:
            raise SystemExit(f"{module}: its tests fail without any change, so they would seem to notice every one")
        (folder / "session.toml").write_text(
            "[cosmic-ray]\n"
            f'module-path = "src/epf_gcs/{module}"\n'
            f"timeout = {_TIMEOUT_S}\n"
            "excluded-modules = []\n"
            f'test-command = "{" ".join(command)}"\n'
            '[cosmic-ray.distributor]\nname = "local"\n'
        )
        _cosmic_ray(folder, "init", "session.toml", "session.sqlite")
        with use_db(str(folder / "session.sqlite"), WorkDB.Mode.open) as work:
            _draw(work, most, draw, source.read_text())
        _cosmic_ray(folder, "exec", "session.toml", "session.sqlite")
        with use_db(str(folder / "session.sqlite"), WorkDB.Mode.open) as work:
            done = list(work.completed_work_items)
        # Without an outcome: a place that cosmic-ray could not change after all.
        tried = [(item, result) for item, result in done if result.worker_outcome is WorkerOutcome.NORMAL]
        passed = [(item, result) for item, result in tried if result.test_outcome is TestOutcome.SURVIVED]
        original = source.read_text()
        if passed and _is_refused(folder, module, cache):
            raise SystemExit(f"{module}: lint or types refuse it without any change")
        survivors = []
        for item, result in passed:
            source.write_text(_changed(original, item) or original)
            if not _is_refused(folder, module, cache):
                survivors.append(str(result.diff))
    return Count(len(tried) - len(passed), len(passed) - len(survivors), tuple(survivors))


def _is_refused(folder: Path, module: str, cache: str) -> bool:
    """Whether lint or types refuse the changed module, as `make check` would; callers elsewhere are checked, too."""
    python = ("env", f"PYTHONPATH={folder / 'src'}", sys.executable, "-m")
    lint = (*python, "ruff", "check", "--quiet", f"src/epf_gcs/{module}")
    types = (*python, "mypy", "--cache-dir", cache, "src")
    return any(subprocess.run(command, cwd=folder, check=False).returncode for command in (lint, types))


def tests_of(module: str) -> tuple[str, ...]:
    """The tests that should notice a change of this module."""
    return (*_RULES, *MODULES[module]) if module in MODULES else ("tests",)


def _copy(folder: Path) -> Path:
    """A copy of the gateway, with what its tests need beside it; returns where its backend is."""
    backend = folder / _BACKEND.name
    backend.mkdir()
    for needed in _NEEDED:
        source = _BACKEND / needed
        if source.is_dir():
            shutil.copytree(source, backend / needed, ignore=shutil.ignore_patterns("__pycache__", "*.egg-info"))
        else:
            shutil.copy(source, backend / needed)
    for beside in _BESIDE:
        (folder / beside).symlink_to(_BACKEND.parent / beside)
    return backend


def _annotations(source: str) -> list[Range]:
    """Where the annotations of a module are."""
    found: list[Range] = []
    for node in ast.walk(ast.parse(source)):
        for field in ("annotation", "returns"):
            part = getattr(node, field, None)
            if isinstance(part, ast.expr) and part.end_lineno is not None and part.end_col_offset is not None:
                found.append(((part.lineno, part.col_offset), (part.end_lineno, part.end_col_offset)))
    return found


def _is_annotation(item: WorkItem, annotations: Sequence[Range]) -> bool:
    return all(any(begin <= mutation.start_pos < end for begin, end in annotations) for mutation in item.mutations)


def _draw(work: WorkDB, most: int, draw: random.Random, source: str) -> None:
    """Leave out all but `most`, all that is in an annotation, which is never evaluated, and all that is no program."""
    # The database gives them in the order of their random names: sorted, a seed draws the same changes again.
    items = sorted(work.pending_work_items, key=_place)
    annotations = _annotations(source)
    drawable = [item for item in items if not _is_annotation(item, annotations)]
    kept = {
        item.job_id for item in _first(draw.sample(drawable, len(drawable)), most, lambda item: _runs(source, item))
    }
    _skip(work, (item.job_id for item in items if item.job_id not in kept))


def _first(items: Iterable[WorkItem], most: int, wanted: Callable[[WorkItem], bool]) -> list[WorkItem]:
    return list(itertools.islice(filter(wanted, items), most))


def _changed(source: str, item: WorkItem) -> str | None:
    """The module with the change; None if cosmic-ray cannot make it."""
    changed: str | None = source
    for mutation in item.mutations:
        if changed is not None:
            operator = get_operator(mutation.operator_name)(**mutation.operator_args)
            changed = mutate_code(changed, operator, mutation.occurrence)
    return changed


def _runs(source: str, item: WorkItem) -> bool:
    """Whether the change leaves a program that Python reads without a warning; any test would notice another one."""
    changed = _changed(source, item)
    if changed is None:
        return False
    try:
        with warnings.catch_warnings(action="error"):
            compile(changed, "changed", "exec", dont_inherit=True)
    except SyntaxError:
        return False
    return True


def _place(item: WorkItem) -> list[tuple[str, int]]:
    return [(mutation.operator_name, mutation.occurrence) for mutation in item.mutations]


def _skip(work: WorkDB, jobs: Iterable[str]) -> None:
    for job in jobs:
        work.set_result(job, WorkResult(worker_outcome=WorkerOutcome.SKIPPED, output="not drawn"))


def _cosmic_ray(folder: Path, *arguments: str) -> None:
    program = Path(sys.executable).with_name("cosmic-ray")
    subprocess.run([str(program), *arguments], cwd=folder, check=True)


if __name__ == "__main__":
    sys.exit(main())
