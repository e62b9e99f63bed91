"""Rows, however they are spread over datagrams -> one XplaneInfo for each frame of the simulator."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable
from dataclasses import dataclass
from typing import Final

from epf_gcs.xplane.datagram import Record
from epf_gcs.xplane.mapping import NEEDED_ROWS, TRACK_ROW, XplaneInfo, info_from_rows, row_meaning

MAX_AGE_S: Final = 0.2
"""A frame whose rows take longer than this to arrive is old: at the slowest rate, 20 Hz, frames are 0.05 s apart."""

_RELEVANT: Final = NEEDED_ROWS | {TRACK_ROW}
_DESCENTS_BEFORE_DOUBT: Final = 12
_PAUSE_DECAY: Final = 0.999  # per datagram, so that one long stall on our side does not choose the leader for ever


@dataclass(frozen=True, slots=True)
class GathererState:
    """All that the next datagrams are read by; times in s. `rows`: the values of the frame so far, by row."""

    incomplete_frames: int
    started_s: float
    last_row: int
    sent: bool
    track_expected: bool
    descents: int
    leader: int
    longest_pause_s: float
    heard_s: float
    rows: dict[int, dict[str, float | None]]
    implausible: dict[str, int]


class Gatherer:
    """Collects the rows of one simulator frame and does not mix two frames, once it knows how the simulator sends them.

    A new frame begins with a row that this frame already has, with a row number lower than the last one (the
    simulator sends rows in ascending order, so a lost datagram cannot shift the frames), or when the frame
    is too old. If a simulator sends its rows in another order, the second rule cuts every frame before it is
    complete. After a dozen such cuts without a complete frame, a frame begins with the leader instead: the row
    that came after the longest pause. A stall of ours at the very beginning can name the wrong leader; until its pause
    has faded (about two seconds of one row a datagram), frames of such a simulator may be mixed.

    The ground track replaces the heading, wherever in the frame its row comes: if the last frame had that row,
    this one is not complete without it.
    """

    def __init__(self, profile: str) -> None:
        self.profile = profile
        self.implausible: Counter[str] = Counter()
        self.incomplete_frames = 0
        self._rows: dict[int, dict[str, float | None]] = {}
        self._started_s = 0.0
        self._last_row = -1
        self._sent = False
        self._track_expected = False
        self._descents = 0
        self._leader = -1
        self._longest_pause_s = -1.0
        self._heard_s = 0.0

    def take(self, records: Iterable[Record], now_s: float) -> XplaneInfo | None:
        """Take one datagram's rows; returns the frame's values when this datagram completes it."""
        relevant = [record for record in records if record.row in _RELEVANT]
        if not relevant:
            return None
        self._watch_pauses(relevant[0].row, now_s)
        if self._begins_frame(relevant, now_s):
            self._begin(now_s)
        for record in relevant:
            self._take_row(record)
        self._last_row = relevant[-1].row
        if self._sent or not self._is_complete():
            return None
        info = info_from_rows(self._rows)
        if info is not None:
            self._sent = True
            if self._descents < _DESCENTS_BEFORE_DOUBT:
                self._descents = 0
        return info

    def kept(self) -> GathererState:
        """For `restore`."""
        return GathererState(
            self.incomplete_frames,
            self._started_s,
            self._last_row,
            self._sent,
            self._track_expected,
            self._descents,
            self._leader,
            self._longest_pause_s,
            self._heard_s,
            dict(self._rows),
            dict(self.implausible),
        )

    def restore(self, state: GathererState) -> None:
        """Go on from a state that `kept` gave."""
        self.incomplete_frames = state.incomplete_frames
        self._started_s = state.started_s
        self._last_row = state.last_row
        self._sent = state.sent
        self._track_expected = state.track_expected
        self._descents = state.descents
        self._leader = state.leader
        self._longest_pause_s = state.longest_pause_s
        self._heard_s = state.heard_s
        self._rows = {row: dict(values) for row, values in state.rows.items()}
        self.implausible = Counter(state.implausible)

    def _take_row(self, record: Record) -> None:
        meaning = row_meaning(record.row, record.values, self.profile)
        self._rows[record.row] = meaning.values
        self.implausible.update(meaning.implausible)

    def _begins_frame(self, relevant: list[Record], now_s: float) -> bool:
        if not self._rows or now_s - self._started_s > MAX_AGE_S:
            return True
        if any(record.row in self._rows for record in relevant):
            return True
        if self._descents >= _DESCENTS_BEFORE_DOUBT:
            return relevant[0].row == self._leader
        descends = relevant[0].row < self._last_row
        self._descents += descends
        return descends

    def _watch_pauses(self, row: int, now_s: float) -> None:
        pause_s = now_s - self._heard_s if self._leader >= 0 else 0.0
        self._longest_pause_s *= _PAUSE_DECAY
        if pause_s > self._longest_pause_s:
            self._leader = row
            self._longest_pause_s = pause_s
        self._heard_s = now_s

    def _begin(self, now_s: float) -> None:
        if self._rows:
            self._track_expected = TRACK_ROW in self._rows
            self.incomplete_frames += not self._sent
        self._rows = {}
        self._sent = False
        self._started_s = now_s

    def _is_complete(self) -> bool:
        if not self._rows.keys() >= NEEDED_ROWS:
            return False
        return TRACK_ROW in self._rows or not self._track_expected
