"""Places have shares: of one holder, and of all of a standing, which nobody below can use up."""

from __future__ import annotations

import pytest

from epf_gcs.shares.holder import Holder, Standing
from epf_gcs.shares.places import Holdings, Part, Places, Shortage
from epf_gcs.shares.table import SHARES

ROW = Places({Standing.viewer: Part(2, 3), Standing.operator: Part(3, 4), Standing.owner: Part(4, 6)})


def holder(standing: Standing, key: str = "") -> Holder:
    return Holder(key or standing.name, standing)


def taken(places: Holdings[str], who: Holder) -> int:
    """How many places somebody gets who takes as many as possible."""
    count = 0
    while places.take(f"{who.key} {count}", who) is None:
        count += 1
    return count


def test_one_holder_has_its_own_share_and_is_told_how_much_that_is() -> None:
    places: Holdings[str] = Holdings(ROW)
    ana = holder(Standing.viewer, "ana")
    assert taken(places, ana) == 2
    assert places.take("more", ana) == Shortage("own", 2)
    places.leave("ana 0")
    places.leave("ana 0")
    assert places.take("more", ana) is None


def test_those_below_leave_the_rest_to_those_above() -> None:
    places: Holdings[str] = Holdings(ROW)
    assert taken(places, holder(Standing.viewer, "ana")) == 2
    assert taken(places, holder(Standing.viewer, "eva")) == 1
    assert places.take("more", holder(Standing.viewer, "eva")) == Shortage("all", 3)
    assert taken(places, holder(Standing.operator)) == 1
    assert taken(places, holder(Standing.owner)) == 2
    assert len(places) == ROW.all


def test_what_those_above_have_is_not_given_to_those_below() -> None:
    places: Holdings[str] = Holdings(ROW)
    assert taken(places, holder(Standing.owner, "a")) == 4
    assert taken(places, holder(Standing.owner, "b")) == 2
    assert places.take("more", holder(Standing.viewer)) == Shortage("all", 6)


def test_who_has_no_share_gets_nothing() -> None:
    places: Holdings[str] = Holdings(ROW)
    assert places.take("one", holder(Standing.stranger)) == Shortage("own", 0)


def test_where_things_make_room_the_first_of_who_has_most_of_the_least_standing_goes() -> None:
    gone: list[str] = []
    places: Holdings[str] = Holdings(ROW, lambda thing: thing, gone.append)
    assert [places.take(f"{thing} owner", holder(Standing.owner)) for thing in "ab"] == [None, None]
    for thing in ("d ana", "c ana"):
        assert places.take(thing, holder(Standing.viewer, "ana")) is None
    assert places.take("b eva", holder(Standing.viewer, "eva")) is None
    assert places.take("e", holder(Standing.viewer, "leo")) is None
    assert gone == ["c ana"]
    assert places.take("z", holder(Standing.owner, "boss")) is None
    assert gone == ["c ana"], "there was a place"


def test_nobody_makes_room_for_who_stands_below() -> None:
    row = Places({Standing.viewer: Part(2, 2), Standing.owner: Part(2, 2)})
    places: Holdings[str] = Holdings(row, lambda thing: thing)
    assert [places.take(thing, holder(Standing.owner)) for thing in "ab"] == [None, None]
    assert places.take("v", holder(Standing.viewer)) == Shortage("all", 2)


@pytest.mark.parametrize("row", [name for name in SHARES.__slots__ if isinstance(getattr(SHARES, name), Places)])
def test_in_each_row_of_the_table_a_higher_standing_has_no_less(row: str) -> None:
    parts = getattr(SHARES, row).parts
    assert list(parts) == sorted(parts)
    for (_, below), (_, above) in zip(list(parts.items()), list(parts.items())[1:], strict=False):
        assert above.each >= below.each
        assert above.together >= below.together
