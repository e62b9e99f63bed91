"""A gamepad at a browser as the pilot's stick: its newest sample, and for how long that sample may be used."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Final

from epf_gcs.xplane.datagram import Surfaces

# Fifteen samples at 50 Hz. A busy page, or a radio that repeats a packet, delays samples by less than this; and a
# light aircraft at full aileron rolls only some twenty degrees meanwhile, from which any pilot recovers.
SAMPLE_LASTS_S: Final = 0.3
# Longer than for the surfaces: cutting the engine for a short gap pitches the aircraft twice, while the speed takes
# seconds to change. After this the pilot counts as gone, and an aircraft that glides is safer than one that flies away
# at full power. The board does the same when it loses its transmitter.
THROTTLE_LASTS_S: Final = 2.0
# Seconds per second. Two clocks drift apart by less than this; a delay that grows more slowly is not noticed.
_DRIFT: Final = 0.001

FIELDS: Final = (*Surfaces._fields, "t_ms")
SAMPLE_FAULT: Final = (
    "A sample of the stick was dropped: send elevator, aileron, rudder (-1..1), throttle (0..1) and t_ms, "
    "each a finite number."
)
_MOST_MS: Final = 1e15
_NEVER_S: Final = -1e9


def read_sample(message: Mapping[str, Any]) -> tuple[Surfaces, float] | None:
    """Positions, clamped to their ranges, and the sender's time in seconds; None if a field is not a finite number."""
    values = [message.get(name) for name in FIELDS]
    if not all(isinstance(value, int | float) and not isinstance(value, bool) for value in values):
        return None
    *position, t_ms = (float(value) for value in values if value is not None)
    surfaces = Surfaces(*position).clamped()
    return None if surfaces is None or not abs(t_ms) < _MOST_MS else (surfaces, t_ms / 1000.0)


class GamepadInput:
    """Keeps one sample. Times are seconds of one steady clock, except `sent_s`, which is the sender's own."""

    def __init__(self) -> None:
        self._surfaces = Surfaces(0.0, 0.0, 0.0, 0.0)
        self._sampled_s = _NEVER_S
        self._throttle_s = _NEVER_S
        self._shortest_s: float | None = None
        self._heard_s = 0.0

    def take(self, surfaces: Surfaces, sent_s: float, now_s: float) -> bool:
        """Take a sample. False if it arrived too late to be used.

        The clock of the sender differs from ours by an unknown amount, so the fastest sample so far counts as on
        time: how much longer this one took is how late it is.
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
        """Whether the newest sample is recent enough to fly with."""
        return now_s - self._sampled_s <= SAMPLE_LASTS_S

    def position(self, now_s: float) -> Surfaces:
        """Positions to fly with: the newest sample; without a live one, centred surfaces.

        The throttle is kept for `THROTTLE_LASTS_S`, then closed.
        """
        if self.is_live(now_s):
            return self._surfaces
        holds = now_s - self._throttle_s <= THROTTLE_LASTS_S
        return Surfaces(0.0, 0.0, 0.0, self._surfaces.throttle if holds else 0.0)

    def let_go(self) -> None:
        """The sender is gone: its sample is void, and the next sender may have another clock."""
        self._sampled_s = _NEVER_S
        self._shortest_s = None
