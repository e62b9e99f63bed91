"""What was written to the gains: the steps that can be undone and redone, and the entries of the journal."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Any, Final, Literal

Kind = Literal["write", "undo", "redo"]
Outcome = Literal["confirmed", "rejected", "timed_out"]

# Enough for an afternoon of tuning; the journal itself keeps more.
_MOST_STEPS: Final = 200
_KINDS: Final[Mapping[str, Kind]] = {"write": "write", "undo": "undo", "redo": "redo"}
_OUTCOMES: Final[Mapping[str, Outcome]] = {
    "confirmed": "confirmed",
    "rejected": "rejected",
    "timed_out": "timed_out",
}


@dataclass(frozen=True, slots=True)
class Move:
    """A gain from one value to another."""

    name: str
    before: float
    after: float

    @property
    def back(self) -> Move:
        """The change that undoes this one."""
        return Move(self.name, self.after, self.before)


@dataclass(frozen=True, slots=True)
class Change:
    """One gain of an entry: `before` is the board's value, None if unknown; `after` is the requested value."""

    name: str
    before: float | None
    after: float
    state: Outcome


Step = tuple[Move, ...]


@dataclass(frozen=True, slots=True)
class Steps:
    """The steps that can be undone and redone, each as first written (not reversed); the newest is last."""

    undoable: tuple[Step, ...] = ()
    redoable: tuple[Step, ...] = ()

    @property
    def undo(self) -> Step | None:
        """What an undo would write now."""
        return tuple(move.back for move in self.undoable[-1]) if self.undoable else None

    @property
    def redo(self) -> Step | None:
        """What a redo would write now."""
        return self.redoable[-1] if self.redoable else None

    def after(self, kind: Kind, changes: Iterable[Change]) -> Steps:
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

    def _after_write(self, changes: tuple[Change, ...]) -> Steps:
        # A write without an answer may have arrived, so it can be undone like a confirmed one.
        step = tuple(
            Move(change.name, change.before, change.after)
            for change in changes
            if change.state != "rejected" and change.before is not None and change.before != change.after
        )
        return Steps(_with(self.undoable, step), ()) if step else self


@dataclass(frozen=True, slots=True)
class Entry:
    """Who wrote what when. `t_s` is Unix time; `client` and `name` are the browser's, None for a program."""

    id: int
    t_s: float
    client: str | None
    name: str | None
    kind: Kind
    changes: tuple[Change, ...]

    @property
    def state(self) -> Outcome:
        """The outcome of the whole entry: confirmed only if every change was."""
        states = {change.state for change in self.changes}
        return "rejected" if "rejected" in states else "timed_out" if "timed_out" in states else "confirmed"

    def as_dict(self) -> dict[str, Any]:
        """Plain values, as they stand in the file and in the interface."""
        return {
            "id": self.id,
            "t_s": self.t_s,
            "client": self.client,
            "name": self.name,
            "kind": self.kind,
            "state": self.state,
            "changes": [
                {"name": change.name, "before": change.before, "after": change.after, "state": change.state}
                for change in self.changes
            ],
        }


def entry_from(values: Mapping[str, Any]) -> Entry:
    """The entry that `as_dict` gave. Raises ValueError, TypeError or KeyError for anything else."""
    return Entry(
        id=int(values["id"]),
        t_s=float(values["t_s"]),
        client=_text(values["client"]),
        name=_text(values["name"]),
        kind=_KINDS[values["kind"]],
        changes=tuple(_change_from(change) for change in values["changes"]),
    )


def moves_as_dicts(step: Step | None) -> list[dict[str, Any]] | None:
    """Plain values of a step; None where there is none."""
    return None if step is None else [{"name": m.name, "before": m.before, "after": m.after} for m in step]


def _change_from(values: Mapping[str, Any]) -> Change:
    before = values["before"]
    return Change(
        str(values["name"]),
        None if before is None else float(before),
        float(values["after"]),
        _OUTCOMES[values["state"]],
    )


def _split(step: Step, changes: Iterable[Change]) -> tuple[Step, Step]:
    """The part of a step that was done, and the part that was not."""
    confirmed = {change.name for change in changes if change.state == "confirmed"}
    return (
        tuple(move for move in step if move.name in confirmed),
        tuple(move for move in step if move.name not in confirmed),
    )


def _with(steps: tuple[Step, ...], step: Step) -> tuple[Step, ...]:
    return (*steps, step)[-_MOST_STEPS:] if step else steps


def _text(value: Any) -> str | None:
    return None if value is None else str(value)
