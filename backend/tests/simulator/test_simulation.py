"""The simulator without its socket."""

from dataclasses import replace

import pytest

from epf_gcs.simulator.link import LinkQuality
from epf_gcs.simulator.simulation import Simulation, SimulationOptions
from epf_gcs.simulator.situation import Situation, Start, Turbulence, Wind
from epf_gcs.xplane.datagram import Surfaces, parse, release_datagram, surfaces_datagram

ROUGH = SimulationOptions(
    situation=Situation(wind=Wind(300.0, 20.0), turbulence=Turbulence.MODERATE, seed=5),
    link=LinkQuality(delay_ms=30.0, jitter_ms=30.0, loss=0.1),
)


def simulation(options: SimulationOptions, crashes: list[str] | None = None) -> Simulation:
    heard: list[str] = [] if crashes is None else crashes
    return Simulation(options, heard.append)


def command(surfaces: Surfaces) -> bytes:
    datagram = surfaces_datagram(surfaces)
    assert datagram is not None
    return datagram


def flown(options: SimulationOptions, frames: int, surfaces: Surfaces | None = None) -> list[bytes]:
    """Every datagram that reaches the station in so many frames."""
    sim = simulation(options)
    datagrams = []
    for _ in range(frames):
        if surfaces is not None:
            sim.receive(command(surfaces))
        sim.advance()
        sim.send()
        datagrams += sim.arrived(sim.time_s)
    return datagrams


def test_the_same_seed_gives_the_same_bytes() -> None:
    gentle = Surfaces(-0.15, 0.05, 0.0, 0.8)
    first = flown(ROUGH, 500, gentle)
    assert 400 < len(first) < 500
    assert flown(ROUGH, 500, gentle) == first
    assert flown(replace(ROUGH, situation=replace(ROUGH.situation, seed=6)), 500, gentle) != first


def test_a_command_moves_the_surfaces_that_row_11_shows_and_minus_999_gives_them_back() -> None:
    sim = simulation(SimulationOptions())
    trimmed = sim.state.surfaces
    sim.receive(command(Surfaces(0.3, 0.0, 0.1, 0.2)))
    for _ in range(25):
        sim.advance()
    assert sim.state.surfaces.elevator == pytest.approx(0.3, abs=0.01)
    assert sim.state.surfaces.throttle == pytest.approx(0.2)
    sim.receive(release_datagram())
    for _ in range(25):
        sim.advance()
    assert sim.state.surfaces.elevator == pytest.approx(trimmed.elevator, abs=0.01)
    assert sim.state.surfaces.throttle == pytest.approx(trimmed.throttle)


def test_delay_is_put_on_both_directions() -> None:
    sim = simulation(SimulationOptions(link=LinkQuality(delay_ms=100.0)))
    sim.receive(command(Surfaces(0.0, 0.0, 0.0, 1.0)))
    first_arrival = first_effect = None
    for frame in range(1, 20):
        sim.advance()
        sim.send()
        if first_arrival is None and sim.arrived(sim.time_s):
            first_arrival = frame
        if first_effect is None and sim.inputs.controls().throttle == 1.0:
            first_effect = frame
    # Sent at the end of frame 1 (20 ms) and at 0 ms; a frame takes in what has come before it begins.
    assert first_arrival == 6
    assert first_effect == 6


@pytest.mark.parametrize("rate_hz", [20, 30, 50, 77, 100])
def test_simulated_time_keeps_step_with_the_frames_at_every_rate(rate_hz: int) -> None:
    sim = simulation(SimulationOptions(rate_hz=rate_hz))
    start = sim.state.latitude_deg
    for _ in range(10 * rate_hz):
        sim.advance()
    assert sim.time_s == pytest.approx(10.0)
    # 10 s at 55.81 kt over the ground, on 29.4 degrees.
    assert (sim.state.latitude_deg - start) * 111_132.0 == pytest.approx(250.4, abs=1.0)


def test_one_row_per_datagram_carries_the_same_rows() -> None:
    together = flown(SimulationOptions(), 1)
    apart = flown(SimulationOptions(one_row_per_datagram=True), 1)
    assert len(together) == 1
    assert len(apart) == 10
    assert [parse(datagram) for datagram in apart] == [[record] for record in parse(together[0]) or []]


def test_a_crash_is_told_and_the_flight_begins_again() -> None:
    crashes: list[str] = []
    sim = simulation(SimulationOptions(situation=Situation(start=Start.FINAL)), crashes)
    start = sim.state
    sim.receive(command(Surfaces(-1.0, 0.0, 0.0, 1.0)))
    while not crashes and sim.time_s < 60.0:
        sim.advance()
    assert sim.crashes == 1
    assert crashes[0].startswith("Crash after ")
    assert sim.state == start


def test_the_throttle_lever_of_a_start_can_be_set() -> None:
    parked = simulation(SimulationOptions(situation=Situation(start=Start.RUNWAY)))
    rolling = simulation(SimulationOptions(situation=Situation(start=Start.RUNWAY), throttle=1.0))
    assert parked.inputs.stick().throttle == 0.0
    assert rolling.inputs.stick().throttle == 1.0
    for sim in (parked, rolling):
        for _ in range(150):
            sim.advance()
    assert parked.state.speed_ground_kt < 0.1
    assert rolling.state.speed_ground_kt > 10.0
