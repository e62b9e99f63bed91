"""The shapes of the gains and of the journal of what was written to them."""

from __future__ import annotations

from typing import Literal

from epf_gcs.contract.shapes import Output

Outcome = Literal["confirmed", "rejected", "timed_out"]


class ParameterState(Output):
    """One gain; `value` is the board's, null until it was read.

    `loaded` is what it was when the operator last loaded all, or when it was read first.
    """

    name: str
    group: str
    value: float | None
    loaded: float | None
    state: Literal["unknown", "loaded", "pending", "confirmed", "rejected"]
    unit: str
    minimum: float
    maximum: float
    step: float
    default: float
    is_integer: bool
    doc: str


class ParameterList(Output):
    """The 17 gains."""

    parameters: list[ParameterState]


class ParameterChange(Output):
    """`before` is what the board had, null where that was not known; `after` is what it was asked to take."""

    name: str
    before: float | None
    after: float
    state: Outcome


class JournalEntry(Output):
    """One step: who wrote what when. It is `confirmed` only where every change was."""

    id: int
    t_s: float
    client: str | None
    name: str | None
    kind: Literal["write", "undo", "redo"]
    state: Outcome
    changes: list[ParameterChange]


class ParameterMove(Output):
    """What an undo or redo would do: from the value that was written to the one that it writes."""

    name: str
    before: float
    after: float


class ParameterJournal(Output):
    """Newest first. `undo` and `redo` are what would be written now, null where there is nothing."""

    entries: list[JournalEntry]
    undo: list[ParameterMove] | None
    redo: list[ParameterMove] | None
