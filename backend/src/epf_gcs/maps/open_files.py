"""A cache of open map files: the few used last, each closed only when nobody reads it any more."""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from threading import Lock
from typing import Final

from epf_gcs.maps.layer import TileSource

Stamp = tuple[int, ...]
"""A value that changes when the file changes."""

_MOST: Final = 8


class _OpenFile:
    def __init__(self, stamp: Stamp, source: TileSource) -> None:
        self.stamp = stamp
        self.source = source
        self.readers = 0
        self.given_up = False


class OpenFiles:
    """Thread-safe."""

    def __init__(self, most: int = _MOST) -> None:
        self._most = most
        self._lock = Lock()
        self._opened: OrderedDict[str, _OpenFile] = OrderedDict()

    def __len__(self) -> int:
        return len(self._opened)

    @contextmanager
    def reading(self, key: str, stamp: Stamp, open_it: Callable[[], TileSource]) -> Iterator[TileSource]:
        """The open file, kept open while inside; reopened if it changed. Raises what `open_it` raises."""
        opened = self._take(key, stamp)
        if opened is None:
            opened = self._keep(key, _OpenFile(stamp, open_it()))
        try:
            yield opened.source
        finally:
            self._release(opened)

    def forget(self, key: str) -> None:
        """Close this file, which is to be moved or was changed, once nobody reads it."""
        with self._lock:
            opened = self._opened.pop(key, None)
        if opened is not None:
            self._give_up(opened)

    def close(self) -> None:
        """Close all files."""
        for key in list(self._opened):
            self.forget(key)

    def _take(self, key: str, stamp: Stamp) -> _OpenFile | None:
        with self._lock:
            opened = self._opened.get(key)
            if opened is None or opened.stamp != stamp:
                return None
            self._opened.move_to_end(key)
            opened.readers += 1
            return opened

    def _keep(self, key: str, opened: _OpenFile) -> _OpenFile:
        opened.readers = 1
        with self._lock:
            before = self._opened.pop(key, None)
            too_many = [] if before is None else [before]
            self._opened[key] = opened
            while len(self._opened) > self._most:
                too_many.append(self._opened.popitem(last=False)[1])
        for old in too_many:
            self._give_up(old)
        return opened

    def _release(self, opened: _OpenFile) -> None:
        with self._lock:
            opened.readers -= 1
            is_last = opened.given_up and opened.readers == 0
        if is_last:
            opened.source.close()

    def _give_up(self, opened: _OpenFile) -> None:
        with self._lock:
            opened.given_up = True
            is_unused = opened.readers == 0
        if is_unused:
            opened.source.close()
