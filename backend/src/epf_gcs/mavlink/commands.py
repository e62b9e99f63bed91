"""MAVLink's commands that this board has, each answered with what became of it."""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from typing import Any, Final

from epf_gcs.client import ControlError, Station, StationError, StationLostError
from epf_gcs.mavlink.aircraft import ASSISTED, AUTOPILOT, MANUAL, MODE_NAMES, AircraftState
from epf_gcs.mavlink.dialect import MAKE, WIRE, Message
from epf_gcs.mavlink.missions import Missions
from epf_gcs.mavlink.peers import Peer

_OF_STANDARD_MODE: Final = {WIRE.MAV_STANDARD_MODE_MISSION: AUTOPILOT, WIRE.MAV_STANDARD_MODE_CRUISE: ASSISTED}
_STANDARD_MODE: Final = {
    MANUAL: WIRE.MAV_STANDARD_MODE_NON_STANDARD,
    ASSISTED: WIRE.MAV_STANDARD_MODE_NON_STANDARD,
    AUTOPILOT: WIRE.MAV_STANDARD_MODE_MISSION,
}
_CAPABILITIES: Final = (
    WIRE.MAV_PROTOCOL_CAPABILITY_MISSION_INT
    | WIRE.MAV_PROTOCOL_CAPABILITY_COMMAND_INT
    | WIRE.MAV_PROTOCOL_CAPABILITY_PARAM_ENCODE_C_CAST
    | WIRE.MAV_PROTOCOL_CAPABILITY_MAVLINK2
)
ACCEPTED, DENIED, UNSUPPORTED = (
    int(WIRE.MAV_RESULT_ACCEPTED),
    int(WIRE.MAV_RESULT_DENIED),
    int(WIRE.MAV_RESULT_UNSUPPORTED),
)
FAILED, LATER = int(WIRE.MAV_RESULT_FAILED), int(WIRE.MAV_RESULT_TEMPORARILY_REJECTED)
IN_PROGRESS = int(WIRE.MAV_RESULT_IN_PROGRESS)
_REMEMBERED_S: Final = 10.0


class Commands:
    """Runs a command once, however often it is repeated: a repeated one gets the result of the first.

    `say` tells people why something was not done.
    """

    def __init__(
        self,
        station: Station,
        state: AircraftState,
        missions: Missions,
        say: Callable[[str], None],
    ) -> None:
        self._station = station
        self._state = state
        self._missions = missions
        self._say = say
        self._results: dict[tuple[Any, ...], tuple[float, int]] = {}

    async def hear(self, peer: Peer, message: Message) -> None:
        """COMMAND_LONG or COMMAND_INT: run it and answer."""
        params = (message.param1, message.param2)
        key = (message.get_srcSystem(), message.get_srcComponent(), message.command, params)
        now_s = asyncio.get_running_loop().time()
        result = self._known(key, getattr(message, "confirmation", 0), now_s)
        if result is None:
            result = await self._result(peer, message.command, params)
            self._results[key] = (now_s, result)
        peer.send(
            MAKE.command_ack_encode(message.command, result, 0, 0, message.get_srcSystem(), message.get_srcComponent())
        )

    async def set_mode(self, mode: int) -> int:
        """Change the mode, and wait until the board does it."""
        if self._state.aircraft == "flight":
            self._say("The mode of the real aircraft is chosen with its transmitter's switch.")
            return DENIED
        if mode not in MODE_NAMES:
            return DENIED
        if mode == MANUAL:
            return await self._done(self._hil_path_manual)
        return await self._done(self._autopilot if mode == AUTOPILOT else self._assisted)

    async def go_to(self, item: int) -> int:
        """Have the plan go to the waypoint of this item."""
        try:
            waypoint = item if self._missions.known is None else self._missions.known.waypoint_at(item)
        except ValueError as fault:
            self._say(f"{fault}.".capitalize())
            return DENIED
        plan = 1 if self._state.aircraft == "hil" else 0

        async def go() -> bool:
            return (await self._station.command("go_to_waypoint", [plan, waypoint])).done

        return await self._done(go)

    def _known(self, key: tuple[Any, ...], confirmation: int, now_s: float) -> int | None:
        """The result of the same command if this is its repetition."""
        self._results = {
            one: (t_s, result) for one, (t_s, result) in self._results.items() if now_s - t_s < _REMEMBERED_S
        }
        known = self._results.get(key)
        return known[1] if known is not None and confirmation > 0 else None

    async def _result(self, peer: Peer, command: int, params: tuple[float, float]) -> int:
        if command == WIRE.MAV_CMD_DO_SET_MODE:
            return await self.set_mode(round(params[1]))
        if command == WIRE.MAV_CMD_DO_SET_STANDARD_MODE:
            mode = _OF_STANDARD_MODE.get(round(params[0]))
            return UNSUPPORTED if mode is None else await self.set_mode(mode)
        if command == WIRE.MAV_CMD_DO_SET_MISSION_CURRENT:
            return await self.go_to(round(params[0]))
        if command == WIRE.MAV_CMD_PREFLIGHT_STORAGE and round(params[0]) == 1:
            return await self._done(self._store)
        if command == WIRE.MAV_CMD_REQUEST_AUTOPILOT_CAPABILITIES:
            return self._tell(peer, WIRE.MAVLINK_MSG_ID_AUTOPILOT_VERSION)
        if command == WIRE.MAV_CMD_REQUEST_MESSAGE:
            return self._tell(peer, round(params[0]), round(params[1]))
        return UNSUPPORTED

    def _tell(self, peer: Peer, message_id: int, number: int = 0) -> int:
        """Send a message that somebody asks for."""
        if message_id == WIRE.MAVLINK_MSG_ID_AUTOPILOT_VERSION:
            none = [0] * 8
            peer.send(MAKE.autopilot_version_encode(_CAPABILITIES, 0, 0, 0, 0, none, none, none, 0, 0, 0))
        elif message_id == WIRE.MAVLINK_MSG_ID_AVAILABLE_MODES:
            for one in MODE_NAMES if number == 0 else (number - 1,):
                if one in MODE_NAMES:
                    peer.send(self._available(one))
        elif message_id == WIRE.MAVLINK_MSG_ID_CURRENT_MODE:
            mode = self._state.mode(self._station.status)
            if mode is None:
                return LATER
            peer.send(MAKE.current_mode_encode(_STANDARD_MODE[mode], mode, mode))
        elif message_id == WIRE.MAVLINK_MSG_ID_HOME_POSITION and (home := self._state.home_position()) is not None:
            peer.send(home)
        else:
            return UNSUPPORTED
        return ACCEPTED

    def _available(self, mode: int) -> Message:
        fixed = WIRE.MAV_MODE_PROPERTY_NOT_USER_SELECTABLE if self._state.aircraft == "flight" else 0
        name = MODE_NAMES[mode].encode()
        return MAKE.available_modes_encode(len(MODE_NAMES), mode + 1, _STANDARD_MODE[mode], mode, fixed, name)

    async def _done(self, act: Callable[[], Any]) -> int:
        """ACCEPTED if the station has its proof, and people are told why not."""
        try:
            if await act():
                return ACCEPTED
        except ControlError as refusal:
            self._say(refusal.detail)
            return LATER
        except StationError as refusal:
            self._say(refusal.detail)
            return DENIED
        except StationLostError as lost:
            self._say(str(lost))
            return FAILED
        self._say("The board did not confirm it.")
        return FAILED

    async def _hil_path_manual(self) -> bool:
        return (await self._station.set_hil(path="manual")).path == "manual"

    async def _assisted(self) -> bool:
        if not (await self._station.command("autopilot_off")).done:
            return False
        return (await self._station.set_hil(path="assisted")).path == "assisted"

    async def _autopilot(self) -> bool:
        if (await self._station.set_hil(path="assisted")).path != "assisted":
            return False
        return (await self._station.command("autopilot_on")).done

    async def _store(self) -> bool:
        return (await self._station.store_gains()).done
