"""The flown tracks, the board's by its GPS and the simulator's: collected, saved, cleared and restored."""

from __future__ import annotations

import asyncio
import secrets
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Final, Protocol

from epf_gcs.clock import Clock
from epf_gcs.contract.answers import TrackState
from epf_gcs.contract.base import Values
from epf_gcs.contract.events import Say
from epf_gcs.errors import ConflictError, GatewayError
from epf_gcs.repeating import repeat
from epf_gcs.track.kept import KeptTrack
from epf_gcs.track.track import Attitude, Position, Track
from epf_gcs.units import m_from_ft

_AHRS: Final = ("yaw_deg", "pitch_deg", "roll_deg")
_EARLIER_FLIGHT_S: Final = 120.0
_SAVE_S: Final = 1.0
_SIMULATOR: Final = ("true_heading_deg", "pitch_deg", "roll_deg")


class PositionSource(Protocol):
    """The vehicle whose positions are collected."""

    @property
    def is_emulated(self) -> bool:
        """Whether its data is emulated and not a flight's."""

    def listen(self, topic: str, listener: Callable[[float, Values], None]) -> None:
        """Call `listener` with the Unix time and the values of each sample of this topic."""

    def newest(self, topic: str) -> Values | None:
        """The newest values of a topic, however old."""

    def is_live(self, topic: str) -> bool:
        """Whether the topic's newest sample is not stale."""


@dataclass(frozen=True, slots=True)
class Pair:
    """The tracks of the board's and of the simulator's aircraft."""

    flight: Track
    hil: Track


class Tracks:
    """Collects the topics with a position. Emulated data has separate tracks, dropped when the emulation ends."""

    def __init__(
        self, vehicle: PositionSource, say: Say, clock: Clock, folder: Path, report: Callable[[GatewayError], None]
    ) -> None:
        self._report = report
        self._kept = (KeptTrack(folder / "flight.track"), KeptTrack(folder / "hil.track"))
        self._has_failed = False
        self._vehicle = vehicle
        self._say = say
        self._clock = clock
        self._was_emulated = False
        self._flown = self._new_pair()
        self._examples = self._new_pair()
        self._cleared: Pair | None = None
        vehicle.listen("gps", self._on_gps)
        vehicle.listen("simulator", self._on_simulator)

    async def run(self) -> None:
        """Load the saved tracks, then save new points once a second, forever."""
        await self._load()
        await repeat(_SAVE_S, "saving the track", self._save)

    async def close(self) -> None:
        """Save the last points."""
        await self._save()

    async def _load(self) -> None:
        """A saved track of a flight that goes on is drawn again; one of an earlier flight is kept as a cleared one."""
        now_s = self._clock.now_s()
        found = [await asyncio.to_thread(kept.load, now_s, secrets.randbits(32)) for kept in self._kept]
        going_on = [None if track is None or _is_earlier(track, now_s) else track for track in found]
        earlier = [track if before is None else None for track, before in zip(found, going_on, strict=True)]
        if any(track is not None for track in going_on):
            before = Pair(*(track or self._new_track() for track in going_on))
            flown, self._flown = self._flown, before
            before.flight.append(flown.flight)
            before.hil.append(flown.hil)
        if any(track is not None for track in earlier):
            # Where only one is of an earlier flight, the other begins with what is drawn of it.
            drawn = (self._flown.flight, self._flown.hil)
            self._cleared = Pair(
                *(track or Track(now.t0_s, secrets.randbits(32)) for track, now in zip(earlier, drawn, strict=True))
            )
        if any(track is not None for track in found):
            self._tell()

    async def _save(self) -> None:
        """Save the flown tracks, never the emulated ones. The thread gets immutable bytes."""
        for kept, track in zip(self._kept, (self._flown.flight, self._flown.hil), strict=True):
            first, total = kept.first_unwritten(track), len(track)
            if first == total:
                continue
            blocks = track.blocks(first)
            points, attitudes = b"".join(block.points for block in blocks), b"".join(one.attitudes for one in blocks)
            try:
                await asyncio.to_thread(kept.save, track.epoch, track.t0_s, total, points, attitudes, first)
            except OSError as error:
                if not self._has_failed:
                    self._report(
                        GatewayError(
                            "track_not_written",
                            f"The flown track could not be kept ({error.strerror or error}): free the disk, or it is "
                            "lost when the gateway ends. The recording is another file.",
                            reason=str(error.strerror or error),
                        )
                    )
                self._has_failed = True
                return
        self._has_failed = False

    @property
    def now(self) -> Pair:
        """The tracks to draw: the emulated ones during an emulation, else the flown ones."""
        return self._examples if self._vehicle.is_emulated else self._flown

    @property
    def can_restore(self) -> bool:
        """Whether there is an earlier track to restore."""
        return self._cleared is not None and not self._vehicle.is_emulated

    def reset(self) -> None:
        """Clear the tracks. The last cleared ones can be restored; recordings are not touched."""
        if self._vehicle.is_emulated:
            self._examples = self._new_pair()
        else:
            if len(self._flown.flight) or len(self._flown.hil):
                self._cleared = self._flown
            self._flown = self._new_pair()
        self._tell()

    def restore(self) -> None:
        """Put the tracks cleared last in front of those flown since. Raises ConflictError if there are none."""
        if self._cleared is None or self._vehicle.is_emulated:
            raise ConflictError(
                "track_not_kept",
                "There is no earlier track to bring back: only the one cleared last, or saved before a restart, is "
                "kept until it is back.",
            )
        cleared, self._cleared = self._cleared, None
        cleared.flight.append(self._flown.flight)
        cleared.hil.append(self._flown.hil)
        self._flown = cleared
        self._tell()

    def status_changed(self) -> None:
        """Drop the emulated tracks when the emulation ends."""
        was, self._was_emulated = self._was_emulated, self._vehicle.is_emulated
        if was and not self._was_emulated:
            self._examples = self._new_pair()
            self._tell()

    @property
    def state(self) -> TrackState:
        """As the interface gives it."""
        return TrackState(len(self.now.flight), len(self.now.hil), self.can_restore)

    def _on_gps(self, t_s: float, values: Values) -> None:
        """Add a GPS position, if it has a fix: without one receivers send the last position, or 0 deg N 0 deg E."""
        if values["valid"] is True and values["fix"]:
            ahrs = self._vehicle.newest("ahrs") if self._vehicle.is_live("ahrs") else None
            attitude = None if ahrs is None else _attitude(ahrs, _AHRS)
            _add(self.now.flight, t_s, values["latitude_deg"], values["longitude_deg"], values["altitude_m"], attitude)

    def _on_simulator(self, t_s: float, values: Values) -> None:
        altitude_ft = values["altitude_msl_ft"]
        altitude_m = None if altitude_ft is None else m_from_ft(altitude_ft)
        attitude = _attitude(values, _SIMULATOR)
        _add(self.now.hil, t_s, values["latitude_deg"], values["longitude_deg"], altitude_m, attitude)

    def _new_pair(self) -> Pair:
        """Empty tracks with random epochs, so that readers notice the change even after a restart of the gateway."""
        return Pair(self._new_track(), self._new_track())

    def _new_track(self) -> Track:
        return Track(self._clock.now_s(), secrets.randbits(32))

    def _tell(self) -> None:
        self._say("track", self.state)


def _is_earlier(track: Track, now_s: float) -> bool:
    return track.newest_s is None or now_s - track.newest_s > _EARLIER_FLIGHT_S


def _attitude(values: Values, names: tuple[str, str, str]) -> Attitude | None:
    heading_deg, pitch_deg, roll_deg = (values.get(name) for name in names)
    if heading_deg is None or pitch_deg is None or roll_deg is None:
        return None
    return heading_deg, pitch_deg, roll_deg


def _add(
    track: Track,
    t_s: float,
    latitude_deg: float | None,
    longitude_deg: float | None,
    altitude_m: float | None,
    attitude: Attitude | None,
) -> None:
    if latitude_deg is None or longitude_deg is None or altitude_m is None:
        return
    position: Position = (latitude_deg, longitude_deg, altitude_m)
    track.add(t_s, position, attitude)
