"""The rules of control, sentence by sentence. Time is what the tests say it is."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from epf_gcs.access.authority import KEPT_S, REFUSED_S, UNANSWERED_S, Authority
from epf_gcs.access.caller import LOCAL_SESSION
from epf_gcs.access.changes import (
    Effect,
    HolderChange,
    KeptOver,
    Page,
    RequestEnd,
    RequestStart,
    StickLoss,
)
from epf_gcs.access.roles import Role
from epf_gcs.contract.events import ControlReason
from epf_gcs.errors import ConflictError, GatewayError, NotFoundError, RoleError


def person(client: str, role: Role = Role.operator, session: str = "") -> Page:
    return Page(client, session or f"session of {client}", "person", client.title(), 1, role)


def local(client: str) -> Page:
    return Page(client, LOCAL_SESSION, "local", "this computer", 1, Role.owner)


ANA, BEA, CAI = person("ana"), person("bea"), person("cai")
EVE = person("eve", Role.viewer)
OLGA = person("olga", Role.owner)
FIRST, SECOND = local("first"), local("second")


class Desk:
    """The rules, and what followed from the last thing that happened."""

    def __init__(self, *pages: Page) -> None:
        self.rules = Authority(by_silence=True)
        for page in pages:
            self.rules.connect(page, 0.0)

    @property
    def holder(self) -> str | None:
        return None if self.rules.holder is None else self.rules.holder.client

    @property
    def kept_for(self) -> str | None:
        return None if self.rules.kept_for is None else self.rules.kept_for.client


def reasons(effects: list[Effect]) -> list[tuple[str | None, ControlReason]]:
    """Who has control after each change, and why."""
    return [
        (effect.page.client if effect.page else None, effect.reason)
        for effect in effects
        if isinstance(effect, HolderChange)
    ]


def refused(action: Callable[[], object], code: str, kind: type[GatewayError] = ConflictError) -> GatewayError:
    with pytest.raises(kind) as caught:
        action()
    assert caught.value.code == code
    assert caught.value.detail.endswith(".")
    return caught.value


def test_the_first_page_that_may_command_gets_control_and_the_second_watches() -> None:
    desk = Desk()
    assert reasons(desk.rules.connect(ANA, 0.0)) == [("ana", "first")]
    assert desk.rules.connect(BEA, 0.0) == []
    desk.rules.check("ana", ANA.session)
    error = refused(lambda: desk.rules.check("bea", BEA.session), "control_held")
    assert error.params == {"client": "ana", "name": "Ana"}
    refused(lambda: desk.rules.check(None, BEA.session), "control_held")


def test_an_operator_who_uses_the_id_of_the_holder_from_another_session_may_not_command() -> None:
    refused(lambda: Desk(ANA, BEA).rules.check("ana", BEA.session), "control_held")


def test_a_request_that_the_holder_does_not_answer_waits_unless_the_owner_chose_that_silence_grants_it() -> None:
    desk = Desk(ANA, BEA)
    desk.rules = Authority()
    desk.rules.connect(ANA, 0.0)
    desk.rules.connect(BEA, 0.0)
    desk.rules.ask("bea", 1.0)
    assert desk.rules.given_s("bea") is None
    assert desk.rules.tick(10_000.0) == []
    assert desk.holder == "ana"
    assert reasons(desk.rules.grant("ana", "bea", 10_001.0)) == [("bea", "granted")]


def test_a_viewer_never_has_control_however_it_tries() -> None:
    desk = Desk(EVE)
    assert desk.rules.holder is None
    for action in (lambda: desk.rules.ask("eve", 0.0), lambda: desk.rules.take("eve", 0.0, confirmed=True)):
        refused(action, "role_too_low", RoleError)
    desk.rules.connect(ANA, 0.0)
    assert desk.holder == "ana", "a viewer is nobody who could be asked to wait for"
    refused(lambda: desk.rules.hand_over("ana", "eve", 0.0), "client_may_not_command")


def test_while_nobody_has_control_whoever_may_command_does() -> None:
    Desk().rules.check(None, BEA.session)
    Desk(EVE).rules.check("eve", EVE.session)


def test_free_control_goes_to_a_page_of_this_computer_at_once_but_to_others_only_where_nobody_else_could_have_it() -> (
    None
):
    desk = Desk(ANA)
    desk.rules.connect(BEA, 0.0)
    desk.rules.release("ana", 1.0)
    assert desk.rules.connect(CAI, 2.0) == [], "Ana and Bea might want it"
    assert reasons(desk.rules.connect(FIRST, 3.0)) == [("first", "first")]


def test_what_is_given_back_can_be_taken_and_does_not_come_back_by_itself() -> None:
    desk = Desk(FIRST, SECOND)
    assert reasons(desk.rules.release("first", 1.0)) == [(None, "released")]
    assert desk.rules.tick(1.0 + KEPT_S) == []
    assert desk.rules.heard("first", 7.0) == []
    assert reasons(desk.rules.take("second", 8.0, confirmed=False)) == [("second", "asked")]
    refused(lambda: desk.rules.release("first", 9.0), "control_held")
    desk.rules.release("second", 9.0)
    assert desk.rules.release("second", 9.0) == [], "giving back what nobody has is nothing"


def test_only_a_page_on_the_stream_gets_control() -> None:
    desk = Desk(ANA)
    for action in (
        lambda: desk.rules.take("x", 0.0, confirmed=True),
        lambda: desk.rules.ask("x", 0.0),
        lambda: desk.rules.hand_over("ana", "x", 0.0),
    ):
        refused(action, "client_unknown", NotFoundError)


def test_an_owner_takes_control_from_anybody_but_only_on_purpose() -> None:
    desk = Desk(ANA, OLGA, BEA)
    error = refused(lambda: desk.rules.take("olga", 1.0, confirmed=False), "control_unconfirmed")
    assert error.params["name"] == "Ana"
    refused(lambda: desk.rules.take("bea", 1.0, confirmed=True), "control_held")
    desk.rules.move_stick("ana", 1.0, moved=True)
    assert desk.rules.take("olga", 1.0, confirmed=True) == [
        StickLoss("ana"),
        HolderChange(OLGA, "taken", ANA),
    ], "also while the stick is moved, and the stick first"
    assert desk.rules.take("olga", 2.0, confirmed=False) == [], "it has it already"


def test_asking_for_free_control_gets_it_at_once() -> None:
    desk = Desk(ANA, BEA)
    desk.rules.release("ana", 1.0)
    assert reasons(desk.rules.ask("bea", 2.0)) == [("bea", "asked")]


def test_the_holder_grants_what_it_was_asked_for_and_only_that() -> None:
    desk = Desk(ANA, BEA, CAI)
    assert desk.rules.ask("bea", 1.0) == [RequestStart(BEA)]
    assert desk.rules.ask("bea", 2.0) == [], "asking twice is asking once"
    refused(lambda: desk.rules.grant("ana", "cai", 3.0), "control_not_asked")
    refused(lambda: desk.rules.grant("bea", "bea", 3.0), "control_held")
    assert desk.rules.grant("ana", "bea", 3.0) == [RequestEnd(BEA, "given"), HolderChange(BEA, "granted", ANA)]
    assert desk.rules.ask("bea", 4.0) == [], "it has it"
    desk.rules.release("bea", 5.0)
    refused(lambda: desk.rules.grant("bea", "cai", 6.0), "control_not_held")


def test_who_was_refused_asks_again_after_a_while_with_no_page_sooner() -> None:
    desk = Desk(ANA, BEA)
    desk.rules.ask("bea", 1.0)
    assert desk.rules.refuse("ana", "bea", 2.0) == [RequestEnd(BEA, "refused")]
    assert desk.holder == "ana"
    error = refused(lambda: desk.rules.ask("bea", 5.0), "control_refused")
    assert error.params["wait_s"] == REFUSED_S - 3.0
    desk.rules.connect(person("other", session=BEA.session), 5.0)
    refused(lambda: desk.rules.ask("other", 6.0), "control_refused")
    desk.rules.tick(2.0 + REFUSED_S)
    assert desk.rules.ask("bea", 2.0 + REFUSED_S) == [RequestStart(BEA)]


def test_who_was_refused_still_gets_control_that_nobody_has() -> None:
    desk = Desk(ANA, BEA)
    desk.rules.ask("bea", 1.0)
    desk.rules.refuse("ana", "bea", 1.0)
    desk.rules.release("ana", 2.0)
    assert reasons(desk.rules.ask("bea", 2.0)) == [("bea", "asked")]


def test_a_refusal_at_this_computer_is_for_one_page_since_all_share_a_session() -> None:
    desk = Desk(FIRST, SECOND, local("third"))
    desk.rules.ask("second", 1.0)
    desk.rules.refuse("first", "second", 1.0)
    assert desk.rules.ask("third", 1.0) != []


def test_a_request_is_withdrawn_and_one_of_a_page_that_goes_is_gone() -> None:
    desk = Desk(ANA, BEA, CAI)
    desk.rules.ask("bea", 1.0)
    desk.rules.ask("cai", 1.0)
    assert desk.rules.withdraw("bea") == [RequestEnd(BEA, "withdrawn")]
    assert desk.rules.withdraw("bea") == []
    assert desk.rules.withdraw("x") == []
    assert desk.rules.disconnect("cai", 2.0) == [RequestEnd(CAI, "gone")]


def test_a_request_that_is_not_answered_is_granted_when_the_holder_did_nothing_for_so_long() -> None:
    desk = Desk(ANA, BEA)
    desk.rules.ask("bea", 5.0)
    assert desk.rules.given_s("bea") == 5.0 + UNANSWERED_S
    assert desk.rules.tick(5.0 + UNANSWERED_S - 0.01) == []
    assert reasons(desk.rules.tick(5.0 + UNANSWERED_S)) == [("bea", "unanswered")]


@pytest.mark.parametrize("does", ["deed", "stick"])
def test_a_holder_that_commands_or_moves_the_stick_keeps_control_and_the_request_stays(does: str) -> None:
    desk = Desk(ANA, BEA)
    desk.rules.ask("bea", 1.0)
    for second in range(5, 100, 5):
        if does == "deed":
            desk.rules.deed("ana", float(second))
        else:
            desk.rules.move_stick("ana", float(second), moved=True)
        assert desk.rules.tick(second + 4.99) == []
    assert list(desk.rules.requests) == ["bea"]
    assert reasons(desk.rules.tick(95 + UNANSWERED_S)) == [("bea", "unanswered")]


def test_a_stick_that_lies_still_is_no_deed() -> None:
    desk = Desk(ANA, BEA)
    desk.rules.ask("bea", 1.0)
    assert desk.rules.move_stick("ana", 9.0, moved=False)
    assert desk.rules.tick(1.0 + UNANSWERED_S) == [
        StickLoss("ana"),
        RequestEnd(BEA, "given"),
        HolderChange(BEA, "unanswered", ANA),
    ]


def test_deeds_of_others_keep_nobodys_control() -> None:
    desk = Desk(ANA, BEA)
    desk.rules.ask("bea", 1.0)
    desk.rules.deed("bea", 9.0)
    assert not desk.rules.move_stick("bea", 9.0, moved=True)
    assert reasons(desk.rules.tick(1.0 + UNANSWERED_S)) == [("bea", "unanswered")]


def test_who_has_just_got_control_has_as_long_to_answer_as_anybody() -> None:
    desk = Desk(ANA, OLGA, BEA)
    desk.rules.ask("bea", 1.0)
    desk.rules.take("olga", 10.0, confirmed=True)
    assert desk.rules.tick(1.0 + UNANSWERED_S) == []
    assert reasons(desk.rules.tick(10.0 + UNANSWERED_S)) == [("bea", "unanswered")]


def test_who_asked_first_gets_it_first_and_the_others_go_on_asking() -> None:
    desk = Desk(ANA, BEA, CAI)
    desk.rules.ask("cai", 1.0)
    desk.rules.ask("bea", 2.0)
    assert reasons(desk.rules.release("ana", 3.0)) == [(None, "released"), ("cai", "asked")]
    assert reasons(desk.rules.tick(3.0 + UNANSWERED_S)) == [("bea", "unanswered")]


def test_the_holder_hands_over_without_being_asked() -> None:
    desk = Desk(ANA, BEA)
    assert reasons(desk.rules.hand_over("ana", "bea", 1.0)) == [("bea", "handed_over")]
    refused(lambda: desk.rules.hand_over("ana", "ana", 1.0), "control_held")
    assert desk.rules.hand_over("bea", "bea", 1.0) == []


def test_the_stick_is_the_holders_alone_and_is_lost_with_control() -> None:
    desk = Desk(ANA, BEA)
    assert desk.rules.move_stick("ana", 1.0, moved=True)
    assert not desk.rules.move_stick("bea", 1.0, moved=True)
    assert desk.rules.stick == "ana"
    assert desk.rules.release("ana", 2.0) == [StickLoss("ana"), HolderChange(None, "released", ANA)]
    assert not desk.rules.move_stick("ana", 2.0, moved=True)
    assert desk.rules.stick is None


@pytest.mark.parametrize("how", ["lost", "silent"])
def test_a_lost_holders_control_is_free_at_once_the_stick_first_and_is_kept_for_its_return(how: str) -> None:
    desk = Desk(ANA, BEA)
    desk.rules.move_stick("ana", 1.0, moved=True)
    lose = desk.rules.disconnect if how == "lost" else desk.rules.silent
    assert lose("ana", 2.0) == [StickLoss("ana"), HolderChange(None, how, ANA)]  # type: ignore[arg-type]
    assert desk.rules.kept_for == ANA
    desk.rules.check(None, BEA.session)
    assert desk.rules.tick(2.0 + KEPT_S - 0.01) == []
    back = desk.rules.connect(ANA, 6.0) if how == "lost" else desk.rules.heard("ana", 6.0)
    assert reasons(back) == [("ana", "back")]
    assert desk.rules.kept_for is None


def test_a_busy_holder_has_its_hand_off_the_stick_and_keeps_control_while_nobody_asks() -> None:
    desk = Desk(ANA, BEA)
    desk.rules.move_stick("ana", 1.0, moved=True)
    assert desk.rules.hang("ana") == [StickLoss("ana")]
    assert desk.rules.tick(100.0) == []
    assert desk.holder == "ana"
    assert desk.rules.heard("ana", 100.0) == []
    desk.rules.ask("bea", 101.0)
    assert desk.rules.tick(101.1) == [], "who goes on is asked as anybody is"


@pytest.mark.parametrize("asks_first", [True, False])
def test_whoever_asks_a_holder_that_does_nothing_gets_control_at_once(asks_first: bool) -> None:
    desk = Desk(ANA, BEA)
    if asks_first:
        desk.rules.ask("bea", 1.0)
    desk.rules.hang("ana")
    if not asks_first:
        desk.rules.ask("bea", 1.0)
    assert reasons(desk.rules.tick(1.1)) == [(None, "silent"), ("bea", "asked")]
    assert desk.rules.heard("ana", 2.0) == []
    assert desk.holder == "bea"


def test_who_gets_control_from_a_page_that_hung_is_asked_as_anybody_is() -> None:
    desk = Desk(ANA, BEA, OLGA)
    desk.rules.hang("ana")
    desk.rules.take("olga", 1.0, confirmed=True)
    desk.rules.ask("bea", 2.0)
    assert desk.rules.tick(2.1) == []


def test_a_stick_that_moves_is_a_page_that_goes_on() -> None:
    desk = Desk(ANA, BEA)
    desk.rules.hang("ana")
    assert desk.rules.move_stick("ana", 1.0, moved=False)
    desk.rules.ask("bea", 2.0)
    assert desk.rules.tick(2.1) == []


def test_a_page_without_control_that_hangs_is_nobody_to_give_it_to() -> None:
    desk = Desk(ANA, BEA)
    desk.rules.ask("bea", 1.0)
    assert desk.rules.hang("bea") == []
    refused(lambda: desk.rules.grant("ana", "bea", 2.0), "client_silent")
    desk.rules.hang("ana")
    assert desk.rules.tick(20.0) == [], "who asked does not answer either"


def test_what_is_kept_for_a_return_goes_to_who_asks() -> None:
    desk = Desk(ANA, BEA)
    desk.rules.disconnect("ana", 1.0)
    assert reasons(desk.rules.ask("bea", 1.1)) == [("bea", "asked")]
    assert desk.rules.connect(ANA, 1.2) == [], "it came too late"


def test_who_asked_already_gets_what_was_lost_at_once() -> None:
    desk = Desk(ANA, BEA)
    desk.rules.ask("bea", 1.0)
    assert reasons(desk.rules.silent("ana", 2.0)) == [(None, "silent"), ("bea", "asked")]
    assert desk.rules.heard("ana", 2.1) == []
    assert desk.rules.kept_for is None


def test_nobody_who_comes_meanwhile_gets_what_is_kept_for_another_page() -> None:
    desk = Desk(FIRST)
    desk.rules.disconnect("first", 1.0)
    assert desk.rules.connect(SECOND, 2.0) == [], "the first one is only being loaded again"
    assert desk.rules.connect(person("first", session="session of a thief"), 3.0) == [], "an id is no secret"
    desk.rules.disconnect("first", 3.0)
    assert reasons(desk.rules.connect(FIRST, 4.0)) == [("first", "back")]


def test_after_a_while_the_longest_page_of_the_same_session_has_control() -> None:
    desk = Desk(FIRST, ANA, SECOND, local("third"))
    desk.rules.disconnect("first", 1.0)
    assert desk.rules.tick(1.0 + KEPT_S) == [KeptOver(FIRST), HolderChange(SECOND, "waited", None)]


def test_a_silent_page_of_the_same_session_is_none() -> None:
    desk = Desk(FIRST, SECOND)
    desk.rules.silent("second", 1.0)
    desk.rules.disconnect("first", 1.0)
    assert desk.rules.tick(1.0 + KEPT_S) == [KeptOver(FIRST)]


def test_no_stranger_to_the_session_inherits_control_but_who_lost_it_gets_it_back_however_late() -> None:
    desk = Desk(ANA, BEA)
    desk.rules.disconnect("ana", 1.0)
    assert desk.rules.tick(1.0 + KEPT_S) == [KeptOver(ANA)]
    assert desk.rules.tick(600.0) == []
    assert reasons(desk.rules.connect(person("new", session=ANA.session), 601.0)) == [("new", "back")]


def test_before_a_restart_who_had_control_has_it_again_and_nobody_else_gets_it_meanwhile() -> None:
    desk = Desk()
    desk.rules.restore(FIRST, 0.0)
    assert desk.rules.kept_for == FIRST
    assert desk.rules.connect(SECOND, 1.0) == []
    assert reasons(desk.rules.connect(FIRST, 2.0)) == [("first", "back")]
    assert desk.rules.restore(SECOND, 3.0) == []
    assert desk.holder == "first"
    assert desk.kept_for is None, "whoever has control is not waited for"
    desk.rules.disconnect("first", 4.0)
    desk.rules.restore(SECOND, 5.0)
    assert desk.kept_for == "first", "nor is another than who lost it"


def test_what_is_kept_from_before_a_restart_is_kept_no_longer_than_any_other() -> None:
    desk = Desk()
    desk.rules.restore(ANA, 100.0)
    desk.rules.connect(BEA, 101.0)
    assert desk.rules.tick(100.0 + KEPT_S - 0.01) == []
    assert desk.rules.tick(100.0 + KEPT_S) == [KeptOver(ANA)]
    assert desk.rules.kept_for is None
    assert desk.rules.tick(100.0 + KEPT_S + 1.0) == [], "it is told once"


def test_who_is_silent_is_given_nothing() -> None:
    desk = Desk(ANA, BEA, CAI)
    desk.rules.ask("bea", 1.0)
    desk.rules.ask("cai", 2.0)
    desk.rules.silent("bea", 3.0)
    refused(lambda: desk.rules.grant("ana", "bea", 3.0), "client_silent")
    refused(lambda: desk.rules.hand_over("ana", "bea", 3.0), "client_silent")
    assert reasons(desk.rules.release("ana", 4.0)) == [(None, "released"), ("cai", "asked")]
    desk.rules.silent("cai", 5.0)
    assert desk.holder is None
    assert reasons(desk.rules.heard("bea", 6.0)) == [("bea", "asked")], "as soon as it is heard again"


def test_an_ended_session_has_no_page_no_request_no_control_and_nothing_is_kept_for_it() -> None:
    twin = person("twin", session=ANA.session)
    desk = Desk(ANA, twin, BEA)
    desk.rules.ask("twin", 1.0)
    desk.rules.move_stick("ana", 1.0, moved=True)
    assert desk.rules.end(ANA.session, 2.0) == [
        RequestEnd(twin, "gone"),
        StickLoss("ana"),
        HolderChange(None, "ended", ANA),
    ]
    assert list(desk.rules.pages) == ["bea"]
    assert desk.rules.kept_for is None
    desk.rules.take("bea", 3.0, confirmed=False)
    desk.rules.disconnect("bea", 4.0)
    assert desk.rules.end(BEA.session, 4.1) == [KeptOver(BEA)], "also where it has just lost it"
    assert reasons(desk.rules.connect(BEA, 4.2)) == [("bea", "first")]


def test_the_control_of_an_ended_session_goes_to_who_asked() -> None:
    desk = Desk(ANA, BEA)
    desk.rules.ask("bea", 1.0)
    assert reasons(desk.rules.end(ANA.session, 2.0)) == [(None, "ended"), ("bea", "asked")]


def test_a_role_that_is_lowered_ends_control_and_requests_and_a_new_name_does_not() -> None:
    desk = Desk(ANA, BEA, CAI)
    renamed = person("ana", Role.owner)
    assert desk.rules.change(renamed, 1.0) == []
    assert desk.rules.holder is renamed
    desk.rules.ask("bea", 1.0)
    watching = person("bea", Role.viewer)
    assert desk.rules.change(watching, 2.0) == [RequestEnd(watching, "gone")]
    desk.rules.ask("cai", 2.0)
    assert reasons(desk.rules.change(person("ana", Role.viewer), 3.0)) == [(None, "ended"), ("cai", "asked")]
    assert reasons(desk.rules.change(person("cai", Role.viewer), 3.0)) == [(None, "ended")]
    assert desk.rules.heard("ana", 4.0) == []


@pytest.mark.parametrize("stranger", ["session of aaa", "session of zzz"])
def test_who_comes_with_another_session_does_not_get_back_what_it_never_had(stranger: str) -> None:
    desk = Desk(ANA, BEA)
    desk.rules.disconnect("ana", 1.0)
    desk.rules.tick(1.0 + KEPT_S)
    assert desk.rules.connect(person("new", session=stranger), 601.0) == []
    assert desk.holder is None


def test_the_end_of_one_session_takes_nothing_from_another_that_has_just_lost_control() -> None:
    desk = Desk(ANA, BEA)
    desk.rules.disconnect("ana", 1.0)
    assert desk.rules.end(BEA.session, 2.0) == []
    assert desk.rules.kept_for == ANA
    assert reasons(desk.rules.connect(ANA, 3.0)) == [("ana", "back")]


def test_another_role_counts_from_now_on_also_while_nobody_has_control() -> None:
    desk = Desk(ANA, BEA, EVE)
    desk.rules.release("ana", 1.0)
    assert desk.rules.change(person("eve", Role.operator), 2.0) == []
    assert desk.rules.change(person("bea", Role.viewer), 2.0) == []
    refused(lambda: desk.rules.ask("bea", 3.0), "role_too_low", RoleError)
    assert reasons(desk.rules.ask("eve", 3.0)) == [("eve", "asked")]


def test_who_may_command_no_longer_does_not_get_back_what_it_lost_by_silence() -> None:
    desk = Desk(ANA, BEA)
    desk.rules.silent("ana", 1.0)
    desk.rules.change(person("ana", Role.viewer), 2.0)
    assert desk.rules.heard("ana", 3.0) == []
    assert desk.holder is None


def test_a_page_that_hangs_hangs_on_while_others_are_heard() -> None:
    desk = Desk(ANA, BEA, CAI)
    desk.rules.hang("ana")
    desk.rules.heard("cai", 1.0)
    desk.rules.ask("bea", 2.0)
    assert reasons(desk.rules.tick(2.1)) == [(None, "silent"), ("bea", "asked")]


def test_a_holder_that_refuses_one_is_there_and_the_others_wait_on() -> None:
    desk = Desk(ANA, BEA, CAI)
    desk.rules.ask("bea", 1.0)
    desk.rules.ask("cai", 2.0)
    desk.rules.refuse("ana", "bea", 9.0)
    assert desk.rules.given_s("cai") == 9.0 + UNANSWERED_S
    assert desk.rules.tick(2.0 + UNANSWERED_S) == []
    assert reasons(desk.rules.tick(9.0 + UNANSWERED_S)) == [("cai", "unanswered")]


@pytest.mark.parametrize("how", ["comes again", "asks", "is heard"])
def test_who_was_silent_is_given_control_again_as_soon_as_anything_is_heard_of_it(how: str) -> None:
    desk = Desk(ANA, BEA)
    desk.rules.silent("bea", 1.0)
    refused(lambda: desk.rules.hand_over("ana", "bea", 2.0), "client_silent")
    if how == "comes again":
        desk.rules.disconnect("bea", 3.0)
        desk.rules.connect(BEA, 3.0)
    elif how == "asks":
        desk.rules.ask("bea", 3.0)
    else:
        desk.rules.heard("bea", 3.0)
    assert reasons(desk.rules.hand_over("ana", "bea", 4.0)) == [("bea", "handed_over")]


def test_nobody_hands_over_what_nobody_has() -> None:
    desk = Desk(ANA, BEA)
    desk.rules.release("ana", 1.0)
    for action in (desk.rules.hand_over, desk.rules.refuse):
        refused(lambda action=action: action("ana", "bea", 2.0), "control_not_held")  # type: ignore[misc]


def test_while_nobody_has_control_a_page_that_is_silent_or_hangs_loses_none_and_gets_none() -> None:
    desk = Desk(ANA, BEA)
    desk.rules.release("ana", 1.0)
    assert desk.rules.silent("ana", 2.0) == []
    assert desk.rules.hang("bea") == []
    assert desk.rules.silent_pages == {"ana", "bea"}
    assert desk.rules.kept_for is None
