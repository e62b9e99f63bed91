"""What proves that a command was done, and what may be sent a second time."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Final

from epf_gcs.codec.tables import Confirm
from epf_gcs.codec.values import Json

# Sent twice they would act twice: when the answer is lost, nobody can tell whether the first one arrived.
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
    """All flags that the command should set are as it should set them."""
    return all(
        heartbeat.get(flag) is (bool(arguments[0]) if wanted == "argument" else wanted)
        for flag, wanted in confirm.flags.items()
    )


def plan_proves(confirm: Confirm, before: int | None, after: Json) -> bool:
    """The waypoint moved as the command says. A plan that was just loaded begins at its first waypoint."""
    if not isinstance(after, int):
        return False
    if confirm.move == "first":
        return after == 0
    return before is not None and after != before
