"""Who changed which gains when, kept across restarts; and what can be undone on the same board."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import Final

import msgspec
import orjson

from epf_gcs.clock import Clock
from epf_gcs.contract.answers import JournalEntry, ParameterChange
from epf_gcs.contract.events import JournalEvent
from epf_gcs.errors import GatewayError
from epf_gcs.flight.memory.lines_file import LinesFile
from epf_gcs.vehicle.journal import Kind, Steps, new_entry
from epf_gcs.vehicle.outside import Outlet

_KEPT: Final = 1000


class Journal:
    """`name_of` maps a client to its name. Each entry goes to the file and to the viewers."""

    def __init__(
        self,
        path: Path,
        *,
        clock: Clock,
        outlet: Outlet,
        report: Callable[[GatewayError], None],
        name_of: Callable[[str], str | None],
    ) -> None:
        self._path = path
        self._clock = clock
        self._outlet = outlet
        self._report = report
        self._name_of = name_of
        self._file = LinesFile(path, _KEPT, report)
        self._entries: deque[JournalEntry] = deque(maxlen=_KEPT)
        self.steps = Steps()
        self._load()

    @property
    def entries(self) -> list[JournalEntry]:
        """Newest first."""
        return list(reversed(self._entries))

    def note(self, kind: Kind, changes: Iterable[ParameterChange], client: str | None, *, undoable: bool) -> None:
        """Note changes that were tried. `undoable` is false if that board is no longer connected."""
        newest = self._entries[-1].id if self._entries else 0
        name = None if client is None else self._name_of(client)
        entry = new_entry(newest + 1, self._clock.now_s(), client, name, kind, changes)
        self._entries.append(entry)
        if undoable:
            self.steps = self.steps.after(kind, entry.changes)
        self._file.append(orjson.dumps(entry))
        self._tell(entry)

    def forget_steps(self) -> None:
        """Drop all undo steps: another board, with other values, may be connected now."""
        if self.steps != Steps():
            self.steps = Steps()
            self._tell(None)

    def close(self) -> None:
        """Wait until all is on the disk."""
        self._file.close()

    def _tell(self, entry: JournalEntry | None) -> None:
        self._outlet.event(JournalEvent(entry, self.steps.undo, self.steps.redo))

    def _load(self) -> None:
        try:
            lines = self._file.read()
        except OSError as error:
            self._complain(error.strerror or str(error))
            return
        good: list[bytes] = []
        for line in lines:
            try:
                self._entries.append(msgspec.json.decode(line, type=JournalEntry))
            except (msgspec.DecodeError, ValueError):
                continue
            good.append(line)
        bad = len(lines) - len(good)
        if bad:
            self._complain(f"{bad} of {len(lines)} lines make no sense")
        self._file.begin_with(good, damaged=bad > 0)

    def _complain(self, why: str) -> None:
        self._report(
            GatewayError(
                "journal_unreadable",
                f"The parameter journal in {self._path} could not be read whole ({why}): "
                "the gateway starts with what could be read.",
                path=str(self._path),
                reason=why,
            )
        )
