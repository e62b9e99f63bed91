"""What a flight is flown in, in the words of a campaign's columns and of `epf-lab`'s options."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict, dataclass
from typing import Any, Final

import msgspec

from epf_gcs.lab.errors import LabError
from epf_gcs.simulator.link import LinkQuality
from epf_gcs.simulator.models import AIRCRAFT
from epf_gcs.simulator.simulation import SimulationOptions
from epf_gcs.simulator.situation import Loading, Situation, Start, Turbulence, Wind

GAIN: Final = "gains."
"""What the name of a gain begins with, where it stands beside those of conditions."""

_PERCENT: Final = 100.0


@dataclass(frozen=True, slots=True)
class Conditions:
    """All that a flight depends on beside the board and the route: two flights with equal conditions are equal.

    `wind_from_deg`: true direction it blows from. `turbulence`: none, light, moderate or severe, of MIL-F-8785C as
    JSBSim makes it. `round_trip_ms`: fixed delay from the simulator over the board and back, half of it each way;
    `jitter_ms`: up to so much more each way; `loss_percent` of the datagrams each way. `mass_factor`, `cg_aft_m`,
    `control_power`: see `simulator.situation.Loading`. `loop`: which of the board's two: `hil`, told by command 50, or
    `aircraft`, that of the real aircraft, told by sensors that are right, without a link.
    """

    wind_kt: float = 0.0
    wind_from_deg: float = 0.0
    turbulence: str = "none"
    mass_factor: float = 1.0
    cg_aft_m: float = 0.0
    control_power: float = 1.0
    round_trip_ms: float = 0.0
    jitter_ms: float = 0.0
    loss_percent: float = 0.0
    start: str = "air"
    loop: str = "hil"
    aircraft: str = "rc"
    rate_hz: int = 50
    seed: int = 1

    @classmethod
    def of(cls, values: Mapping[str, object], *, are_texts: bool = False) -> Conditions:
        """From names and values; `are_texts`: values as typed on a command line. Raises LabError for a name that there
        is none of, or a value that cannot be."""
        unknown = values.keys() - USUAL.keys()
        if unknown:
            raise LabError(
                f"there is no condition {', '.join(sorted(unknown))}: choose of {', '.join(NAMES)}, gains.NAME"
            )
        given = {name: _typed(name, value, type(USUAL[name]), are_texts=are_texts) for name, value in values.items()}
        conditions = msgspec.convert(given, cls)
        conditions.options()
        return conditions

    def options(self) -> SimulationOptions:
        """For the simulator. Raises LabError for a value that cannot be."""
        self._check()
        situation = Situation(
            start=Start(self.start),
            wind=Wind(self.wind_from_deg % 360.0, self.wind_kt),
            turbulence=Turbulence(self.turbulence),
            seed=self.seed,
            loading=Loading(self.mass_factor, self.cg_aft_m, self.control_power),
        )
        link = LinkQuality(self.round_trip_ms / 2.0, self.jitter_ms, self.loss_percent / _PERCENT)
        return SimulationOptions(
            self.aircraft,
            situation,
            throttle=1.0 if situation.start is Start.RUNWAY else None,
            rate_hz=self.rate_hz,
            link=link,
        )

    def _check(self) -> None:
        for name, low, high in _LIMITS:
            value = getattr(self, name)
            if not low <= value <= high:
                raise LabError(f"{name} is {value}, and must be {low:g} to {high:g}")
        for name, known in _CHOICES.items():
            if getattr(self, name) not in known:
                raise LabError(f"{name} is {getattr(self, name)!r}, and must be one of {', '.join(known)}")


USUAL: Final[Mapping[str, Any]] = asdict(Conditions())
"""The value of each condition where nothing is said, in the order in which they are shown."""
NAMES: Final = tuple(USUAL)

_LIMITS: Final = (
    ("wind_kt", 0.0, 100.0),
    ("wind_from_deg", -360.0, 360.0),
    ("mass_factor", 0.5, 2.0),
    ("cg_aft_m", -0.2, 0.2),
    ("control_power", 0.1, 2.0),
    ("round_trip_ms", 0.0, 2000.0),
    ("jitter_ms", 0.0, 1000.0),
    ("loss_percent", 0.0, 100.0),
    ("rate_hz", 20, 100),
    ("seed", 0, 2**31 - 1),
)
_CHOICES: Final = {
    "turbulence": tuple(Turbulence),
    "start": tuple(Start),
    "loop": ("hil", "aircraft"),
    "aircraft": tuple(AIRCRAFT),
}


def gains_of(values: Mapping[str, object], *, are_texts: bool = False) -> dict[str, float]:
    """Gains by name. Raises LabError for a value that is no number."""
    return {name: float(_typed(f"gains.{name}", value, float, are_texts=are_texts)) for name, value in values.items()}


def _typed(name: str, value: object, kind: type, *, are_texts: bool) -> Any:
    try:
        return msgspec.convert(value, kind, strict=not are_texts)
    except msgspec.ValidationError as error:
        raise LabError(f"{name} cannot be {value!r}: it must be {_KINDS[kind]}") from error


_KINDS: Final = {float: "a number", int: "a whole number", str: "a word"}
