"""The recording as it is, or a stretch of it with the same bytes, times and notes."""

from __future__ import annotations

import os
import shutil
from io import BytesIO
from pathlib import Path
from typing import Any, Final

import numpy as np
from mcap.data_stream import ReadDataStream
from mcap.records import Metadata

from epf_gcs.flights.export.asked import ExportRequest, Progress
from epf_gcs.recordings import notes
from epf_gcs.recordings.export_names import stretch_empty
from epf_gcs.recordings.notes import Note
from epf_gcs.recordings.packed_file import PackedFile
from epf_gcs.recordings.packing import Block, RecordReader
from epf_gcs.recordings.parts import Messages
from epf_gcs.recordings.scan import HEAD, PAYLOAD_AT

_LIBRARY: Final = "epf-gcs export"
_LEVEL: Final = 3
_STATES: Final = (notes.IDENTITY, notes.PARAMETERS, notes.PLAN, notes.LINE)


def write(asked: ExportRequest, target: Path, _aside: Path, progress: Progress) -> None:
    """Raises GatewayError, OSError."""
    if asked.is_whole:
        _copy(asked.recording, target)
        return
    reader = RecordReader(asked.recording)
    size = max(1, asked.recording.stat().st_size)
    with target.open("wb") as file:
        cut = _StretchWriter(asked, PackedFile(file, _LIBRARY, level=_LEVEL))
        for block in reader.blocks():
            cut.take(block)
            progress.at(reader.place / size)
            if cut.is_over:
                break
        cut.finish()


def _copy(source: Path, target: Path) -> None:
    """A second name of the same file takes no room, and packing or deleting replaces only the first."""
    try:
        os.link(source, target)
    except OSError:
        shutil.copyfile(source, target)


class _StretchWriter:
    """Takes the blocks of a recording in order and writes those messages and notes that are in the stretch.

    What was known at its beginning is noted there: identity, gains, plans and lines.
    """

    def __init__(self, asked: ExportRequest, output: PackedFile) -> None:
        self._asked = asked
        self._output = output
        self._known: dict[tuple[str, Any], tuple[str, bytes]] = {}
        self._first_ns = self._last_ns = 0
        self._has_start = self._is_inside = self.is_over = False
        self._count = 0

    def take(self, block: Block) -> None:
        t_ns = block.messages.t_ns
        if len(t_ns) and not self._has_start:
            self._has_start = True
            self._first_ns, self._last_ns = self._asked.span_ns(int(t_ns[0]))
        if len(t_ns):
            inside = np.flatnonzero((t_ns >= self._first_ns) & (t_ns <= self._last_ns))
            if len(inside):
                self._begin()
                self._put(block, int(inside[0]), int(inside[-1]) + 1)
            elif self._is_inside or (t_ns > self._last_ns).all():
                self.is_over = bool((t_ns > self._last_ns).all())
        if block.note is not None and not self.is_over:
            self._note(*block.note)

    def finish(self) -> None:
        """Raises InvalidInputError if nothing was in the stretch."""
        if not self._count:
            raise stretch_empty()
        self._output.finish()

    def _begin(self) -> None:
        if not self._is_inside:
            self._is_inside = True
            for name, record in self._known.values():
                self._output.note(name, record)

    def _put(self, block: Block, first: int, end: int) -> None:
        """The messages from `first` to `end`: one in between with a time outside the stretch stays, in its order."""
        sizes = block.messages.length[first:end] + PAYLOAD_AT
        begin, stop = int(block.at[first]), int(block.at[end - 1] + sizes[-1])
        part = slice(first, end)
        channel, t_ns, start, length, data = block.messages
        messages = Messages(channel[part], t_ns[part], start[part], length[part], data)
        self._output.put(block.records[begin:stop], block.at[part] - begin, messages)
        self._count += end - first

    def _note(self, name: str, record: bytes) -> None:
        found = _read(name, record)
        if self._is_inside:
            # A block may reach beyond the stretch, and notes with it.
            if found is None or found.t_ns <= self._last_ns:
                self._output.note(name, record)
        elif name in _STATES:
            content = found.content if found is not None and isinstance(found.content, dict) else {}
            self._known[name, str(content.get("plan") or content.get("line"))] = (name, record)


def _read(name: str, record: bytes) -> Note | None:
    return notes.read(name, Metadata.read(ReadDataStream(BytesIO(record[HEAD.size :]))).metadata)
