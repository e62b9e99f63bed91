"""Run a part of `make test` to its end, and note in the results how it ended and what it took.

Usage: timed.py FOLDER PART COMMAND... Its own exit code is 0 whatever becomes of the part, so that the other parts come
too: the summary says which of them failed.
"""

from __future__ import annotations

import resource
import subprocess
import sys
import time
from pathlib import Path

FAILED, PASSED, UNENDED = "failed", "passed", "unended"


def main(folder: Path, part: str, command: list[str]) -> int:
    """Note: how it ended, its seconds by the clock and of the processor. Returns the exit code."""
    note = folder / f"{part}.part"
    folder.mkdir(parents=True, exist_ok=True)
    # What stays where the machine or the user ends all of it.
    note.write_text(f"{UNENDED} 0 0\n", encoding="utf-8")
    began_s = time.monotonic()
    code = subprocess.run(command, check=False).returncode
    took_s = time.monotonic() - began_s
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    ended = FAILED if code else PASSED
    note.write_text(f"{ended} {took_s:.0f} {used.ru_utime + used.ru_stime:.0f}\n", encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1]), sys.argv[2], sys.argv[3:]))
