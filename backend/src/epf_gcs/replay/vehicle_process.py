"""A replay on an event loop: the player's turns, the scout's work between them, and what the station asks."""

from __future__ import annotations

import asyncio
import math
from pathlib import Path
from time import monotonic
from typing import Any, Final

from epf_gcs import __version__
from epf_gcs.bus.address import Listener
from epf_gcs.bus.definition import Asker
from epf_gcs.bus.vehicle_end import Broadcast, Handler, VehicleEnd
from epf_gcs.replay.answers import build_inspector, build_known
from epf_gcs.replay.keys import Keys
from epf_gcs.replay.player import Player
from epf_gcs.replay.scout import Scout
from epf_gcs.replay.timeline import Timeline

# The scout works while no turn is due for this long.
_SPARE_S: Final = 0.002
_LOOK_S: Final = 0.1
_REST_S: Final = 3600.0


class VehicleProcess:
    """`keys` is the file of key frames, None for none. Raises RecordingError for a file that is no recording."""

    def __init__(self, recording: Path, keys: Path | None, *, at_s: float) -> None:
        self._flight = recording.stem
        self._keys_file = keys
        self._at_s = at_s
        self._timeline = Timeline(recording)
        self._keys: Keys | None = None
        self._player: Player | None = None
        self._scout: Scout | None = None
        self._timer: asyncio.Handle | None = None
        self._broadcast = Broadcast(self._now_s)

    async def run(self, listener: Listener) -> None:
        """Play until cancelled. Raises RecordingError if the file turns out to be none."""
        while self._timeline.starts_ns is None:
            # A recording that begins now, and holds no byte yet.
            await asyncio.sleep(_LOOK_S)
            self._timeline.look()
        self._keys = Keys(self._keys_file, self._flight, self._timeline.starts_ns)
        player = self._player = Player(self._timeline, self._keys, self._broadcast, self._flight, at_s=self._at_s)
        self._scout = Scout(self._timeline, self._keys)
        while not player.is_there:
            player.turn(monotonic())
        end = VehicleEnd(
            self._broadcast,
            hello=self._hello,
            samples=player.samples,
            requests=self._requests(player),
            on_notice=self._notice,
            on_gone=lambda: None,
        )
        self._hurry()
        try:
            await end.run(listener)
        finally:
            if self._timer is not None:
                self._timer.cancel()

    def close(self) -> None:
        """Let the file of key frames go."""
        if self._keys is not None:
            self._keys.close()

    def _turn(self) -> None:
        """One turn of the player, or a slice of the scout's work; arms the timer of the next."""
        player, scout = self._the_player(), self._scout
        loop = asyncio.get_running_loop()
        wait_s = player.turn(monotonic())
        if wait_s > _SPARE_S and scout is not None and scout.has_work:
            scout.work()
            player.keys_came(monotonic())
            wait_s = 0.0
        if wait_s <= 0.0:
            self._timer = loop.call_soon(self._turn)
        else:
            self._timer = loop.call_later(min(wait_s, _REST_S), self._turn)

    def _hurry(self) -> None:
        """Something was asked: the next turn comes at once."""
        if self._timer is not None:
            self._timer.cancel()
        self._timer = asyncio.get_running_loop().call_soon(self._turn)

    def _now_s(self) -> float:
        return 0.0 if self._player is None else self._player.head.clock.now_s()

    def _hello(self) -> dict[str, Any]:
        player = self._the_player()
        playback = player.playback()
        return {
            "version": __version__,
            "vehicle": "replay",
            "clock_offset_ns": 0,
            "control": None,
            "status": player.status(),
            "playback": playback,
            "flight": self._flight,
            "starts_s": (self._timeline.starts_ns or 0) * 1e-9,
            "duration_s": playback["duration_s"],
        }

    def _the_player(self) -> Player:
        if self._player is None:
            raise RuntimeError("the replay has not begun")
        return self._player

    def _requests(self, player: Player) -> dict[str, Handler]:
        """What can be asked of the past: only to read."""

        async def status(_: Asker, __: dict[str, Any]) -> Any:
            return player.status()

        async def telemetry(_: Asker, __: dict[str, Any]) -> Any:
            return player.head.vehicle.telemetry.snapshot()

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
        player, now_s = self._the_player(), monotonic()
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
