"""When the next frame is due: an absolute schedule, so that small delays never add up."""


class Schedule:
    """Frames at fixed instants from a start. The time is passed in [s, any monotonic clock].

    A frame that is late by less than a period does not change the schedule. After a stall of a
    period or more the whole schedule shifts, so that missed frames are not sent in a burst.
    """

    def __init__(self, period_s: float, start_s: float) -> None:
        self._period_s = period_s
        self._start_s = start_s
        self._frames = 0
        self.shifts = 0

    @property
    def due_s(self) -> float:
        """The instant of the next frame."""
        return self._start_s + self._frames * self._period_s

    def done(self, now_s: float) -> None:
        """The frame that was due is done at `now_s`; go on to the next."""
        self._frames += 1
        if now_s >= self.due_s:
            # Set a new start: adding each shift to the old one would accumulate rounding errors.
            self._start_s = now_s + self._period_s
            self._frames = 0
            self.shifts += 1
