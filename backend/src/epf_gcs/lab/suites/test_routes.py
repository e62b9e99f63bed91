"""Whole routes in calm air: every waypoint is reached in truth, and the way to it is kept."""

from __future__ import annotations

from epf_gcs.lab.bounds import Bounds
from epf_gcs.lab.plugin import Lab
from epf_gcs.lab.suites.places import SHORT, waypoint


def test_a_plan_that_the_station_sends(lab: Lab, bounds: Bounds) -> None:
    flight = lab.fly(SHORT)
    bounds.equal("waypoints at which the aircraft was", flight.captured_honestly, len(SHORT))
    bounds.below("off the way, rms", flight.near.rms_m, 25.0, "m")
    bounds.below("altitude, rms", flight.altitude.settled.rms_ft, 14.0, "ft")
    bounds.below("nearest to the first waypoint", flight.captures[0].distance_m, flight.captures[0].within_m, "m")
    bounds.above("capture of the first waypoint", flight.captures[0].distance_m, 180.0, "m")


def test_a_turn_through_north_goes_the_short_way(lab: Lab, bounds: Bounds) -> None:
    # From 33 degrees to the left, over north: the long way round takes a minute more.
    plan = (waypoint(0.0, 900.0), waypoint(-45.0, 1900.0))
    flight = lab.fly(plan)
    bounds.equal("waypoints at which the aircraft was", flight.captured_honestly, len(plan))
    bounds.below("time", flight.time_s, 75.0, "s")


def test_the_gando_circuit(lab: Lab, bounds: Bounds) -> None:
    flight = lab.fly("gando")
    bounds.equal("waypoints at which the aircraft was", flight.captured_honestly, 8)
    bounds.below("off the leg, rms", flight.leg.rms_m, 50.0, "m")
    bounds.below("off the way, rms", flight.near.rms_m, 48.0, "m")
    bounds.below("altitude, rms", flight.altitude.settled.rms_ft, 16.0, "ft")
    bounds.below("airspeed, rms", flight.airspeed.settled.rms_kt, 4.0, "kt")
    bounds.below("time", flight.time_s, 690.0, "s")


def test_from_a_standing_start_on_the_runway(lab: Lab, bounds: Bounds) -> None:
    flight = lab.fly((waypoint(0.0, 2500.0, 500.0),), start="runway")
    bounds.below("altitude at the start", flight.truth.altitude_ft[0], 90.0, "ft")
    bounds.equal("waypoints at which the aircraft was", flight.captured_honestly, 1)


def test_the_real_aircrafts_loop_flies_a_plan(lab: Lab, bounds: Bounds) -> None:
    flight = lab.fly(SHORT, loop="aircraft")
    bounds.equal("waypoints at which the aircraft was", flight.captured_honestly, len(SHORT))
    bounds.below("off the way, rms", flight.near.rms_m, 25.0, "m")
    bounds.below("altitude, rms", flight.altitude.settled.rms_ft, 14.0, "ft")
