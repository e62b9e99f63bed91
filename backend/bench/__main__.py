"""Run the measurements and print one table: `python -m bench [name ...]`; `besieged:pings` runs one part of one."""

from __future__ import annotations

import argparse
import importlib
import sys
from collections.abc import Sequence

from bench.table import Row, table

MODULES = (
    "decode",
    "damaged",
    "flights",
    "exports",
    "report",
    "latency",
    "tls",
    "cpu",
    "slow",
    "line",
    "hil",
    "control",
    "strangers",
    "shares",
    "terrain",
    "besieged",
    "kill",
    "plots",
    "page",
    "globe",
    "plots_http",
    "replay",
    "past",
    "flight",
    "board",
    "image",
)
"""Each is a module of this package with `run() -> list[Row]`, in the order of the table."""


def main(arguments: Sequence[str]) -> int:
    """Run the named measurements, all by default. A missed target is printed but does not fail the run."""
    parser = argparse.ArgumentParser(prog="bench", description=__doc__)
    parser.add_argument("names", nargs="*", metavar="name", help=f"which to run: {', '.join(MODULES)} (default: all)")
    chosen = parser.parse_args(arguments).names or MODULES
    unknown = sorted({name.partition(":")[0] for name in chosen} - set(MODULES))
    if unknown:
        parser.error(f"there is no measurement {', '.join(unknown)}; there are {', '.join(MODULES)}")
    rows: list[Row] = []
    for name in chosen:
        print(f"measuring {name} ...", file=sys.stderr, flush=True)
        module, _, part = name.partition(":")
        run = importlib.import_module(f"bench.{module}").run
        rows += run(part) if part else run()
    print(table(rows))
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
