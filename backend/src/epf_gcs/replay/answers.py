"""What is asked of the moment that a replay shows, in the interface's shapes. What no recording tells is null."""

from __future__ import annotations

from typing import Any, Final

from epf_gcs.codec.tables import Waypoint
from epf_gcs.contract.answers import KnownMission, KnownMissions
from epf_gcs.contract.base import PlanName
from epf_gcs.contract.flight_knowledge import FlightKnowledge
from epf_gcs.contract.inspector import InspectedLink, Inspector
from epf_gcs.replay.playhead import Playhead
from epf_gcs.replay.status import CHANNEL_BYTES_PER_S
from epf_gcs.vehicle.inspection import copy_frames, inspect_frames, inspect_rows, share_percent
from epf_gcs.vehicle.noted import gains_of, identity_of

_PLANS: Final[tuple[PlanName, ...]] = ("flight", "hil")


def build_known(head: Playhead, at_s: float) -> FlightKnowledge:
    """Identity, gains and both plans as noted until `at_s` seconds after the start."""
    now = head.known.now
    parameters, plans = now.parameters, now.plans
    return FlightKnowledge(
        at_s,
        identity_of(now.identity),
        None if parameters is None else gains_of(parameters),
        now.own,
        KnownMissions(*(_plan(plan, plans[plan]) if plan in plans else None for plan in _PLANS)),
    )


def _plan(plan: PlanName, waypoints: Any) -> KnownMission:
    return KnownMission(plan, None if waypoints is None else [Waypoint(**waypoint) for waypoint in waypoints])


def build_inspector(head: Playhead) -> Inspector:
    """Every type of frame and row until that moment. What was to be done then is of no use now, and reads a millisecond
    apart share a recorded time, which is too coarse for round trips."""
    vehicle, now_s = head.vehicle, head.clock.now_s()
    board, simulator = vehicle.board, vehicle.simulator
    capacity = board.baud / 10.0 if board.link is not None else None
    rx, tx, from_simulator = (rate.per_s() for rate in (head.board_in, head.board_out, head.simulator_in))
    return Inspector(
        t_s=now_s,
        board=inspect_frames(copy_frames(board.frame_statistics, vehicle.telemetry), now_s),
        rows=inspect_rows(simulator.arrivals, simulator.profile, now_s),
        link=InspectedLink(
            rx_bytes_per_s=round(rx, 1),
            tx_bytes_per_s=round(tx, 1),
            capacity_bytes_per_s=capacity,
            rx_percent=share_percent(rx, capacity),
            tx_percent=share_percent(tx, capacity),
            simulator_bytes_per_s=round(from_simulator, 1),
            simulator_percent=share_percent(from_simulator, CHANNEL_BYTES_PER_S) or 0.0,
        ),
    )
