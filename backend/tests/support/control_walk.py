"""A random walk through the rules of control, followed by somebody who sees only what the rules say happened."""

from __future__ import annotations

import copy
import random
from collections import Counter
from collections.abc import Callable
from dataclasses import replace
from typing import Final

from epf_gcs.access.authority import REFUSED_S, UNANSWERED_S, Authority
from epf_gcs.access.caller import LOCAL_SESSION
from epf_gcs.access.changes import Effect, HolderChange, KeptOver, Page, RequestEnd, RequestStart, StickLoss
from epf_gcs.access.roles import Role
from epf_gcs.errors import GatewayError

PAGES: Final = (
    Page("here", LOCAL_SESSION, "local", "this computer", 1, Role.owner),
    Page("here too", LOCAL_SESSION, "local", "this computer 2", 2, Role.owner),
    Page("ana", "a", "person", "Ana", 1, Role.operator),
    Page("ana too", "a", "person", "Ana 2", 2, Role.operator),
    Page("bea", "b", "person", "Bea", 1, Role.operator),
    Page("script", "s", "program", "script", 1, Role.operator),
    Page("olga", "o", "person", "Olga", 1, Role.owner),
    Page("eve", "e", "person", "Eve", 1, Role.viewer),
)
_CLIENTS: Final = tuple(page.client for page in PAGES)
_BY_CLIENT: Final = {page.client: page for page in PAGES}
_PAUSES_S: Final = (0.0,) * 12 + (0.02,) * 6 + (0.1, 0.5, 1.0, 3.0, 5.0, 11.0)
_WAY_BACK_EVERY: Final = 500


class Flight:
    """What the flight process is told, in order: it must never see a hand on the stick without control."""

    def __init__(self) -> None:
        self.holder: Page | None = None
        self.hand: str | None = None
        self.asking: set[str] = set()
        self.kept_over = 0
        self.reasons: Counter[str] = Counter()

    def hear(self, effects: list[Effect]) -> None:
        for effect in effects:
            match effect:
                case HolderChange(page, reason, before):
                    assert before is self.holder, "every change says who had it"
                    assert page is not before, "a change changes something"
                    assert self.hand is None, "the stick is let go before control goes on"
                    self.holder = page
                    self.reasons[reason] += 1
                case StickLoss(client):
                    assert self.hand == client
                    self.hand = None
                case RequestStart(page):
                    assert page.client not in self.asking
                    self.asking.add(page.client)
                case RequestEnd(page, result):
                    self.asking.remove(page.client)
                    self.reasons[result] += 1
                case KeptOver():
                    self.kept_over += 1


class Walk:
    """One walk. `rules` are those that it walks through."""

    def __init__(self, seed: int, rules: Authority | None = None) -> None:
        self.rules = rules or Authority(by_silence=True)
        self.flight = Flight()
        self.refusals: Counter[str] = Counter()
        self.ways_back = 0
        self._random = random.Random(seed)
        self._now_s = 0.0
        self._actions = self._table()

    def go(self, steps: int) -> None:
        """Take so many steps, and look after each."""
        actions, pauses, number = self._actions, len(_PAUSES_S), self._random.random
        for step in range(steps):
            self._now_s += _PAUSES_S[int(number() * pauses)]
            try:
                self.flight.hear(actions[int(number() * len(actions))](_CLIENTS[int(number() * len(_CLIENTS))]))
            except GatewayError as error:
                self.refusals[error.code] += 1
                assert not self.rules._effects, "what was refused has done nothing"
            self._look()
            if step % _WAY_BACK_EVERY == 0:
                self._find_way_back()

    def _look(self) -> None:
        rules, flight = self.rules, self.flight
        holder = rules.holder
        assert flight.holder is holder, "the flight knows who has control"
        assert flight.hand == rules.stick
        if holder is None:
            assert rules.stick is None, "no stick without a holder"
            assert rules.hung is None
            assert all(client in rules.silent_pages for client in rules.requests), "nobody waits for what is free"
        else:
            assert rules.stick in (None, holder.client), "no other hand on the stick"
            assert rules.hung in (None, holder.client)
            assert rules.hung is None or rules.stick is None, "no stick of a page that does nothing"
            assert rules.pages.get(holder.client) is holder, "who has control is there"
            assert holder.client not in rules.silent_pages, "and is heard"
            assert holder.may_command
            assert holder.client not in rules.requests
            assert rules.last is None, "what is held is kept for nobody else"
            assert rules.kept_for is None
        assert flight.asking == rules.requests.keys()
        assert rules.requests.keys() <= rules.pages.keys()
        assert rules.silent_pages <= rules.pages.keys()

    def _find_way_back(self) -> None:
        """From here anybody who may command gets control: by asking and waiting, and an owner at once."""
        self.ways_back += 1
        for client in ("bea", "olga"):
            rules, now_s = copy.deepcopy(self.rules), self._now_s
            if client not in rules.pages:
                rules.connect(_BY_CLIENT[client], now_s)
            rules.change(_BY_CLIENT[client], now_s)
            rules.heard(client, now_s)
            if client == "olga":
                rules.take(client, now_s, confirmed=True)
            else:
                now_s += REFUSED_S
                rules.tick(now_s)
                rules.ask(client, now_s)
                for _ in range(len(PAGES)):
                    if rules.holder is None or rules.holder.client != client:
                        now_s += UNANSWERED_S
                        rules.tick(now_s)
                        if client not in rules.requests and (rules.holder is None or rules.holder.client != client):
                            rules.ask(client, now_s)
            assert rules.holder is not None
            assert rules.holder.client == client, "there is a way back"

    def _table(self) -> tuple[Callable[[str], list[Effect]], ...]:
        rules = self.rules
        return (
            self._come,
            self._come,
            self._come,
            self._come_or_go,
            self._change,
            self._restart,
            self._move,
            self._move_own,
            rules.withdraw,
            lambda client: rules.silent(client, self._now_s) if client in rules.pages else [],
            lambda client: rules.hang(client) if client in rules.pages else [],
            lambda _: rules.hang(self._holder()) if rules.holder is not None else [],
            lambda client: rules.heard(client, self._now_s) if client in rules.pages else [],
            lambda client: rules.heard(client, self._now_s) if client in rules.pages else [],
            lambda client: rules.deed(client, self._now_s) if client in rules.pages else [],
            lambda client: rules.ask(client, self._now_s),
            lambda client: rules.ask(client, self._now_s),
            lambda client: rules.take(client, self._now_s, confirmed=self._random.random() < 0.5),
            lambda client: rules.release(client, self._now_s),
            lambda client: rules.grant(client, self._some(), self._now_s),
            lambda _: rules.grant(self._holder(), next(iter(rules.requests), ""), self._now_s),
            lambda client: rules.refuse(client, self._some(), self._now_s),
            lambda _: rules.refuse(self._holder(), next(iter(rules.requests), ""), self._now_s),
            lambda client: rules.hand_over(client, self._some(), self._now_s),
            lambda _: rules.hand_over(self._holder(), self._some(), self._now_s),
            lambda _: rules.tick(self._now_s),
            lambda _: rules.tick(self._now_s),
            lambda client: rules.end(_BY_CLIENT[client].session, self._now_s) if self._random.random() < 0.2 else [],
        )

    def _some(self) -> str:
        return _CLIENTS[int(self._random.random() * len(_CLIENTS))]

    def _holder(self) -> str:
        return "" if self.rules.holder is None else self.rules.holder.client

    def _come(self, client: str) -> list[Effect]:
        return [] if client in self.rules.pages else self.rules.connect(_BY_CLIENT[client], self._now_s)

    def _come_or_go(self, client: str) -> list[Effect]:
        return self.rules.disconnect(client, self._now_s) if client in self.rules.pages else self._come(client)

    def _restart(self, client: str) -> list[Effect]:
        return [] if self.rules.pages else self.rules.restore(_BY_CLIENT[client], self._now_s)

    def _move(self, client: str) -> list[Effect]:
        if self.rules.move_stick(client, self._now_s, moved=self._random.random() < 0.5):
            self.flight.hand = client
        return []

    def _move_own(self, _: str) -> list[Effect]:
        return self._move(self._holder())

    def _change(self, client: str) -> list[Effect]:
        page = self.rules.pages.get(client)
        if page is None:
            return []
        new = _BY_CLIENT[client] if page.role == Role.viewer else replace(page, role=Role.viewer)
        if self._holder() == client:
            self.flight.holder = new
        return self.rules.change(new, self._now_s)
