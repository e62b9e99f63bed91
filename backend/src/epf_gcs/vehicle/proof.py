"""What proves that a command was done, and what may be sent a second time."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Final

from epf_gcs.codec.tables import Confirm
from epf_gcs.codec.values import Json

# Sent twice these act twice. After a lost answer it is unknown whether the first one arrived, so it is not repeated.
NOT_REPEATABLE: Final = frozenset(
    {
        "reset",
        "fms_next_waypoint",
        "fms_previous_waypoint",
        "hil_fms_next_waypoint",
        "hil_fms_previous_waypoint",
    }
)


def heartbeat_proves(confirm: Confirm, arguments: Sequence[float], heartbeat: Mapping[str, Json]) -> bool:
    """Whether all flags that the command affects have the expected values."""
    return all(
        heartbeat.get(flag) is (bool(arguments[0]) if wanted == "argument" else wanted)
        for flag, wanted in confirm.flags.items()
    )


def plan_proves(confirm: Confirm, before: int | None, after: Json) -> bool:
    """Whether the current waypoint changed as the command says. A plan just loaded begins at its first waypoint."""
    if not isinstance(after, int):
        return False
    if confirm.move == "first":
        return after == 0
    return before is not None and after != before
