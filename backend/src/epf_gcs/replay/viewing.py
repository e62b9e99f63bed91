"""One viewer's replay on an event loop: its player's turns, its stream, and what it asks."""

from __future__ import annotations

import asyncio
import math
from collections.abc import Callable
from time import monotonic
from typing import Final

from epf_gcs import __version__
from epf_gcs.bus.address import Listener
from epf_gcs.bus.definition import Asker
from epf_gcs.bus.vehicle_end import Broadcast, Handlers, VehicleEnd
from epf_gcs.contract.answers import Sample
from epf_gcs.contract.flight_knowledge import FlightKnowledge
from epf_gcs.contract.hello import FlightSpan, Hello
from epf_gcs.contract.inspector import Inspector
from epf_gcs.contract.notices import Notice
from epf_gcs.contract.playback import Loop, Pause, Play, Playback, SampleCredit, Seek, Step, Want
from epf_gcs.contract.requests import ReadInspector, ReadKnown, ReadPlayback, ReadStatus, ReadTelemetry
from epf_gcs.contract.status import Status
from epf_gcs.repeating import Repeating
from epf_gcs.replay.answers import build_inspector, build_known
from epf_gcs.replay.keys import Keys
from epf_gcs.replay.player import Player
from epf_gcs.replay.timeline import Timeline

_REST_S: Final = 3600.0
_FAR_S: Final = 1e9


class ReplayViewer:
    """`on_turn` is called after each turn. `due_s` is when the next one is due, on the steady clock."""

    def __init__(
        self, timeline: Timeline, keys: Keys, flight: str, at_s: float, *, on_turn: Callable[[], None]
    ) -> None:
        self._timeline = timeline
        self._flight = flight
        self._on_turn = on_turn
        self._turns = Repeating(asyncio.get_running_loop(), "a turn of a replay", self._turn)
        self._gone = asyncio.Event()
        self._fault: Exception | None = None
        self._broadcast = Broadcast(self._now_s)
        self._player = Player(timeline, keys, self._broadcast, flight, at_s=at_s)
        self.due_s = 0.0

    async def run(self, listener: Listener) -> None:
        """Play for the viewer that connects, until it has gone. Raises RecordingError if the file turns out to be
        none, MemoryError if it takes too much."""
        player = self._player
        while not player.is_there:
            player.turn(monotonic())
            # The others' turns are not held up.
            await asyncio.sleep(0)
        end = VehicleEnd(
            self._broadcast,
            hello=self._hello,
            samples=player.samples,
            requests=self._requests(),
            on_notice=self._take_notice,
            on_gone=self._gone.set,
        )
        self._hurry()
        serving = asyncio.ensure_future(end.run(listener))
        try:
            await self._gone.wait()
        finally:
            serving.cancel()
            self._turns.stop()
        if self._fault is not None:
            raise self._fault

    def keys_came(self) -> None:
        """More key frames are there."""
        self._player.keys_came(monotonic())
        self._hurry()

    def _turn(self) -> float | None:
        """One turn of the player; returns in how many seconds the next is due."""
        now_s = monotonic()
        try:
            wait_s = self._player.turn(now_s)
        except Exception as fault:  # noqa: BLE001 - else the viewer has a picture that stands still for ever
            self._fault = fault
            self._gone.set()
            return None
        self.due_s = now_s + wait_s
        self._on_turn()
        return min(wait_s, _REST_S)

    def _hurry(self) -> None:
        """Something was asked: the next turn comes at once."""
        self.due_s = 0.0
        self._turns.hurry()

    def _now_s(self) -> float:
        return self._player.head.clock.now_s()

    def _hello(self) -> Hello:
        playback = self._player.playback()
        starts_s = (self._timeline.starts_ns or 0) * 1e-9
        return Hello(
            __version__,
            "replay",
            self._player.status(),
            flight=FlightSpan(self._flight, starts_s, playback.duration_s),
            playback=playback,
        )

    def _requests(self) -> Handlers:
        """What can be asked of the past: only to read."""
        player = self._player

        async def read_status(_: ReadStatus, __: Asker) -> Status:
            return player.status()

        async def read_telemetry(_: ReadTelemetry, __: Asker) -> dict[str, Sample]:
            return player.head.vehicle.newest()

        async def read_playback(_: ReadPlayback, __: Asker) -> Playback:
            return player.playback()

        async def read_known(_: ReadKnown, __: Asker) -> FlightKnowledge:
            return build_known(player.head, player.playback().at_s)

        async def read_inspector(_: ReadInspector, __: Asker) -> Inspector:
            return build_inspector(player.head)

        return {
            ReadStatus: read_status,
            ReadTelemetry: read_telemetry,
            ReadPlayback: read_playback,
            ReadKnown: read_known,
            ReadInspector: read_inspector,
        }

    def _take_notice(self, notice: Notice) -> None:
        """Play, pause and seek. Anything else, and numbers out of range, are ignored: a replay cannot be commanded."""
        player, now_s = self._player, monotonic()
        match notice:
            case Play(rate) if math.isfinite(rate):
                player.play(now_s, rate)
            case Pause():
                player.pause(now_s)
            case Seek(at_s) if abs(at_s) < _FAR_S:
                player.seek(now_s, at_s)
            case Step(frames) if frames:
                player.step(now_s, frames)
            case Loop(float() | int() as from_s, float() | int() as to_s) if (
                abs(from_s) < _FAR_S and abs(to_s) < _FAR_S
            ):
                player.loop((from_s, to_s))
            case Loop():
                player.loop(None)
            case Want(rate_hz):
                player.want(rate_hz)
            case SampleCredit(count):
                player.taken(count)
            case _:
                return
        self._hurry()
