"""The board's C code in closed loop with the simulator, compared to reference flights of the same control laws.

`python -m bench flight` flies the steps, the circuit and the shortest of the long routes; `python -m bench.flight`
flies all four routes, 2 h 50 min of simulated time.
"""

from __future__ import annotations

from bench.table import Row, table
from board_tests.closed_loop.closed_loop import ClosedLoop, Sample
from board_tests.closed_loop.figures import Figures, measure, settling_s
from board_tests.closed_loop.manoeuvres import (
    CLIMB,
    FASTER,
    TURN,
    climb_error_ft,
    cruise,
    fly_route,
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
from epf_gcs.codec.messages_gen import ROUTES
from epf_gcs.simulator.link import LinkQuality
from epf_gcs.simulator.simulation import SimulationOptions

_SHORT_ROUTES = ("gando", "vuelo")
_LONGEST_SHARE = 1.3  # share of the reference time after which a flight is given up as lost
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
    figures = _figures(name, SimulationOptions())
    reached = Row(
        f"{name}: waypoints",
        figures.waypoints_reached,
        "",
        f"{reference.waypoints}",
        figures.waypoints_reached == reference.waypoints,
    )
    circuit = name == "gando"
    return [
        reached,
        _beside(f"{name}: time", figures.time_s, "s", reference.time_s),
        Row(
            f"{name}: steady altitude error, rms",
            figures.altitude_rms_ft,
            "ft",
            f"<= {ALTITUDE_LIMIT_FT:g}",
            figures.altitude_rms_ft <= ALTITUDE_LIMIT_FT,
            reference.altitude_rms_ft,
            "reference" if reference.altitude_rms_ft is not None else "",
        ),
        Row(
            f"{name}: cross-track, rms",
            figures.cross_track_rms_m,
            "m",
            f"<= {CROSS_TRACK_LIMIT_M:g}" if circuit else "",
            figures.cross_track_rms_m <= CROSS_TRACK_LIMIT_M if circuit else None,
            reference.cross_track_rms_m,
            "reference" if reference.cross_track_rms_m is not None else "",
        ),
    ]


def _bad_links() -> list[Row]:
    """Flights over bad links, all of which must succeed; at 250 ms round trip the control laws are known to fail."""
    links = {
        "200 ms round trip": LinkQuality(delay_ms=100.0),
        "5 % of frames lost": LinkQuality(loss=0.05),
        "20 % of frames lost": LinkQuality(loss=0.2),
    }
    rows = []
    for what, link in links.items():
        figures = _figures("gando", SimulationOptions(link=link))
        clean = (
            figures.waypoints_reached == ROUTE_REFERENCES["gando"].waypoints
            and figures.altitude_rms_ft <= ALTITUDE_LIMIT_FT
        )
        rows.append(
            Row(
                f"gando, {what}: cross-track, rms",
                figures.cross_track_rms_m,
                "m",
                f"<= {CROSS_TRACK_LIMIT_M:g}",
                clean and figures.cross_track_rms_m <= CROSS_TRACK_LIMIT_M,
            )
        )
    return rows


def _figures(name: str, options: SimulationOptions) -> Figures:
    with ClosedLoop(options) as loop:
        samples = fly_route(loop, name, ROUTE_REFERENCES[name].time_s * _LONGEST_SHARE)
        return measure(samples, ROUTES[name].waypoints)


def _beside(what: str, ours: float, unit: str, reference: float) -> Row:
    limit = reference * WITHIN
    return Row(what, ours, unit, f"<= {limit:,.4g}", ours <= limit, reference, "reference")


if __name__ == "__main__":
    print(table(run(tuple(ROUTE_REFERENCES))))
