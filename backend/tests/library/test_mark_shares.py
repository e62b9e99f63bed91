"""Marks have a limit for each caller and each flight; one that is removed counts no more."""

from __future__ import annotations

import pytest

from epf_gcs.contract.flights import FlightEvent, FlightEvents
from epf_gcs.errors import ConflictError
from epf_gcs.library.mark_shares import MarkShares
from epf_gcs.shares.holder import Holder, Standing
from epf_gcs.shares.places import Part, Places

ANA, EVA, BOSS = Holder("ana", Standing.viewer), Holder("eva", Standing.viewer), Holder("boss", Standing.owner)


@pytest.fixture
def shares() -> MarkShares:
    return MarkShares(Places({Standing.viewer: Part(3, 5), Standing.owner: Part(10, 10)}))


def set_marks(shares: MarkShares, who: Holder, most: int, flight: str = "f") -> int:
    """How many of so many marks are taken."""
    count = 0
    try:
        for number in range(most):
            with shares.one_more(flight, who):
                shares.note(flight, who, f"{who.key}{number}")
            count += 1
    except ConflictError:
        pass
    return count


def refusal(shares: MarkShares, who: Holder) -> str:
    with pytest.raises(ConflictError) as refused, shares.one_more("f", who):
        pass
    return refused.value.code


def test_a_viewer_sets_so_many_in_one_flight_and_as_many_in_another(shares: MarkShares) -> None:
    assert set_marks(shares, ANA, 100) == 3
    assert refusal(shares, ANA) == "marks_own"
    assert set_marks(shares, ANA, 100, "another") == 3


def test_viewers_leave_room_to_owners(shares: MarkShares) -> None:
    assert set_marks(shares, ANA, 3) + set_marks(shares, EVA, 3) == 5
    assert refusal(shares, EVA) == "marks_full"
    assert set_marks(shares, BOSS, 100) == 5


def test_those_that_are_being_set_count(shares: MarkShares) -> None:
    with shares.one_more("f", ANA), shares.one_more("f", ANA), shares.one_more("f", ANA):
        assert refusal(shares, ANA) == "marks_own"
    with shares.one_more("f", ANA):
        pass


def test_a_mark_that_was_removed_counts_no_more(shares: MarkShares) -> None:
    set_marks(shares, ANA, 3)
    shares.forget("f", "ana1")
    shares.forget("f", "never there")
    assert set_marks(shares, ANA, 1) == 1


def test_those_that_were_there_before_the_station_started_count_for_the_flight(shares: MarkShares) -> None:
    marks = [FlightEvent(1.0, 1.0, "mark", "", f"m{number}", {}, None) for number in range(5)]
    shares.look("f", FlightEvents([*marks, FlightEvent(1.0, 1.0, "link", "", None, {}, None)]))
    assert refusal(shares, ANA) == "marks_full"
    assert set_marks(shares, BOSS, 1) == 1


def test_flights_that_were_not_marked_lately_are_forgotten(shares: MarkShares) -> None:
    set_marks(shares, ANA, 3)
    for number in range(300):
        set_marks(shares, EVA, 1, f"f{number}")
    assert len(shares._flights) <= 256
