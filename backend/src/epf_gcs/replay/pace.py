"""Where a replay is at a moment of the steady clock: recorded time over real time, without drift."""

from __future__ import annotations

from epf_gcs.contract.playback import FASTEST, SLOWEST


class Pace:
    """Times of the recording in Unix ns, `now_s` of any steady clock. Nothing is added up, so nothing drifts."""

    def __init__(self, at_ns: int) -> None:
        self._from_ns = at_ns
        self._from_s: float | None = None
        self.rate = 1.0

    @property
    def is_playing(self) -> bool:
        """Whether the time goes on."""
        return self._from_s is not None

    def at_ns(self, now_s: float) -> int:
        """The moment of the recording at `now_s`."""
        if self._from_s is None:
            return self._from_ns
        return self._from_ns + round((now_s - self._from_s) * self.rate * 1e9)

    def play(self, now_s: float, rate: float) -> None:
        """Go on from the present moment, at `rate` times the real speed."""
        self._from_ns, self._from_s = self.at_ns(now_s), now_s
        self.rate = min(FASTEST, max(SLOWEST, rate))

    def pause(self, now_s: float) -> None:
        """Stop at the present moment."""
        self._from_ns, self._from_s = self.at_ns(now_s), None

    def jump(self, now_s: float, at_ns: int) -> None:
        """Be at this moment now; playing or not stays as it is."""
        self._from_ns = at_ns
        if self._from_s is not None:
            self._from_s = now_s

    def wait_s(self, now_s: float, t_ns: int) -> float:
        """Real time until the recording's `t_ns` comes; 0 if it has come, infinite while paused."""
        if self._from_s is None:
            return float("inf")
        return max(0.0, (t_ns - self.at_ns(now_s)) * 1e-9 / self.rate)
