"""`python -m epf_gcs.rehearsal`: flies one plan, told by a line on standard input, and ends.

It answers with the places that it flew over, is told the ground below them by a second line, and ends with what it
found. It has a low priority and little memory and time: somebody waits for it, the flight comes first.
"""

from __future__ import annotations

import sys
from typing import Any, Final

import orjson

from epf_gcs.codec.tables import Waypoint
from epf_gcs.rehearsal.findings import Bounds, findings
from epf_gcs.rehearsal.flight_model import Start, SteadyWind
from epf_gcs.rehearsal.flown_plan import fly, start_at_first
from epf_gcs.system.limits import limit_memory, limit_time
from epf_gcs.system.priority import WAITED_FOR, be_nice, read_last
from epf_gcs.workers.lines import tell

_MOST_MEMORY_BYTES: Final = 1_000_000_000
_MOST_CPU_S: Final = 10


def main() -> int:
    """Returns the exit code."""
    be_nice(WAITED_FOR)
    read_last()
    limit_memory(_MOST_MEMORY_BYTES)
    limit_time(_MOST_CPU_S)
    order = _hear()
    waypoints = [Waypoint(**waypoint) for waypoint in order["waypoints"]]
    start = start_at_first(waypoints[order["first"] :]) if order["start"] is None else Start(**order["start"])
    flown = fly(waypoints, order["first"], start, SteadyWind(**order["wind"]))
    tell({"places": [(sample.latitude_deg, sample.longitude_deg) for sample in flown.samples]})
    bounds = Bounds(**{**order["bounds"], "corners_deg": tuple(map(tuple, order["bounds"]["corners_deg"]))})
    found = findings(waypoints, flown, _hear()["ground_ft"], bounds)
    tell({"done": {"time_s": flown.time_s, "last": flown.legs[-1].row, "findings": [one._asdict() for one in found]}})
    return 0


def _hear() -> dict[str, Any]:
    line: dict[str, Any] = orjson.loads(sys.stdin.buffer.readline())
    return line


if __name__ == "__main__":
    sys.exit(main())
