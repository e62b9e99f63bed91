"""Goes ahead through a recording in spare moments and makes its key frames."""

from __future__ import annotations

from typing import Final

from epf_gcs.replay.keys import EVERY_NS, Keys
from epf_gcs.replay.outlet import Silence
from epf_gcs.replay.playhead import Playhead
from epf_gcs.replay.timeline import Timeline

# Items in one slice of work: a few milliseconds.
_SLICE: Final = 200


class Scout:
    """`work` does one slice. It has something to do while the recording goes on behind the last key frame."""

    def __init__(self, timeline: Timeline, keys: Keys) -> None:
        self._timeline = timeline
        self._keys = keys
        self._head: Playhead | None = None
        self._next_ns = 0

    @property
    def has_work(self) -> bool:
        """Whether key frames are missing that can be made now."""
        edge_ns = self._timeline.edge_ns
        if not self._keys.is_writer or not edge_ns:
            return False
        if self._head is None:
            latest_ns = self._keys.latest_ns or self._timeline.starts_ns or edge_ns
            return edge_ns - latest_ns > EVERY_NS
        return edge_ns > self._next_ns

    def work(self) -> bool:
        """Decode a little further, and keep the state where a key frame is due. True if it was."""
        head = self._head or self._begin()
        if not head.advance(self._next_ns - 1, _SLICE):
            return False
        at_ns = head.next_ns
        if at_ns is None:
            return False
        is_kept = head.can_be_kept
        if is_kept:
            self._keys.add(at_ns, head.kept())
        self._next_ns = max(self._next_ns, at_ns) + EVERY_NS
        return is_kept

    def _begin(self) -> Playhead:
        latest_ns = self._keys.latest_ns
        found = None if latest_ns is None else self._keys.before(latest_ns)
        if found is None:
            head = Playhead(self._timeline, Silence())
            self._next_ns = (self._timeline.starts_ns or 0) + EVERY_NS
        else:
            head = Playhead(self._timeline, Silence(), *found)
            self._next_ns = found[0] + EVERY_NS
        self._head = head
        return head
