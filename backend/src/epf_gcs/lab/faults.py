"""How a fault of the lab is asked for, and which of the lab's two loops can fly it.

As text: `gyro.drift@60+30=0.002` is the gyro drifting by 0.002 rad/s each second, from the 60th second, for 30 s. It
lasts until the flight ends without a length, and is of the usual strength without one.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from typing import Final

import msgspec

from epf_gcs.contract.simulator_faults import Fault, FaultError
from epf_gcs.lab.errors import LabError

_NOT_IN_HIL: Final = (
    'command 50 has no word for a value that was not measured. Fly the loop of the real aircraft: loop = "aircraft"'
)
_NO_LINE: Final = 'the loop of the real aircraft flies by its sensors, without line or simulator. Fly loop = "hil"'
_TEXT: Final = re.compile(r"(?P<place>\w+)\.(?P<kind>\w+)@(?P<start>[^+=]+)(\+(?P<length>[^=]+))?(=(?P<strength>.+))?")


Asked = Fault | str | Mapping[str, object]
"""How a fault may be given: as it is, as text, or as a table's names and values."""


def read(asked: Iterable[Asked]) -> tuple[Fault, ...]:
    """The faults of a flight. Raises LabError as `Fault`, or for what cannot be read as a fault."""
    return tuple(_one(fault) for fault in asked)


def told(asked: Iterable[Asked]) -> str:
    """As text, also of what cannot be read as a fault."""
    return " ".join(_told(fault) for fault in asked)


def check_hil(faults: Iterable[Fault]) -> None:
    """Raises LabError for a fault that the line of HIL cannot carry."""
    for fault in faults:
        if fault.kind == "dropout":
            raise LabError(f"{fault} cannot be flown: {_NOT_IN_HIL}")


def check_aircraft(faults: Iterable[Fault]) -> None:
    """Raises LabError for a fault that the loop of the real aircraft does not have."""
    for fault in faults:
        if fault.place in ("line", "simulator"):
            raise LabError(f"{fault} cannot be flown: {_NO_LINE}")


def _told(asked: Asked) -> str:
    try:
        return str(_one(asked))
    except LabError:
        return str(asked)


def _one(asked: Asked) -> Fault:
    if isinstance(asked, Fault):
        return asked
    try:
        if isinstance(asked, str):
            return _of_text(asked)
        return msgspec.convert(asked, Fault)
    except msgspec.ValidationError as error:
        raise LabError(f"{asked} is no fault: {error}") from error
    except FaultError as error:
        raise LabError(str(error)) from error


def _of_text(text: str) -> Fault:
    found = _TEXT.fullmatch(text)
    if found is None:
        raise LabError(f"{text!r} is no fault: PLACE.KIND@START+LENGTH=STRENGTH, as gyro.drift@60+30=0.002")
    try:
        times = [None if found[name] is None else float(found[name]) for name in ("length", "strength")]
        return Fault(found["place"], found["kind"], float(found["start"]), *times)
    except ValueError as error:
        raise LabError(f"{text!r} is no fault: {error}") from error
