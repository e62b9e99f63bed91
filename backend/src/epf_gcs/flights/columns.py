"""A recording -> its columns: one Parquet table a topic, and what was counted on the way."""

from __future__ import annotations

import re
import shutil
from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass, field
from datetime import UTC, datetime
from pathlib import Path
from typing import Any, Final, Protocol

import numpy as np
import pyarrow as pa
from numpy.typing import NDArray

from epf_gcs.codec.frame import FROM_BOARD, TO_BOARD, Direction
from epf_gcs.codec.tables import Message
from epf_gcs.contract.own_topics import OWN_TYPE_WORDS
from epf_gcs.flights.bulk import BulkDecoder, DamageReport, StretchContents
from epf_gcs.flights.convert import T_NS, log_rows, schema, table
from epf_gcs.flights.datagrams import Datagrams, without_no_value
from epf_gcs.flights.keyframes import KeyFrames
from epf_gcs.flights.rates import Rates
from epf_gcs.flights.tables import Tables
from epf_gcs.recordings.log_table import unpacked
from epf_gcs.recordings.notes import IDENTITY, LINE, Note
from epf_gcs.recordings.parts import Messages, Part
from epf_gcs.recordings.reading import LIMITS, Limits, Reader
from epf_gcs.recordings.table_names import DAMAGE, KEYFRAMES, LINK, RAW_ROWS, SENT
from epf_gcs.recordings.topics import BOARD_RECEIVED, BOARD_SENT, LOG_TABLE, SIMULATOR_RECEIVED
from epf_gcs.vehicle.noted import noted_messages

Say = Callable[[float, str], None]

_DAMAGE: Final = pa.schema(
    [T_NS, pa.field("direction", pa.string()), pa.field("kind", pa.string()), pa.field("data", pa.binary())]
)
_UNSAFE: Final = re.compile(r"[^A-Za-z0-9._-]+")
_UNNAMED: Final = "unknown"


@dataclass
class Counts:
    """What a recording holds. Times are Unix ns; `gaps`: no byte of the board for over 1 s while its line was open."""

    bytes: int = 0
    first_ns: int | None = None
    last_ns: int | None = None
    frames: Counter[str] = field(default_factory=Counter)
    damaged: Counter[str] = field(default_factory=Counter)
    implausible: Counter[str] = field(default_factory=Counter)
    gaps: list[tuple[int, int]] = field(default_factory=list)
    is_whole: bool = False
    damage: str | None = None

    @property
    def frames_heard(self) -> int:
        """Good frames from the board."""
        return sum(count for name, count in self.frames.items() if not name.startswith(SENT))

    @property
    def frames_damaged(self) -> int:
        """Failed frames alone, as live counts them."""
        return sum(count for kind, count in self.damaged.items() if kind not in ("noise", "remains", "text"))


@dataclass(frozen=True)
class TableFolder:
    """The folder that holds the tables now, what was counted, and all notes of the recording."""

    folder: Path
    counts: Counts
    notes: list[Note]


class Sink(Protocol):
    """Where the tables go."""

    def add(self, topic: str, table: pa.Table) -> None:
        """Take rows of a topic; all its tables have one schema. Raises OSError."""


def write_columns(
    path: Path, root: Path, say: Say, limits: Limits = LIMITS, *, watch: Callable[[Messages], None] | None = None
) -> TableFolder:
    """Write the tables of a recording below `root`, in place of earlier ones of the same flight, whole or not at all.

    `say` is told the progress (0..1), `watch` all messages in file order. Raises RecordingError and OSError.
    """
    root.mkdir(parents=True, exist_ok=True)
    work = root / f".{path.stem}.part"
    shutil.rmtree(work, ignore_errors=True)
    work.mkdir()
    try:
        tables = Tables(work)
        try:
            making = TableMaker(tables, path, limits)
            making.run(say, watch)
        finally:
            tables.close()
        folder = root / _partition(making.notes, making.counts, path.stem)
        folder.parent.mkdir(parents=True, exist_ok=True)
        for old in root.glob(f"vehicle=*/date=*/flight={path.stem}"):
            shutil.rmtree(old)
        work.rename(folder)
    finally:
        shutil.rmtree(work, ignore_errors=True)
    return TableFolder(folder, making.counts, making.notes)


def _partition(notes: list[Note], counts: Counts, flight: str) -> Path:
    """Where the tables go: by aircraft (or board) and day."""
    known = [note.content for note in notes if note.name == IDENTITY and isinstance(note.content, dict)]
    names = [content.get("aircraft") or _board_name(content.get("board")) for content in known]
    name = _UNSAFE.sub("_", next((str(one) for one in reversed(names) if one), _UNNAMED))[:64].strip("._") or _UNNAMED
    day = datetime.fromtimestamp((counts.first_ns or 0) // 1_000_000_000, UTC).strftime("%Y-%m-%d")
    return Path(f"vehicle={name}") / f"date={day}" / f"flight={flight}"


def _board_name(board: Any) -> Any:
    return board.get("firmware_name") if isinstance(board, dict) else None


class _Line:
    """One direction of the board's line."""

    def __init__(self, direction: Direction, prefix: str) -> None:
        self.decoder = BulkDecoder(direction)
        self.name = "sent" if prefix else "received"
        self._prefix = prefix
        self._own: dict[str, Message] = {}

    def topic(self, message: Message) -> str:
        """The name of its table: one of another form than an earlier one of its name has a number behind it."""
        if message.id not in OWN_TYPE_WORDS:
            return self._prefix + message.name
        name, number = message.name, 1
        while not schema(self._own.setdefault(name, message)).equals(schema(message)):
            number += 1
            name = f"{message.name}_{number}"
        return name


class TableMaker:
    """Makes tables of what a recording has, and of what it has more at each `advance`."""

    def __init__(self, tables: Sink, path: Path, limits: Limits = LIMITS) -> None:
        self.counts = Counts()
        self.notes: list[Note] = []
        self._size = max(1, path.stat().st_size)
        self._reader = Reader(path, limits=limits)
        self._tables = tables
        self._lines = {BOARD_RECEIVED: _Line(FROM_BOARD, ""), BOARD_SENT: _Line(TO_BOARD, SENT)}
        self._datagrams = Datagrams()
        self._keys = KeyFrames()
        self._rates = Rates()
        self._made: dict[str, list[pa.Table]] = {}

    def run(self, say: Say, watch: Callable[[Messages], None] | None = None) -> None:
        """Read all of it, to its end. Raises RecordingError, OSError."""
        self.advance(say, watch)
        for channel in self._lines:
            self._decoded(channel, self._lines[channel].decoder.finish())
        for topic, tables in self._made.items():
            for one in tables:
                self._tables.add(topic, one)
        rates = self._rates.table()
        if rates.num_rows:
            self._tables.add(LINK, rates)
        self.counts.is_whole = self._reader.is_whole
        self.counts.damage = self._reader.damage

    def advance(self, say: Say | None = None, watch: Callable[[Messages], None] | None = None) -> None:
        """Read what the file has more than before; frames that are not whole yet wait. Raises as `run`."""
        for part in self._reader.parts():
            if watch is not None:
                watch(part.messages)
            self._take(part)
            if say is not None:
                say(self._reader.place / self._size, "columns")
        self.counts.gaps = self._rates.gaps

    def _take(self, part: Part) -> None:
        """Everything of one part: between two notes that a line was opened or closed, all at once."""
        self.notes += [note for _, note in part.notes]
        t_ns = part.messages.t_ns
        if len(t_ns):
            self.counts.bytes += int(part.messages.length.sum())
            self.counts.first_ns = int(t_ns[0]) if self.counts.first_ns is None else self.counts.first_ns
            self.counts.last_ns = max(int(t_ns.max()), self.counts.last_ns or 0)
        begin = 0
        for before, note in part.notes:
            own = noted_messages(note)
            is_line = note.name == LINE and isinstance(note.content, dict)
            if own is None and not is_line:
                continue
            self._stretch(part.messages, begin, before)
            begin = before
            if own is not None:
                self._lines[BOARD_RECEIVED].decoder.learn(own)
            if is_line:
                self._line_changed(note)
        self._stretch(part.messages, begin, len(t_ns))
        made, self._made = self._made, {}
        joined = {topic: pa.concat_tables(tables) for topic, tables in made.items()}
        shown = {topic: one for topic, one in joined.items() if topic != DAMAGE and not topic.startswith(SENT)}
        self._tables.add(KEYFRAMES, self._keys.take(part, shown))
        for topic, one in joined.items():
            self._tables.add(topic, without_no_value(one) if topic == RAW_ROWS else one)

    def _line_changed(self, note: Note) -> None:
        """A line was opened or closed: its stream begins anew."""
        if note.content.get("line") == "simulator":
            self._datagrams.begin(str(note.content.get("profile") or "xp10"))
            return
        for channel in self._lines:
            self._decoded(channel, self._lines[channel].decoder.finish())
        self._rates.line_changed(is_open=bool(note.content.get("open")), t_ns=note.t_ns)

    def _stretch(self, messages: Messages, begin: int, end: int) -> None:
        if begin == end:
            return
        for channel in (*self._lines, SIMULATOR_RECEIVED, LOG_TABLE):
            chosen = np.flatnonzero(messages.channel[begin:end] == channel) + begin
            if not len(chosen):
                continue
            some = Messages(
                messages.channel[chosen],
                messages.t_ns[chosen],
                messages.start[chosen],
                messages.length[chosen],
                messages.data,
            )
            if channel == LOG_TABLE:
                self._log_tables(some)
                continue
            self._rates.heard(channel, some.t_ns, some.length)
            if channel == SIMULATOR_RECEIVED:
                for topic, one in self._datagrams.take(some).tables.items():
                    self._made.setdefault(topic, []).append(one)
            else:
                ends = np.cumsum(some.length)
                self._decoded(channel, self._lines[channel].decoder.feed(_joined(some), ends, some.t_ns))

    def _log_tables(self, messages: Messages) -> None:
        """The topics of another program's log. Their payloads end later than the messages' times."""
        view = messages.data.data
        for start, length in zip(messages.start.tolist(), messages.length.tolist(), strict=True):
            found = unpacked(bytes(view[start : start + length]))
            rows = None if found is None else log_rows(found)
            if found is None or rows is None:
                self.counts.damaged["log"] += 1
                continue
            lowest, highest = int(found.t_ns.min()), int(found.t_ns.max())
            self.counts.first_ns = min(lowest, self.counts.first_ns or lowest)
            self.counts.last_ns = max(highest, self.counts.last_ns or highest)
            self._tables.add(found.topic, rows)

    def _decoded(self, channel: int, decoded: StretchContents) -> None:
        line = self._lines[channel]
        for message, frames in decoded.frames.items():
            topic = line.topic(message)
            self.counts.frames[topic] += len(frames.t_ns)
            made, implausible = table(message, frames)
            self.counts.implausible.update({f"{topic}.{name}": count for name, count in implausible.items()})
            self._made.setdefault(topic, []).append(made)
        if decoded.damage:
            self._damaged(line, decoded.damage)

    def _damaged(self, line: _Line, found: list[DamageReport]) -> None:
        # Lines of text, as the one that opens the binary mode, are no damage; live counts them apart too.
        kinds = [one.damage.kind if one.damage.text is None else "text" for one in found]
        if line.name == "received":
            self.counts.damaged.update(kinds)
        self._made.setdefault(DAMAGE, []).append(
            pa.Table.from_arrays(
                [
                    pa.array([one.t_ns for one in found], pa.int64()),
                    pa.array([line.name] * len(found), pa.string()),
                    pa.array(kinds, pa.string()),
                    pa.array([one.damage.data for one in found], pa.binary()),
                ],
                schema=_DAMAGE,
            )
        )


def _joined(messages: Messages) -> NDArray[np.uint8]:
    """The payloads one after another: the bytes of the line."""
    view = messages.data.data
    pieces = [
        view[start:end]
        for start, end in zip(messages.start.tolist(), (messages.start + messages.length).tolist(), strict=True)
    ]
    return np.frombuffer(b"".join(pieces), dtype=np.uint8)
