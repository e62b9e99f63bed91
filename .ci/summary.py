"""Print one plain line of what passed, from the JUnit files that the test runners wrote.

Usage: summary.py FOLDER. Fails when a runner left no file or a file without a test, so that a suite
which did not run cannot pass for one that did.
"""

from __future__ import annotations

import sys
from pathlib import Path
from xml.etree import ElementTree as ET

SUITES = ("protocol", "firmware", "backend", "frontend", "e2e")


def count(paths: list[Path]) -> tuple[int, int, int]:
    """Return (passed, failed, skipped) over the test cases of these files."""
    passed = failed = skipped = 0
    for path in paths:
        for case in ET.parse(path).iter("testcase"):  # noqa: S314 (written by our own runners)
            kinds = {child.tag for child in case}
            if kinds & {"failure", "error"}:
                failed += 1
            elif "skipped" in kinds:
                skipped += 1
            else:
                passed += 1
    return passed, failed, skipped


def main(folder: Path) -> int:
    """Print a line for each suite and the sum; return the exit code."""
    totals = [0, 0, 0]
    complete = True
    for suite in SUITES:
        counts = count(sorted(folder.glob(f"{suite}*.xml")))
        if sum(counts) == 0:
            print(f"{suite}: no test was run")
            complete = False
        else:
            print(f"{suite}: {counts[0]} passed, {counts[1]} failed, {counts[2]} skipped")
        totals = [total + new for total, new in zip(totals, counts, strict=True)]
    print(f"{totals[0]} passed, {totals[1]} failed, {totals[2]} skipped")
    return 0 if complete and totals[1] == 0 else 1


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1])))
