"""A random walk of streams that come and go, wish for ids and command by them, held against who has had which id."""

from __future__ import annotations

import os
import random
from collections import deque

import pytest

from epf_gcs.access.caller import LOCAL, Caller
from epf_gcs.access.roles import Role
from epf_gcs.errors import GatewayError
from tests.access.test_control_alone import Desk, Line, person

STEPS = int(os.environ.get("CONTROL_STEPS", "30000"))
CALLERS = (LOCAL, person("ana"), person("bea"), person("olga", Role.owner), person("eve", Role.viewer))


class IdsWalk:
    """`whose`: the session that was last given an id, by id."""

    def __init__(self, seed: int) -> None:
        self.random = random.Random(seed)
        self.desk = Desk()
        self.open: dict[str, tuple[Line, Caller]] = {}
        self.whose: dict[str, str] = {}
        self.recent: deque[str] = deque(maxlen=40)
        self.commanded = self.refused = 0

    def step(self) -> None:
        caller = self.random.choice(CALLERS)
        action = self.random.random()
        if action < 0.45:
            self._come(caller)
        elif action < 0.7 and self.open:
            self._go(self.random.choice(list(self.open)))
        else:
            self._command(caller)
        self.desk.clock.time_s += self.random.choice((0.0, 0.0, 0.1, 6.0))
        self.desk.control._look()
        self.desk.events.clear()
        self.desk.notices.clear()
        self.desk.loop.timers.clear()
        holder = self.desk.control.holder
        if holder is not None:
            assert self.open[holder.client][1].session == holder.session, "who has control is there"

    def _some_id(self) -> str:
        return self.random.choice([*self.recent, f"{self.random.getrandbits(64):016x}"])

    def _come(self, caller: Caller) -> None:
        if len(self.open) > 20:
            return
        wished = self._some_id()
        client = self.desk.control.client_for(wished, caller)
        if client == wished:
            assert self.whose[client] == caller.session, "an id comes back to its own session alone"
        if client in self.open:  # a silent stream whose place the new one takes
            self._go(client)
        line = Line()
        line.heard = self.random.randrange(1000)
        self.desk.control.connect(client, caller, "", line)
        self.open[client] = (line, caller)
        self.whose[client] = caller.session
        self.recent.append(client)

    def _go(self, client: str) -> None:
        line, _ = self.open.pop(client)
        self.desk.control.disconnect(client, line)

    def _command(self, caller: Caller) -> None:
        client = self._some_id()
        try:
            self.desk.control.command(caller, client)
        except GatewayError:
            self.refused += 1
        else:
            self.commanded += 1
            assert self.whose[client] == caller.session, "nobody commands by another's id"
            holder = self.desk.control.holder
            assert holder is None or (holder.client, holder.session) == (client, caller.session)
        if client in self.open:
            own = self.open[client][1]
            assert self.desk.control.own(own, client) == client, "the id of an open stream is not forgotten"


@pytest.mark.uncounted
def test_nobody_commands_by_an_id_of_another_session_and_no_open_stream_is_forgotten() -> None:
    walk = IdsWalk(seed=20261126)
    for _ in range(STEPS):
        walk.step()
    assert walk.commanded > STEPS // 100
    assert walk.refused > STEPS // 100
