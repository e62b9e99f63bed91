"""When a page counts as silent: by looks, one each tenth of a second."""

from __future__ import annotations

import pytest

from epf_gcs.access.changes import Page
from epf_gcs.access.watch import Found, Watch

CUT_LOOKS = 7
HUNG_LOOKS = 20
STUCK_LOOKS = 100


class Line:
    """A line that is told what came. `answers`: its browser answers pings."""

    def __init__(self, *, answers: bool = False, is_waited_for: bool = True, heard: int = 1) -> None:
        self.heard, self.said, self.pings = heard, 0, 0
        self.answers = answers
        self.is_waited_for = is_waited_for

    def ping(self) -> None:
        self.pings += 1
        self.heard += self.answers

    def drop(self) -> None:
        raise AssertionError("looking drops nothing")

    def renew(self, page: Page) -> None:
        raise AssertionError(f"looking does not rename {page}")


def looks_until(found: Found, line: Line) -> int | None:
    watch = Watch()
    assert watch.look(line) == "heard"
    return next((look for look in range(1, 200) if watch.look(line) == found), None)


@pytest.mark.parametrize("is_waited_for", [True, False])
def test_a_line_on_which_nothing_comes_is_pinged_and_counts_as_cut(is_waited_for: bool) -> None:
    line = Line(is_waited_for=is_waited_for)
    assert looks_until("silent", line) == CUT_LOOKS
    assert line.pings == 1


@pytest.mark.parametrize("heard", [0, 1])
def test_however_long_a_line_is_silent_it_owes_one_answer(heard: int) -> None:
    """A browser answers each ping, all at once when the line stands again: more than the station takes of anybody."""
    line, watch = Line(heard=heard), Watch()
    for silence in range(1, 4):
        for _ in range(3 * STUCK_LOOKS):
            watch.look(line)
        assert line.pings == silence
        line.heard += 1


def test_a_page_that_has_only_begun_to_load_hangs_for_its_browser_does_not_answer_yet() -> None:
    assert looks_until("hangs", Line(heard=0)) == CUT_LOOKS
    assert looks_until("silent", Line(heard=0)) == STUCK_LOOKS
    line, watch = Line(heard=0, is_waited_for=False), Watch()
    assert [watch.look(line) for _ in range(CUT_LOOKS + 1)][-1] == "hangs"
    line.answers = True
    line.heard += 1
    assert watch.look(line) == "heard", "its browser answers the ping that lay there"
    line.answers = False
    assert "silent" in {watch.look(line) for _ in range(CUT_LOOKS + 1)}, "from then on a cut line is one"


def test_a_page_whose_browser_answers_but_which_acknowledges_nothing_hangs_and_at_last_is_stuck() -> None:
    assert looks_until("hangs", Line(answers=True)) == HUNG_LOOKS
    assert looks_until("silent", Line(answers=True)) == STUCK_LOOKS


def test_a_page_that_is_sent_nothing_owes_nothing() -> None:
    assert looks_until("hangs", Line(answers=True, is_waited_for=False)) is None


def test_whatever_is_said_begins_it_anew() -> None:
    line, watch = Line(), Watch()
    for _ in range(5):
        assert {watch.look(line) for _ in range(CUT_LOOKS - 1)} == {"heard"}
        line.heard += 1
        line.said += 1
    line.answers = True
    for _ in range(STUCK_LOOKS):
        watch.look(line)
    line.said += 1
    assert watch.look(line) == "heard", "a page that was stuck goes on"
