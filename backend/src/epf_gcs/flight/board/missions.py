"""Flight plans to the board and back: whole or not at all, and read back."""

from __future__ import annotations

import asyncio
from collections.abc import Callable, Sequence
from typing import Final

from epf_gcs.codec.frame import Frame
from epf_gcs.codec.messages_gen import COMMANDS
from epf_gcs.codec.tables import Waypoint
from epf_gcs.codec.values import Meaning
from epf_gcs.contract.events import MissionEvent, MissionState
from epf_gcs.errors import BoardError, ConflictError, InvalidInputError
from epf_gcs.flight.board.commands import Commands
from epf_gcs.vehicle.board import Board
from epf_gcs.vehicle.mission import PLAN_NUMBERS, Plan, item_arguments, mission_fault, same_plan, waypoint_from
from epf_gcs.vehicle.outside import Outlet

# 100 waypoints are 4.8 kB: half a second of a 115200 line.
_READ_S: Final = 5.0


class Missions:
    """One transfer at a time. `on_read` is called with each plan that was read from the board."""

    def __init__(
        self, board: Board, commands: Commands, outlet: Outlet, on_read: Callable[[Plan, list[Waypoint]], None]
    ) -> None:
        self._board = board
        self._commands = commands
        self._outlet = outlet
        self._lock = asyncio.Lock()
        # Plans read from or written to the board since its session opened.
        self._known: dict[Plan, None] = {}
        self._on_read = on_read

    def take_known(self) -> tuple[Plan, ...]:
        """Return the plans known to be on the board, and forget them."""
        known, self._known = tuple(self._known), {}
        return known

    async def read(self, plan: Plan) -> list[Waypoint]:
        """The plan that the board has. Raises BoardError if it does not arrive complete."""
        self._check_supported()
        async with self._lock:
            return await self._read(plan)

    async def write(self, plan: Plan, waypoints: Sequence[Waypoint], client: str | None) -> list[Waypoint]:
        """Replace a plan; returns the plan read back from the board.

        Raises InvalidInputError before anything is sent, BoardError if the board did not take it: it then keeps
        the old plan, for a new one takes effect only with its commit.
        """
        fault = mission_fault(waypoints)
        if fault is not None:
            raise InvalidInputError("mission_invalid", fault, plan=plan)
        self._check_supported()
        async with self._lock:
            self._tell(plan, "pending", len(waypoints), client)
            try:
                await self._send(plan, waypoints, client)
                found = await self._read(plan)
            except BaseException:
                self._tell(plan, "rejected", len(waypoints), client)
                raise
            if not same_plan(waypoints, found):
                self._tell(plan, "rejected", len(found), client)
                raise BoardError(
                    "mission_differs",
                    f"The {plan} plan was sent, but the board has another one ({len(found)} waypoints): send it again.",
                    plan=plan,
                )
            self._tell(plan, "confirmed", len(found), client)
            return found

    async def _send(self, plan: Plan, waypoints: Sequence[Waypoint], client: str | None) -> None:
        number = PLAN_NUMBERS[plan]
        await self._step(plan, "mission_begin", (number, len(waypoints)), client)
        for index, waypoint in enumerate(waypoints):
            await self._step(plan, "mission_item", item_arguments(number, index, waypoint), client)
        await self._step(plan, "mission_commit", (number,), client)

    async def _step(self, plan: Plan, name: str, arguments: tuple[float, ...], client: str | None) -> None:
        result = await self._commands.run(name, arguments, client=client, quiet=True)
        if not result.done:
            reason = result.reason or result.state
            raise BoardError(
                "mission_refused",
                f"The {plan} plan was not taken because the board did not accept {name} ({reason}): "
                "the old plan still stands; correct the plan or try again.",
                plan=plan,
                step=name,
                reason=reason,
            )

    async def _read(self, plan: Plan) -> list[Waypoint]:
        collector = _Collector(PLAN_NUMBERS[plan], asyncio.get_running_loop().create_future())
        with self._board.listening(collector.listen):
            await self._commands.run("mission_read", (PLAN_NUMBERS[plan],), quiet=True)
            try:
                async with asyncio.timeout(_READ_S):
                    found = await collector.whole
                if found:
                    self._known[plan] = None
                self._on_read(plan, found)
                return found
            except TimeoutError:
                raise BoardError(
                    "mission_not_read",
                    f"The {plan} plan could not be read because the board did not send all of it: try again.",
                    plan=plan,
                ) from None

    def _check_supported(self) -> None:
        self._commands.check_ready(COMMANDS["mission_read"])
        if not self._board.capabilities().get("has_missions"):
            raise ConflictError(
                "not_supported",
                "Plans cannot be transferred because this board does not support it: it needs newer firmware.",
                command="mission_read",
            )

    def _tell(self, plan: Plan, state: MissionState, count: int, client: str | None) -> None:
        self._outlet.event(MissionEvent(plan, state, count, client))


class _Collector:
    """Collects the items of one plan; a new count starts over."""

    def __init__(self, plan: int, whole: asyncio.Future[list[Waypoint]]) -> None:
        self.whole = whole
        self._plan = plan
        self._count: int | None = None
        self._items: dict[int, Waypoint] = {}

    def listen(self, frame: Frame, meant: Meaning) -> None:
        """A frame of the board."""
        values = meant.values
        if frame.message.name not in ("mission_count", "mission_item") or values.get("plan") != self._plan:
            return
        if frame.message.name == "mission_count":
            count = values["count"]
            self._count = count if isinstance(count, int) else None
            self._items.clear()
        else:
            waypoint = waypoint_from(values)
            index = values["index"]
            if waypoint is not None and isinstance(index, int):
                self._items[index] = waypoint
        if self._count is not None and not self.whole.done() and all(i in self._items for i in range(self._count)):
            self.whole.set_result([self._items[i] for i in range(self._count)])
