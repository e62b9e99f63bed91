"""Places that are taken and given back: how many there are, how many one holder may have, and who makes room."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass
from typing import Any, Generic, Literal, NamedTuple, TypeVar

from epf_gcs.shares.holder import Holder, Standing

T = TypeVar("T")


class Part(NamedTuple):
    """`each`: the most that one holder of a standing has. `together`: the most that all of it and below it have; the
    rest is left to those above."""

    each: int
    together: int


class Shortage(NamedTuple):
    """Why there is no place: of one's own share, or of all. `most` places are taken."""

    of: Literal["own", "all"]
    most: int


@dataclass(frozen=True, slots=True)
class Places:
    """A row of the table. A standing that is left out has no share."""

    parts: Mapping[Standing, Part]

    def shortage(self, holder: Holder, own: int, held: Mapping[Standing, int]) -> Shortage | None:
        """Why this holder, who has `own`, gets no place more; None: it gets one. `held`: taken by each standing."""
        part = self.parts.get(holder.standing, Part(0, 0))
        if own >= part.each:
            return Shortage("own", part.each)
        for standing, (_, together) in self.parts.items():
            if standing >= holder.standing and sum(n for other, n in held.items() if other <= standing) >= together:
                return Shortage("all", together)
        return None

    @property
    def all(self) -> int:
        """How many places there are."""
        return max(part.together for part in self.parts.values())


class Holdings(Generic[T]):
    """Who holds the places of one row, each by one thing. Owned by the event loop.

    `order` says who makes room: the thing with the smallest goes first, one with None never. Without it nothing does.
    """

    def __init__(
        self, row: Places, order: Callable[[T], Any | None] | None = None, give_up: Callable[[T], None] | None = None
    ) -> None:
        """`give_up` is told the thing that has made room, whose place is free already."""
        self.row = row
        self._order = order
        self._give_up = give_up
        self._of: dict[str, dict[T, Standing]] = {}
        self._key: dict[T, str] = {}
        self._held: dict[Standing, int] = dict.fromkeys(Standing, 0)

    def __len__(self) -> int:
        return len(self._key)

    def __iter__(self) -> Iterator[T]:
        return iter(tuple(self._key))

    def count(self, key: str) -> int:
        """How many places the holder with this key has."""
        return len(self._of.get(key, ()))

    def take(self, thing: T, holder: Holder) -> Shortage | None:
        """Take a place, which another may have to give up; why not, if there is none."""
        while (shortage := self.row.shortage(holder, self.count(holder.key), self._held)) is not None:
            if not self._make_room(holder, shortage):
                return shortage
        self._of.setdefault(holder.key, {})[thing] = holder.standing
        self._key[thing] = holder.key
        self._held[holder.standing] += 1
        return None

    def leave(self, thing: T) -> None:
        """Give a place back. Idempotent."""
        key = self._key.pop(thing, None)
        if key is None:
            return
        those = self._of[key]
        self._held[those.pop(thing)] -= 1
        if not those:
            del self._of[key]

    def _make_room(self, holder: Holder, shortage: Shortage) -> bool:
        if self._order is None:
            return False
        if shortage.of == "own":
            return self._one_goes(self._of.get(holder.key, ()), self._order)
        # The least standing first, and among them who has most; what stands above the newcomer is left alone.
        for those in sorted(self._of.values(), key=lambda those: (max(those.values()), -len(those))):
            below = [thing for thing, standing in those.items() if standing <= holder.standing]
            if self._one_goes(below, self._order):
                return True
        return False

    def _one_goes(self, things: Iterable[T], order: Callable[[T], Any | None]) -> bool:
        found = [(rank, number, thing) for number, thing in enumerate(things) if (rank := order(thing)) is not None]
        if not found:
            return False
        goes = min(found)[2]
        self.leave(goes)
        if self._give_up is not None:
            self._give_up(goes)
        return True
