"""One viewer's replay on an event loop: its player's turns, its stream, and what it asks."""

from __future__ import annotations

import asyncio
import math
from collections.abc import Callable
from time import monotonic
from typing import Any, Final

from epf_gcs import __version__
from epf_gcs.bus.address import Listener
from epf_gcs.bus.definition import Asker
from epf_gcs.bus.vehicle_end import Broadcast, Handler, VehicleEnd
from epf_gcs.repeating import Repeating
from epf_gcs.replay.answers import build_inspector, build_known
from epf_gcs.replay.keys import Keys
from epf_gcs.replay.player import Player
from epf_gcs.replay.timeline import Timeline

_REST_S: Final = 3600.0


class Viewing:
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
            on_notice=self._notice,
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

    def _hello(self) -> dict[str, Any]:
        playback = self._player.playback()
        return {
            "version": __version__,
            "vehicle": "replay",
            "clock_offset_ns": 0,
            "control": None,
            "status": self._player.status(),
            "playback": playback,
            "flight": self._flight,
            "starts_s": (self._timeline.starts_ns or 0) * 1e-9,
            "duration_s": playback["duration_s"],
        }

    def _requests(self) -> dict[str, Handler]:
        """What can be asked of the past: only to read."""
        player = self._player

        async def status(_: Asker, __: dict[str, Any]) -> Any:
            return player.status()

        async def telemetry(_: Asker, __: dict[str, Any]) -> Any:
            return player.head.vehicle.newest()

        async def parameters(_: Asker, __: dict[str, Any]) -> Any:
            return player.head.known.now["parameters"]

        async def playback(_: Asker, __: dict[str, Any]) -> Any:
            return player.playback()

        async def known(_: Asker, __: dict[str, Any]) -> Any:
            return build_known(player.head, player.playback()["at_s"])

        async def inspector(_: Asker, __: dict[str, Any]) -> Any:
            return build_inspector(player.head)

        return {
            "status": status,
            "telemetry": telemetry,
            "parameters.read": parameters,
            "playback": playback,
            "known": known,
            "inspector": inspector,
        }

    def _notice(self, name: str, arguments: dict[str, Any]) -> None:
        """play {rate}; pause; seek {at_s}; step {frames}; loop {from_s, to_s} or {}; want {rate_hz}; taken {count}.

        Anything else, and values that are no numbers, are ignored: a replay cannot be commanded.
        """
        player, now_s = self._player, monotonic()
        match name, arguments:
            case "play", {"rate": int() | float() as rate} if math.isfinite(rate):
                player.play(now_s, rate)
            case "pause", _:
                player.pause(now_s)
            case "seek", {"at_s": int() | float() as at_s} if abs(at_s) < 1e9:
                player.seek(now_s, at_s)
            case "step", {"frames": int(frames)} if frames:
                player.step(now_s, frames)
            case "loop", {"from_s": int() | float() as from_s, "to_s": int() | float() as to_s} if (
                abs(from_s) < 1e9 and abs(to_s) < 1e9
            ):
                player.loop((from_s, to_s))
            case "loop", _:
                player.loop(None)
            case "want", {"rate_hz": int(rate_hz)}:
                player.want(rate_hz)
            case "taken", {"count": int(count)}:
                player.taken(count)
            case _:
                return
        self._hurry()
