"""What a station says without waiting for an answer."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from epf_gcs.flight.hil.stick import Stick
from epf_gcs.flight.requests.hil import stick_notices
from epf_gcs.vehicle.surroundings import ToldSurroundings


def notices(
    stick: Stick, surroundings: ToldSurroundings, steady_s: Callable[[], float]
) -> Callable[[str, dict[str, Any]], None]:
    """surroundings {findings, watched, blind}, as `ToldSurroundings.take` has them; and the notices of the stick."""
    stick_notice = stick_notices(stick)

    def notice(name: str, arguments: dict[str, Any]) -> None:
        match name, arguments:
            case "surroundings", {"findings": list(findings)}:
                words = [value if isinstance(value := arguments.get(one), list) else [] for one in ("watched", "blind")]
                surroundings.take(findings, steady_s(), *words)
            case _:
                stick_notice(name, arguments)

    return notice
