"""`python -m epf_gcs.flights VERB ...`: the worker programs of the library, started by the web process.

Each verb is a module with `run(arguments, say)`, loaded only when it is asked for. `serve` speaks another way: see
`serve.py`.
"""

from __future__ import annotations

import os
import sys
from importlib import import_module
from typing import Final

# Before numpy is loaded: its threads would take the second core too, and wait for each other.
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

from epf_gcs.flights.worker import work

VERBS: Final = {
    "backup": "epf_gcs.flights.backup_verb",
    "export": "epf_gcs.flights.export.verb",
    "import": "epf_gcs.flights.importing",
    "index": "epf_gcs.flights.index",
    "pack": "epf_gcs.flights.pack",
    "report": "epf_gcs.flights.report.report",
}


def main(arguments: list[str]) -> int:
    """Run one verb; returns the exit code."""
    if not arguments or arguments[0] not in (*VERBS, "serve"):
        print(f"usage: python -m epf_gcs.flights {'|'.join((*VERBS, 'serve'))} ...", file=sys.stderr)
        return 2
    verb, *rest = arguments
    if verb == "serve":
        from epf_gcs.flights.serve import main as serve  # noqa: PLC0415 - loads the query engine

        return serve(rest)
    return work(import_module(VERBS[verb]).run, rest)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
