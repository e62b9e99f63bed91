"""Control, as the running station has it: watches the pages' lines, tells viewers and the flight what changed."""

from __future__ import annotations

import asyncio
import secrets
from collections import OrderedDict
from collections.abc import Callable, Iterable
from dataclasses import asdict, replace
from typing import Any, Final, Protocol, cast

from epf_gcs.access import refusals
from epf_gcs.access.authority import KEPT_S, Authority
from epf_gcs.access.caller import LOCAL_SESSION, Caller
from epf_gcs.access.changes import Effect, HolderChange, KeptOver, Page, RequestEnd, RequestStart, StickLoss
from epf_gcs.access.roles import Role, RoleName
from epf_gcs.access.watch import LOOK_EVERY_S, Line, Watch
from epf_gcs.bus.definition import Asker
from epf_gcs.clock import Clock
from epf_gcs.contract.base import PageFacts
from epf_gcs.contract.events import ControlEvent, ControlRequestEndEvent, ControlRequestEvent, Event, PageName
from epf_gcs.contract.hello import ControlHolder
from epf_gcs.contract.notices import ControlChange, Notice, StickRelease
from epf_gcs.contract.status import ControlRequest, ControlReservation, ControlState
from epf_gcs.repeating import Repeating, report_failure
from epf_gcs.xplane.datagram import Surfaces

# An axis that moved by less is a hand at rest, or a worn gamepad.
_AT_REST: Final = 0.02
_MOST_SESSIONS: Final = 2000
_THIS_COMPUTER: Final = "this computer"
_SOMEBODY: Final = "somebody"
_NAMELESS: Final[dict[str, Any]] = {"client": None, "name": None, "kind": None, "number": None}


class ControlListener(Protocol):
    """Who hears of changes."""

    def event(self, event: Event) -> None:
        """All viewers."""

    def notice(self, notice: Notice) -> None:
        """The flight process."""

    def changed(self) -> None:
        """Whoever shows the whole state."""


class Control:
    """Owned by the event loop. A page is a live stream; its id is no secret, for it works only for its own session."""

    def __init__(
        self, loop: asyncio.AbstractEventLoop, clock: Clock, told: ControlListener, *, by_silence: bool = False
    ) -> None:
        """`by_silence`: the owner chose that a request which the holder does not answer is granted by time alone."""
        self._loop = loop
        self._clock = clock
        self._told = told
        self._rules = Authority(by_silence=by_silence)
        self._lines: dict[str, Line] = {}
        self._watches: dict[str, Watch] = {}
        self._called: dict[str, str] = {}
        # Whose an id is, also after its stream has closed.
        self._sessions: OrderedDict[str, str] = OrderedDict()
        self._stick_at: Surfaces | None = None
        # Whoever keeps a log of it.
        self.on_holder: Callable[[HolderChange], None] = lambda _: None
        self._looking = Repeating(loop, "the watch over control", self._look, after_failure_s=LOOK_EVERY_S)

    @property
    def holder(self) -> Page | None:
        """The page that has control."""
        return self._rules.holder

    @property
    def is_hung(self) -> bool:
        """Whether the page that has control does nothing, although its line stands."""
        return self._rules.hung is not None

    def is_connected(self, client_id: str) -> bool:
        """Whether a live stream has this id."""
        return client_id in self._lines

    def client_for(self, wished: str | None, caller: Caller) -> str:
        """The id of a new stream: the one it had before, if it may have it again, else a new one.

        Of a stream that is silent its successor takes the place.
        """
        if wished is None or self._sessions.get(wished) != caller.session:
            return secrets.token_hex(8)
        line = self._lines.get(wished)
        if line is not None:
            if wished not in self._rules.silent_pages:
                return secrets.token_hex(8)
            line.drop()
        return wished

    def connect(self, client_id: str, caller: Caller, own_name: str, line: Line) -> Page:
        """Add a live stream. `own_name`: what it calls itself; only what is of this computer may choose."""
        named = caller.session == LOCAL_SESSION and own_name != ""
        base = own_name if named else base_name(caller)
        taken = {self._rules.pages[client].number for client, called in self._called.items() if called == base}
        number = next(number for number in range(1, len(taken) + 2) if number not in taken)
        kind = "program" if named else caller.kind
        page = Page(client_id, caller.session, kind, _numbered(base, number), number, caller.role)
        self._called[client_id] = base
        self._lines[client_id] = line
        self._belongs(client_id, caller.session)
        self._apply(self._rules.connect(page, self._clock.steady_s()))
        # Samples of an earlier stream of the same page must not count as those of this one.
        self._told.notice(StickRelease(client_id))
        self._looking.arm(LOOK_EVERY_S)
        return page

    def disconnect(self, client_id: str, line: Line) -> None:
        """A stream is closed. Idempotent, also where another stream has its id by now."""
        if self._lines.get(client_id) is line:
            self._apply(self._rules.disconnect(client_id, self._clock.steady_s()))
            self._told.notice(StickRelease(client_id))
            self._forget(client_id)

    def change_session(self, caller: Caller) -> None:
        """A session or key has another role or name, which holds for its pages from now on."""
        base = base_name(caller)
        for page in [page for page in self._rules.pages.values() if page.session == caller.session]:
            new = replace(page, role=caller.role, name=_numbered(base, page.number))
            self._called[page.client] = base
            self._apply(self._rules.change(new, self._clock.steady_s()))
            self._lines[page.client].renew(new)
        self._told.changed()

    def end_session(self, session: str) -> None:
        """A session or key is no longer good: its pages have no control, from now on."""
        pages = [page for page in self._rules.pages.values() if page.session == session]
        self._apply(self._rules.end(session, self._clock.steady_s()))
        for page in pages:
            self._told.notice(StickRelease(page.client))
            self._forget(page.client)

    def restore(self, kept: ControlHolder) -> None:
        """Keep control for the page that had it before a restart, as `tell_flight` told it."""
        if self._rules.holder is None and self._rules.last is None:
            about = kept.about
            page = Page(kept.client, about.session, about.kind, kept.name, about.number, Role.operator)
            self._belongs(page.client, about.session)
            self._apply(self._rules.restore(page, self._clock.steady_s()))
            self._looking.arm(LOOK_EVERY_S)

    def tell_flight(self, put_out: Page | None = None) -> None:
        """Tell the flight process who may move the stick, or for whom it is kept meanwhile.

        `put_out` has just lost control for good. To the aircraft that is a radio that fell silent: nobody else's hand
        is on another stick yet.
        """
        page = self._rules.holder or self._rules.kept_for or put_out
        if page is None:
            self._told.notice(ControlChange())
            return
        about = PageFacts(page.session, page.kind, page.number)
        kept = self._rules.holder is None
        self._told.notice(ControlChange(page.client, page.name, about, kept))

    def own(self, caller: Caller, client_id: str) -> str:
        """The id, if it is of the caller's session: an id that is not known is nobody's. Raises NotYoursError."""
        if self._sessions.get(client_id) != caller.session:
            raise refusals.not_yours(client_id)
        return client_id

    def asker(self, caller: Caller, client_id: str | None) -> Asker:
        """Who asks, by name. Raises NotYoursError."""
        if client_id is not None and self.own(caller, client_id) in self._lines:
            return Asker(client_id, self._rules.pages[client_id].name)
        return Asker(client_id, base_name(caller))

    def command(self, caller: Caller, client_id: str | None) -> Asker:
        """Who commands. Raises ConflictError while another has control, NotYoursError."""
        asker = self.asker(caller, client_id)
        if client_id in self._lines:
            self._did(client_id)
        self._rules.check(client_id, caller.session)
        return asker

    def act(self, action: str, client_id: str, to: str, *, confirmed: bool) -> None:
        """Take, release, ask, withdraw, grant, refuse or hand_over, for a page of the caller.

        Raises ConflictError, NotFoundError, RoleError.
        """
        rules, now_s = self._rules, self._clock.steady_s()
        if client_id in self._lines:
            self._did(client_id)
        match action:
            case "take":
                effects = rules.take(client_id, now_s, confirmed=confirmed)
            case "release":
                effects = rules.release(client_id, now_s)
            case "ask":
                effects = rules.ask(client_id, now_s)
            case "withdraw":
                effects = rules.withdraw(client_id)
            case "grant":
                effects = rules.grant(client_id, to, now_s)
            case "refuse":
                effects = rules.refuse(client_id, to, now_s)
            case _:
                effects = rules.hand_over(client_id, to, now_s)
        self._apply(effects)

    def stick(self, page: Page, position: Surfaces) -> bool:
        """A sample of a page's stick. False: it does not count, for that page has no control."""
        at = self._stick_at
        moved = at is None or any(abs(now - then) > _AT_REST for now, then in zip(position, at, strict=True))
        if not self._rules.move_stick(page.client, self._clock.steady_s(), moved=moved):
            return False
        if moved:
            self._stick_at = position
        return True

    def state(self) -> ControlState:
        """For the status: who has control, whom it is kept for, and who asks for it."""
        rules = self._rules
        kept, until_s = rules.kept_for, rules.kept_until_s
        return ControlState(
            **fields(rules.holder),
            since_s=None if rules.holder is None else self._unix(rules.since_s),
            reserved=None
            if kept is None or until_s is None
            else ControlReservation(**fields(kept), until_s=self._unix(until_s)),
            requests=[self._request(rules.pages[client]) for client in rules.requests],
        )

    def pages(self) -> list[dict[str, Any]]:
        """All pages on the live stream, the longest first."""
        return [{**fields(page), "role": page.role.name} for page in self._rules.pages.values()]

    def _request(self, page: Page) -> ControlRequest:
        given_s = self._rules.given_s(page.client)
        return ControlRequest(
            **fields(page),
            role=cast(RoleName, page.role.name),
            since_s=self._unix(self._rules.requests[page.client]),
            given_at_s=None if given_s is None else self._unix(given_s),
        )

    def _did(self, client_id: str) -> None:
        self._watches.pop(client_id, None)
        self._apply(self._rules.deed(client_id, self._clock.steady_s()))

    def _belongs(self, client_id: str, session: str) -> None:
        self._sessions[client_id] = session
        self._sessions.move_to_end(client_id)
        if len(self._sessions) > _MOST_SESSIONS:
            self._drop_a_session()

    def _drop_a_session(self) -> None:
        """Forget whose the longest unused id is; never one with an open stream, or one that control is kept for."""
        kept = None if self._rules.last is None else self._rules.last.client
        for client_id in self._sessions:
            if client_id not in self._lines and client_id != kept:
                del self._sessions[client_id]
                return

    def _forget(self, client_id: str) -> None:
        self._lines.pop(client_id, None)
        self._watches.pop(client_id, None)
        self._called.pop(client_id, None)

    def _apply(self, effects: Iterable[Effect]) -> None:
        gone: list[str] = []
        for effect in effects:
            match effect:
                case HolderChange(page, reason, before):
                    self._stick_at = None
                    self.tell_flight(before if reason == "ended" else None)
                    if reason == "ended":
                        self._loop.call_later(KEPT_S, self.tell_flight)
                    self.on_holder(effect)
                    named = None if before is None else PageName(**fields(before))
                    self._told.event(ControlEvent(**fields(page), reason=reason, before=named))
                case KeptOver():
                    self.tell_flight()
                case StickLoss(client):
                    self._stick_at = None
                    gone.append(client)
                case RequestStart(page):
                    self._told.event(ControlRequestEvent(**asdict(self._request(page))))
                case RequestEnd(page, result):
                    self._told.event(ControlRequestEndEvent(**fields(page), result=result))
            self._told.changed()
        # After the holder, which says whether the choice of that gamepad has ended or only its samples.
        for client in gone:
            self._told.notice(StickRelease(client))

    def _look(self) -> float | None:
        """Look at the lines of those whose silence matters: who has control, who asks, and who was silent."""
        rules = self._rules
        watched = [*rules.requests, *rules.silent_pages, *(() if rules.holder is None else (rules.holder.client,))]
        self._watches = {client: self._watches.get(client) or Watch() for client in dict.fromkeys(watched)}
        for client, watch in tuple(self._watches.items()):
            self._look_at(client, watch)
        self._apply(rules.tick(self._clock.steady_s()))
        return LOOK_EVERY_S if self._lines or rules.kept_for is not None else None

    def _look_at(self, client: str, watch: Watch) -> None:
        """A page whose line cannot be looked at counts as silent: it must not keep control, nor end the watch."""
        rules = self._rules
        try:
            found = watch.look(self._lines[client])
        except Exception as error:  # noqa: BLE001 - told to the loop
            report_failure(self._loop, "the watch over a page's line", error)
            found = "silent"
        known = "silent" if client in rules.silent_pages else "hangs" if client == rules.hung else "heard"
        if found == known or (found, known) == ("hangs", "silent"):
            return
        if found == "hangs":
            self._apply(rules.hang(client))
        else:
            tell = rules.silent if found == "silent" else rules.heard
            self._apply(tell(client, self._clock.steady_s()))

    def _unix(self, steady_s: float) -> float:
        return self._clock.now_s() - self._clock.steady_s() + steady_s


def fields(page: Page | None) -> dict[str, Any]:
    """How status, events and answers name a page, or nobody."""
    if page is None:
        return dict(_NAMELESS)
    return {"client": page.client, "name": page.name, "kind": page.kind, "number": page.number}


def _numbered(base: str, number: int) -> str:
    return base if number == 1 else f"{base} {number}"


def base_name(caller: Caller) -> str:
    """What others call this caller; a page among several of that name gets a number besides."""
    return _THIS_COMPUTER if caller.kind == "local" else caller.name or _SOMEBODY
