"""Settings that the gateway keeps across restarts: links, path of control, streams, thresholds, map sources."""

from __future__ import annotations

import asyncio
import contextlib
import threading
import time
from collections.abc import Callable
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any, Final

import orjson

from epf_gcs.disk import KeptFile
from epf_gcs.errors import GatewayError
from epf_gcs.flight.memory.flight_log import say
from epf_gcs.vehicle.wanted import IntendedSettings

_GATHER_S: Final = 0.05


@dataclass(frozen=True, slots=True)
class FlightMemory:
    """Plain values, as they stand in the file."""

    board_url: str | None = None
    board_identity: str | None = None
    simulator: dict[str, Any] | None = None
    hil_path: str = "manual"
    wanted: IntendedSettings = field(default_factory=IntendedSettings)
    thresholds: dict[str, Any] = field(default_factory=dict)
    # The policy of the disk, as `DiskPolicy` has it; empty for the default.
    recording: dict[str, Any] = field(default_factory=dict)
    # What the aircraft is called, as a person said it; empty for no name.
    aircraft: str = ""
    # What of ground and fence a person wants to be warned of, as `ToldSurroundings` has it.
    watched: tuple[str, ...] = ()


class Memory:
    """One small JSON file, replaced as a whole by a thread: the newest values are on the disk within a second.

    If the disk refuses it, `report` is called on the constructing loop (or thread), and the flight goes on.
    """

    def __init__(
        self, path: Path, report: Callable[[GatewayError], None], *, unix_s: Callable[[], float] = time.time
    ) -> None:
        self._file = KeptFile(path, _decode, _encode, unix_s)
        self._report = report
        self._loop = _running_loop()
        self._wake = threading.Condition()
        # Shared with the thread, under `_wake`.
        self._to_write: FlightMemory | None = None
        self._is_ending = False
        self._thread: threading.Thread | None = None
        self.now = self._load()

    def update(self, **changes: Any) -> None:
        """Change these values; returns at once."""
        changed = replace(self.now, **changes)
        if changed == self.now:
            return
        self.now = changed
        with self._wake:
            if self._is_ending:
                return
            self._to_write = changed
            self._wake.notify()
            if self._thread is None:
                self._thread = threading.Thread(target=self._run, name="memory", daemon=True)
                self._thread.start()

    def close(self) -> None:
        """Wait until the newest values are on the disk; later updates are not written."""
        with self._wake:
            self._is_ending = True
            self._wake.notify()
            thread = self._thread
        if thread is not None:
            thread.join()

    def _run(self) -> None:
        while True:
            with self._wake:
                while self._to_write is None:
                    if self._is_ending:
                        return
                    self._wake.wait()
                if not self._is_ending:
                    # Moving a slider makes many updates a second: gather them into one write.
                    self._wake.wait_for(lambda: self._is_ending, _GATHER_S)
                newest, self._to_write = self._to_write, None
            if newest is not None:
                self._write(newest)

    def _write(self, values: FlightMemory) -> None:
        try:
            self._file.path.parent.mkdir(parents=True, exist_ok=True)
            self._file.write(values)
        except OSError as error:
            self._hand_over(
                GatewayError(
                    "memory_not_written",
                    f"The settings could not be kept in {self._file.path} ({error.strerror or error}): "
                    "free the disk or correct its permissions, or they are lost at the next start.",
                    path=str(self._file.path),
                )
            )

    def _hand_over(self, failure: GatewayError) -> None:
        if self._loop is None:
            self._report(failure)
            return
        with contextlib.suppress(RuntimeError):  # the event loop may be closed already
            self._loop.call_soon_threadsafe(self._report, failure)

    def _load(self) -> FlightMemory:
        try:
            found = self._file.read_or_set_aside(lambda kept: self._say_unreadable("its content makes no sense", kept))
        except OSError as error:
            found = None
            self._say_unreadable(error.strerror or str(error), self._file.set_aside())
        return found or FlightMemory()

    def _say_unreadable(self, why: str, kept: Path | None) -> None:
        where = "it could not be kept aside" if kept is None else f"it is kept as {kept.name}"
        path = str(self._file.path)
        say("warning", "settings unreadable", path=path, reason=why, kept=None if kept is None else kept.name)
        self._report(
            GatewayError(
                "memory_unreadable",
                f"The settings in {path} could not be read ({why}): the gateway starts without them; {where}.",
                path=path,
            )
        )


def _running_loop() -> asyncio.AbstractEventLoop | None:
    try:
        return asyncio.get_running_loop()
    except RuntimeError:
        return None


def _encode(values: FlightMemory) -> bytes:
    return orjson.dumps(
        {
            "board_url": values.board_url,
            "board_identity": values.board_identity,
            "simulator": values.simulator,
            "hil_path": values.hil_path,
            "streams": sorted(values.wanted.streams),
            "periods_ms": dict(values.wanted.periods_ms),
            "source": values.wanted.source,
            "thresholds": values.thresholds,
            "recording": values.recording,
            "aircraft": values.aircraft,
            "watched": values.watched,
        },
        option=orjson.OPT_INDENT_2,
    )


def _decode(text: bytes) -> FlightMemory:
    values = orjson.loads(text)
    source = values["source"]
    return FlightMemory(
        board_url=_text(values["board_url"]),
        board_identity=_text(values["board_identity"]),
        simulator=dict(values["simulator"]) if values["simulator"] is not None else None,
        hil_path="assisted" if values["hil_path"] == "assisted" else "manual",
        wanted=IntendedSettings(
            frozenset(str(stream) for stream in values["streams"]),
            {str(name): int(period) for name, period in values["periods_ms"].items()},
            None if source is None else int(source),
        ),
        # Not in the files of earlier versions.
        thresholds=dict(values.get("thresholds", {})),
        recording=dict(values.get("recording", {})),
        aircraft=str(values.get("aircraft", "")),
        watched=tuple(str(one) for one in values.get("watched", ())),
    )


def _text(value: Any) -> str | None:
    return None if value is None else str(value)
