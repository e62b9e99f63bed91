"""A row of results, and all rows as a table."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

HEADINGS = ("what", "ours", "peer", "ratio", "reach", "")


@dataclass(frozen=True, slots=True)
class Row:
    """A measured value, with the peer's value from the same run if there is a peer.

    `reach` is the target and `ok` whether it was met; None if there is no target.
    """

    what: str
    ours: float
    unit: str
    reach: str = ""
    ok: bool | None = None
    peer: float | None = None
    peer_name: str = ""

    @property
    def ratio(self) -> float | None:
        """Our value divided by the peer's; None without a peer."""
        return None if self.peer is None or self.peer == 0.0 else self.ours / self.peer


def table(rows: Iterable[Row]) -> str:
    """The rows as aligned text."""
    lines = [HEADINGS, *(_cells(row) for row in rows)]
    widths = [max(len(line[column]) for line in lines) for column in range(len(HEADINGS))]
    shown = ["  ".join(cell.ljust(width) for cell, width in zip(line, widths, strict=True)).rstrip() for line in lines]
    return "\n".join([shown[0], "  ".join("-" * width for width in widths[:-1]), *shown[1:]])


def _cells(row: Row) -> tuple[str, ...]:
    peer = "" if row.peer is None else f"{_number(row.peer)} {row.unit} ({row.peer_name})"
    ratio = "" if row.ratio is None else f"{row.ratio:.2f}"
    verdict = {None: "", True: "reached", False: "SHORT"}[row.ok]
    return row.what, f"{_number(row.ours)} {row.unit}", peer, ratio, row.reach, verdict


def _number(value: float) -> str:
    """Three significant digits: more would be noise on a shared machine."""
    if value == 0.0 or abs(value) >= 100:
        return f"{value:,.0f}"
    return f"{value:.3g}"
