"""Reads map files in worker processes, which may crash without harm and are killed when a request takes too long.

So an untrusted file costs the station neither memory nor time. A file that took too much is not tried again until it
changes, or until some minutes have passed, for the disk may have been the cause.
"""

from __future__ import annotations

import contextlib
import queue
import threading
import time
from pathlib import Path
from typing import Final

import msgspec
import structlog

from epf_gcs.errors import GatewayError, InvalidInputError
from epf_gcs.maps import faults
from epf_gcs.maps.layer import Datum, Description, LayerFormat, Tile, TilePlace
from epf_gcs.maps.open_files import Stamp
from epf_gcs.maps.reader_requests import (
    DescribeRequest,
    ForgetRequest,
    GridRequest,
    InsideRequest,
    MapReply,
    Request,
    TileRequest,
)
from epf_gcs.maps.reading import TOO_COSTLY
from epf_gcs.workers.asked_process import AskedProcess

WORKERS: Final = 2
_PROGRAM: Final = "epf_gcs.maps.reader_worker"
# Longer than the worker's own limits on queries, whose errors say more about the reason.
_LONGEST_TILE_S: Final = 8.0
_LONGEST_OPENING_S: Final = 30.0
_LOOK_EVERY_S: Final = 0.5
_NOT_AGAIN_FOR_S: Final = 300.0
# The second is SQLite's message for a query that was interrupted for taking too long.
_GIVEN_UP: Final = (TOO_COSTLY, "interrupted")

log = structlog.get_logger("gateway")


class Reader:
    """Thread-safe; each calling thread waits for its answer."""

    def __init__(
        self,
        workers: int = WORKERS,
        longest_tile_s: float = _LONGEST_TILE_S,
        longest_opening_s: float = _LONGEST_OPENING_S,
    ) -> None:
        self._longest_tile_s = longest_tile_s
        self._longest_opening_s = longest_opening_s
        self._workers = [AskedProcess(_PROGRAM) for _ in range(workers)]
        self._idle: queue.LifoQueue[AskedProcess] = queue.LifoQueue()
        for worker in self._workers:
            self._idle.put(worker)
        self._costly: dict[tuple[Path, Stamp], float] = {}
        self._closing = threading.Event()
        self._watch: threading.Thread | None = None
        self._lock = threading.Lock()

    def describe(self, path: Path, name: str, form: LayerFormat, stamp: Stamp) -> Description:
        """A file's description. Raises GatewayError if it cannot be shown."""
        asked = DescribeRequest(str(path), name, form, stamp)
        found = self._ask(asked, path, stamp, self._longest_opening_s)[0].description
        if found is None:
            raise faults.damaged(name, "no description")
        return found

    def tile(
        self, path: Path, name: str, form: LayerFormat, stamp: Stamp, place: TilePlace, datum: Datum | None = None
    ) -> Tile | None:
        """One tile, as from `layer.TileSource`, terrain with heights above the sea. Raises GatewayError if the file
        cannot be read."""
        asked = TileRequest(str(path), name, form, stamp, place, datum)
        head, data = self._ask(asked, path, stamp, self._longest_tile_s)
        return Tile(data, head.media_type, head.encoding) if data else None

    def grid(
        self, path: Path, name: str, form: LayerFormat, stamp: Stamp, place: TilePlace, datum: Datum | None = None
    ) -> bytes | None:
        """The heights of one tile of terrain; None if there is none. Rows and errors as with `tile`."""
        asked = GridRequest(str(path), name, form, stamp, place, datum)
        return self._ask(asked, path, stamp, self._longest_tile_s)[1] or None

    def raster_inside(self, path: Path, stamp: Stamp) -> str | None:
        """The one raster in an archive; None if there is not exactly one, or if looking took too much."""
        try:
            head, _ = self._ask(InsideRequest(str(path), path.name), path, stamp, self._longest_opening_s)
        except GatewayError:
            return None
        return head.inside

    def forget(self, path: Path) -> None:
        """Close a file that is to be moved. A busy worker keeps it open until its next request."""
        held: list[AskedProcess] = []
        with contextlib.suppress(queue.Empty):
            while True:
                held.append(self._idle.get_nowait())
        try:
            for worker in held:
                if worker.is_running:
                    worker.ask(ForgetRequest(str(path)), self._longest_tile_s)
        finally:
            # In the order that they came, so that a process that runs is asked before one that has to be started.
            for worker in reversed(held):
                self._idle.put(worker)

    def close(self) -> None:
        """End the processes."""
        self._closing.set()
        if self._watch is not None:
            self._watch.join()
        for worker in self._workers:
            worker.end()

    def _ask(self, asked: Request, path: Path, stamp: Stamp, longest_s: float) -> tuple[MapReply, bytes]:
        key = (path, stamp)
        if self._costly.get(key, 0.0) > time.monotonic():
            raise faults.damaged(asked.name, TOO_COSTLY)
        self._begin_to_watch()
        worker = self._idle.get()
        try:
            answer = worker.ask(asked, longest_s)
        finally:
            self._idle.put(worker)
        if answer is None:
            self._remember_costly(key)
            log.warning("a map file was too costly", file=asked.name)
            raise faults.damaged(asked.name, TOO_COSTLY)
        head, data = msgspec.json.decode(answer[0], type=MapReply), answer[1]
        fault = head.fault
        if fault is not None:
            if fault.params.get("why") in _GIVEN_UP:
                self._remember_costly(key)
            raise InvalidInputError(fault.code, fault.detail, **fault.params)
        return head, data

    def _remember_costly(self, key: tuple[Path, Stamp]) -> None:
        now_s = time.monotonic()
        self._costly = {old: until_s for old, until_s in self._costly.items() if until_s > now_s}
        self._costly[key] = now_s + _NOT_AGAIN_FOR_S

    def _begin_to_watch(self) -> None:
        with self._lock:
            if self._watch is None:
                self._watch = threading.Thread(target=self._end_the_late, name="map readers", daemon=True)
                self._watch.start()

    def _end_the_late(self) -> None:
        while not self._closing.wait(_LOOK_EVERY_S):
            for worker in self._workers:
                worker.end_if_late()


def is_too_costly(found: object) -> bool:
    """Whether this is the error of a file that took too much, which may be tried again later."""
    return isinstance(found, GatewayError) and found.params.get("why") in _GIVEN_UP
