"""MAVLink's mission protocol: plans go down item by item, come up whole, and are read back before they are accepted."""

from __future__ import annotations

from collections.abc import Awaitable, Callable
from typing import Final

from epf_gcs.client import StationError, Waypoint
from epf_gcs.mavlink.choice import Home
from epf_gcs.mavlink.dialect import MAKE, WIRE, Message
from epf_gcs.mavlink.peers import Peer
from epf_gcs.mavlink.plan_items import MOST_ITEMS, PlanError, PlanItems, items_of, plan_of

_OURS: Final = WIRE.MAV_MISSION_TYPE_MISSION
ASK_AGAIN_S: Final = 1.0
MOST_QUESTIONS: Final = 10


class Upload:
    """Items as they come. `asked` counts questions without an answer."""

    def __init__(self, peer: Peer, count: int) -> None:
        self.peer = peer
        self.count = count
        self.items: list[Message] = []
        self.questions = 0

    def ask(self) -> None:
        """Ask for the next item."""
        self.questions += 1
        self.peer.send(MAKE.mission_request_int_encode(0, 0, len(self.items), _OURS))


class Missions:
    """One plan of the board; one upload at a time. `read` and `write` are the station's, `say` tells people."""

    def __init__(
        self,
        read: Callable[[], Awaitable[list[Waypoint]]],
        write: Callable[[list[Waypoint]], Awaitable[list[Waypoint]]],
        say: Callable[[str], None],
        usual_speed_kt: float | None,
        home: Home | None,
    ) -> None:
        self._read = read
        self._write = write
        self._say = say
        self._usual_speed_kt = usual_speed_kt
        self._home = home
        self._upload: Upload | None = None
        self._ended: tuple[Peer, int] | None = None
        self.known: PlanItems | None = None

    def item_of(self, waypoint: int) -> int:
        """A waypoint's number among the items; its own where the plan was not read yet."""
        known = self.known
        return waypoint if known is None or waypoint >= len(known.at) else known.at[waypoint]

    async def hear(self, peer: Peer, message: Message) -> None:
        """Take one of the protocol's messages."""
        kind = message.get_type()
        if getattr(message, "mission_type", _OURS) != _OURS:
            self._refuse_type(peer, message)
        elif kind == "MISSION_REQUEST_LIST":
            await self._count(peer)
        elif kind in ("MISSION_REQUEST_INT", "MISSION_REQUEST"):
            self._item(peer, message.seq, as_float=kind == "MISSION_REQUEST")
        elif kind == "MISSION_COUNT":
            self._begin(peer, message.count)
        elif kind == "MISSION_ITEM_INT":
            await self._take(peer, message)
        elif kind == "MISSION_CLEAR_ALL":
            self._say("A plan of this board has at least one waypoint: send another in its place.")
            self._answer(peer, WIRE.MAV_MISSION_DENIED)

    def look(self) -> None:
        """Ask again for an item that did not come, and give an upload up whose sender is silent."""
        upload = self._upload
        if upload is None:
            return
        if upload.questions >= MOST_QUESTIONS:
            self._upload = None
            self._answer(upload.peer, WIRE.MAV_MISSION_OPERATION_CANCELLED)
            return
        upload.ask()

    async def _count(self, peer: Peer) -> None:
        try:
            self.known = items_of(await self._read(), self._usual_speed_kt)
        except StationError as refusal:
            if refusal.code == "mission_not_read":
                self._say(refusal.detail)
            peer.send(MAKE.mission_count_encode(0, 0, 0, _OURS))
            return
        peer.send(MAKE.mission_count_encode(0, 0, len(self.known.items), _OURS))

    def _item(self, peer: Peer, number: int, *, as_float: bool) -> None:
        known = self.known
        if known is None or not 0 <= number < len(known.items):
            self._answer(peer, WIRE.MAV_MISSION_INVALID_SEQUENCE)
            return
        item = known.items[number]
        peer.send(_as_float(item) if as_float else item)

    def _begin(self, peer: Peer, count: int) -> None:
        if self._upload is not None and self._upload.peer is not peer:
            self._say("Another station is sending a plan.")
            self._answer(peer, WIRE.MAV_MISSION_DENIED)
            return
        if not 0 < count <= MOST_ITEMS:
            self._answer(peer, WIRE.MAV_MISSION_NO_SPACE if count else WIRE.MAV_MISSION_DENIED)
            return
        self._ended = None
        self._upload = Upload(peer, count)
        self._upload.ask()

    async def _take(self, peer: Peer, item: Message) -> None:
        upload = self._upload
        if upload is None or upload.peer is not peer:
            if self._ended is not None and self._ended[0] is peer:
                # Its last item came again: the answer was lost.
                self._answer(peer, self._ended[1])
            return
        if item.seq != len(upload.items):
            return
        upload.items.append(item)
        upload.questions = 0
        if len(upload.items) < upload.count:
            upload.ask()
            return
        self._upload = None
        result = await self._send(upload.items)
        self._ended = (peer, result)
        self._answer(peer, result)

    async def _send(self, items: list[Message]) -> int:
        """Send the plan to the board; MAVLink's result."""
        try:
            plan = plan_of(items, self._usual_speed_kt, self._home)
            self.known = items_of(await self._write(plan), self._usual_speed_kt)
        except PlanError as fault:
            self._say(str(fault))
            return fault.result
        except StationError as refusal:
            self._say(refusal.detail)
            return int(WIRE.MAV_MISSION_ERROR)
        return int(WIRE.MAV_MISSION_ACCEPTED)

    def _refuse_type(self, peer: Peer, message: Message) -> None:
        """Fences and rally points: the board has none."""
        if message.get_type() == "MISSION_REQUEST_LIST":
            peer.send(MAKE.mission_count_encode(0, 0, 0, message.mission_type))
        elif message.get_type() in ("MISSION_COUNT", "MISSION_CLEAR_ALL"):
            peer.send(MAKE.mission_ack_encode(0, 0, WIRE.MAV_MISSION_UNSUPPORTED, message.mission_type))

    @staticmethod
    def _answer(peer: Peer, result: int) -> None:
        peer.send(MAKE.mission_ack_encode(0, 0, result, _OURS))


def _as_float(item: Message) -> Message:
    """The same item for a station that asks for degrees in single precision, as old ones do."""
    frame = WIRE.MAV_FRAME_GLOBAL if item.frame == WIRE.MAV_FRAME_GLOBAL_INT else item.frame
    params = (item.param1, item.param2, item.param3, item.param4)
    place = (item.x * 1e-7, item.y * 1e-7, item.z)
    return MAKE.mission_item_encode(0, 0, item.seq, frame, item.command, 0, 1, *params, *place, _OURS)
