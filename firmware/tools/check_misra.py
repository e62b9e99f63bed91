"""Run cppcheck with its MISRA C:2012 addon over the sources, and compare its findings with MISRA.md.

Usage: check_misra.py CPPCHECK MISRA.md FOLDER... -- CPPCHECK_OPTION...

A row of a table in MISRA.md whose first cell is a rule's number or a check's name permits that rule in the files of its
second cell (patterns, `all` for every one). Fails on a finding that no row permits, on a row that permits nothing any
more, and when cppcheck said that it could not do its work.
"""

from __future__ import annotations

import fnmatch
import re
import subprocess
import sys
from collections import Counter
from dataclasses import dataclass
from pathlib import Path

TEMPLATE = "{file}:{line}:{id}:{message}"
FINDING = re.compile(r"(?P<file>[^:]+):(?P<line>\d+):(?P<id>[^:]+):(?P<message>.*)")
ROW = re.compile(r"\| *`?(?P<rule>[0-9]+\.[0-9]+|[a-zA-Z]+)`? *\| *(?P<files>[^|]+?) *\| *(?P<reason>[^|]+?) *\|")
CHECKS = "warning,style,performance,portability"
WORKERS = "2"


@dataclass(frozen=True)
class Deviation:
    """A rule that is not kept in some files; the table gives the reason."""

    rule: str
    patterns: tuple[str, ...]

    def permits(self, rule: str, file: str) -> bool:
        """Tell whether this row permits the finding."""
        return rule == self.rule and any(fnmatch.fnmatch(file, pattern) for pattern in self.patterns)


def read_deviations(path: Path) -> list[Deviation]:
    """Return the rows of the tables; a row without files or reason is an error."""
    deviations = []
    for line in path.read_text(encoding="utf-8").splitlines():
        row = ROW.fullmatch(line.strip())
        if row is None or row["rule"] in {"rule", "check"}:
            continue
        files = row["files"].replace("`", "")
        patterns = ("*",) if files == "all" else tuple(pattern.strip() for pattern in files.split(","))
        deviations.append(Deviation(row["rule"], patterns))
    return deviations


def run(cppcheck: str, folders: list[str], options: list[str]) -> list[re.Match[str]]:
    """Return the findings of cppcheck and its addon."""
    command = [cppcheck, "-q", "-j", WORKERS, "--std=c11", "--addon=misra", f"--enable={CHECKS}"]
    command += ["--suppress=missingIncludeSystem", f"--template={TEMPLATE}", "--error-exitcode=0", *options, *folders]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode != 0 or done.stdout.strip():
        raise SystemExit(f"cppcheck failed ({done.returncode}): {done.stdout}{done.stderr}")
    findings = [FINDING.fullmatch(line) for line in done.stderr.splitlines() if line.strip()]
    if None in findings:
        raise SystemExit(f"cppcheck said something else than findings:\n{done.stderr}")
    return [finding for finding in findings if finding is not None]


def main() -> int:
    """Print every finding without a permit and every permit without a finding; return the exit code."""
    split = sys.argv.index("--")
    cppcheck, table, *folders = sys.argv[1:split]
    deviations = read_deviations(Path(table))
    findings = run(cppcheck, folders, sys.argv[split + 1 :])
    used: Counter[Deviation] = Counter()
    refused = []
    for finding in findings:
        rule = finding["id"].removeprefix("misra-c2012-")
        permit = next((row for row in deviations if row.permits(rule, finding["file"])), None)
        if permit is None:
            refused.append(f"{finding['file']}:{finding['line']}: {finding['id']}: {finding['message']}")
        else:
            used[permit] += 1
    stale = [row for row in deviations if used[row] == 0]
    for line in sorted(set(refused)):
        print(line, file=sys.stderr)
    for row in stale:
        print(f"{table}: {row.rule} in {', '.join(row.patterns)}: nothing deviates any more", file=sys.stderr)
    # some deviations always exist, so no finding at all means that the addon did not run
    if refused or stale or not findings:
        print(f"misra: {len(set(refused))} findings without a deviation, {len(stale)} deviations without a finding")
        return 1
    print(f"misra: {sum(used.values())} places, all covered by the {len(deviations)} deviations of {Path(table).name}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
