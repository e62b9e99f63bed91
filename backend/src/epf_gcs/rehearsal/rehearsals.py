"""Rehearsals: each flown by a program of its own, with the ground below it from the station's heights."""

from __future__ import annotations

import asyncio
import math
import sys
from collections.abc import Sequence
from dataclasses import asdict, dataclass
from typing import Any, Final, Literal

import numpy as np
import orjson
import structlog

from epf_gcs.codec.tables import Waypoint
from epf_gcs.contract.surroundings import HeightSet
from epf_gcs.errors import ConflictError
from epf_gcs.rehearsal.findings import Bounds, Finding
from epf_gcs.rehearsal.flight_model import Start, SteadyWind
from epf_gcs.surroundings.ground import Ground, Tiles, merged
from epf_gcs.units import ft_from_m
from epf_gcs.workers.child import child

LONGEST_S: Final = 9.0
"""A rehearsal that takes longer is given up: whoever sends a plan waits for it."""
_PROGRAM: Final = "epf_gcs.rehearsal"
_MOST_AT_ONCE: Final = 2
_LONGEST_LINE: Final = 8_000_000
# Fewer tiles of the ground than are kept in memory: a flight of this many seconds crosses no more.
_AT_ONCE: Final = 500

GroundKnown = Literal["whole", "part", "none"]

log = structlog.get_logger("web")


@dataclass(frozen=True, slots=True)
class RehearsalOrder:
    """A plan from its waypoint `first` on. `start`: None begins over that waypoint."""

    waypoints: Sequence[Waypoint]
    first: int
    start: Start | None
    wind: SteadyWind
    bounds: Bounds


@dataclass(frozen=True, slots=True)
class Rehearsal:
    """What came of it: `time_s` until waypoint `last` was reached, or could not be. `ground`: how much of the ground
    below the flight is known; what is not known was not judged. `heights`: the sets of terrain that it is known by."""

    time_s: float
    last: int
    ground: GroundKnown
    heights: list[HeightSet]
    findings: list[Finding]


class Rehearsals:
    """Owned by the event loop."""

    def __init__(self, tiles: Tiles) -> None:
        self._tiles = tiles
        self._running = 0

    async def fly(self, order: RehearsalOrder) -> Rehearsal:
        """Fly a plan. Raises ConflictError if it was not flown: never a result that only looks like one."""
        if self._running >= _MOST_AT_ONCE:
            raise ConflictError(
                "rehearsal_busy", "Other plans are being flown in the model: try again in some seconds."
            )
        self._running += 1
        try:
            async with asyncio.timeout(LONGEST_S):
                return await self._work(order)
        except TimeoutError:
            raise ConflictError(
                "rehearsal_late",
                f"The plan was not flown in the model: it took more than {LONGEST_S:.0f} s on this computer.",
                seconds=LONGEST_S,
            ) from None
        except (OSError, ValueError, KeyError) as error:
            log.error("a rehearsal failed", reason=str(error))
            raise ConflictError(
                "rehearsal_failed", "The plan was not flown in the model: its program failed."
            ) from error
        finally:
            self._running -= 1

    async def _work(self, order: RehearsalOrder) -> Rehearsal:
        pipe = asyncio.subprocess.PIPE
        async with child(sys.executable, "-m", _PROGRAM, stdin=pipe, stdout=pipe, limit=_LONGEST_LINE) as process:
            flown = await _ask(process, asdict(order))
            ground_ft, heights = await self._ground_ft(flown["places"])
            done = (await _ask(process, {"ground_ft": ground_ft}))["done"]
        found = [Finding(one["code"], one["row"], one["params"]) for one in done["findings"]]
        return Rehearsal(done["time_s"], done["last"], _known(ground_ft), heights, found)

    async def _ground_ft(self, places_deg: Sequence[tuple[float, float]]) -> tuple[list[float | None], list[HeightSet]]:
        """Feet above the sea, None where not known; and the sets that they are of."""
        # Its own: the tiles around the aircraft that fly stay where they are.
        ground = Ground(self._tiles)
        found: list[float | None] = []
        sets: list[HeightSet] = []
        for begin in range(0, len(places_deg), _AT_ONCE):
            latitude_deg, longitude_deg = np.array(places_deg[begin : begin + _AT_ONCE], dtype=np.float64).T
            heights_m = await ground.read(latitude_deg, longitude_deg)
            found += [None if math.isnan(height_m) else ft_from_m(height_m) for height_m in heights_m.tolist()]
            sets += ground.sets(latitude_deg, longitude_deg)
        return found, merged(sets)


async def _ask(process: asyncio.subprocess.Process, asked: dict[str, Any]) -> dict[str, Any]:
    """One line to the program, one from it. Raises ValueError if it ended without one."""
    if process.stdin is None or process.stdout is None:
        raise ValueError("the program has no pipes")
    process.stdin.write(orjson.dumps(asked) + b"\n")
    await process.stdin.drain()
    answer: dict[str, Any] = orjson.loads(await process.stdout.readline())
    return answer


def _known(ground_ft: Sequence[float | None]) -> GroundKnown:
    if all(height_ft is None for height_ft in ground_ft):
        return "none"
    return "part" if any(height_ft is None for height_ft in ground_ft) else "whole"
