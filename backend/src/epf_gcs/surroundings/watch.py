"""Looks at ground and fence of both aircraft twice a second, and tells the flight process what to raise alarms of."""

from __future__ import annotations

import asyncio
import math
from collections.abc import Callable, Mapping, Sequence
from typing import Any, Final, Literal, Protocol

import numpy as np

from epf_gcs.contract.base import Values
from epf_gcs.contract.notices import Notice, SurroundingsReport
from epf_gcs.contract.surroundings import AircraftAround, HeightSet, SurroundingsState, ThreatAhead, TrackPlace
from epf_gcs.errors import InvalidInputError
from epf_gcs.repeating import repeat
from epf_gcs.surroundings.aircraft import AircraftSurroundings, SurroundingsView, WatchChoice
from epf_gcs.surroundings.choice import SurroundingsChange, crossing
from epf_gcs.surroundings.ground import Ground, Tiles
from epf_gcs.surroundings.kept import OFF, KeptSurroundings
from epf_gcs.surroundings.motion import Fix
from epf_gcs.surroundings.threats import Threat
from epf_gcs.units import ft_from_m, m_from_ft, mps_from_kt

_TICK_S: Final = 0.2
_LOOK_S: Final = 0.5
_PATH_EVERY: Final = 5

Which = Literal["flight", "hil"]


class Mirror(Protocol):
    """What is known of the vehicle (`web.vehicle.mirror.VehicleMirror`)."""

    def newest(self, topic: str) -> Values | None:
        """The newest values of a topic, however old."""

    def newest_at_s(self, topic: str) -> float | None:
        """Unix time of the newest values of a topic."""

    def is_live(self, topic: str) -> bool:
        """Whether they are not stale."""


class Surroundings:
    """`notice`: tells the flight process. Heights are read in worker processes; what they are used for takes well under
    a millisecond of the web process's loop."""

    def __init__(
        self,
        mirror: Mirror,
        tiles: Tiles,
        kept: KeptSurroundings,
        now_s: Callable[[], float],
        notice: Callable[[Notice], None],
    ) -> None:
        self._mirror = mirror
        self._ground = Ground(tiles)
        self._kept = kept
        self._now_s = now_s
        self._notice = notice
        self._wanted = WatchChoice()
        self._aircraft: dict[Which, AircraftSurroundings] = {
            "flight": AircraftSurroundings(),
            "hil": AircraftSurroundings(),
        }
        self._seen: dict[Which, SurroundingsView] = {"flight": SurroundingsView(), "hil": SurroundingsView()}
        self._live: set[Which] = set()
        self.choice = OFF
        # Whether there is a choice that cannot be read.
        self._is_unknown = False
        # Whose ground was seen since the choice was made.
        self._saw_ground: set[Which] = set()

    async def run(self) -> None:
        """Look, forever."""
        choice = await asyncio.to_thread(self._kept.read)
        self._is_unknown = choice is None
        self._take(choice or OFF)
        async with asyncio.TaskGroup() as tasks:
            tasks.create_task(self._ground.run(), name="heights")
            tasks.create_task(self._repeat(), name="surroundings")

    async def choose(self, change: SurroundingsChange) -> None:
        """Keep the choice and watch by it; else nothing changes. Raises InvalidInputError for a fence that crosses
        itself, ConflictError if the disk does not take it."""
        sides = crossing(change)
        if sides is not None:
            first, second = sides
            raise InvalidInputError(
                "fence_crosses",
                f"The fence crosses itself: sides {first} and {second} meet, so it is not clear what is inside. Move a "
                "corner.",
                first=first,
                second=second,
            )
        await asyncio.to_thread(self._kept.write, change)
        self._is_unknown = False
        self._take(change)
        self.look()

    async def ground_ft(self, places_deg: Sequence[tuple[float, float]]) -> tuple[list[float | None], list[HeightSet]]:
        """The ground's altitude below places of latitude and longitude, feet above the sea, None where not known; and
        the sets that it is of."""
        latitude_deg, longitude_deg = np.array(places_deg, dtype=np.float64).reshape(-1, 2).T
        heights_m = await self._ground.read(latitude_deg, longitude_deg)
        ground_ft = [None if math.isnan(height_m) else ft_from_m(height_m) for height_m in heights_m.tolist()]
        return ground_ft, self._ground.sets(latitude_deg, longitude_deg)

    def state(self) -> SurroundingsState:
        """For the status: what was seen last."""
        return SurroundingsState(self._shown("flight"), self._shown("hil"))

    def gather(self) -> None:
        """Take the newest positions."""
        gps = self._mirror.newest("gps") if self._mirror.is_live("gps") else None
        simulator = self._mirror.newest("simulator") if self._mirror.is_live("simulator") else None
        self._add("flight", _gps_fix(gps, self._mirror.newest_at_s("gps")))
        self._add("hil", _simulator_fix(simulator, self._mirror.newest_at_s("simulator")))

    def look(self) -> None:
        """See what is around, and say what alarms shall be raised of."""
        now_s = self._now_s()
        for which, aircraft in self._aircraft.items():
            self._seen[which] = (
                aircraft.look(now_s, self._wanted, self._ground.heights, has_heights=self._ground.has_heights)
                if which in self._live
                else aircraft.unseen(now_s)
            )
        # Also while nothing is to be watched: the flight process tells a station that has gone by its silence.
        self._notice(SurroundingsReport(_findings(self._seen), self._watched(), self._blind()))

    async def _repeat(self) -> None:
        loop = asyncio.get_running_loop()
        due_s = loop.time()

        def tick() -> None:
            nonlocal due_s
            self.gather()
            if loop.time() >= due_s:
                due_s = loop.time() + _LOOK_S
                self.look()

        await repeat(_TICK_S, "the watch over ground and fence", tick)

    def _shown(self, which: Which) -> AircraftAround:
        seen, fix = self._seen[which], self._aircraft[which].newest
        if seen.ground_m is None or fix is None:
            return _around(seen, [])
        return _around(seen, self._ground.sets(np.array([fix.latitude_deg]), np.array([fix.longitude_deg])))

    def _watched(self) -> list[str]:
        if self._is_unknown:
            return ["unknown"]
        return [what for what, is_on in (("terrain", self._wanted.terrain), ("fence", self._wanted.fence)) if is_on]

    def _blind(self) -> list[str]:
        """What was seen until now and is not any more: the map was removed or left, or its workers do not answer."""
        self._saw_ground |= {which for which, seen in self._seen.items() if seen.ground_m is not None}
        lost = (which for which in self._saw_ground & self._live if self._seen[which].blind is not None)
        return ["terrain"] if self._wanted.terrain and any(lost) else []

    def _add(self, which: Which, fix: Fix | None) -> None:
        aircraft = self._aircraft[which]
        if fix is None:
            self._live.discard(which)
            return
        self._live.add(which)
        if fix.t_s != aircraft.newest_s:
            aircraft.add(fix)

    def _take(self, choice: SurroundingsChange) -> None:
        self.choice = choice
        self._saw_ground.clear()
        self._wanted = WatchChoice(
            terrain=choice.terrain_on,
            margin_m=m_from_ft(choice.margin_ft),
            fence=choice.fence_on,
            corners_deg=tuple((corner.latitude_deg, corner.longitude_deg) for corner in choice.corners),
            ceiling_m=None if choice.ceiling_ft is None else m_from_ft(choice.ceiling_ft),
            fence_margin_m=m_from_ft(choice.fence_margin_ft),
        )


def _gps_fix(gps: Values | None, t_s: float | None) -> Fix | None:
    """The board's position; None without a valid one."""
    if gps is None or t_s is None or gps.get("valid") is not True or not gps.get("fix"):
        return None
    place = _numbers(gps, "latitude_deg", "longitude_deg", "altitude_m")
    if place is None:
        return None
    moving = _numbers(gps, "speed_kt", "heading_deg")
    if moving is None:
        return Fix(t_s, place[0], place[1], place[2])
    speed_mps, track = mps_from_kt(moving[0]), math.radians(moving[1])
    return Fix(t_s, place[0], place[1], place[2], speed_mps * math.sin(track), speed_mps * math.cos(track))


def _simulator_fix(values: Values | None, t_s: float | None) -> Fix | None:
    place = None if values is None else _numbers(values, "latitude_deg", "longitude_deg", "altitude_msl_ft")
    return None if place is None or t_s is None else Fix(t_s, place[0], place[1], m_from_ft(place[2]))


def _numbers(values: Values, *names: str) -> list[float] | None:
    found = [values.get(name) for name in names]
    numbers = [float(value) for value in found if isinstance(value, int | float)]
    return numbers if len(numbers) == len(names) and all(map(math.isfinite, numbers)) else None


def _findings(seen: dict[Which, SurroundingsView]) -> list[Mapping[str, Any]]:
    """One of each kind: where both aircraft have it, that of the board's."""
    found: dict[str, dict[str, Any]] = {}
    for which, one in seen.items():
        if one.terrain is not None:
            found.setdefault("terrain_ahead", _finding("terrain_ahead", which, one.terrain))
        if one.fence is not None:
            name = "fence_left" if one.outside else "fence_ahead"
            found.setdefault(name, _finding(name, which, one.fence))
    return list(found.values())


def _finding(name: str, which: Which, threat: Threat) -> dict[str, Any]:
    return {"id": name, "aircraft": which, "what": threat.what, "in_s": threat.in_s}


def _around(seen: SurroundingsView, heights: list[HeightSet]) -> AircraftAround:
    path = seen.path
    every = slice(None, None, _PATH_EVERY)
    places = [] if path is None else zip(path.latitude_deg[every], path.longitude_deg[every], strict=True)
    return AircraftAround(
        blind=seen.blind,
        ground_ft=None if seen.ground_m is None else ft_from_m(seen.ground_m),
        height_ft=None if seen.height_m is None else ft_from_m(seen.height_m),
        terrain=_threat(seen.terrain),
        fence=_threat(seen.fence),
        outside=seen.outside,
        heights=heights,
        path=[TrackPlace(float(north), float(east)) for north, east in places],
    )


def _threat(threat: Threat | None) -> ThreatAhead | None:
    if threat is None:
        return None
    return ThreatAhead(
        threat.what, threat.in_s, threat.latitude_deg, threat.longitude_deg, ft_from_m(threat.altitude_m)
    )
