"""An acknowledgement proves the command that it belongs to, and no other one."""

from __future__ import annotations

import pytest

from epf_gcs.codec.encode import encode_telemetry
from epf_gcs.codec.frame import Frame, FrameDecoder
from epf_gcs.codec.messages_gen import COMMANDS
from epf_gcs.codec.values import meaning
from epf_gcs.flight.board.acknowledgements import FENCE, AcknowledgementJudge, OutstandingAcknowledgements

BY_ID = sorted(COMMANDS.values(), key=lambda command: command.id)
# One with neighbours on both sides, so that an order of ids is not taken for equality.
COMMAND = COMMANDS["gps_on"]
BELOW = BY_ID[BY_ID.index(COMMAND) - 1]
ABOVE = BY_ID[BY_ID.index(COMMAND) + 1]
STORE = COMMANDS["store_parameters"]


def frame(*values: int, name: str = "acknowledgement") -> Frame:
    (found,) = FrameDecoder().feed(encode_telemetry(name, *values))
    assert isinstance(found, Frame)
    return found


class World:
    def __init__(self) -> None:
        self.now_s = 100.0
        self.owed = OutstandingAcknowledgements(lambda: self.now_s)

    def judge(self, command_id: int) -> AcknowledgementJudge:
        made = AcknowledgementJudge(command_id, self.owed)
        made.sent()
        return made

    def hears(self, *values: int) -> None:
        heard = frame(*values)
        self.owed.on_frame(heard, meaning(heard))


def is_fenced(judge: AcknowledgementJudge) -> bool:
    return judge.is_fenced


def judged(judge: AcknowledgementJudge, *values: int) -> tuple[bool, str] | None:
    heard = frame(*values)
    return judge(heard, meaning(heard))


def test_only_its_own_type_proves_a_command() -> None:
    judge = World().judge(COMMAND.id)
    assert judged(judge, BELOW.id, 0) is None
    assert judged(judge, ABOVE.id, 0) is None
    assert judged(judge, COMMAND.id, 0) == (True, "done")


def test_only_done_is_done() -> None:
    judge = World().judge(COMMAND.id)
    for result, name in enumerate(("bad_value", "bad_state", "unknown", "storage_failed"), start=1):
        assert judged(judge, COMMAND.id, result) == (False, name)
    assert judged(judge, COMMAND.id, 999) == (False, "unknown")


def test_another_frame_says_nothing() -> None:
    judge = World().judge(COMMAND.id)
    heard = frame(*[0] * 12, name="heartbeat")
    assert judge(heard, meaning(heard)) is None


def test_behind_a_fence_nothing_counts_before_it_and_only_the_own_sending_is_owed_after_it() -> None:
    world = World()
    for _ in range(3):
        world.owed.sent(COMMAND.id)
    judge = world.judge(COMMAND.id)
    assert is_fenced(judge)
    for command in BY_ID:
        if command.id != FENCE.id:
            assert judged(judge, command.id, 0) is None
            assert is_fenced(judge), command.name
    assert judged(judge, FENCE.id, 0) is None
    assert not is_fenced(judge)
    assert world.owed.of(COMMAND.id) == 1
    assert judged(judge, COMMAND.id, 0) == (True, "done")


@pytest.mark.parametrize(("answered", "owed"), [(0, 2), (2, 1)])
def test_behind_a_fence_each_own_sending_is_owed_that_was_not_answered(answered: int, owed: int) -> None:
    world = World()
    world.owed.sent(COMMAND.id)
    judge = world.judge(COMMAND.id)
    judge.sent()
    for _ in range(answered):
        world.hears(COMMAND.id, 0)
    judged(judge, FENCE.id, 0)
    assert world.owed.of(COMMAND.id) == owed


def test_what_is_owed_is_counted_for_each_type_and_never_below_none() -> None:
    world = World()
    world.owed.sent(COMMAND.id)
    world.owed.sent(COMMAND.id)
    world.hears(BELOW.id, 0)
    assert (world.owed.of(COMMAND.id), world.owed.of(BELOW.id)) == (2, 0)
    world.hears(COMMAND.id, 0)
    assert world.owed.of(COMMAND.id) == 1
    world.hears(COMMAND.id, 0)
    world.hears(COMMAND.id, 0)
    assert world.owed.of(COMMAND.id) == 0
    world.owed.sent(COMMAND.id)
    assert world.owed.of(COMMAND.id) == 1


def test_the_fence_itself_is_not_fenced_but_counted() -> None:
    world = World()
    world.owed.sent(FENCE.id)
    judge = world.judge(FENCE.id)
    assert not is_fenced(judge)
    assert judged(judge, FENCE.id, 0) is None
    assert judged(judge, FENCE.id, 0) == (True, "done")


@pytest.mark.parametrize(("after_s", "owed"), [(9.9, 1), (10.0, 0)])
def test_the_card_s_answer_is_expected_for_ten_seconds(after_s: float, owed: int) -> None:
    world = World()
    assert world.owed.of(STORE.id) == 0
    world.owed.sent(STORE.id)
    world.now_s += after_s
    assert world.owed.of(STORE.id) == owed


def test_an_answer_of_the_card_that_is_expected_no_longer_is_not_expected_again_with_the_next() -> None:
    world = World()
    world.owed.sent(STORE.id)
    world.now_s += 60.0
    world.owed.sent(STORE.id)
    world.hears(STORE.id, 0)
    world.now_s += 5.0
    assert world.owed.of(STORE.id) == 0


def test_another_command_s_answer_is_expected_for_ever() -> None:
    world = World()
    world.owed.sent(COMMAND.id)
    world.now_s += 1000.0
    assert world.owed.of(COMMAND.id) == 1
