"""Samples that came together get times at which they can have been taken; the track has no speed that nobody flew."""

from __future__ import annotations

import random

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from epf_gcs.flights.export.spread import spread

PERIOD_NS = 100_000_000


def spread_times(t_ns: list[int], cut: int = 1 << 30) -> np.ndarray:
    """The times after spreading, given in batches of `cut` samples."""
    times = np.array(t_ns, dtype=np.int64)
    rows = np.arange(len(times), dtype=np.float64)[:, None]
    batches = [(times[at : at + cut], rows[at : at + cut]) for at in range(0, len(times), cut)]
    given_back = list(spread(batches))
    if given_back:
        assert np.concatenate([one[1] for one in given_back])[:, 0].tolist() == rows[:, 0].tolist(), "none is lost"
    return np.concatenate([one[0] for one in given_back]) if given_back else np.empty(0, dtype=np.int64)


def read_late(taken_ns: list[int], stalls: list[tuple[int, int]]) -> list[int]:
    """When samples are read that were taken at these times, while the station hangs from and to."""
    return [next((end for begin, end in stalls if begin <= t_ns < end), t_ns) for t_ns in taken_ns]


@pytest.mark.parametrize("cut", [1 << 30, 50, 7, 1])
def test_114_samples_of_one_time_get_the_times_at_which_they_were_taken(cut: int) -> None:
    taken = [index * PERIOD_NS for index in range(600)]
    read = read_late(taken, [(200 * PERIOD_NS + 1, 315 * PERIOD_NS)])
    assert len(set(read)) == 600 - 114
    found = spread_times(read, cut)
    assert np.abs(found - np.array(taken)).max() <= PERIOD_NS * 0.05
    assert (np.diff(found) > 0).all()


@pytest.mark.parametrize("cut", [1 << 30, 50, 1])
def test_a_flight_that_ends_in_a_stall_has_the_times_at_which_its_last_samples_were_taken(cut: int) -> None:
    taken = [index * PERIOD_NS for index in range(300)]
    found = spread_times(read_late(taken, [(200 * PERIOD_NS + 1, 299 * PERIOD_NS)]), cut)
    assert np.abs(found - np.array(taken)).max() <= PERIOD_NS * 0.05


def test_samples_that_come_on_time_keep_their_times() -> None:
    rng = random.Random(3)
    read = [index * PERIOD_NS + rng.randrange(PERIOD_NS // 4) for index in range(5000)]
    assert spread_times(read, 512).tolist() == read


def test_a_rate_that_changes_is_no_burst_of_the_slower_one() -> None:
    slow = [index * PERIOD_NS for index in range(300)]
    fast = [slow[-1] + index * PERIOD_NS // 10 for index in range(1, 3000)]
    found = spread_times(slow + fast)
    assert np.abs(found - np.array(slow + fast)).max() < PERIOD_NS


def test_a_silence_is_not_filled() -> None:
    read = [index * PERIOD_NS for index in range(100)]
    read += [read[-1] + 600_000_000_000 + index for index in range(5)]
    read += [read[-1] + index * PERIOD_NS for index in range(1, 100)]
    found = spread_times(read)
    assert found[100] >= read[100] - 5 * PERIOD_NS


@given(st.lists(st.integers(0, 10**10), max_size=300), st.integers(1, 400))
def test_no_sample_is_said_to_be_later_than_it_was_read_or_earlier_than_the_one_before_it(
    steps: list[int], cut: int
) -> None:
    read = np.cumsum(np.array(steps, dtype=np.int64))
    found = spread_times(read.tolist(), cut)
    assert (found <= read).all()
    assert (np.diff(found) >= 0).all()


def test_spread_samples_are_not_kept_for_the_whole_flight() -> None:
    held = 0

    def batches() -> object:
        nonlocal held
        for number in range(200):
            held += 100
            yield np.full(100, number * 10 * PERIOD_NS), np.zeros((100, 1))

    most = 0
    for t_ns, _ in spread(batches()):  # type: ignore[arg-type]
        held -= len(t_ns)
        most = max(most, held)
    assert most <= 300
