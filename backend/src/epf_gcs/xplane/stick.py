"""The pilot's hand on a stick that is far away: its newest sample, for as long as that may be flown by."""

from __future__ import annotations

from typing import Final

from epf_gcs.xplane.datagram import Surfaces

# Fifteen samples at 50 Hz: a page that draws something heavy, or a radio that repeats a packet, is back sooner, and a
# light aircraft at full aileron has rolled some twenty degrees, from which anybody recovers.
SAMPLE_LASTS_S: Final = 0.3
# Cutting the engine at a hiccup pitches the aircraft twice; speed takes seconds to change. After that nobody is there,
# and what flies away at full power is worse than what glides: the board does the same without its transmitter.
THROTTLE_LASTS_S: Final = 2.0
# Two clocks drift apart by less than this; a line whose delay creeps up more slowly is not noticed.
_DRIFT: Final = 0.001

_NEVER_S: Final = -1e9


class Hand:
    """Keeps one sample. Times are seconds of one steady clock, but `sent_s`, which is the sender's own."""

    def __init__(self) -> None:
        self._surfaces = Surfaces(0.0, 0.0, 0.0, 0.0)
        self._sampled_s = _NEVER_S
        self._throttle_s = _NEVER_S
        self._shortest_s: float | None = None
        self._heard_s = 0.0

    def take(self, surfaces: Surfaces, sent_s: float, now_s: float) -> bool:
        """A sample came. False where it was on its way for too long to be used.

        Only the sender knows when it was taken, by a clock of its own: what it took longer than the fastest sample
        until now is what it is late.
        """
        way_s = now_s - sent_s
        if self._shortest_s is None:
            self._shortest_s = way_s
        else:
            self._shortest_s = min(way_s, self._shortest_s + _DRIFT * (now_s - self._heard_s))
        self._heard_s = now_s
        late_s = way_s - self._shortest_s
        if late_s > SAMPLE_LASTS_S:
            return False
        self._surfaces = surfaces
        self._sampled_s = self._throttle_s = now_s - late_s
        return True

    def is_live(self, now_s: float) -> bool:
        """The newest sample may still be flown by."""
        return now_s - self._sampled_s <= SAMPLE_LASTS_S

    def position(self, now_s: float) -> Surfaces:
        """What the aircraft shall do: the newest sample; without one the stick let go, and some time later no power."""
        if self.is_live(now_s):
            return self._surfaces
        holds = now_s - self._throttle_s <= THROTTLE_LASTS_S
        return Surfaces(0.0, 0.0, 0.0, self._surfaces.throttle if holds else 0.0)

    def let_go(self) -> None:
        """The sender is known to be gone: its sample does not last any longer, and its clock may be another one."""
        self._sampled_s = _NEVER_S
        self._shortest_s = None
