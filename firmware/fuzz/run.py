"""Run the fuzz targets and report the results.

Usage: run.py short|long|planted FOLDER [--runs N | --minutes N] [--results FOLDER] [--compile COMMAND --link COMMAND]

short    the same few seconds each time, from the seeds
long     RUNS or MINUTES of each target, going on from what earlier long runs found (FOLDER/corpus)
planted  a copy of a source with a bug in it is compiled in; the target has to find it

With --results a JUnit file says what passed. The exit code is 1 when something was found, or a planted bug was not.
"""

from __future__ import annotations

import argparse
import os
import re
import shlex
import shutil
import subprocess
import sys
import time
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path
from xml.etree import ElementTree as ET

ROOT = Path(__file__).parents[1]
LONGEST_INPUT_BYTES = {"frame": 512, "interpreter": 1280, "mission": 1280}
SHORT_RUNS = {"frame": 60_000, "interpreter": 8_000, "mission": 12_000}
PLANTED_RUNS = 100_000
WORKERS = 2
RUNS_MADE = r"stat::number_of_executed_units:\s*(\d+)"


@dataclass(frozen=True)
class Outcome:
    """Result of one target's run; `failure` is empty when all is well."""

    name: str
    line: str
    failure: str
    seconds: float


@dataclass(frozen=True)
class Planted:
    """A bug, planted by one replacement in one source, and the finding that has to result (a regular expression)."""

    target: str
    source: str
    good: str
    bad: str
    finding: str


PLANTED = (
    # after a refused header too many bytes are skipped, so that a frame among them is lost
    Planted(
        "frame",
        "src/comms/frame.c",
        "    decoder->start += header_bytes;\n}",
        "    decoder->start += decoder->end - decoder->start < 12U ? header_bytes : 12U;\n}",
        "finding: not so: .*",
    ),
    # one byte more than fits is copied
    Planted(
        "frame",
        "src/comms/frame.c",
        "sizeof decoder->buffer - held;",
        "sizeof decoder->buffer - held + 1U;",
        "heap-buffer-overflow|global-buffer-overflow|runtime error|finding: not so: .*",
    ),
    # a position of NaN is not refused any more
    Planted(
        "interpreter",
        "src/flight/servo_outputs.c",
        "position >= -1.0F && position <= 1.0F",
        "!(position < -1.0F || position > 1.0F)",
        "every servo gets a position",
    ),
    # a servo that does not exist is accepted
    Planted(
        "interpreter",
        "src/flight/servo_outputs.c",
        "servo < board_servo_count",
        "servo <= board_servo_count",
        "index 20 out of bounds",
    ),
    # a mission with a missing waypoint is accepted
    Planted(
        "mission",
        "src/navigation/mission.c",
        "if (!mission->received[i])",
        "if (i == 0U && !mission->received[i])",
        "answered as the model says",
    ),
)


def fuzz(program: Path, target: str, arguments: list[str], log: Path) -> tuple[int, str]:
    """Run a target and return its exit code and what it printed."""
    environment = os.environ | {"ASAN_OPTIONS": "detect_leaks=0", "UBSAN_OPTIONS": "print_stacktrace=1"}
    command = [str(program), "-print_final_stats=1", f"-max_len={LONGEST_INPUT_BYTES[target]}", *arguments]
    with log.open("wb") as output:
        code = subprocess.run(command, stdout=output, stderr=subprocess.STDOUT, env=environment, check=False).returncode
    return code, log.read_text(encoding="utf-8", errors="replace")


def told(text: str, pattern: str) -> int:
    """Return the last number that `pattern` matches in a target's output, or 0."""
    found = re.findall(pattern, text)
    return int(found[-1]) if found else 0


def statistics(text: str) -> str:
    """Return runs, features and corpus in words."""
    edges, kept = told(text, r"cov: (\d+)"), told(text, r"corp: (\d+)/")
    return f"{told(text, RUNS_MADE)} runs, {edges} edges, {kept} inputs kept"


def look_for_findings(folder: Path, target: str, arguments: list[str], least_runs: int) -> Outcome:
    """Run one target on the sources as they are."""
    begun = time.monotonic()
    log = folder / f"{target}.log"
    findings = folder / "findings"
    findings.mkdir(exist_ok=True)
    code, text = fuzz(folder / f"fuzz_{target}", target, [f"-artifact_prefix={findings}/{target}-", *arguments], log)
    failure = ""
    if code != 0:
        failure = f"{text[-6000:]}\nThe input is in {findings}: run {folder}/fuzz_{target} with it as its argument."
    elif told(text, RUNS_MADE) < least_runs:
        failure = f"fewer than {least_runs} runs were made:\n{text[-2000:]}"
    return Outcome(target, statistics(text), failure, time.monotonic() - begun)


def short(folder: Path, target: str) -> Outcome:
    """Run the seeds and a fixed sequence of changes to them."""
    runs = SHORT_RUNS[target]
    return look_for_findings(folder, target, [f"-runs={runs}", "-seed=1", str(folder / "seeds" / target)], runs)


def long(folder: Path, target: str, options: argparse.Namespace) -> Outcome:
    """Continue from the inputs that were kept as interesting."""
    corpus = folder / "corpus" / target
    corpus.mkdir(parents=True, exist_ok=True)
    limit = f"-max_total_time={options.minutes * 60}" if options.minutes else f"-runs={options.runs}"
    least = 1 if options.minutes else options.runs
    return look_for_findings(folder, target, [limit, str(corpus), str(folder / "seeds" / target)], least)


def build_planted(folder: Path, bug: Planted, options: argparse.Namespace) -> Path:
    """Compile the target with the bug in a copy of its source; the sources stay as they are."""
    source = ROOT / bug.source
    text = source.read_text(encoding="utf-8")
    if text.count(bug.good) != 1:
        raise SystemExit(f"{bug.source} does not hold {bug.good!r} once: the bug cannot be planted")
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    copy = folder / source.name
    copy.write_text(text.replace(bug.good, bug.bad), encoding="utf-8")
    made = copy.with_suffix(".o")
    subprocess.run([*shlex.split(options.compile), "-c", str(copy), "-o", str(made)], cwd=ROOT, check=True)
    program = folder / f"fuzz_{bug.target}"
    # the changed object comes first, so that the linker does not take the unchanged one from the archive
    own = options.folder / "object" / "fuzz"
    objects = [made, own / f"fuzz_{bug.target}.o", own / "line_mutator.o", options.folder / "tested.a"]
    link = [*shlex.split(options.link), "-o", str(program), *map(str, objects), "-lm"]
    subprocess.run(link, cwd=ROOT, check=True)
    return program


def planted(number: int, options: argparse.Namespace) -> Outcome:
    """Plant one bug and check that the fuzzer finds it."""
    bug = PLANTED[number]
    begun = time.monotonic()
    folder = options.folder / "planted" / str(number)
    program = build_planted(folder, bug, options)
    seeds = options.folder / "seeds" / bug.target
    arguments = [f"-runs={PLANTED_RUNS}", "-seed=1", f"-artifact_prefix={folder}/", str(seeds)]
    code, text = fuzz(program, bug.target, arguments, folder / "log")
    found = re.search(bug.finding, text) if code != 0 else None
    failure = "" if found else f"not found in {PLANTED_RUNS} runs (exit code {code}):\n{text[-3000:]}"
    line = f"planted bug in {bug.source} found: {found.group(0) if found else 'no'}"
    return Outcome(f"{bug.target}: {bug.bad.strip().splitlines()[0]}", line, failure, time.monotonic() - begun)


def write_results(folder: Path, name: str, outcomes: list[Outcome]) -> None:
    """Write the outcomes as JUnit test cases."""
    suite = ET.Element("testsuite", name=f"fuzz {name}", tests=str(len(outcomes)))
    for outcome in outcomes:
        case = ET.SubElement(
            suite, "testcase", classname=f"fuzz.{name}", name=outcome.name, time=f"{outcome.seconds:.1f}"
        )
        if outcome.failure:
            ET.SubElement(case, "failure").text = "".join(c for c in outcome.failure if c.isprintable() or c == "\n")
    folder.mkdir(parents=True, exist_ok=True)
    ET.ElementTree(suite).write(folder / f"firmware-fuzz-{name}.xml", encoding="utf-8", xml_declaration=True)


def main() -> int:
    """Run the requested targets, two at a time."""
    parser = argparse.ArgumentParser()
    parser.add_argument("what", choices=["short", "long", "planted"])
    parser.add_argument("folder", type=lambda text: Path(text).resolve())
    parser.add_argument("--runs", type=int, default=1_000_000)
    parser.add_argument("--minutes", type=int, default=0)
    parser.add_argument("--results", default="")
    parser.add_argument("--compile", default="")
    parser.add_argument("--link", default="")
    options = parser.parse_args()
    with ThreadPoolExecutor(WORKERS) as pool:
        if options.what == "planted":
            jobs = [pool.submit(planted, number, options) for number in range(len(PLANTED))]
        elif options.what == "long":
            jobs = [pool.submit(long, options.folder, target, options) for target in LONGEST_INPUT_BYTES]
        else:
            jobs = [pool.submit(short, options.folder, target) for target in LONGEST_INPUT_BYTES]
        outcomes = [job.result() for job in jobs]
    for outcome in outcomes:
        print(f"fuzz {options.what} {outcome.name}: {outcome.line}, {outcome.seconds:.0f} s")
        if outcome.failure:
            print(outcome.failure, file=sys.stderr)
    if options.results:
        write_results(Path(options.results), options.what, outcomes)
    return 1 if any(outcome.failure for outcome in outcomes) else 0


if __name__ == "__main__":
    sys.exit(main())
