"""The Gando circuit with the board's own C code, default gains, in lock-step.

What the figures mean is defined in `figures.py`.
"""

from dataclasses import replace

import pytest

from board_tests.closed_loop.circuit import CALM, LONGEST_S, Circuit
from board_tests.closed_loop.closed_loop import ClosedLoop
from board_tests.closed_loop.figures import Figures, measure
from board_tests.closed_loop.manoeuvres import fly_route
from board_tests.closed_loop.reference import ALTITUDE_LIMIT_FT, CROSS_TRACK_LIMIT_M, ROUTE_REFERENCES, WITHIN
from epf_gcs.codec.messages_gen import ROUTES
from epf_gcs.simulator.link import LinkQuality
from epf_gcs.simulator.simulation import SimulationOptions
from epf_gcs.simulator.situation import Situation, Start, Turbulence, Wind

GANDO = ROUTES["gando"].waypoints
WINDY = Situation(wind=Wind(330.0, 20.0), turbulence=Turbulence.MODERATE)


def figures_of(options: SimulationOptions) -> Figures:
    with ClosedLoop(options) as loop:
        samples = fly_route(loop, "gando", LONGEST_S)
        assert loop.crashes == []
        return measure(samples, GANDO)


def test_the_whole_circuit_is_flown_within_the_limits(circuit: Circuit) -> None:
    figures = measure(circuit.samples, GANDO)
    assert circuit.crashes == []
    assert figures.waypoints_reached == 8
    assert figures.altitude_rms_ft < ALTITUDE_LIMIT_FT
    assert figures.cross_track_rms_m < CROSS_TRACK_LIMIT_M
    assert figures.time_s < ROUTE_REFERENCES["gando"].time_s * WITHIN


def test_the_same_seed_gives_the_same_bytes(circuit: Circuit) -> None:
    with ClosedLoop(CALM) as again:
        fly_route(again, "gando", 150.0)
        assert len(again.bytes_to_station) == 7500
        assert again.bytes_to_station == circuit.bytes_to_station[:7500]


def test_in_turbulence_over_a_bad_link_the_seed_decides_every_byte() -> None:
    rough = replace(CALM, situation=WINDY, link=LinkQuality(delay_ms=20.0, jitter_ms=30.0, loss=0.1))

    def bytes_of(seed: int) -> list[bytes]:
        with ClosedLoop(replace(rough, situation=replace(WINDY, seed=seed))) as loop:
            fly_route(loop, "gando", 30.0)
            return loop.bytes_to_station

    first = bytes_of(7)
    assert 1200 < len(first) < 1500
    assert bytes_of(7) == first
    assert bytes_of(8) != first


@pytest.mark.parametrize(
    "link",
    [
        pytest.param(LinkQuality(delay_ms=100.0), id="200 ms round trip"),
        pytest.param(LinkQuality(loss=0.05), id="5 % lost"),
    ],
)
def test_a_worse_link_changes_nothing_that_shows(link: LinkQuality) -> None:
    figures = figures_of(replace(CALM, link=link))
    assert figures.waypoints_reached == 8
    assert figures.altitude_rms_ft < ALTITUDE_LIMIT_FT
    assert figures.cross_track_rms_m < CROSS_TRACK_LIMIT_M


def test_the_circuit_is_flown_in_20_kt_of_wind_with_turbulence() -> None:
    figures = figures_of(replace(CALM, situation=WINDY))
    assert figures.waypoints_reached == 8
    assert figures.altitude_rms_ft < 30.0
    assert figures.cross_track_rms_m < 100.0


def test_the_circuit_is_flown_from_a_standing_start_on_the_runway() -> None:
    # The pilot opens the throttle; the autopilot, on from the first moment, does the rest.
    standing = replace(CALM, situation=Situation(start=Start.RUNWAY), throttle=1.0)
    with ClosedLoop(standing) as loop:
        samples = fly_route(loop, "gando", LONGEST_S)
        assert samples[0].state.on_ground
        assert samples[0].state.speed_ground_kt < 1.0
        assert loop.crashes == []
        figures = measure(samples, GANDO)
    assert figures.waypoints_reached == 8
    assert figures.altitude_rms_ft < ALTITUDE_LIMIT_FT
    assert figures.cross_track_rms_m < CROSS_TRACK_LIMIT_M
