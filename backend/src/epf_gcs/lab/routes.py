"""What is flown: a route that the board has by name, or a plan from a file."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Final

from epf_gcs.codec.messages_gen import ROUTES
from epf_gcs.codec.tables import Waypoint
from epf_gcs.errors import GatewayError
from epf_gcs.formats.recognise import MAX_FILE_BYTES, read_plan_file, settle_plan
from epf_gcs.lab.errors import LabError
from epf_gcs.rehearsal.flown_plan import metres
from epf_gcs.units import mps_from_kt

HIL_PLAN: Final = 1
"""Which of its two plans the board flies in the loop with a simulator."""
FLIGHT_PLAN: Final = 0
"""Which it flies in the real aircraft."""

# So many times as long as the way takes at the planned speeds: a route that is not flown by then never is.
_SLOWEST: Final = 3.0
_SETTLE_S: Final = 120.0


@dataclass(frozen=True, slots=True)
class Route:
    """Waypoints with a name. `is_on_board`: the board loads it by this name."""

    name: str
    waypoints: tuple[Waypoint, ...]
    is_on_board: bool = False

    def longest_s(self) -> float:
        """After so long a flight of it has not come to its end, and will not."""
        return _SETTLE_S + _SLOWEST * sum(self._legs_s())

    def commands(self, plan: int = HIL_PLAN) -> Iterator[tuple[str, tuple[float, ...]]]:
        """What makes the board fly it: names and values."""
        if self.is_on_board and plan == HIL_PLAN:
            yield f"hil_load_{self.name}", ()
            return
        yield "mission_begin", (plan, len(self.waypoints))
        for index, one in enumerate(self.waypoints):
            place = (one.latitude_deg, one.longitude_deg, one.altitude_ft, one.speed_kt)
            yield "mission_item", (plan, index, *place)
        yield "mission_commit", (plan,)

    def _legs_s(self) -> Iterator[float]:
        for one, other in zip(self.waypoints, self.waypoints[1:], strict=False):
            north_m, east_m = metres((one.latitude_deg, one.longitude_deg), (other.latitude_deg, other.longitude_deg))
            yield (north_m**2 + east_m**2) ** 0.5 / max(1.0, mps_from_kt(other.speed_kt))


def route(wanted: str | Path | Sequence[Waypoint]) -> Route:
    """A route by name, from a plan file, or of waypoints. Raises LabError with what is wrong."""
    if isinstance(wanted, str) and wanted in ROUTES:
        return Route(wanted, tuple(ROUTES[wanted].waypoints), is_on_board=True)
    if isinstance(wanted, str | Path):
        return _from_file(Path(wanted))
    if not wanted:
        raise LabError("a route needs waypoints")
    return Route("plan", tuple(wanted))


def _from_file(path: Path) -> Route:
    try:
        with path.open("rb") as file:
            data = file.read(MAX_FILE_BYTES + 1)
        if len(data) > MAX_FILE_BYTES:
            raise LabError(f"{path} is larger than any plan")
        plan = settle_plan(path.name, read_plan_file(path.name, data))
    except OSError as error:
        known = ", ".join(ROUTES)
        raise LabError(f"{path} cannot be read ({error.strerror}); routes with a name are {known}") from error
    except GatewayError as error:
        raise LabError(error.detail) from error
    return Route(path.stem, plan.waypoints)
