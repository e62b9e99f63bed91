"""What can be undone and done again, and entries that come back from a file as they were."""

from __future__ import annotations

import msgspec
import orjson
import pytest
from hypothesis import given
from hypothesis import strategies as st

from epf_gcs.contract.answers import JournalEntry, ParameterChange, ParameterMove, WriteOutcome
from epf_gcs.vehicle.journal import Step, Steps, new_entry

NAMES = ("k_pitch", "k_roll", "k_elev")
values = st.floats(0, 99.5, width=32)
outcomes: st.SearchStrategy[WriteOutcome] = st.sampled_from(("confirmed", "rejected", "timed_out"))


def written(name: str, before: float | None, after: float, state: WriteOutcome = "confirmed") -> ParameterChange:
    return ParameterChange(name, before, after, state)


def tried(step: Step | None, state: WriteOutcome = "confirmed") -> list[ParameterChange]:
    assert step is not None
    return [ParameterChange(move.name, move.before, move.after, state) for move in step]


def test_an_undo_goes_back_and_a_redo_forth() -> None:
    steps = Steps().after("write", [written("k_pitch", 2.0, 2.5), written("k_roll", 1.0, 3.0)])
    assert steps.undo == (ParameterMove("k_pitch", 2.5, 2.0), ParameterMove("k_roll", 3.0, 1.0))
    assert steps.redo is None
    undone = steps.after("undo", tried(steps.undo))
    assert undone.undo is None
    assert undone.redo == (ParameterMove("k_pitch", 2.0, 2.5), ParameterMove("k_roll", 1.0, 3.0))
    assert undone.after("redo", tried(undone.redo)) == steps


def test_a_write_clears_what_could_be_done_again() -> None:
    steps = Steps().after("write", [written("k_pitch", 2.0, 2.5)])
    steps = steps.after("undo", tried(steps.undo)).after("write", [written("k_roll", 1.0, 3.0)])
    assert steps.redo is None


@pytest.mark.parametrize(
    "change", [written("k_pitch", 2.0, 2.5, "rejected"), written("k_pitch", 2.0, 2.0), written("k_pitch", None, 2.0)]
)
def test_what_changed_nothing_or_nobody_knows_what_is_no_step(change: ParameterChange) -> None:
    steps = Steps().after("write", [written("k_roll", 1.0, 3.0)])
    steps = steps.after("undo", tried(steps.undo))
    assert steps.after("write", [change]) == steps


def test_a_write_without_an_answer_can_be_undone_for_it_may_have_arrived() -> None:
    assert Steps().after("write", [written("k_pitch", 2.0, 2.5, "timed_out")]).undo == (
        ParameterMove("k_pitch", 2.5, 2.0),
    )


@pytest.mark.parametrize("state", ["rejected", "timed_out"])
def test_an_undo_that_was_not_done_can_be_tried_again(state: WriteOutcome) -> None:
    steps = Steps().after("write", [written("k_pitch", 2.0, 2.5)])
    assert steps.after("undo", tried(steps.undo, state)) == steps


def test_an_undo_that_was_done_in_part_leaves_the_rest_to_undo() -> None:
    steps = Steps().after("write", [written("k_pitch", 2.0, 2.5), written("k_roll", 1.0, 3.0)])
    steps = steps.after("undo", [written("k_pitch", 2.5, 2.0), written("k_roll", 3.0, 1.0, "rejected")])
    assert steps.undo == (ParameterMove("k_roll", 3.0, 1.0),)
    assert steps.redo == (ParameterMove("k_pitch", 2.0, 2.5),)


@given(st.lists(st.one_of(st.sampled_from(("undo", "redo")), st.tuples(st.sampled_from(NAMES), values))))
def test_undo_and_redo_walk_through_all_states_that_the_board_ever_had(
    actions: list[str | tuple[str, float]],
) -> None:
    """Against a plain list of snapshots with a cursor."""
    board = dict.fromkeys(NAMES, 1.0)
    history, place = [dict(board)], 0
    steps = Steps()
    for action in actions:
        if isinstance(action, tuple):
            name, value = action
            steps = steps.after("write", [written(name, board[name], value)])
            if board[name] != value:
                board[name] = value
                history, place = [*history[: place + 1], dict(board)], place + 1
        elif action == "undo" and steps.undo is not None:
            board.update({move.name: move.after for move in steps.undo})
            steps, place = steps.after("undo", tried(steps.undo)), place - 1
        elif action == "redo" and steps.redo is not None:
            board.update({move.name: move.after for move in steps.redo})
            steps, place = steps.after("redo", tried(steps.redo)), place + 1
        assert board == history[place]
        assert (steps.undo is None) == (place == 0)
        assert (steps.redo is None) == (place == len(history) - 1)


def test_only_the_newest_steps_are_kept() -> None:
    steps = Steps()
    for number in range(500):
        steps = steps.after("write", [written("k_pitch", number, number + 1.0)])
    assert len(steps.undoable) == 200
    assert steps.undo == (ParameterMove("k_pitch", 500.0, 499),)


changes = st.builds(ParameterChange, st.sampled_from(NAMES), st.none() | values, values, outcomes)


@pytest.mark.uncounted
@given(
    st.builds(
        new_entry,
        st.integers(1, 10**9),
        st.floats(0, 4e9),
        st.none() | st.text(),
        st.none() | st.text(),
        st.sampled_from(("write", "undo", "redo")),
        st.lists(changes, min_size=1).map(tuple),
    )
)
def test_an_entry_comes_back_from_the_file_as_it_was(entry: JournalEntry) -> None:
    assert msgspec.json.decode(orjson.dumps(entry), type=JournalEntry) == entry


@given(st.lists(outcomes, min_size=1))
def test_an_entry_is_confirmed_only_where_every_change_is(states: list[WriteOutcome]) -> None:
    entry = new_entry(1, 0.0, None, None, "write", tuple(written("k_pitch", 1.0, 2.0, state) for state in states))
    assert (entry.state == "confirmed") == (set(states) == {"confirmed"})


def test_an_entry_with_a_refusal_is_refused_and_else_one_without_an_answer_is_unanswered() -> None:
    cases: tuple[tuple[tuple[WriteOutcome, ...], WriteOutcome], ...] = (
        (("confirmed", "timed_out", "rejected"), "rejected"),
        (("rejected", "confirmed"), "rejected"),
        (("confirmed", "timed_out"), "timed_out"),
    )
    for states, expected in cases:
        entry = new_entry(1, 0.0, None, None, "write", [written("k_pitch", 1.0, 2.0, state) for state in states])
        assert entry.state == expected
