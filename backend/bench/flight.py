"""The board's C code in closed loop with the simulator, compared to reference flights of the same control laws.

`python -m bench flight` flies the steps, the circuit and the shortest of the long routes; `python -m bench.flight`
flies all four routes, 2 h 50 min of simulated time.
"""

from __future__ import annotations

from bench.table import Row, table
from board_tests.closed_loop.manoeuvres import (
    CLIMB,
    FASTER,
    TURN,
    climb_error_ft,
    cruise,
    speed_error_kt,
    step,
    turn_error_deg,
)
from board_tests.closed_loop.reference import (
    ALTITUDE_LIMIT_FT,
    CLIMB_OVERSHOOT_FT,
    CLIMB_SETTLING_S,
    CROSS_TRACK_LIMIT_M,
    FASTER_SETTLING_S,
    ROUTE_REFERENCES,
    SETTLED_DEG,
    SETTLED_FT,
    SETTLED_KT,
    TURN_SETTLING_S,
    WITHIN,
)
from epf_gcs.lab.closed_loop import Sample
from epf_gcs.lab.conditions import Conditions
from epf_gcs.lab.figures import settling_s
from epf_gcs.lab.flight import fly
from epf_gcs.lab.routes import route

_SHORT_ROUTES = ("gando", "vuelo")
_STEP_S = 90.0


def run(routes: tuple[str, ...] = _SHORT_ROUTES) -> list[Row]:
    """Fly and measure."""
    rows = _steps()
    for name in routes:
        rows += _route(name)
    rows += _bad_links()
    return rows


def _steps() -> list[Row]:
    climb = _flown(CLIMB)
    turn = _flown(TURN)
    return [
        _beside("step +300 ft: settled to 30 ft", settling_s(climb, climb_error_ft, SETTLED_FT), "s", CLIMB_SETTLING_S),
        _beside("step +300 ft: overshoot", max(map(climb_error_ft, climb)), "ft", CLIMB_OVERSHOOT_FT),
        _beside("step +90 deg: within 3 deg", settling_s(turn, turn_error_deg, SETTLED_DEG), "s", TURN_SETTLING_S),
        Row(
            "step +90 deg: overshoot",
            max(0.0, *map(turn_error_deg, turn)),
            "deg",
            "0",
            max(map(turn_error_deg, turn)) <= 0,
        ),
        _beside(
            "step +15 % airspeed: within 1 kt",
            settling_s(_flown(FASTER), speed_error_kt, SETTLED_KT),
            "s",
            FASTER_SETTLING_S,
        ),
    ]


def _flown(index: int) -> list[Sample]:
    with cruise() as loop:
        return step(loop, index, _STEP_S)


def _route(name: str) -> list[Row]:
    reference = ROUTE_REFERENCES[name]
    flight = fly(route(name), Conditions())
    reached = Row(
        f"{name}: waypoints",
        flight.waypoints_reached,
        "",
        f"{reference.waypoints}",
        flight.waypoints_reached == reference.waypoints,
    )
    circuit = name == "gando"
    return [
        reached,
        _beside(f"{name}: time", flight.time_s, "s", reference.time_s),
        Row(
            f"{name}: steady altitude error, rms",
            flight.altitude.settled.rms_ft,
            "ft",
            f"<= {ALTITUDE_LIMIT_FT:g}",
            flight.altitude.settled.rms_ft <= ALTITUDE_LIMIT_FT,
            reference.altitude_rms_ft,
            "reference" if reference.altitude_rms_ft is not None else "",
        ),
        Row(
            f"{name}: cross-track, rms",
            flight.cross_track.rms_m,
            "m",
            f"<= {CROSS_TRACK_LIMIT_M:g}" if circuit else "",
            flight.cross_track.rms_m <= CROSS_TRACK_LIMIT_M if circuit else None,
            reference.cross_track_rms_m,
            "reference" if reference.cross_track_rms_m is not None else "",
        ),
    ]


def _bad_links() -> list[Row]:
    """Flights over bad links, all of which must succeed; at 250 ms round trip the control laws are known to fail."""
    links = {
        "200 ms round trip": Conditions(round_trip_ms=200.0),
        "5 % of frames lost": Conditions(loss_percent=5.0),
        "20 % of frames lost": Conditions(loss_percent=20.0),
    }
    rows = []
    for what, conditions in links.items():
        flight = fly(route("gando"), conditions)
        clean = (
            flight.waypoints_reached == ROUTE_REFERENCES["gando"].waypoints
            and flight.altitude.settled.rms_ft <= ALTITUDE_LIMIT_FT
        )
        rows.append(
            Row(
                f"gando, {what}: cross-track, rms",
                flight.cross_track.rms_m,
                "m",
                f"<= {CROSS_TRACK_LIMIT_M:g}",
                clean and flight.cross_track.rms_m <= CROSS_TRACK_LIMIT_M,
            )
        )
    return rows


def _beside(what: str, ours: float, unit: str, reference: float) -> Row:
    limit = reference * WITHIN
    return Row(what, ours, unit, f"<= {limit:,.4g}", ours <= limit, reference, "reference")


if __name__ == "__main__":
    print(table(run(tuple(ROUTE_REFERENCES))))
