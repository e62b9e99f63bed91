"""What was known at a moment of a flight."""

from __future__ import annotations

from dataclasses import dataclass

from epf_gcs.contract.answers import FlightIdentity, KnownMissions, ParameterState
from epf_gcs.contract.base import Shape
from epf_gcs.contract.own_gains import OwnGains


@dataclass(frozen=True, slots=True)
class FlightKnowledge(Shape):
    """`parameters` and `own` as GET /parameters gave them then; null: not noted."""

    at_s: float
    identity: FlightIdentity
    parameters: list[ParameterState] | None
    own: OwnGains | None
    missions: KnownMissions
