"""Numbers as people and spreadsheets write them, in any country: a comma may be the decimal mark or part thousands."""

from __future__ import annotations

import re
from typing import Final

# Three digits behind every mark but the last part thousands: 1,234,567 and 1,234.5 and 1.234,5.
_THOUSANDS: Final = re.compile(
    r"(?P<head>[+-]?[1-9][0-9]{0,2})(?P<groups>(?P<mark>[.,])[0-9]{3}(?:(?P=mark)[0-9]{3})*)"
    r"(?P<rest>(?!(?P=mark))[.,][0-9]+)?"
)


def readings(text: str) -> tuple[str, ...]:
    """The numbers that a text can mean, written with a decimal point; text that is no number stays as it is.

    Two for one mark with three digits behind it: 1,000 is a thousand ("1000") or one ("1.0").
    """
    decimal = text.replace(",", ".")
    found = _THOUSANDS.fullmatch(text)
    if found is None:
        # Two marks in other places are no number.
        return (decimal if decimal.count(".") <= 1 else text,)
    whole = found["head"] + re.sub("[.,]", "", found["groups"])
    if found["rest"] is not None or len(found["groups"]) > 4:
        return (whole + (found["rest"] or "").replace(",", "."),)
    return whole.lstrip("+"), plain_decimal(decimal.lstrip("+"))


def plain_decimal(text: str) -> str:
    """The same number, so that nobody reads thousands in it: not with three decimals."""
    head, mark, decimals = text.partition(".")
    if not mark or len(decimals) != 3:
        return text
    short = decimals.rstrip("0") or "0"
    return f"{head}.{short}0" if len(short) == 3 else f"{head}.{short}"
