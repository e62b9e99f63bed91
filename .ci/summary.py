"""Print what failed and why, what was skipped, and one plain line of what passed, from the test runners' JUnit files.

Usage: summary.py FOLDER [LIST]. Says what each part took (`timed.py`). Fails when a part or a test failed, when a
runner left no file or a file without a test, so that a suite which did not run cannot pass for one that did, and when a
test was skipped that LIST (`skips.txt` beside this program) does not allow.
"""

from __future__ import annotations

import re
import sys
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass, field
from fnmatch import fnmatchcase
from pathlib import Path
from xml.etree import ElementTree as ET

from timed import PASSED

SUITES = ("ci", "protocol", "firmware", "backend", "frontend", "e2e")
_MOST_LINES = 24
_MOST_WIDE = 200
# XML has no escape character, so that reporters may leave it out.
_COLOURS = re.compile(r"\x1b?\[[0-9;]*m")


class BadListError(Exception):
    """A line of the list that says not all of it."""


@dataclass
class Counts:
    """What became of the tests of a suite. `failed`: names and what was said; `skipped`: names and reasons."""

    passed: int = 0
    failed: list[tuple[str, str]] = field(default_factory=list)
    skipped: list[tuple[str, str]] = field(default_factory=list)

    @property
    def total(self) -> int:
        """How many tests there are."""
        return self.passed + len(self.failed) + len(self.skipped)

    def __str__(self) -> str:
        return f"{self.passed} passed, {len(self.failed)} failed, {len(self.skipped)} skipped"


def count(paths: list[Path]) -> Counts:
    """The test cases of these files."""
    found = Counts()
    for path in paths:
        for case in ET.parse(path).iter("testcase"):  # noqa: S314 (written by our own runners)
            kinds = {child.tag: child for child in case}
            name = f"{case.get('classname', '')}::{case.get('name', '')}"
            faults = [kinds[kind] for kind in ("failure", "error") if kind in kinds]
            if faults:
                found.failed.append((name, f"{faults[0].get('message') or ''}\n{faults[0].text or ''}"))
            elif "skipped" in kinds:
                found.skipped.append((name, kinds["skipped"].get("message") or "no reason given"))
            else:
                found.passed += 1
    return found


def allowed(text: str) -> Iterator[tuple[str, str]]:
    """Suite and pattern of each line of the list. Raises BadListError."""
    for number, line in enumerate(text.splitlines(), 1):
        words = line.split(maxsplit=2)
        if not words or words[0].startswith("#"):
            continue
        if len(words) < 3 or words[0] not in SUITES:
            raise BadListError(f"line {number} of the list of skips does not say suite, test and reason: {line}")
        yield words[0], words[1]


def tell_failures(suite: str, failed: list[tuple[str, str]]) -> None:
    """Print the failed tests of a suite, each with the beginning of what was said."""
    for name, said in failed:
        print(f"  {suite}, FAILED: {name}")
        lines = [line.rstrip() for line in _COLOURS.sub("", said).splitlines() if line.strip()]
        for line in lines[:_MOST_LINES]:
            print(f"    {line[:_MOST_WIDE]}")
        if len(lines) > _MOST_LINES:
            print(f"    and {len(lines) - _MOST_LINES} more lines")


def tell_skips(suite: str, skipped: list[tuple[str, str]], patterns: list[str]) -> bool:
    """Print the skips of a suite by reason; returns whether the list allows all of them."""
    lines: Counter[str] = Counter()
    good = True
    for name, reason in skipped:
        is_allowed = any(fnmatchcase(name, pattern) for pattern in patterns)
        good = good and is_allowed
        lines[f"{'allowed' if is_allowed else 'NOT ALLOWED'}: {reason}"] += 1
    for line, times in lines.items():
        print(f"  {suite}, {times} skipped, {line}")
    return good


def tell_parts(folder: Path) -> bool:
    """Print what each part took, the longest first; returns whether all of them passed."""
    notes = [(path.stem, *path.read_text(encoding="utf-8").split()) for path in folder.glob("*.part")]
    for part, ended, took_s, used_s in sorted(notes, key=lambda note: -int(note[2])):
        words = f"{int(took_s) / 60:.1f} min, {int(used_s) / 60:.1f} min of processor time"
        print(f"{part}: {'' if ended == PASSED else f'{ended.upper()} '}{words}")
    return all(ended == PASSED for _, ended, *_ in notes)


def main(folder: Path, listed: Path) -> int:
    """Print a line for each part, each suite, and the sum; return the exit code."""
    may_skip = list(allowed(listed.read_text(encoding="utf-8")))
    sums = Counts()
    good = tell_parts(folder)
    for suite in SUITES:
        counts = count(sorted(folder.glob(f"{suite}*.xml")))
        print(f"{suite}: {counts if counts.total else 'no test was run'}")
        tell_failures(suite, counts.failed)
        good = good and counts.total > 0 and not counts.failed
        good = tell_skips(suite, counts.skipped, [pattern for of, pattern in may_skip if of == suite]) and good
        sums = Counts(sums.passed + counts.passed, sums.failed + counts.failed, sums.skipped + counts.skipped)
    print(f"{sums}{'' if good else ': NOT all that has to pass has passed'}")
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1]), Path(sys.argv[2]) if len(sys.argv) > 2 else Path(__file__).with_name("skips.txt")))
