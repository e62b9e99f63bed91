"""Wire values -> their meaning, without the implausible ones; and checks of command arguments."""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import lru_cache
from struct import Struct
from typing import Any, Final, NamedTuple

from epf_gcs.codec.frame import Frame
from epf_gcs.codec.tables import Message, Value

Json = float | int | bool | str | None

_SINGLE: Final = Struct("<f")
_SHORTEST_DIGITS: Final = range(6, 10)  # nine digits always tell two single-precision numbers apart


class Meaning(NamedTuple):
    """The values of one frame by name, None for "no data", and the names whose value was not plausible."""

    values: dict[str, Json]
    implausible: tuple[str, ...]


def meaning(frame: Frame) -> Meaning:
    """Decode a frame. A value that is not finite or outside its range becomes None and is listed as implausible.

    The "no data" value of a field becomes None too, but is not listed: the board sent it on purpose.
    """
    wire = frame.values
    values: dict[str, Json] = {}
    implausible: list[str] = []
    for name, slot, minimum, maximum, absent, read in _PLANS[frame.message]:
        raw = wire[slot]
        if read is None:
            if minimum <= raw <= maximum:
                values[name] = raw
                continue
            values[name] = None
            if not _says_nothing(raw, absent):
                implausible.append(name)
        else:
            values[name] = read(raw)
            if values[name] is None:
                implausible.append(name)
    return Meaning(values, tuple(implausible))


def steps(message: Message) -> tuple[Step, ...]:
    """How each value of a message is read, in the order of the definition: for those who read many frames at once."""
    return _PLANS[message]


def argument_fault(value: Value, given: float) -> str | None:
    """Why a number is not allowed as this argument of a command, in one sentence; None if it is allowed."""
    if not math.isfinite(given):
        return f"{value.name} must be a number"
    if value.kind == "integer" and given != int(given):
        return f"{value.name} must be a whole number, not {given:g}"
    if value.minimum is not None and value.maximum is not None and not value.minimum <= given <= value.maximum:
        return f"{value.name} must be in {value.minimum:g}..{value.maximum:g}, not {given:g}"
    return None


def single(value: float) -> float:
    """The single-precision number that the wire will carry for `value`."""
    rounded: float = _SINGLE.unpack(_SINGLE.pack(value))[0]
    return rounded


def shortest(value: float) -> float:
    """The shortest decimal that is the same single-precision number: 0.6 for 0.6000000238418579."""
    # Zero is not kept with the others: 0.0 and -0.0 are equal, and would be given for each other.
    return value if value == 0.0 else _shortest(value)


@lru_cache(maxsize=256)  # the board's gains: few values, asked for again and again
def _shortest(value: float) -> float:
    for digits in _SHORTEST_DIGITS:
        candidate = float(f"{value:.{digits}g}")
        if single(candidate) == value:
            return candidate
    return value


class Step(NamedTuple):
    """How one value is read: as it stands, if within its limits, or by `read` if the wire encodes it."""

    name: str
    slot: int
    minimum: float
    maximum: float
    absent: float | None
    read: Callable[[Any], Json] | None


def _says_nothing(raw: float, absent: float | None) -> bool:
    """Whether the field holds its "no data" value; if that is NaN, every NaN counts."""
    return raw == absent or (absent is not None and math.isnan(absent) and math.isnan(raw))


def _flag(raw: int) -> bool | None:
    return bool(raw) if raw in (0, 1) else None


def _text(raw: bytes) -> str | None:
    """Zero-padded ASCII; None if any of it is not printable."""
    text = raw.split(b"\0", 1)[0].decode("ascii", "replace")
    return text if text.isascii() and text.isprintable() else None


def _ascii_digits(value: Value) -> Callable[[int], int | None]:
    """A number in ASCII digits, the last digit in the low byte; at most as many digits as the maximum has."""
    size = len(str(int(value.maximum or 0)))

    def read(raw: int) -> int | None:
        letters = raw.to_bytes(4, "big", signed=True).lstrip(b"\0")
        return int(letters) if letters.isdigit() and len(letters) <= size else None

    return read


def _bit(value: Value) -> Callable[[int], bool | None]:
    minimum, maximum, bit = value.minimum or 0, value.maximum or 0, value.bit or 0

    def read(raw: int) -> bool | None:
        return bool(raw >> bit & 1) if minimum <= raw <= maximum else None

    return read


def _ascii_flag(value: Value) -> Callable[[int], bool | None]:
    yes, no = value.letters or ("", "")
    meanings = {ord(yes): True, ord(no): False}
    return meanings.get


def _step(value: Value) -> Step:
    read: Callable[[Any], Json] | None = None
    match value.encoding:
        case "flag":
            read = _flag
        case "text":
            read = _text
        case "bit":
            read = _bit(value)
        case "ascii_digits":
            read = _ascii_digits(value)
        case "ascii_flag":
            read = _ascii_flag(value)
        case "scaled":
            read = _scaled(value)
        case "plain":
            pass
    minimum = -math.inf if value.minimum is None else value.minimum
    maximum = math.inf if value.maximum is None else value.maximum
    if value.kind == "number":  # in single precision a limit such as 99.99 may be rounded to slightly outside itself
        minimum, maximum = min(minimum, single(minimum)), max(maximum, single(maximum))
    return Step(value.name, value.slot, minimum, maximum, value.absent, read)


def _scaled(value: Value) -> Callable[[int], float | None]:
    scale, digits = value.scale, _digits_of(value.scale)
    minimum = -math.inf if value.minimum is None else value.minimum
    maximum = math.inf if value.maximum is None else value.maximum

    def read(raw: int) -> float | None:
        number = round(raw * scale, digits)
        return number if minimum <= number <= maximum else None

    return read


def _digits_of(scale: float) -> int:
    """Decimals that tell two neighbours apart, and six more: 0.1 times 3 is 0.3."""
    return 6 - math.floor(math.log10(abs(scale)))


class _Plans(dict[Message, tuple[Step, ...]]):
    """Each is made when the first frame of its message comes."""

    def __missing__(self, message: Message) -> tuple[Step, ...]:
        made = self[message] = tuple(_step(value) for value in message.values)
        return made


_PLANS: Final = _Plans()
