"""The shapes of what is set for all flights: the disk and what happens when it fills, and the aircraft's name."""

from __future__ import annotations

from typing import Annotated

from pydantic import Field, StringConstraints

from epf_gcs.contract.shapes import Input, Output


class FlightPolicy(Output):
    """What happens when the disk fills: with `delete_oldest` the oldest flights that are not pinned are deleted
    until `keep_free_bytes` are free; without, recording stops there."""

    delete_oldest: bool
    keep_free_bytes: int


class FlightDisk(Output):
    """Room for recordings. `hours_left` at the rate of the newest flights, with all that is made of a flight; null if
    there is none to judge by. `used_bytes`: all flights, those of the bin, what was made of them, and finished exports.
    `most_import_bytes`: the largest recording of another machine that can be taken in now.
    """

    free_bytes: int | None
    used_bytes: int
    most_import_bytes: int
    hours_left: float | None
    policy: FlightPolicy


class FlightPolicyInput(Input):
    """What the person wants to happen when the disk fills."""

    delete_oldest: bool
    keep_free_bytes: Annotated[int, Field(ge=1_000_000_000, le=10_000_000_000_000)]


class FlightAircraft(Output):
    """What the aircraft is called; empty for no name."""

    name: str


class FlightAircraftInput(Input):
    """What the aircraft is called from now on; empty for no name."""

    name: Annotated[str, StringConstraints(strip_whitespace=True, max_length=60)]
