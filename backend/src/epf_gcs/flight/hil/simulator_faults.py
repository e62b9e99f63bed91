"""Faults and wind of the embedded simulator: ordered, watched, told to the viewers and noted in the recording.

The simulator says what goes wrong there, unasked, beside its rows. X-Plane says nothing of the kind, and is
sent no orders.
"""

from __future__ import annotations

import asyncio
import contextlib
from collections.abc import Callable, Mapping
from dataclasses import asdict
from typing import Final, Literal, cast
from uuid import uuid4

from epf_gcs.clock import Clock
from epf_gcs.contract.events import FaultEvent, WindEvent
from epf_gcs.contract.simulator_faults import (
    MOST_FAULTS,
    Fault,
    FaultKind,
    FaultOrder,
    FaultPlace,
    FaultReport,
    FaultState,
    FlownFault,
    OrderedFault,
    SimulatedFaults,
    WindState,
    datagram,
    not_carried,
    read_datagram,
)
from epf_gcs.errors import ConflictError, InvalidInputError, NotFoundError, UnavailableError
from epf_gcs.repeating import repeat
from epf_gcs.vehicle.outside import Outlet

_LOOK_S: Final = 0.5
# The simulator is gone when it has said nothing for so long.
_GONE_S: Final = 5.0
# An order is sent so often, with this pause, until its report comes.
_TRIES: Final = 10
_TRY_S: Final = 0.5


class SimulatorFaultControl:
    """`send`: a datagram to the simulator. `on_change`: what is flown has changed. `know`: for the recording."""

    def __init__(
        self,
        send: Callable[[bytes], None],
        outlet: Outlet,
        clock: Clock,
        know: Callable[[Mapping[str, object]], None],
        on_change: Callable[[], None],
    ) -> None:
        self._send = send
        self._outlet = outlet
        self._clock = clock
        self._know = know
        self._on_change = on_change
        self._serial = 0
        self._answered = asyncio.Event()
        self._report: FaultReport | None = None
        self._heard_s = 0.0
        self._states: dict[str, FaultState] = {}

    @property
    def flown(self) -> SimulatedFaults | None:
        """What goes wrong now; None: the simulator takes no orders."""
        if self._report is None:
            return None
        faults = sorted(self._states.values(), key=lambda one: (one.begins_s, one.id))
        return SimulatedFaults(faults, self._report.wind)

    async def run(self) -> None:
        """Miss the simulator when it is gone, forever."""
        await repeat(_LOOK_S, "faults of the simulator", self._look)

    async def _look(self) -> None:
        if self._clock.steady_s() - self._heard_s > _GONE_S:
            self._take(None)

    def on_datagram(self, data: bytes | None) -> None:
        """A report of the simulator; None: its port was closed."""
        report = None if data is None else read_datagram(data, FaultReport)
        if data is None or report is not None:
            self._heard_s = self._clock.steady_s()
            self._take(report)

    async def begin(self, fault: Fault) -> FaultState:
        """Let it begin `start_s` from now. Raises InvalidInputError, ConflictError, UnavailableError."""
        why = not_carried(fault.place, fault.kind)
        if why is not None:
            raise InvalidInputError(
                "fault_not_carried",
                f"The simulator cannot fly {fault.place}.{fault.kind}: {why}.",
                fault=f"{fault.place}.{fault.kind}",
            )
        if len(self._states) >= MOST_FAULTS:
            raise ConflictError(
                "faults_full", f"{MOST_FAULTS} faults wait or are there already: end one first.", most=MOST_FAULTS
            )
        name = uuid4().hex[:8]
        await self._order(FaultOrder(self._next(), begin=OrderedFault(name, fault)), lambda: name in self._states)
        return self._states[name]

    async def end(self, name: str | None) -> SimulatedFaults:
        """End a fault, or all. Raises NotFoundError, ConflictError, UnavailableError."""
        if name is None:
            return await self._order(FaultOrder(self._next(), ends_all=True), lambda: not self._states)
        self._check()
        if name not in self._states:
            raise NotFoundError("fault_unknown", f"There is no fault '{name}' now: it has ended.", id=name)
        return await self._order(FaultOrder(self._next(), end=name), lambda: name not in self._states)

    async def blow(self, wind: WindState) -> SimulatedFaults:
        """Steady wind and turbulence from now on. Raises ConflictError, UnavailableError."""
        serial = self._next()
        return await self._order(
            FaultOrder(serial, wind=wind), lambda: self._report is not None and self._report.serial == serial
        )

    async def _order(self, order: FaultOrder, is_done: Callable[[], bool]) -> SimulatedFaults:
        self._check()
        for _ in range(_TRIES):
            self._answered.clear()
            self._send(datagram(order))
            with contextlib.suppress(TimeoutError):
                async with asyncio.timeout(_TRY_S):
                    while not is_done():
                        await self._answered.wait()
                        self._answered.clear()
            flown = self.flown
            if is_done() and flown is not None:
                return flown
        raise UnavailableError("faults_silent", "The simulator does not answer: see whether it still runs, try again.")

    def _check(self) -> None:
        if self._report is None:
            raise ConflictError(
                "faults_no_simulator",
                "Faults and wind are for the embedded simulator, and none is in the loop: start epf-run or epf-sim.",
            )

    def _next(self) -> int:
        self._serial += 1
        return self._serial

    def _take(self, report: FaultReport | None) -> None:
        """Compare with what was known, and tell what has changed; None: the simulator is gone."""
        before, wind_before = self._states, None if self._report is None else self._report.wind
        if report is None and self._report is None:
            return
        now_s = self._clock.now_s()
        listed = () if report is None else report.faults
        self._report = report
        self._states = {one.id: self._state(one, now_s) for one in listed if not one.is_over}
        frames = {one.id: one.frames for one in listed}
        for name, state in {**before, **self._states}.items():
            was = before.get(name)
            if state.is_on and (was is None or not was.is_on):
                self._outlet.event(_event("begun", state, frames.get(name)))
            if was is not None and was.is_on and not (name in self._states and state.is_on):
                self._outlet.event(_event("ended", was, frames.get(name)))
        if report is not None and wind_before is not None and report.wind != wind_before:
            self._outlet.event(WindEvent(**asdict(report.wind)))
        self._answered.set()
        if before != self._states or wind_before != (None if report is None else report.wind):
            self._know({"flown": None if self.flown is None else asdict(self.flown)})
            self._on_change()

    def _state(self, flown: FlownFault, now_s: float) -> FaultState:
        """Its times as they were first heard, while nothing changes them: a pause of the simulator shifts them."""
        fault = flown.fault
        begins_s = now_s + flown.begins_in_s
        ends_s = None if flown.ends_in_s is None else now_s + flown.ends_in_s
        was = self._states.get(flown.id)
        if was is not None:
            begins_s = _kept(was.begins_s, begins_s)
            ends_s = None if ends_s is None else _kept(was.ends_s, ends_s)
        return FaultState(
            id=flown.id,
            place=cast(FaultPlace, fault.place),
            kind=cast(FaultKind, fault.kind),
            strength=fault.amount if fault.about.unit else None,
            unit=fault.about.unit,
            begins_s=begins_s,
            ends_s=ends_s,
            is_on=flown.begins_in_s <= 0.0,
        )


def _event(state: Literal["begun", "ended"], fault: FaultState, frames: int | None) -> FaultEvent:
    return FaultEvent(state, fault.id, fault.place, fault.kind, fault.strength, fault.unit, frames)


def _kept(before_s: float | None, now_s: float) -> float:
    """The earlier figure while the two differ by no more than the ways of datagrams do."""
    return now_s if before_s is None or abs(before_s - now_s) > _LOOK_S else before_s
