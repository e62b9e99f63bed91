"""Control without a station: what the flight is told, whose an id is, and which hand counts as moving."""

from __future__ import annotations

from typing import Any

import pytest

from epf_gcs.access.authority import KEPT_S, UNANSWERED_S
from epf_gcs.access.caller import LOCAL, Caller
from epf_gcs.access.changes import Page
from epf_gcs.access.control import Control
from epf_gcs.access.roles import Role
from epf_gcs.contract.base import PageFacts
from epf_gcs.contract.events import Event
from epf_gcs.contract.hello import ControlHolder
from epf_gcs.contract.notices import ControlChange, Notice, StickRelease
from epf_gcs.errors import GatewayError
from epf_gcs.xplane.datagram import Surfaces
from tests.support.contract import as_told
from tests.support.held import UNIX_S, HeldClock
from tests.support.held_loop import HeldLoop


class Line:
    """A page's stream."""

    heard = 0
    said = 0
    is_waited_for = False

    def __init__(self) -> None:
        self.dropped = 0
        self.pages: list[Page] = []

    def ping(self) -> None:
        """Nobody answers."""

    def drop(self) -> None:
        self.dropped += 1

    def renew(self, page: Page) -> None:
        self.pages.append(page)


class Desk:
    """Control, with all that it tells."""

    def __init__(self) -> None:
        self.clock = HeldClock(100.0)
        self.loop = HeldLoop()
        self.notices: list[Notice] = []
        self.events: list[tuple[str, dict[str, Any]]] = []
        self.control = Control(self.loop, self.clock, self, by_silence=True)  # type: ignore[arg-type]
        self.lines: dict[str, Line] = {}

    def event(self, event: Event) -> None:
        self.events.append(as_told(event))

    def notice(self, notice: Notice) -> None:
        self.notices.append(notice)

    def changed(self) -> None:
        """Nobody shows it."""

    def open(self, client: str, caller: Caller) -> Page:
        self.lines[client] = Line()
        return self.control.connect(client, caller, "", self.lines[client])

    def told(self) -> list[tuple[object, ...]]:
        """What the flight was told since the last look."""
        told: list[tuple[object, ...]] = []
        for one in self.notices:
            match one:
                case ControlChange():
                    told.append(("control", one.client, one.kept))
                case StickRelease():
                    told.append(("stick_gone", one.client))
        self.notices.clear()
        return told


def person(name: str, role: Role = Role.operator) -> Caller:
    return Caller("person", name, name.title(), role, f"session-{name}")


ANA, BEA = person("ana"), person("bea")
MIDDLE = Surfaces(0.0, 0.0, 0.0, 0.5)


@pytest.fixture
def desk() -> Desk:
    made = Desk()
    made.open("a", ANA)
    made.open("b", BEA)
    made.told()
    return made


def test_the_flight_knows_whose_hand_counts_and_for_whom_it_is_kept_meanwhile(desk: Desk) -> None:
    page = desk.control.holder
    assert page is not None
    desk.control.stick(page, MIDDLE)
    desk.control.disconnect("a", desk.lines["a"])
    assert desk.told() == [("control", "a", True), ("stick_gone", "a"), ("stick_gone", "a")]
    reserved = desk.control.state().reserved
    assert reserved is not None
    assert reserved.client == "a"
    assert reserved.until_s == pytest.approx(UNIX_S + 100.0 + KEPT_S)
    desk.clock.time_s += 1.0
    desk.open("a", ANA)
    assert desk.told() == [("control", "a", False), ("stick_gone", "a")]
    assert desk.control.state().since_s == pytest.approx(UNIX_S + 101.0)
    desk.control.act("release", "a", "", confirmed=False)
    assert desk.told() == [("control", None, False)]
    assert desk.control.state().since_s is None


def test_to_the_flight_a_pilot_that_is_put_out_is_a_radio_that_fell_silent_for_a_while(desk: Desk) -> None:
    page = desk.control.holder
    assert page is not None
    desk.control.stick(page, MIDDLE)
    before = len(desk.loop.timers)
    desk.control.end_session(ANA.session)
    assert desk.told() == [("control", "a", True), ("stick_gone", "a"), ("stick_gone", "a")]
    assert desk.control.holder is None
    assert not desk.control.is_connected("a")
    (timer,) = desk.loop.timers[before:]
    assert timer.due_s == KEPT_S
    timer.call()
    assert desk.told() == [("control", None, False)]


def test_a_hand_at_rest_trembles_and_one_that_creeps_moves(desk: Desk) -> None:
    holder = desk.control.holder
    assert holder is not None
    desk.control.act("ask", "b", "", confirmed=False)

    def given_s(elevator: float, throttle: float = 0.5) -> float:
        desk.clock.time_s += 1.0
        assert desk.control.stick(holder, Surfaces(elevator, 0.0, 0.0, throttle))
        (request,) = desk.control.state().requests
        assert request.given_at_s is not None
        return request.given_at_s - UNIX_S - UNANSWERED_S

    assert given_s(0.0) == pytest.approx(101.0), "the first sample is one of somebody"
    for tremble in (0.02, -0.02, 0.01, 0.0):
        assert given_s(tremble) == pytest.approx(101.0)
    assert [round(given_s(elevator)) for elevator in (0.01, 0.02, 0.03, 0.04, 0.045)] == [101, 101, 108, 108, 108]
    assert given_s(-0.1) == pytest.approx(desk.clock.time_s), "to either side"
    assert given_s(-0.1, throttle=0.6) == pytest.approx(desk.clock.time_s), "the last axis counts as the first"


def test_a_hand_that_has_just_got_control_moves_with_its_first_sample(desk: Desk) -> None:
    ana = desk.control.holder
    assert ana is not None
    desk.control.stick(ana, MIDDLE)
    desk.control.act("hand_over", "a", "b", confirmed=False)
    bea = desk.control.holder
    assert bea is not None
    assert not desk.control.stick(ana, MIDDLE)
    desk.control.act("ask", "a", "", confirmed=False)
    desk.clock.time_s += 3.0
    assert desk.control.stick(bea, MIDDLE)
    (request,) = desk.control.state().requests
    assert request.given_at_s == pytest.approx(UNIX_S + 103.0 + UNANSWERED_S)


def test_an_id_comes_back_to_its_own_session_where_its_stream_is_gone_or_silent(desk: Desk) -> None:
    control = desk.control
    assert control.client_for("new", ANA) != "new", "an id that nobody has had is not one to wish for"
    for wished, caller in ((None, ANA), ("a", BEA), ("a", ANA)):
        assert control.client_for(wished, caller) not in ("a", "b", None), "another's, or a twin's"
    assert desk.lines["a"].dropped == 0
    for _ in range(300):
        control._look()
    assert control.holder is None, "nothing was heard of it"
    assert control.client_for("a", BEA) != "a"
    assert control.client_for("a", ANA) == "a"
    assert desk.lines["a"].dropped == 1
    control.disconnect("b", desk.lines["b"])
    assert control.client_for("b", ANA) != "b"
    assert control.client_for("b", BEA) == "b"


def test_an_operator_cannot_command_by_the_id_of_the_holder_however_many_streams_came_and_went(desk: Desk) -> None:
    """The station remembers whose 2,000 ids are; whoever opened more streams could make it forget the holder's."""
    viewer = person("eve", Role.viewer)
    for number in range(2_100):
        client = f"{number:016x}"
        line = Line()
        desk.control.connect(client, viewer, "", line)
        desk.control.disconnect(client, line)
    assert desk.control.holder is not None
    assert desk.control.holder.client == "a"
    with pytest.raises(GatewayError) as caught:
        desk.control.command(BEA, "a")
    assert caught.value.code == "client_not_yours"
    assert desk.control.command(ANA, "a").client == "a", "whose stream is open is not forgotten"
    with pytest.raises(GatewayError) as caught:
        desk.control.own(BEA, f"{0:016x}")
    assert caught.value.code == "client_not_yours", "an id that was forgotten is nobody's"


def test_a_page_whose_line_cannot_be_looked_at_loses_control_and_the_watch_goes_on() -> None:
    desk = Desk()
    for client, caller in (("a", ANA), ("b", BEA)):
        desk.open(client, caller)

    class Broken(Line):
        @property
        def heard(self) -> int:  # type: ignore[override]
            raise ZeroDivisionError

    desk.control._lines["a"] = Broken()
    desk.loop.step()
    assert [what for what, _ in desk.loop.failures] == ["the watch over a page's line"]
    assert desk.control.holder is None, "a page that nobody hears keeps no control"
    assert desk.loop.due, "it looks again"


def test_the_end_of_an_earlier_stream_ends_nothing_of_the_one_that_took_its_place(desk: Desk) -> None:
    earlier = desk.lines["b"]
    desk.control.disconnect("b", earlier)
    desk.open("b", BEA)
    desk.told()
    desk.control.disconnect("b", earlier)
    assert desk.control.is_connected("b")
    assert desk.told() == []


def test_a_new_name_is_on_all_pages_of_the_session_with_their_numbers(desk: Desk) -> None:
    desk.open("a2", ANA)
    desk.control.change_session(Caller("person", "ana", "Anne", Role.viewer, ANA.session))
    assert [page["name"] for page in desk.control.pages()] == ["Anne", "Bea", "Anne 2"]
    assert [line.pages[-1].name for line in (desk.lines["a"], desk.lines["a2"])] == ["Anne", "Anne 2"]
    assert desk.lines["b"].pages == []
    assert desk.control.holder is None
    assert desk.open("a3", Caller("person", "x", "Anne", Role.viewer, "session-x")).name == "Anne 3"
    assert desk.open("a4", ANA).name == "Ana"


def test_who_had_control_before_a_restart_has_its_id_and_control_again_and_only_it() -> None:
    desk = Desk()
    about = PageFacts(ANA.session, "person", 1)
    desk.control.restore(ControlHolder("a", "Ana", about))
    desk.control.restore(ControlHolder("b", "Bea", PageFacts(BEA.session)))
    assert desk.control.client_for("a", BEA) != "a"
    desk.open("b", BEA)
    assert desk.control.state().client is None
    desk.open("a", ANA)
    assert desk.control.state().client == "a"


def test_a_command_names_who_gave_it_and_only_the_holder_gives_one(desk: Desk) -> None:
    asker = desk.control.command(ANA, "a")
    assert (asker.client, asker.name) == ("a", "Ana")
    for caller, client, code in ((BEA, "b", "control_held"), (LOCAL, None, "control_held"), (BEA, "a", "not_yours")):
        with pytest.raises(GatewayError) as refused:
            desk.control.command(caller, client)
        assert code in refused.value.code
    desk.control.act("release", "a", "", confirmed=False)
    assert desk.control.command(LOCAL, None).name == "this computer"
    assert desk.control.command(BEA, "b").name == "Bea"
