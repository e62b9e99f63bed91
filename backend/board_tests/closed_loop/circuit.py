"""The Gando circuit in calm air, flown once for all tests that look at it."""

from __future__ import annotations

import fcntl
import pickle
from pathlib import Path
from typing import Final, NamedTuple

from board_tests.closed_loop.manoeuvres import fly_route
from epf_gcs.lab.closed_loop import ClosedLoop, Sample
from epf_gcs.simulator.simulation import SimulationOptions

CALM: Final = SimulationOptions()
LONGEST_S: Final = 800.0


class Circuit(NamedTuple):
    """What came of the flight: each frame's sample and datagram, and what was said of crashes."""

    samples: list[Sample]
    bytes_to_station: list[bytes]
    crashes: list[str]


def flown_once(folder: Path) -> Circuit:
    """Flown by whichever process asks first; the others wait for it and read it from the folder that they share."""
    kept = folder / "circuit.pickle"
    with (folder / "circuit.lock").open("w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        if kept.exists():
            return Circuit(*pickle.loads(kept.read_bytes()))  # noqa: S301 - this very run wrote it
        with ClosedLoop(CALM) as loop:
            fly_route(loop, "gando", LONGEST_S)
            flown = Circuit(loop.samples, loop.bytes_to_station, loop.crashes)
        kept.write_bytes(pickle.dumps(tuple(flown)))
        return flown
