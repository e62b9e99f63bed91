"""What a campaign flies: a file names the route, what is fixed and what is drawn; a number and the seed give a flight.

route = "gando"
flights = 1000
seed = 1
[fixed]
turbulence = "moderate"
[drawn]
wind_kt = { uniform = [0, 25] }
mass_factor = { normal = [1.0, 0.05] }
start = { choice = ["air", "runway"] }
"gains.k_roll" = { uniform = [1.5, 3.0] }
[[faults]]
place = "gyro"
kind = "drift"
start_s = { uniform = [60, 300] }
length_s = 30
"""

from __future__ import annotations

import hashlib
import random
import tomllib
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Final

from epf_gcs.lab.conditions import GAIN, Conditions, gains_of
from epf_gcs.lab.errors import LabError
from epf_gcs.lab.faults import read as read_faults
from epf_gcs.lab.routes import Route, route

_KEYS: Final = {"route", "flights", "seed", "fixed", "drawn", "faults"}
_MOST_FLIGHTS: Final = 1_000_000
# What a normal distribution draws beyond so many deviations is drawn again: no campaign means an aircraft of no mass.
_DEVIATIONS: Final = 3.0
_RANGE: Final = 2


@dataclass(frozen=True, slots=True)
class Draw:
    """Where one value comes from: `uniform` between two, `normal` of mean and deviation, or `choice` of some."""

    kind: str
    values: tuple[Any, ...]

    def value(self, dice: random.Random) -> Any:
        """The next one."""
        match self.kind:
            case "uniform":
                return dice.uniform(*self.values)
            case "normal":
                mean, deviation = self.values
                while abs(drawn := dice.gauss(0.0, 1.0)) > _DEVIATIONS:
                    pass
                return mean + deviation * drawn
            case _:
                return dice.choice(self.values)


@dataclass(frozen=True, slots=True)
class Order:
    """One flight of a campaign, by its number: conditions and gains by name, as they were fixed or drawn."""

    number: int
    conditions: Mapping[str, object]
    gains: Mapping[str, object]
    faults: tuple[Mapping[str, object], ...] = ()


@dataclass(frozen=True, slots=True)
class Campaign:
    """`text`: the file, which says what was flown beside the results."""

    route: Route
    flights: int
    seed: int
    fixed: Mapping[str, object]
    drawn: Mapping[str, Draw]
    faults: tuple[Mapping[str, object], ...]
    text: str = field(repr=False)

    @property
    def fingerprint(self) -> str:
        """Of all that decides its flights."""
        return hashlib.sha256(f"{self.text}\n{self.route.waypoints}".encode()).hexdigest()

    def order(self, number: int) -> Order:
        """Flight `number`, from 0: always the same, whoever flies it and in whatever order."""
        dice = random.Random(f"{self.seed}/{number}")
        values = {**self.fixed, **{name: draw.value(dice) for name, draw in self.drawn.items()}}
        values.setdefault("seed", dice.randrange(2**31))
        gains = {name.removeprefix(GAIN): values.pop(name) for name in list(values) if name.startswith(GAIN)}
        faults = tuple({name: _given(value, dice) for name, value in fault.items()} for fault in self.faults)
        return Order(number, values, gains, faults)


def read(path: Path) -> Campaign:
    """Read a campaign's file. Raises LabError with what is wrong in it."""
    try:
        text = path.read_text(encoding="utf-8")
        given = tomllib.loads(text)
    except OSError as error:
        raise LabError(f"{path} cannot be read: {error.strerror}") from error
    except (tomllib.TOMLDecodeError, UnicodeDecodeError) as error:
        raise LabError(f"{path} is no campaign: {error}") from error
    unknown = given.keys() - _KEYS
    if unknown:
        raise LabError(f"{path} has {', '.join(sorted(unknown))}, which a campaign has not: {', '.join(sorted(_KEYS))}")
    flights, seed = given.get("flights"), given.get("seed", 1)
    if not isinstance(flights, int) or not 1 <= flights <= _MOST_FLIGHTS or not isinstance(seed, int):
        raise LabError(f"{path} needs `flights`, 1 to {_MOST_FLIGHTS}, and `seed`, a whole number")
    wanted = str(given.get("route", "gando"))
    # A plan is looked for beside the campaign that names it.
    beside = path.parent / wanted
    campaign = Campaign(
        route(beside if beside.is_file() else wanted),
        flights,
        seed,
        _table(given, "fixed"),
        {name: _draw(name, one) for name, one in _table(given, "drawn").items()},
        _faults(given),
        text,
    )
    twice = campaign.fixed.keys() & campaign.drawn.keys()
    if twice:
        raise LabError(f"{', '.join(sorted(twice))} cannot be fixed and drawn")
    first = campaign.order(0)
    Conditions.of(first.conditions)
    gains_of(first.gains)
    read_faults(first.faults)
    return campaign


def _table(given: Mapping[str, object], name: str) -> dict[str, object]:
    table = given.get(name, {})
    if not isinstance(table, dict):
        raise LabError(f"`{name}` must be a table, as [{name}]")
    # [fixed.gains] and "gains.k_roll" are the same.
    gains = table.pop("gains", {})
    return {**table, **{f"{GAIN}{key}": value for key, value in gains.items()}}


def _faults(given: Mapping[str, object]) -> tuple[dict[str, object], ...]:
    faults = given.get("faults", [])
    if not isinstance(faults, list) or not all(isinstance(fault, dict) for fault in faults):
        raise LabError("`faults` must be tables, as [[faults]]")
    return tuple(
        {name: _draw(name, value) if isinstance(value, dict) else value for name, value in fault.items()}
        for fault in faults
    )


def _given(value: object, dice: random.Random) -> object:
    return value.value(dice) if isinstance(value, Draw) else value


def _draw(name: str, given: Any) -> Draw:
    if isinstance(given, dict) and len(given) == 1:
        ((kind, values),) = given.items()
        if isinstance(values, list) and values:
            numbers = all(isinstance(value, int | float) for value in values)
            if kind == "choice" or (kind in ("uniform", "normal") and numbers and len(values) == _RANGE):
                return Draw(kind, tuple(values))
    raise LabError(
        f"{name} must be drawn by one of {{ uniform = [from, to] }}, {{ normal = [mean, deviation] }}, "
        f"{{ choice = [one, other] }}"
    )
