"""Where the pilot's stick comes from: the simulator's rows 8 and 25, or the gamepad at the operator's browser."""

from __future__ import annotations

import asyncio
from collections import Counter
from collections.abc import Callable, Mapping
from typing import Any, Final, Literal

from epf_gcs.bus.definition import Client
from epf_gcs.contract.events import StickEvent, StickReason
from epf_gcs.errors import ConflictError
from epf_gcs.vehicle.outside import Clock, Outlet
from epf_gcs.xplane.datagram import Surfaces
from epf_gcs.xplane.stick import GamepadInput, read_sample

StickSource = Literal["simulator", "gamepad"]
StickState = Literal["live", "lost"]

# A page starts sending samples together with its request: without one after this long no gamepad is active.
_FIRST_SAMPLE_S: Final = 1.0
# Longer than the web process keeps control for a page that was lost: it decides, unless it has died meanwhile.
_KEPT_S: Final = 15.0


class Stick:
    """Samples count only from the page that has control. Without it the stick is let go at once; the choice of its
    gamepad ends when another has control, or when it is kept for nobody any longer."""

    def __init__(
        self,
        outlet: Outlet,
        clock: Clock,
        on_change: Callable[[], None],
        on_holder: Callable[[], None] = lambda: None,
    ) -> None:
        """`on_holder` is called when another browser, or none, has control."""
        self._event = outlet.event
        self._on_holder = on_holder
        self._clock = clock
        self._on_change = on_change
        self._input = GamepadInput()
        self._holder: Client | None = None
        self._kept: Client | None = None
        self._kept_since_s = 0.0
        self._pilot: Client | None = None
        self._was_live = False
        self._arrived = asyncio.Event()
        self.gamepad: str | None = None
        self.counts: Counter[str] = Counter()

    @property
    def source(self) -> StickSource:
        """Whether the simulator's or a gamepad's stick position is used."""
        return "simulator" if self._pilot is None else "gamepad"

    @property
    def state(self) -> StickState | None:
        """Whether the gamepad's samples arrive; None if no gamepad is chosen."""
        if self._pilot is None:
            return None
        return "live" if self._input.is_live(self._clock.steady_s()) else "lost"

    @property
    def holder(self) -> Client | None:
        """The browser that has control, as the web process reported last."""
        return self._holder

    @property
    def last_holder(self) -> Client | None:
        """The same, or the one that has just lost it and gets it back on return."""
        return self._holder or self._kept

    @property
    def pilot(self) -> Client | None:
        """The browser whose gamepad is chosen."""
        return self._pilot

    def now(self, now_s: float) -> Surfaces | None:
        """What replaces the simulator's stick at `now_s`; None while no gamepad is chosen."""
        return None if self._pilot is None else self._input.position(now_s)

    def take(self, client: str, sample: Mapping[str, Any]) -> None:
        """Take a sample from a browser; unusable ones are counted."""
        read = read_sample(sample)
        if read is None:
            self.counts["invalid"] += 1
            return
        if self._holder is None or self._holder.id != client:
            # Not an error of the page: it learns only from the next status that it lost control.
            self.counts["not_operator"] += 1
            return
        surfaces, sent_s = read
        if not self._input.take(surfaces, sent_s, self._clock.steady_s()):
            self.counts["late"] += 1
            return
        self.counts["taken"] += 1
        self._arrived.set()
        if self._pilot is not None and not self._was_live:
            self._announce_state()

    async def choose_gamepad(self, client: str | None, gamepad: str) -> None:
        """Use this browser's gamepad, once a sample has arrived. Raises ConflictError."""
        self._check_holder(client)
        if not self._input.is_live(self._clock.steady_s()):
            self._input.let_go()
            self._arrived.clear()
            try:
                await asyncio.wait_for(self._arrived.wait(), _FIRST_SAMPLE_S)
            except TimeoutError:
                raise ConflictError(
                    "stick_silent",
                    "The gamepad was not taken because nothing of it arrives: connect it, press one of its buttons and "
                    "keep its page in sight.",
                ) from None
        # Control may have gone to somebody else while the first sample was waited for.
        self._pilot = self._check_holder(client)
        self.gamepad = gamepad
        self._was_live = True
        self._announce("chosen")

    def choose_simulator(self) -> None:
        """Use the stick position of the simulator's rows."""
        self._end("chosen")

    def control_changed(self, holder: Client | None, kept: Client | None = None) -> None:
        """Another page, or none, has control: a gamepad whose page lost it is no longer used.

        `kept`: nobody has control, but this page gets it back on return. Until then its gamepad counts as lost.
        """
        is_news = holder != self._holder
        self._holder, self._kept, self._kept_since_s = holder, kept, self._clock.steady_s()
        if is_news:
            self._on_holder()
        may_fly = holder or kept
        if self._pilot is not None and (may_fly is None or may_fly.id != self._pilot.id):
            self._end("control_lost")
        if self._pilot is None or holder is None:
            self._input.let_go()
            self.tick()

    def let_go(self, client: str | None = None) -> None:
        """Drop the samples of this browser (None: of every browser): its connection ended or was replaced."""
        hand = self._pilot or self._holder
        if hand is not None and client in (None, hand.id):
            self._input.let_go()
            self.tick()

    def tick(self) -> None:
        """Announce loss and return of the samples; called a few times a second."""
        if self._holder is None and self._kept is not None and self._clock.steady_s() - self._kept_since_s > _KEPT_S:
            self._kept = None
            self._end("control_lost")
        if self._pilot is not None and self._was_live != (self.state == "live"):
            self._announce_state()

    def _check_holder(self, client: str | None) -> Client:
        if self._holder is None or self._holder.id != client:
            raise ConflictError(
                "stick_needs_control",
                "Only the page that has control can fly with its gamepad: take control there first.",
            )
        return self._holder

    def _announce_state(self) -> None:
        self._was_live = self.state == "live"
        self._announce("back" if self._was_live else "lost")

    def _end(self, reason: StickReason) -> None:
        if self._pilot is None:
            return
        gamepad = self.gamepad
        self._pilot = self.gamepad = None
        self._announce(reason, gamepad)

    def _announce(self, reason: StickReason, gamepad: str | None = None) -> None:
        pilot = self._pilot
        client, name = (None, None) if pilot is None else (pilot.id, pilot.name)
        self._event(StickEvent(self.source, self.state, reason, client, name, self.gamepad or gamepad))
        self._on_change()
