"""The shapes of faults and wind of the embedded simulator."""

from __future__ import annotations

import math
from typing import Final, Self, cast

from pydantic import Field

from epf_gcs.contract.shapes import Input, Output
from epf_gcs.contract.simulator_faults import (
    HIGHEST_WIND_KT,
    KINDS,
    FaultKind,
    FaultPlace,
    Kind,
    SimulatedFaults,
    TurbulenceName,
    not_carried,
)

_LATEST_S: Final = 3600.0
_LONGEST_S: Final = 86400.0


class FaultChoice(Output):
    """A fault that the embedded simulator can fly. `unit` is "" where it has no strength, "1" for a share. `usual_s`:
    its length where none is asked for; null: until somebody ends it."""

    place: FaultPlace
    kind: FaultKind
    says: str
    unit: str
    usual: float
    lowest: float
    highest: float
    usual_s: float | None

    @classmethod
    def of(cls, place: FaultPlace, kind: FaultKind, about: Kind) -> Self:
        """From the table."""
        return cls(
            place=place,
            kind=kind,
            says=about.says,
            unit=about.unit,
            usual=about.usual,
            lowest=about.lowest,
            highest=about.highest,
            usual_s=about.usual_s if math.isfinite(about.usual_s) else None,
        )


class FaultTable(Output):
    """All faults that can be asked for, and what is flown now; `flown` is null where no embedded simulator is in the
    loop."""

    choices: list[FaultChoice]
    flown: SimulatedFaults | None


class FaultInput(Input):
    """A fault that begins `start_s` from now. Null: as usual for its kind."""

    place: FaultPlace
    kind: FaultKind
    start_s: float = Field(0.0, ge=0.0, le=_LATEST_S)
    length_s: float | None = Field(None, gt=0.0, le=_LONGEST_S)
    strength: float | None = None


class WindInput(Input):
    """Steady wind: the true direction it blows from; and turbulence by MIL-F-8785C's name."""

    from_deg: float = Field(ge=0.0, le=360.0)
    speed_kt: float = Field(ge=0.0, le=HIGHEST_WIND_KT)
    turbulence: TurbulenceName = "none"


CHOICES: Final = [
    FaultChoice.of(cast(FaultPlace, place), cast(FaultKind, kind), about)
    for place, kinds in KINDS.items()
    for kind, about in kinds.items()
    if not_carried(place, kind) is None
]
"""In the table's order."""
