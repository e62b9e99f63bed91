"""Where the pilot's stick comes from: the simulator's rows 8 and 25, or the gamepad at the operator's browser."""

from __future__ import annotations

import asyncio
from collections import Counter
from collections.abc import Callable, Mapping
from typing import Any, Final, Literal

from epf_gcs.clock import Clock
from epf_gcs.errors import ConflictError
from epf_gcs.web.access.control import Client, Control
from epf_gcs.web.stream.hub import Hub
from epf_gcs.xplane.datagram import Surfaces
from epf_gcs.xplane.stick import Hand

StickSource = Literal["simulator", "gamepad"]
StickState = Literal["live", "lost"]
Reason = Literal["chosen", "control_lost", "lost", "back"]

FIELDS: Final = (*Surfaces._fields, "t_ms")
# A page sends its first sample with the question; one that has none after so long has no gamepad that speaks.
_FIRST_SAMPLE_S: Final = 1.0
_INVALID: Final = (
    "A sample of the stick was dropped: send elevator, aileron, rudder (-1..1), throttle (0..1) and t_ms, "
    "each a finite number."
)


class Stick:
    """Samples count only from the browser that has control; the choice ends with that browser's control."""

    def __init__(self, control: Control, hub: Hub, clock: Clock, on_change: Callable[[], None]) -> None:
        self._control = control
        self._hub = hub
        self._clock = clock
        self._on_change = on_change
        self._hand = Hand()
        self._pilot: Client | None = None
        self._was_live = False
        self._arrived = asyncio.Event()
        self.gamepad: str | None = None
        self.counts: Counter[str] = Counter()

    @property
    def source(self) -> StickSource:
        """Whose positions are flown."""
        return "simulator" if self._pilot is None else "gamepad"

    @property
    def state(self) -> StickState | None:
        """Whether the gamepad's samples come; None where none is chosen."""
        if self._pilot is None:
            return None
        return "live" if self._hand.is_live(self._clock.steady_s()) else "lost"

    @property
    def pilot(self) -> Client | None:
        """The browser whose gamepad is chosen."""
        return self._pilot

    def now(self, now_s: float) -> Surfaces | None:
        """What takes the place of the simulator's stick at `now_s`; None: nothing does."""
        return None if self._pilot is None else self._hand.position(now_s)

    def take(self, client: str, message: Mapping[str, Any]) -> str | None:
        """A sample from a browser. Answers the sentence of what is wrong with its form, None where nothing is."""
        values = [message.get(name) for name in FIELDS]
        if not all(isinstance(value, int | float) and not isinstance(value, bool) for value in values):
            self.counts["invalid"] += 1
            return _INVALID
        *position, t_ms = (float(value) for value in values if value is not None)
        surfaces = Surfaces(*position).clamped()
        if surfaces is None or not abs(t_ms) < 1e15:
            self.counts["invalid"] += 1
            return _INVALID
        holder = self._control.holder
        if holder is None or holder.id != client:
            # A page that lost control learns it by the next status: until then this is no mistake of its own.
            self.counts["not_operator"] += 1
            return None
        if not self._hand.take(surfaces, t_ms / 1000.0, self._clock.steady_s()):
            self.counts["late"] += 1
            return None
        self.counts["taken"] += 1
        self._arrived.set()
        if self._pilot is not None and not self._was_live:
            self._tell_state()
        return None

    async def choose_gamepad(self, client: str | None, gamepad: str) -> None:
        """The gamepad of this browser flies from now on, once a sample of it is here. Raises ConflictError."""
        holder = self._control.holder
        if holder is None or holder.id != client:
            raise ConflictError(
                "stick_needs_control",
                "Only the page that has control can fly with its gamepad: take control there first.",
            )
        if not self._hand.is_live(self._clock.steady_s()):
            self._hand.let_go()
            self._arrived.clear()
            try:
                await asyncio.wait_for(self._arrived.wait(), _FIRST_SAMPLE_S)
            except TimeoutError:
                raise ConflictError(
                    "stick_silent",
                    "The gamepad was not taken because nothing of it arrives: connect it, press one of its buttons and "
                    "keep its page in sight.",
                ) from None
        self._control.check(client)
        self._pilot = holder
        self.gamepad = gamepad
        self._was_live = True
        self._tell("chosen")

    def choose_simulator(self) -> None:
        """The simulator's rows fly from now on."""
        self._end("chosen")

    def control_changed(self, holder: Client | None) -> None:
        """Another browser, or nobody, has control: no gamepad flies on from a page that may not command."""
        if self._pilot is not None and (holder is None or holder.id != self._pilot.id):
            self._end("control_lost")
        if self._pilot is None:
            self._hand.let_go()

    def gone(self, client: str) -> None:
        """This browser's connection is over, or begins anew: what it sent before does not count any longer."""
        holder = self._control.holder
        if holder is not None and holder.id == client:
            self._hand.let_go()
            self.tick()

    def tick(self) -> None:
        """Called some times a second: samples that stopped are told of."""
        if self._pilot is not None and self._was_live != (self.state == "live"):
            self._tell_state()

    def _tell_state(self) -> None:
        self._was_live = self.state == "live"
        self._tell("back" if self._was_live else "lost")

    def _end(self, reason: Reason) -> None:
        if self._pilot is None:
            return
        gamepad = self.gamepad
        self._pilot = self.gamepad = None
        self._tell(reason, gamepad)

    def _tell(self, reason: Reason, gamepad: str | None = None) -> None:
        pilot = self._pilot
        self._hub.event(
            "stick",
            {
                "source": self.source,
                "state": self.state,
                "reason": reason,
                "client": None if pilot is None else pilot.id,
                "name": None if pilot is None else pilot.name,
                "gamepad": self.gamepad or gamepad,
            },
        )
        self._on_change()
