"""The Gando circuit with the board's own C code, default gains, in lock-step.

What the figures mean is defined in `epf_gcs/lab/figures.py`.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import pytest

from board_tests.closed_loop.circuit import CALM, Circuit
from board_tests.closed_loop.manoeuvres import fly_route
from board_tests.closed_loop.reference import ALTITUDE_LIMIT_FT, CROSS_TRACK_LIMIT_M, ROUTE_REFERENCES, WITHIN
from epf_gcs.lab.closed_loop import ClosedLoop
from epf_gcs.lab.plugin import Lab
from epf_gcs.simulator.link import LinkQuality
from epf_gcs.simulator.situation import Situation, Turbulence, Wind

WINDY = Situation(wind=Wind(330.0, 20.0), turbulence=Turbulence.MODERATE)


def test_the_whole_circuit_is_flown_within_the_limits(lab: Lab) -> None:
    flight = lab.fly("gando")
    assert flight.captured_honestly == 8
    assert flight.altitude.settled.rms_ft < ALTITUDE_LIMIT_FT
    assert flight.cross_track.rms_m < CROSS_TRACK_LIMIT_M
    assert flight.time_s < ROUTE_REFERENCES["gando"].time_s * WITHIN


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


@pytest.mark.parametrize("link", [{"round_trip_ms": 200.0}, {"loss_percent": 5.0}])
def test_a_worse_link_changes_nothing_that_shows(lab: Lab, link: dict[str, Any]) -> None:
    flight = lab.fly("gando", **link)
    assert flight.captured_honestly == 8
    assert flight.altitude.settled.rms_ft < ALTITUDE_LIMIT_FT
    assert flight.cross_track.rms_m < CROSS_TRACK_LIMIT_M


def test_the_circuit_is_flown_in_20_kt_of_wind_with_turbulence(lab: Lab) -> None:
    flight = lab.fly("gando", wind_kt=20, wind_from_deg=330, turbulence="moderate")
    assert flight.captured_honestly == 8
    assert flight.altitude.settled.rms_ft < 30.0
    assert flight.cross_track.rms_m < 100.0


def test_the_circuit_is_flown_from_a_standing_start_on_the_runway(lab: Lab) -> None:
    # The pilot opens the throttle; the autopilot, on from the first moment, does the rest.
    flight = lab.fly("gando", start="runway")
    assert flight.truth.altitude_ft[0] < 80.0
    assert flight.captured_honestly == 8
    assert flight.altitude.settled.rms_ft < ALTITUDE_LIMIT_FT
    assert flight.cross_track.rms_m < CROSS_TRACK_LIMIT_M
