"""The suites that ship, and a board's line held against its protocol, as commands run them."""

from __future__ import annotations

import os
from collections.abc import Sequence
from importlib.util import find_spec
from pathlib import Path
from typing import Final

from epf_gcs.lab.conformance import Outcome, conform
from epf_gcs.lab.errors import LabError
from epf_gcs.lab.peer import wire

_FOLDER: Final = Path(__file__).parent / "suites"
_NAMED: Final = {path.stem.removeprefix("test_"): path for path in sorted(_FOLDER.glob("test_*.py"))}
SUITES: Final = tuple(_NAMED)
"""Their names."""


def run_suites(names: Sequence[str], seeds: int, laws: Path | None, junit: Path | None) -> int:
    """Run suites, all without names; returns pytest's exit code. Raises LabError for an unknown name."""
    if find_spec("pytest") is None:
        raise LabError("the suites need pytest: pip install pytest")
    unknown = [name for name in names if name not in _NAMED]
    if unknown:
        raise LabError(f"there is no suite {', '.join(unknown)}: choose of {', '.join(SUITES)}")
    import pytest  # noqa: PLC0415 - whoever flies without tests needs none of it

    # The settings of the folder in which this is typed are of other tests.
    options = ["-q", "-c", os.devnull, "--rootdir", str(_FOLDER), "--import-mode=importlib", "-p", "no:cacheprovider"]
    options += ["--figures", f"--seeds={seeds}"]
    options += [] if laws is None else [f"--laws={laws.absolute()}"]
    options += [] if junit is None else [f"--junitxml={junit}"]
    return int(pytest.main([*options, *(str(_NAMED[name]) for name in names or SUITES)]))


def conformance_of(url: str, patience_s: float) -> list[Outcome]:
    """Hold the board at an address against the page of its protocol. Raises LabError where there is no line."""
    line = wire(url)
    try:
        return list(conform(line, patience_s))
    finally:
        line.close()
