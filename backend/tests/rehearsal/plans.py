"""Plans over a coast with hills, as they are drawn: twenty good ones, and twenty with one fault each."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import Final

from epf_gcs.codec.messages_gen import ROUTES
from epf_gcs.codec.tables import Waypoint
from epf_gcs.earth import M_PER_DEG
from epf_gcs.rehearsal.findings import Bounds, Finding, FindingCode, findings
from epf_gcs.rehearsal.flight_model import Start, SteadyWind
from epf_gcs.rehearsal.flown_plan import fly, start_at_first

HOME_DEG: Final = (27.9, -15.4)
CALM: Final = SteadyWind()
OPEN: Final = Bounds()

Leg = tuple[float, float] | tuple[float, float, float] | tuple[float, float, float, float]
Ground = Callable[[float, float], float | None]


def place(north_m: float, east_m: float) -> tuple[float, float]:
    """Latitude and longitude so far from home."""
    across = math.cos(math.radians(HOME_DEG[0]))
    return HOME_DEG[0] + north_m / M_PER_DEG, HOME_DEG[1] + east_m / (M_PER_DEG * across)


def plan(*points: Leg, altitude_ft: float = 1000.0, speed_kt: float = 55.0) -> list[Waypoint]:
    """Waypoints by metres north and east of home, and where it differs, altitude and speed."""
    return [
        Waypoint(
            *place(point[0], point[1]),
            point[2] if len(point) > 2 else altitude_ft,
            point[3] if len(point) > 3 else speed_kt,
        )
        for point in points
    ]


def at(
    north_m: float, east_m: float, altitude_ft: float = 1000.0, track_deg: float = 0.0, speed_kt: float = 55.0
) -> Start:
    return Start(*place(north_m, east_m), altitude_ft, track_deg, speed_kt)


def hill(north_m: float, east_m: float, top_ft: float, radius_m: float = 400.0) -> Ground:
    """A flat coast at 50 ft with one cone."""

    def ground_ft(latitude_deg: float, longitude_deg: float) -> float:
        top_deg = place(north_m, east_m)
        away_m = math.hypot(
            (latitude_deg - top_deg[0]) * M_PER_DEG,
            (longitude_deg - top_deg[1]) * M_PER_DEG * math.cos(math.radians(HOME_DEG[0])),
        )
        return 50.0 + max(0.0, (top_ft - 50.0) * (1.0 - away_m / radius_m))

    return ground_ft


def box(north_m: float, south_m: float, east_m: float, west_m: float) -> tuple[tuple[float, float], ...]:
    """Corners of a fence, by its sides."""
    return place(north_m, west_m), place(north_m, east_m), place(south_m, east_m), place(south_m, west_m)


@dataclass(frozen=True, slots=True)
class Drawn:
    """A plan with its surroundings. `fault`: what is to be found, and on the leg to which waypoint, from 0."""

    name: str
    waypoints: Sequence[Waypoint]
    start: Start | None = None
    wind: SteadyWind = CALM
    ground: Ground = field(default=lambda _latitude_deg, _longitude_deg: 50.0)
    bounds: Bounds = OPEN
    fault: tuple[FindingCode, int] | None = None

    def found(self) -> list[Finding]:
        """What its rehearsal finds."""
        flown = fly(self.waypoints, 0, self.start or start_at_first(self.waypoints), self.wind)
        ground_ft = [self.ground(sample.latitude_deg, sample.longitude_deg) for sample in flown.samples]
        return findings(self.waypoints, flown, ground_ft, self.bounds)


SQUARE: Final = plan((0, 0), (2000, 0), (2000, 2000), (0, 2000), (0, 0))
STRAIGHT: Final = plan((0, 0), (3000, 0), (6000, 0), (9000, 0))
# To the right: the way back lies a little to the east.
REVERSAL: Final = plan((0, 0), (3000, 0), (-500, 200), (-2000, 200))
ZIGZAG: Final = plan(*((1000.0 * step, 700.0 * (step % 2)) for step in range(20)))
ROUTES_FLOWN: Final = {name: route.waypoints for name, route in ROUTES.items()}
RUNWAY: Final = at(-2500, 0, 60.0, 0.0, 0.0)

GOOD: Final = (
    *(Drawn(f"route {name}", waypoints) for name, waypoints in ROUTES_FLOWN.items()),
    Drawn("gando in 20 kt from the north-west", ROUTES_FLOWN["gando"], wind=SteadyWind(330, 20)),
    Drawn("round the island in 15 kt", ROUTES_FLOWN["ruta_isla"], wind=SteadyWind(240, 15)),
    Drawn("vuelo in 25 kt from the east", ROUTES_FLOWN["vuelo"], wind=SteadyWind(90, 25)),
    Drawn("a square", SQUARE),
    Drawn(
        "a square in 20 kt, inside its fence",
        SQUARE,
        wind=SteadyWind(45, 20),
        bounds=Bounds(box(2600, -600, 2600, -600)),
    ),
    Drawn("twenty legs to and fro", ZIGZAG),
    Drawn("twenty legs to and fro in 15 kt", ZIGZAG, wind=SteadyWind(200, 15)),
    Drawn("from the runway", STRAIGHT, RUNWAY, bounds=Bounds(margin_ft=150.0)),
    Drawn("from the other side of the field", SQUARE, at(3000, -3000, 1500.0, 200.0)),
    Drawn("under the ceiling", STRAIGHT, bounds=Bounds(ceiling_ft=1000.0)),
    Drawn("over a hill with room", STRAIGHT, ground=hill(4500, 0, 700.0), bounds=Bounds(margin_ft=200.0)),
    Drawn("past a hill", STRAIGHT, ground=hill(4500, 800, 2000.0), bounds=Bounds(margin_ft=200.0)),
    Drawn(
        "climbing 300 ft a leg", plan((0, 0, 500), (2000, 0, 800), (2000, 2000, 1100), (0, 2000, 1400), (0, 0, 1700))
    ),
    Drawn("down to the field", plan((0, 0, 1500), (3000, 0, 1000), (6000, 0, 600), (9000, 0, 300))),
    Drawn("a battery that lasts", SQUARE, bounds=Bounds(endurance_s=400.0)),
    Drawn("slow and fast", plan((0, 0, 1000, 40), (3000, 0, 1000, 65), (6000, 1000, 1000, 45), (9000, 0, 1000, 70))),
)

FAULTY: Final = (
    Drawn("a hill on the leg", STRAIGHT, ground=hill(4500, 0, 1300.0), fault=("meets_ground", 2)),
    Drawn(
        "a hill under the line down",
        plan((0, 0, 1500), (2000, 0, 1500), (6000, 0, 500), (8000, 0, 500)),
        ground=hill(4500, 0, 750.0),
        fault=("meets_ground", 2),
    ),
    Drawn("a hill beside a turn back", REVERSAL, ground=hill(2900, 350, 1600.0, 200.0), fault=("meets_ground", 2)),
    Drawn(
        "a hill that the last circle meets", STRAIGHT, ground=hill(9250, 0, 1800.0, 300.0), fault=("meets_ground", 3)
    ),
    Drawn(
        "less than the margin over a hill",
        STRAIGHT,
        ground=hill(4500, 0, 900.0),
        bounds=Bounds(margin_ft=150.0),
        fault=("low_ground", 2),
    ),
    Drawn("a corner outside the fence", SQUARE, bounds=Bounds(box(2600, -600, 1500, -600)), fault=("leaves_fence", 2)),
    Drawn(
        "a turn back that swings over the fence",
        REVERSAL,
        bounds=Bounds(box(3500, -2600, 250, -600)),
        fault=("leaves_fence", 2),
    ),
    Drawn(
        "the last circle leaves the fence",
        SQUARE,
        bounds=Bounds(box(2600, -100, 2600, -600)),
        fault=("leaves_fence", 4),
    ),
    Drawn(
        "a waypoint above the ceiling",
        plan((0, 0), (2000, 0), (4000, 0, 1200), (6000, 0)),
        bounds=Bounds(ceiling_ft=1100.0),
        fault=("above_ceiling", 2),
    ),
    Drawn(
        "a start above the ceiling",
        STRAIGHT,
        at(-3000, 0, 1800.0),
        bounds=Bounds(ceiling_ft=1500.0),
        fault=("above_ceiling", 0),
    ),
    Drawn("two waypoints 120 m apart", plan((0, 0), (2000, 0), (2120, 0), (4000, 0)), fault=("short_leg", 2)),
    Drawn(
        "a waypoint that a sharp turn passes", plan((0, 0), (3000, 0), (2740, 150), (0, 1500)), fault=("short_leg", 2)
    ),
    Drawn(
        "a sharp turn before a short leg",
        plan((0, 0), (3000, 0), (2875, 217), (2875, 3000)),
        fault=("unfinished_turn", 2),
    ),
    Drawn(
        "a turn downwind before a short leg",
        plan((0, 0), (3000, 0), (3000, 300), (6000, 300)),
        wind=SteadyWind(180, 20),
        fault=("unfinished_turn", 2),
    ),
    Drawn("a turn back that a crosswind carries away", REVERSAL, wind=SteadyWind(270, 30), fault=("wide_turn", 2)),
    Drawn("a wind that is faster than the aircraft", STRAIGHT, wind=SteadyWind(0, 62), fault=("unreached", 1)),
    Drawn(
        "one leg against the wind",
        plan((0, 0), (0, 3000), (0, 6000), (0, 3500), (0, 1000)),
        wind=SteadyWind(270, 60),
        fault=("unreached", 3),
    ),
    Drawn("a battery that ends on the way", SQUARE, bounds=Bounds(endurance_s=170.0), fault=("battery_ends", 3)),
    Drawn(
        "a climb that is too steep",
        plan((0, 0), (2000, 0), (2900, 0, 2000), (6000, 0, 2000)),
        fault=("misses_altitude", 2),
    ),
    Drawn(
        "slower over ground than a day",
        plan((0, 0), (0, 3000), (0, -60000), (0, -63000)),
        wind=SteadyWind(270, 53),
        fault=("too_long", 2),
    ),
)
