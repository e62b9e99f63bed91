"""What is asked of the moment that a replay shows, in the interface's shapes. What no recording tells is null."""

from __future__ import annotations

from typing import Any, Final

from epf_gcs.replay.playhead import Playhead
from epf_gcs.replay.status import CHANNEL_BYTES_PER_S
from epf_gcs.vehicle.inspection import copy_frames, inspect_frames, inspect_rows, share_percent
from epf_gcs.vehicle.noted import gains_of, identity_of

_PLANS: Final = ("flight", "hil")


def build_known(head: Playhead, at_s: float) -> dict[str, Any]:
    """Identity, gains and both plans as noted until `at_s` seconds after the start: the interface's FlightKnown."""
    now = head.known.now
    parameters, plans = now["parameters"], now["plans"]
    return {
        "at_s": at_s,
        "identity": identity_of(now["identity"]),
        "parameters": None if parameters is None else gains_of(parameters),
        "missions": {plan: {"plan": plan, "waypoints": plans[plan]} if plan in plans else None for plan in _PLANS},
    }


def build_inspector(head: Playhead) -> dict[str, Any]:
    """Every type of frame and row until that moment: the interface's Inspector, without advice and round trips."""
    vehicle, now_s = head.vehicle, head.clock.now_s()
    board, simulator = vehicle.board, vehicle.simulator
    capacity = board.baud / 10.0 if board.link is not None else None
    rx, tx, from_simulator = (rate.per_s() for rate in (head.board_in, head.board_out, head.simulator_in))
    return {
        "t_s": now_s,
        "board": inspect_frames(copy_frames(board.frame_statistics, vehicle.telemetry), now_s),
        "rows": inspect_rows(simulator.arrivals, simulator.profile, now_s),
        "link": {
            "rx_bytes_per_s": round(rx, 1),
            "tx_bytes_per_s": round(tx, 1),
            "capacity_bytes_per_s": capacity,
            "rx_percent": share_percent(rx, capacity),
            "tx_percent": share_percent(tx, capacity),
            "simulator_bytes_per_s": round(from_simulator, 1),
            "simulator_percent": share_percent(from_simulator, CHANNEL_BYTES_PER_S),
            # Reads a millisecond apart share a recorded time: too coarse for this figure.
            "round_trip_ms": {"newest": None, "p50": None, "p99": None},
            "round_trips": None,
        },
        # What was to be done then is of no use now.
        "advice": [],
    }
