"""Between one station and its MAVLink peers, as long as the station is there."""

from __future__ import annotations

import asyncio
from typing import Final

from epf_gcs.client import Station, StationError, Topic
from epf_gcs.contract.events import AlarmEvent
from epf_gcs.mavlink.aircraft import AircraftState
from epf_gcs.mavlink.choice import Choice
from epf_gcs.mavlink.commands import ACCEPTED, Commands
from epf_gcs.mavlink.dialect import MAKE, SYSTEM_ID, WIRE, Message, status_texts
from epf_gcs.mavlink.missions import ASK_AGAIN_S, Missions
from epf_gcs.mavlink.parameters import Parameters
from epf_gcs.mavlink.peers import Peer, Peers

# Twenty batches a second are what the fastest message needs.
RATE_HZ: Final = 20
_HEARTBEAT_S: Final = 1.0
_MOST_QUESTIONS: Final = 256
# All gains at once are more than a radio takes in one piece.
_BETWEEN_GAINS_S: Final = 0.01
_MISSION_MESSAGES: Final = frozenset(
    {
        "MISSION_REQUEST_LIST",
        "MISSION_REQUEST_INT",
        "MISSION_REQUEST",
        "MISSION_COUNT",
        "MISSION_ITEM_INT",
        "MISSION_CLEAR_ALL",
    }
)


class Bridge:
    """Tells the peers what the station hears, and does what they ask, one thing after the other."""

    def __init__(self, station: Station, peers: Peers, choice: Choice, begun_s: float) -> None:
        self._station = station
        self._peers = peers
        self._state = AircraftState(choice.aircraft, choice.home, begun_s)
        plan = choice.aircraft
        self._missions = Missions(
            lambda: station.plan(plan),
            lambda waypoints: station.send_plan(plan, waypoints),
            self._say,
            choice.usual_speed_kt,
            choice.home,
        )
        self._state.item_of = self._missions.item_of
        self._parameters = Parameters(station)
        self._commands = Commands(station, self._state, self._missions, self._say)
        self._handlers = {
            "COMMAND_LONG": self._commands.hear,
            "COMMAND_INT": self._commands.hear,
            "SET_MODE": self._set_mode,
            "MISSION_SET_CURRENT": self._go_to,
            "PARAM_REQUEST_LIST": self._tell_gains,
            "PARAM_REQUEST_READ": self._tell_gain,
            "PARAM_SET": self._set_gain,
        }
        self._asked: asyncio.Queue[tuple[Peer, Message]] = asyncio.Queue(_MOST_QUESTIONS)
        self._texts = 0

    def hear(self, peer: Peer, message: Message) -> None:
        """A peer's message. What does not fit is dropped: who asked asks again."""
        if message.get_type() != "HEARTBEAT" and not self._asked.full():
            self._asked.put_nowait((peer, message))

    async def run(self) -> None:
        """Until the station is lost: raises StationLostError, in a group."""
        async with asyncio.TaskGroup() as group:
            for topic in self._state.topics:
                group.create_task(self._tell(topic))
            group.create_task(self._tell_alarms())
            group.create_task(self._beat())
            group.create_task(self._answer())
            group.create_task(self._look())

    async def _tell(self, topic: type[Topic]) -> None:
        async for sample in self._station.samples(topic):
            for message in self._state.take(sample):
                self._peers.send(message)

    async def _tell_alarms(self) -> None:
        async for alarm in self._station.events(AlarmEvent):
            if alarm.acknowledged:
                continue
            severity = WIRE.MAV_SEVERITY_CRITICAL if alarm.level == "critical" else WIRE.MAV_SEVERITY_WARNING
            if alarm.active:
                self._say(alarm.text, severity)
            else:
                self._say(f"Over: {alarm.text}", WIRE.MAV_SEVERITY_INFO)

    async def _beat(self) -> None:
        """Once a second while the board is heard: a station of others sees at once when it is not."""
        while True:
            status = self._station.status
            if status.board.state != "open":
                self._state.forget()
            elif (mode := self._state.mode(status)) is not None:
                self._peers.send(self._state.heartbeat(mode))
            await asyncio.sleep(_HEARTBEAT_S)

    async def _look(self) -> None:
        while True:
            await asyncio.sleep(ASK_AGAIN_S)
            self._missions.look()

    async def _answer(self) -> None:
        while True:
            peer, message = await self._asked.get()
            try:
                await self._do(peer, message)
            except StationError as refusal:
                self._say(refusal.detail)

    async def _do(self, peer: Peer, message: Message) -> None:
        if getattr(message, "target_system", 0) not in (0, SYSTEM_ID):
            return
        kind = message.get_type()
        if kind in _MISSION_MESSAGES:
            await self._missions.hear(peer, message)
        elif kind in self._handlers:
            await self._handlers[kind](peer, message)

    async def _set_mode(self, _: Peer, message: Message) -> None:
        await self._commands.set_mode(message.custom_mode)

    async def _go_to(self, peer: Peer, message: Message) -> None:
        if await self._commands.go_to(message.seq) == ACCEPTED:
            peer.send(MAKE.mission_current_encode(message.seq))

    async def _tell_gains(self, peer: Peer, _: Message) -> None:
        for answer in await self._parameters.every():
            peer.send(answer)
            await asyncio.sleep(_BETWEEN_GAINS_S)

    async def _tell_gain(self, peer: Peer, message: Message) -> None:
        for answer in await self._parameters.one(message):
            peer.send(answer)

    async def _set_gain(self, _: Peer, message: Message) -> None:
        answers, fault = await self._parameters.set(message)
        for answer in answers:
            # Everybody shows the gain that the board has now.
            self._peers.send(answer)
        if fault:
            self._say(fault)

    def _say(self, text: str, severity: int = WIRE.MAV_SEVERITY_WARNING) -> None:
        """Tell people at every peer."""
        self._texts = self._texts % 65535 + 1
        for message in status_texts(severity, text, self._texts):
            self._peers.send(message)
