"""What was written to the gains: the steps that can be undone and redone, and the entries of the journal."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Final, Literal

from epf_gcs.contract.answers import JournalEntry, ParameterChange, ParameterMove, WriteOutcome

Kind = Literal["write", "undo", "redo"]

# Enough for an afternoon of tuning; the journal itself keeps more.
_MOST_STEPS: Final = 200

Step = tuple[ParameterMove, ...]


@dataclass(frozen=True, slots=True)
class Steps:
    """The steps that can be undone and redone, each as first written (not reversed); the newest is last."""

    undoable: tuple[Step, ...] = ()
    redoable: tuple[Step, ...] = ()

    @property
    def undo(self) -> Step | None:
        """What an undo would write now."""
        return tuple(back(move) for move in self.undoable[-1]) if self.undoable else None

    @property
    def redo(self) -> Step | None:
        """What a redo would write now."""
        return self.redoable[-1] if self.redoable else None

    def after(self, kind: Kind, changes: Iterable[ParameterChange]) -> Steps:
        """The steps after these changes were tried."""
        changes = tuple(changes)
        match kind:
            case "write":
                return self._after_write(changes)
            case "undo" if self.undoable:
                done, left = _split(self.undoable[-1], changes)
                return Steps(_with(self.undoable[:-1], left), _with(self.redoable, done))
            case "redo" if self.redoable:
                done, left = _split(self.redoable[-1], changes)
                return Steps(_with(self.undoable, done), _with(self.redoable[:-1], left))
        return self

    def _after_write(self, changes: tuple[ParameterChange, ...]) -> Steps:
        # A write without an answer may have arrived, so it can be undone like a confirmed one.
        step = tuple(
            ParameterMove(change.name, change.before, change.after)
            for change in changes
            if change.state != "rejected" and change.before is not None and change.before != change.after
        )
        return Steps(_with(self.undoable, step), ()) if step else self


def new_entry(
    number: int, t_s: float, client: str | None, name: str | None, kind: Kind, changes: Iterable[ParameterChange]
) -> JournalEntry:
    """An entry, confirmed only if every change was. `client` and `name` are the browser's, None for a program."""
    changes = tuple(changes)
    states = {change.state for change in changes}
    state: WriteOutcome = "rejected" if "rejected" in states else "timed_out" if "timed_out" in states else "confirmed"
    return JournalEntry(number, t_s, client, name, kind, state, changes)


def back(move: ParameterMove) -> ParameterMove:
    """The move that undoes this one."""
    return ParameterMove(move.name, move.after, move.before)


def _split(step: Step, changes: Iterable[ParameterChange]) -> tuple[Step, Step]:
    """The part of a step that was done, and the part that was not."""
    confirmed = {change.name for change in changes if change.state == "confirmed"}
    return (
        tuple(move for move in step if move.name in confirmed),
        tuple(move for move in step if move.name not in confirmed),
    )


def _with(steps: tuple[Step, ...], step: Step) -> tuple[Step, ...]:
    return (*steps, step)[-_MOST_STEPS:] if step else steps
