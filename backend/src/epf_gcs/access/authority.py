"""Who has control: one table of rules, without clock, loop or network.

Each method is something that happened, with the time on a steady clock in seconds; it returns what follows from it.
Control is a page's: one stream, opened by one session. Nobody moves the stick but the page that has control.
"""

from __future__ import annotations

from typing import Final

from epf_gcs.access import refusals
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
from epf_gcs.contract.events import ControlReason, RequestResult

UNANSWERED_S: Final = 10.0
"""A holder who neither answers nor does anything for so long has left the page alone."""
KEPT_S: Final = 5.0
"""For so long nobody gets a lost control without asking: a page is being loaded again, a radio is out of reach."""
REFUSED_S: Final = 10.0
"""Who was refused may ask again after this."""


class Authority:
    """Holder, requests and who is there. Times of the arguments must not go back."""

    def __init__(self, *, by_silence: bool = False) -> None:
        """`by_silence`: a request that the holder leaves unanswered is granted after `UNANSWERED_S`; else it waits."""
        self._by_silence = by_silence
        # In the order in which they came.
        self.pages: dict[str, Page] = {}
        self.holder: Page | None = None
        self.since_s = 0.0
        # The page whose samples of the stick were taken last; it has control.
        self.stick: str | None = None
        # Who asks, since when: the first has asked longest.
        self.requests: dict[str, float] = {}
        # Who had control until it was lost, and gets it back on return while nobody has it.
        self.last: Page | None = None
        self.kept_until_s: float | None = None
        # Whose stream is open, although nothing is heard.
        self.silent_pages: set[str] = set()
        # The page that has control and does nothing, although its line stands: busy, or stuck.
        self.hung: str | None = None
        self._refused_s: dict[str, float] = {}
        self._did_s = 0.0
        self._effects: list[Effect] = []

    @property
    def kept_for(self) -> Page | None:
        """Who has just lost control, and gets it back without asking."""
        return None if self.kept_until_s is None else self.last

    def given_s(self, client: str) -> float | None:
        """When this page's request is granted by time alone unless the holder acts before; None: never."""
        return max(self.requests[client], self.since_s, self._did_s) + UNANSWERED_S if self._by_silence else None

    def restore(self, page: Page, now_s: float) -> list[Effect]:
        """Before a restart this page had control: keep it for its return."""
        if self.holder is None and self.last is None:
            self.last = page
            self.kept_until_s = now_s + KEPT_S
        return self._done()

    def connect(self, page: Page, now_s: float) -> list[Effect]:
        """A page came. Its id is of no page that is there."""
        others = any(one.may_command for one in self.pages.values())
        self.pages[page.client] = page
        last = self.last
        if self.holder is None and page.may_command:
            is_kept = self.kept_until_s is not None
            if last is not None and last.session == page.session and (last.client == page.client or not is_kept):
                self._give(page, "back", now_s)
            elif not is_kept and (page.is_local or not others):
                self._give(page, "first", now_s)
        return self._done()

    def disconnect(self, client: str, now_s: float) -> list[Effect]:
        """A page's stream is closed."""
        page = self._remove(client)
        if self.holder is page:
            self._lose("lost", now_s)
        return self._done()

    def end(self, session: str, now_s: float) -> list[Effect]:
        """A session or key is no longer good: its pages are no longer there."""
        gone = [self._remove(page.client) for page in tuple(self.pages.values()) if page.session == session]
        if self.last is not None and self.last.session == session:
            self._forget_last()
        if self.holder in gone:
            self._free("ended")
            self._serve_who_ask(now_s)
        return self._done()

    def change(self, page: Page, now_s: float) -> list[Effect]:
        """A page that is there has another role or name."""
        self.pages[page.client] = page
        holds = self.holder is not None and self.holder.client == page.client
        if holds:
            self.holder = page
        if not page.may_command:
            self._close(page, "gone")
            if holds:
                self._free("ended")
                self._serve_who_ask(now_s)
        return self._done()

    def silent(self, client: str, now_s: float) -> list[Effect]:
        """Nothing is heard of a page, although its stream is open."""
        self.silent_pages.add(client)
        if self.holder is not None and self.holder.client == client:
            self._lose("silent", now_s)
        return self._done()

    def hang(self, client: str) -> list[Effect]:
        """A page does nothing, although its line stands: a globe is loading, or it is stuck.

        Its hand is off the stick, and whoever asks gets control; while nobody does, a busy page loses nothing.
        """
        if self.holder is not None and self.holder.client == client:
            self.hung = client
            self._let_stick_go()
        else:
            self.silent_pages.add(client)
        return self._done()

    def heard(self, client: str, now_s: float) -> list[Effect]:
        """A page is heard again, or did something."""
        self.silent_pages.discard(client)
        if self.hung == client:
            self.hung = None
        page, last = self.pages[client], self.last
        if self.holder is None:
            if last is not None and (last.client, last.session) == (client, page.session) and page.may_command:
                self._give(page, "back", now_s)
            else:
                self._serve_who_ask(now_s)
        return self._done()

    def deed(self, client: str, now_s: float) -> list[Effect]:
        """A page sent a command, or something else that needs control."""
        effects = self.heard(client, now_s)
        if self.holder is not None and self.holder.client == client:
            self._did_s = now_s
        return effects

    def move_stick(self, client: str, now_s: float, *, moved: bool) -> bool:
        """A sample of a page's stick, `moved` since the one before. False: it does not count, for it has no control."""
        if self.holder is None or self.holder.client != client:
            return False
        self.stick, self.hung = client, None
        if moved:
            self._did_s = now_s
        return True

    def take(self, client: str, now_s: float, *, confirmed: bool) -> list[Effect]:
        """Take control: anybody who may command while nobody has it; an owner from anybody, having confirmed it."""
        page = self._asker(client)
        if self.holder is None:
            self._give(page, "asked", now_s)
        elif self.holder is not page:
            if page.role < Role.owner:
                raise refusals.held(self.holder)
            if not confirmed:
                raise refusals.unconfirmed(self.holder)
            self._give(page, "taken", now_s)
        return self._done()

    def ask(self, client: str, now_s: float) -> list[Effect]:
        """Ask for control: at once while nobody has it, else the holder is asked."""
        page = self._asker(client)
        if self.holder is None:
            self._give(page, "asked", now_s)
        elif self.holder is not page and client not in self.requests:
            wait_s = self._refused_s.get(page.refused_as, now_s - REFUSED_S) + REFUSED_S - now_s
            if wait_s > 0.0:
                raise refusals.refused(self.holder, wait_s)
            self.requests[client] = now_s
            self._effects.append(RequestStart(page))
        return self._done()

    def withdraw(self, client: str) -> list[Effect]:
        """A page asks no longer."""
        if client in self.pages:
            self._close(self.pages[client], "withdrawn")
        return self._done()

    def grant(self, client: str, to: str, now_s: float) -> list[Effect]:
        """The holder gives control to a page that asked."""
        self._check_holds(client)
        page = self._request_of(to)
        self._check_heard(page)
        self._give(page, "granted", now_s)
        return self._done()

    def refuse(self, client: str, to: str, now_s: float) -> list[Effect]:
        """The holder keeps control; who asked may ask again in a while."""
        self._check_holds(client)
        page = self._request_of(to)
        self._refused_s[page.refused_as] = self._did_s = now_s
        self._close(page, "refused")
        return self._done()

    def hand_over(self, client: str, to: str, now_s: float) -> list[Effect]:
        """The holder gives control to any page that may have it."""
        holder = self._check_holds(client)
        page = self._connected(to)
        if not page.may_command:
            raise refusals.only_watches(page)
        self._check_heard(page)
        if page is not holder:
            self._give(page, "handed_over", now_s)
        return self._done()

    def release(self, client: str, now_s: float) -> list[Effect]:
        """The holder gives control back; who asked longest gets it."""
        if self.holder is not None:
            self._check_holds(client)
            self._free("released")
            self._serve_who_ask(now_s)
        return self._done()

    def tick(self, now_s: float) -> list[Effect]:
        """Time passed; call it some times a second."""
        for who in [who for who, at_s in self._refused_s.items() if now_s - at_s >= REFUSED_S]:
            del self._refused_s[who]
        if self.holder is None:
            self._serve_who_ask(now_s)
            if self.kept_until_s is not None and now_s >= self.kept_until_s:
                self._kept_over(now_s)
        else:
            asker = self._longest_asker()
            if asker is not None and self.hung is not None:
                self.silent_pages.add(self.hung)
                self._lose("silent", now_s)
            elif asker is not None:
                given_s = self.given_s(asker.client)
                if given_s is not None and now_s >= given_s:
                    self._give(asker, "unanswered", now_s)
        return self._done()

    def check(self, client: str | None, session: str) -> None:
        """Raise ConflictError unless this page of this session may command now.

        Without a page only while nobody has control. Ids are told to everybody, so the session decides.
        """
        if self.holder is not None and (self.holder.client, self.holder.session) != (client, session):
            raise refusals.held(self.holder)

    def _give(self, page: Page, reason: ControlReason, now_s: float) -> None:
        before = self.holder
        self._let_stick_go()
        self.holder, self.hung = page, None
        self.since_s = self._did_s = now_s
        self.last = self.kept_until_s = None
        self._close(page, "given")
        self._effects.append(HolderChange(page, reason, before))

    def _free(self, reason: ControlReason) -> None:
        before, self.holder, self.hung = self.holder, None, None
        self._let_stick_go()
        self._effects.append(HolderChange(None, reason, before))

    def _lose(self, reason: ControlReason, now_s: float) -> None:
        self.last = self.holder
        self.kept_until_s = now_s + KEPT_S
        self._free(reason)
        self._serve_who_ask(now_s)

    def _remove(self, client: str) -> Page:
        page = self.pages.pop(client)
        self.silent_pages.discard(client)
        self._close(page, "gone")
        return page

    def _let_stick_go(self) -> None:
        if self.stick is not None:
            self._effects.append(StickLoss(self.stick))
            self.stick = None

    def _kept_over(self, now_s: float) -> None:
        last = self.kept_for
        self.kept_until_s = None
        if last is None:
            return
        self._effects.append(KeptOver(last))
        for page in self.pages.values():
            if page.session == last.session and page.may_command and page.client not in self.silent_pages:
                self._give(page, "waited", now_s)
                return

    def _forget_last(self) -> None:
        kept = self.kept_for
        self.last = self.kept_until_s = None
        if kept is not None:
            self._effects.append(KeptOver(kept))

    def _serve_who_ask(self, now_s: float) -> None:
        asker = self._longest_asker()
        if asker is not None:
            self._give(asker, "asked", now_s)

    def _longest_asker(self) -> Page | None:
        return next((self.pages[client] for client in self.requests if client not in self.silent_pages), None)

    def _close(self, page: Page, result: RequestResult) -> None:
        if self.requests.pop(page.client, None) is not None:
            self._effects.append(RequestEnd(page, result))

    def _connected(self, client: str) -> Page:
        page = self.pages.get(client)
        if page is None:
            raise refusals.unknown(client)
        return page

    def _asker(self, client: str) -> Page:
        page = self._connected(client)
        if not page.may_command:
            raise refusals.too_low(page)
        self.silent_pages.discard(client)
        return page

    def _check_holds(self, client: str) -> Page:
        if self.holder is None:
            raise refusals.not_held()
        if self.holder.client != client:
            raise refusals.held(self.holder)
        return self.holder

    def _request_of(self, client: str) -> Page:
        if client not in self.requests:
            raise refusals.not_asked(client)
        return self.pages[client]

    def _check_heard(self, page: Page) -> None:
        if page.client in self.silent_pages:
            raise refusals.silent(page)

    def _done(self) -> list[Effect]:
        effects, self._effects = self._effects, []
        return effects
