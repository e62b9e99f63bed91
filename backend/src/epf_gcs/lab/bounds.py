"""Figures beside their bounds: a test says both, and whoever reads its report sees both, whether it failed or not."""

from __future__ import annotations

from collections.abc import Callable
from typing import Final

FIGURE: Final = "figure"
"""The name under which a test's report keeps them, as JUnit's `property`."""


class Bounds:
    """Of one test. Each call fails the test with figure and bound where the figure is outside; NaN always is."""

    def __init__(self, record: Callable[[str, object], None]) -> None:
        self._record = record

    def below(self, name: str, value: float, bound: float, unit: str = "") -> None:
        """The figure must be smaller."""
        self._judge(f"{name} {value:.4g}{_after(unit)}, bound {bound:g}{_after(unit)}", holds=value < bound)

    def above(self, name: str, value: float, bound: float, unit: str = "") -> None:
        """The figure must be larger."""
        self._judge(f"{name} {value:.4g}{_after(unit)}, at least {bound:g}{_after(unit)}", holds=value > bound)

    def equal(self, name: str, value: object, wanted: object) -> None:
        """The figure must be just that."""
        self._judge(f"{name} {value}, wanted {wanted}", holds=value == wanted)

    def _judge(self, sentence: str, *, holds: bool) -> None:
        self._record(FIGURE, sentence)
        if not holds:
            raise AssertionError(sentence)


def _after(unit: str) -> str:
    return f" {unit}" if unit else ""
