"""Plays a recording: told the steady time, it feeds the vehicle, and says when it must be told again.

No thread, no timer and no socket in here: what it does at a moment depends on the times it is told alone.
"""

from __future__ import annotations

import math
from typing import Final, Literal, Protocol

from epf_gcs.contract.base import Values
from epf_gcs.contract.playback import Playback
from epf_gcs.contract.status import Status
from epf_gcs.replay.keys import EVERY_NS, Keys
from epf_gcs.replay.outlet import ReplayOutlet, Sink
from epf_gcs.replay.pace import Pace
from epf_gcs.replay.playhead import Playhead
from epf_gcs.replay.status import build_status
from epf_gcs.replay.timeline import Timeline

State = Literal["playing", "paused", "ended"]

_TOLD_S: Final = 0.1
_STATUS_S: Final = 0.5
_PAUSED_STATUS_S: Final = 1.0
# A file that is being written is looked at this often while the replay is near its edge.
_LOOK_S: Final = 0.25
_NEAR_NS: Final = 1_000_000_000
# A timer may wake so much early.
_GRAIN_S: Final = 0.001
# Items fed in one turn: a few milliseconds, so that what a viewer asks is heard between turns.
_TURN: Final = 400
# With every sample wanted: samples given away before the viewer has been sent them.
_MOST_UNDER_WAY: Final = 512
_TOGETHER: Final = 64
# Without key frames near, a moment is reached from this far before it, and exactly as soon as there are key frames.
_WARM_NS: Final = 15_000_000_000
# A replay that was held up catches up with its clock. One that has worked so long without getting there cannot keep
# up: it stays behind, and its time is that of what is shown.
_CATCH_UP_S: Final = 2.0
# A turn is a few milliseconds: what is longer between two is the machine's, and no work of the replay's.
_LONGEST_TURN_S: Final = 0.05


class Audience(Sink, Protocol):
    """Who is shown the replay."""

    def status(self, status: Status) -> None:
        """The state of the flight at that moment."""

    def playback(self, playback: Playback, *, with_samples: bool = False) -> None:
        """Where the replay is, and whether it plays; at once, or with the samples of the next `flush`."""


class Player:
    """`flight` is the recording's id. Commands (`play`, `seek`, ...) and `turn` are told the time of a steady clock."""

    def __init__(self, timeline: Timeline, keys: Keys, audience: Audience, flight: str, *, at_s: float = 0.0) -> None:
        self._timeline = timeline
        self._keys = keys
        self._audience = audience
        self._flight = flight
        self._starts_ns = timeline.starts_ns or 0
        self._outlet = ReplayOutlet(audience)
        self._head = Playhead(timeline, self._outlet)
        self._pace = Pace(self._starts_ns)
        self._loop: tuple[int, int] | None = None
        self._target_ns: int | None = None
        self._is_rough = False
        self._has_ended = False
        self._jumps = 0
        self._period_s = 1.0 / 60.0
        # How long it has worked without catching up, and when its last such turn was; None while it keeps up.
        self._behind_s = 0.0
        self._turned_s: float | None = None
        self._give_at_s = self._tell_at_s = self._status_at_s = self._look_at_s = 0.0
        self.seek(0.0, at_s)

    @property
    def head(self) -> Playhead:
        """The vehicle at the moment that is shown."""
        return self._head

    @property
    def is_there(self) -> bool:
        """Whether the moment that was asked for is reached."""
        return self._target_ns is None

    def want(self, rate_hz: int) -> None:
        """How many batches a second the viewer takes; 0: every sample."""
        self._outlet.every = rate_hz == 0
        self._outlet.under_way = 0
        self._period_s = 1.0 / min(60, rate_hz) if rate_hz > 0 else 1.0 / 60.0

    def taken(self, count: int) -> None:
        """The viewer has been sent so many samples."""
        self._outlet.under_way = max(0, self._outlet.under_way - count)

    def play(self, now_s: float, rate: float) -> None:
        """Go on at this rate; from the beginning, or from the loop's, if the end was reached."""
        if self._has_ended:
            self._go(now_s, self._starts_ns if self._loop is None else self._loop[0])
        self._has_ended = False
        if self._turned_s is not None and self._target_ns is None:
            # What a fast replay has to catch up is no matter of a slower one's.
            self._pace.jump(now_s, self._head.clock.t_ns)
        self._turned_s = None
        self._pace.play(now_s, rate)
        self._tell_at_s = 0.0

    def pause(self, now_s: float) -> None:
        """Stop at what is shown."""
        self._pace.pause(now_s)
        if self._target_ns is None:
            self._pace.jump(now_s, self._head.clock.t_ns)
        self._tell_at_s = self._status_at_s = 0.0

    def seek(self, now_s: float, at_s: float) -> None:
        """Be at so many seconds after the start; playing or not stays as it is."""
        self._has_ended = False
        self._go(now_s, self._starts_ns + round(at_s * 1e9))

    def step(self, now_s: float, frames: int) -> None:
        """To the next frame or datagram, or to the one before; pauses."""
        self._pace.pause(now_s)
        if self._target_ns is not None:
            return
        if frames > 0:
            self._outlet.is_open = True
            t_ns = self._head.step()
            if t_ns is not None:
                self._pace.jump(now_s, t_ns)
        else:
            self._has_ended = False
            self._go(now_s, self._head.frame_ns - 1)
        self._give_at_s = self._tell_at_s = self._status_at_s = 0.0

    def loop(self, stretch: tuple[float, float] | None) -> None:
        """Repeat from the first to the second moment (seconds after the start); None: no more."""
        if stretch is None or stretch[1] <= stretch[0]:
            self._loop = None
        else:
            self._loop = (self._starts_ns + round(stretch[0] * 1e9), self._starts_ns + round(stretch[1] * 1e9))
        self._tell_at_s = 0.0

    def turn(self, now_s: float) -> float:
        """Do what is due; returns the seconds until the next call (a command must be followed by a call at once)."""
        self._look(now_s)
        if self._target_ns is not None:
            if not self._head.advance(self._target_ns, _TURN):
                return 0.0
            self._arrive(now_s)
        elif self._pace.is_playing and not self._play_on(now_s):
            self._tell(now_s)
            return 0.0
        return self._tell(now_s)

    def playback(self) -> Playback:
        """Where the replay is."""
        t_ns = self._head.clock.t_ns
        state: State = "ended" if self._has_ended else "playing" if self._pace.is_playing else "paused"
        length_s = self._at_s(self._timeline.edge_ns)
        return Playback(
            flight=self._flight,
            at_s=self._at_s(t_ns),
            t_s=t_ns * 1e-9,
            state=state,
            rate=self._pace.rate,
            loop=None if self._loop is None else (self._at_s(self._loop[0]), self._at_s(self._loop[1])),
            duration_s=length_s,
            edge_s=length_s,
            jumps=self._jumps,
        )

    def status(self) -> Status:
        """The flight's state at the moment shown."""
        return build_status(self._head, f"{self._flight}.mcap", self._timeline.size)

    def samples(self) -> list[tuple[str, float, Values]]:
        """The newest sample of every topic at the moment shown, by their time."""
        newest = self._head.vehicle.telemetry.samples()
        return sorted(((topic, one.t_s, one.values) for topic, one in newest.items()), key=lambda one: one[1])

    def keys_came(self, now_s: float) -> None:
        """More key frames are there: a moment that was reached without one is now reached exactly."""
        latest_ns = self._keys.latest_ns
        here_ns = self._head.clock.t_ns
        if self._is_rough and self.is_there and latest_ns is not None and latest_ns + EVERY_NS >= here_ns:
            self._go(now_s, here_ns)

    def _at_s(self, t_ns: int) -> float:
        return (t_ns - self._starts_ns) * 1e-9

    def _go(self, now_s: float, at_ns: int) -> None:
        """Begin to go to a moment: from a key frame before it, or from here if that is nearer."""
        at_ns = min(max(at_ns, self._starts_ns), max(self._timeline.edge_ns, self._starts_ns))
        self._outlet.is_open = False
        self._outlet.drop()
        self._turned_s = None
        self._target_ns = at_ns
        self._pace.jump(now_s, at_ns)
        self._keys.look()
        key = self._keys.before(at_ns)
        from_ns = self._starts_ns if key is None else key[0]
        here_ns = self._head.clock.t_ns
        is_nearer = not self._is_rough and from_ns <= here_ns <= at_ns
        if at_ns - (here_ns if is_nearer else from_ns) > _WARM_NS:
            self._head = Playhead(self._timeline, self._outlet, at_ns - _WARM_NS)
            self._is_rough = True
        elif not is_nearer:
            self._head = Playhead(self._timeline, self._outlet, *(key or ()))
            self._is_rough = False

    def _arrive(self, now_s: float) -> None:
        """The moment is reached: show all of it."""
        self._pace.jump(now_s, self._head.clock.t_ns)
        self._target_ns = None
        self._jumps += 1
        self._outlet.under_way = 0
        self._audience.playback(self.playback())
        for sample in self.samples():
            self._audience.sample(*sample)
        self._audience.flush()
        self._audience.status(self.status())
        self._outlet.is_open = True
        self._tell_at_s = now_s + _TOLD_S if self._pace.is_playing else float("inf")
        self._status_at_s = now_s + _STATUS_S
        self._give_at_s = now_s + self._period_s

    def _play_on(self, now_s: float) -> bool:
        """Feed what is due. False if more is due than one turn takes."""
        end_ns = self._timeline.edge_ns if self._loop is None else min(self._timeline.edge_ns, self._loop[1])
        at_ns = self._pace.at_ns(now_s)
        if self._outlet.every:
            if self._outlet.under_way >= _MOST_UNDER_WAY:
                # The time stands still while the viewer cannot follow.
                self._pace.jump(now_s, self._head.clock.t_ns)
                return True
            if not self._feed_every(min(at_ns, end_ns)):
                return False
        elif not self._head.advance(min(at_ns, end_ns), _TURN):
            self._fall_behind(now_s)
            return False
        self._turned_s = None
        if at_ns >= end_ns:
            self._at_end(now_s, end_ns)
        return True

    def _fall_behind(self, now_s: float) -> None:
        """Count the work of catching up, not the time: a machine that stood still for a minute is caught up with."""
        if self._turned_s is None:
            self._behind_s = 0.0
        else:
            self._behind_s += min(now_s - self._turned_s, _LONGEST_TURN_S)
        self._turned_s = now_s
        if self._behind_s >= _CATCH_UP_S:
            self._pace.jump(now_s, self._head.clock.t_ns)
            self._turned_s = None

    def _feed_every(self, to_ns: int) -> bool:
        """Feed item by item, some samples at a time. False if more is due."""
        outlet = self._outlet
        for _ in range(_TURN):
            if self._head.advance(to_ns, 1):
                outlet.give()
                return True
            if outlet.waiting >= _TOGETHER:
                break
        outlet.give()
        return False

    def _at_end(self, now_s: float, end_ns: int) -> None:
        if self._loop is not None and end_ns == self._loop[1]:
            self._go(now_s, self._loop[0])
        elif self._timeline.is_whole:
            self._pace.pause(now_s)
            self._pace.jump(now_s, end_ns)
            self._has_ended = True
            self._give_at_s = self._tell_at_s = self._status_at_s = 0.0
        else:
            self._pace.jump(now_s, end_ns)

    def _tell(self, now_s: float) -> float:
        """Send samples, position and status as they are due; returns the seconds until the next is."""
        if self._target_ns is not None:
            return 0.0
        is_playing = self._pace.is_playing
        is_given = not self._outlet.every and now_s >= self._give_at_s - _GRAIN_S
        # What is due soon goes with the samples, for each thing sent alone wakes three processes.
        soon_s = now_s + 0.5 * self._period_s if is_given and is_playing else now_s
        if soon_s >= self._tell_at_s:
            self._tell_at_s = max(self._tell_at_s, now_s - _TOLD_S) + _TOLD_S if is_playing else float("inf")
            self._audience.playback(self.playback(), with_samples=is_given)
        if is_given:
            self._give_at_s = self._on_grid(now_s + 0.5 * self._period_s)
            self._outlet.give()
            self._audience.flush()
        if soon_s >= self._status_at_s:
            self._status_at_s = now_s + (_STATUS_S if is_playing else _PAUSED_STATUS_S)
            self._audience.status(self.status())
        due_s = min(self._tell_at_s, self._status_at_s)
        if is_playing:
            due_s = min(due_s, self._due_s(now_s))
        return max(0.0, due_s - now_s)

    def _due_s(self, now_s: float) -> float:
        """When the next samples are to be given."""
        if self._outlet.every and self._outlet.under_way >= _MOST_UNDER_WAY:
            return float("inf")
        next_ns = self._head.next_ns
        coming_s = float("inf") if next_ns is None else now_s + self._pace.wait_s(now_s, next_ns)
        return coming_s if self._outlet.every else self._on_grid(max(self._give_at_s - _GRAIN_S, coming_s))

    def _on_grid(self, now_s: float) -> float:
        """The next moment at which samples are given: the mean rate is exact, and all replays wake together."""
        return now_s if math.isinf(now_s) else math.ceil(now_s / self._period_s) * self._period_s

    def _look(self, now_s: float) -> None:
        """See what the file has got, if it is being written."""
        if self._timeline.is_whole or now_s < self._look_at_s:
            return
        self._timeline.look()
        near = self._pace.is_playing and self._timeline.edge_ns - self._head.clock.t_ns < _NEAR_NS
        self._look_at_s = now_s + (_LOOK_S if near else _PAUSED_STATUS_S)
