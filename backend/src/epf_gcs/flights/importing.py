"""`import FILE OUT`: checks a recording of another machine and writes what it holds anew, as our recorder would.

So nothing of a stranger's file lands in the library but payloads and notes within limits; whatever else it has, and
all that is damaged, stays behind, and a clock that was set back in flight goes on. A log of another program becomes a
recording of its topics. It says {"started_ns", "fingerprint", "damage", "log"}: a time, a text, a sentence or null, and
of which kind of program it is a log or null.
"""

from __future__ import annotations

import time
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path
from typing import BinaryIO, Final

import numpy as np
from numpy.typing import NDArray

from epf_gcs.errors import InvalidInputError
from epf_gcs.flights.fingerprint import Fingerprint
from epf_gcs.flights.logs.log import EARLIEST_S, Log
from epf_gcs.flights.logs.own_topics import own_topics
from epf_gcs.flights.logs.reading import read_log
from epf_gcs.flights.room import minding_room
from epf_gcs.flights.worker import Say
from epf_gcs.recordings import notes
from epf_gcs.recordings.limits import RecordingError
from epf_gcs.recordings.log_table import packed
from epf_gcs.recordings.mcap_file import Tally, closing, data_end, message_record, metadata_record, opening
from epf_gcs.recordings.notes import Note
from epf_gcs.recordings.parts import Part
from epf_gcs.recordings.reading import Reader
from epf_gcs.recordings.topics import ALL_TOPICS, LOG_TABLE

_LIBRARY: Final = "epf-gcs import"
_EARLIEST_NS: Final = EARLIEST_S * 1_000_000_000
_DAY_NS: Final = 86_400 * 1_000_000_000
_LONGEST_NS: Final = 7 * _DAY_NS
_SET_BACK_NS: Final = 1_000_000_000
# More than what recording asks for by default: what is made of a log may be larger than the log.
_RESERVE_BYTES: Final = 1_200_000_000


def run(arguments: list[str], say: Say) -> dict[str, int | str | None]:
    """Raises RecordingError, InvalidInputError, ConflictError, OSError; `OUT` is whole or not there."""
    source, target = (Path(argument) for argument in arguments)
    try:
        return _recording(source, target, say)
    except RecordingError as error:
        log = read_log(source) if error.code == "recording_foreign" else None
        if log is None:
            raise
    return _log(log, target, minding_room(say, target, _RESERVE_BYTES))


def _recording(source: Path, target: Path, say: Say) -> dict[str, int | str | None]:
    size = max(1, source.stat().st_size)
    fingerprint, times, clock, reader = Fingerprint(), _Times(), _SteadyClock(), Reader(source)
    with _written(target) as writer:
        for part in reader.parts():
            times.add(part.messages.t_ns)
            steady = clock.steady(part)
            fingerprint.add(steady.messages)
            writer.add(steady)
            say(reader.place / size, "checking")
        first_ns = times.check(time.time_ns())
    damage = _joined(reader.damage, clock.said())
    return {"started_ns": first_ns, "fingerprint": fingerprint.text(), "damage": damage, "log": None}


def _log(log: Log, target: Path, say: Say) -> dict[str, int | str | None]:
    """A recording of a log's topics, in the order in which its reader has them."""
    now_ns = time.time_ns()
    times = _Times()
    stamp_ns = 0
    with _written(target) as writer:
        for piece in log.pieces:
            table = piece.table if log.is_dated else piece.table._replace(t_ns=piece.table.t_ns + now_ns)
            times.add(table.t_ns)
            # A log's topics come one after the other, and a recording's time never goes back: the rows have theirs,
            # and the messages tell where all of it begins and ends.
            stamp_ns = max(stamp_ns, int(table.t_ns.max())) if stamp_ns else int(table.t_ns.min())
            for one in (table, *own_topics(table)):
                writer.message(LOG_TABLE, stamp_ns, packed(one))
            say(piece.share, "checking")
        times.check(now_ns)
    fingerprint = Fingerprint()
    for part in Reader(target).parts():
        fingerprint.add(part.messages)
    undated = None if log.is_dated else "It does not say when it was flown: here it begins when it was imported."
    damage = _joined(*log.said, undated)
    return {"started_ns": times.lowest_ns, "fingerprint": fingerprint.text(), "damage": damage, "log": log.kind}


@contextmanager
def _written(target: Path) -> Iterator[_Writer]:
    """The writer of a file that is there once it is whole, or not at all."""
    part_file = target.with_suffix(".part")
    try:
        with part_file.open("wb") as output:
            writer = _Writer(output)
            yield writer
            writer.finish()
        part_file.replace(target)
    finally:
        part_file.unlink(missing_ok=True)


class _Times:
    """What the messages say of the clock."""

    def __init__(self) -> None:
        self._first_ns: int | None = None
        self.lowest_ns = self._highest_ns = 0

    def add(self, t_ns: NDArray[np.int64]) -> None:
        if not len(t_ns):
            return
        lowest, highest = int(t_ns.min()), int(t_ns.max())
        if self._first_ns is None:
            self._first_ns, self.lowest_ns, self._highest_ns = int(t_ns[0]), lowest, highest
        self.lowest_ns, self._highest_ns = min(self.lowest_ns, lowest), max(self._highest_ns, highest)

    def check(self, now_ns: int) -> int:
        """The time of the first message. Raises InvalidInputError where there is none, or no clock shows such times."""
        if self._first_ns is None:
            raise InvalidInputError("recording_empty", "This recording holds no message: there is nothing to import.")
        if self.lowest_ns < _EARLIEST_NS:
            raise _wrong_clock("it begins before the year 2000")
        if self._highest_ns > now_ns + _DAY_NS:
            raise _wrong_clock("it ends in the future")
        if self._highest_ns - self.lowest_ns > _LONGEST_NS:
            raise _wrong_clock("it lasts longer than a week")
        return self._first_ns


class _SteadyClock:
    """Lets time go on where a clock was set back by a second or more: all that follows comes later by as much.

    A replay, a plot and a track need times that go on, and of the flight after the step nobody knows the right ones.
    """

    def __init__(self) -> None:
        self._last_ns: int | None = None
        self._later_ns = 0
        self._steps = 0

    def steady(self, part: Part) -> Part:
        """The part with such times, those of its notes too."""
        t_ns = part.messages.t_ns
        later = np.full(1, self._later_ns)
        if len(t_ns):
            before = np.concatenate((t_ns[:1] if self._last_ns is None else [self._last_ns], t_ns[:-1]))
            back = np.where(before - t_ns >= _SET_BACK_NS, before - t_ns, 0)
            later = self._later_ns + np.cumsum(back)
            self._steps += int(np.count_nonzero(back))
            self._last_ns, self._later_ns = int(t_ns[-1]), int(later[-1])
        if not self._steps:
            return part
        notes = [(count, replace(note, t_ns=note.t_ns + int(later[max(0, count - 1)]))) for count, note in part.notes]
        return part._replace(messages=part.messages._replace(t_ns=t_ns + later), notes=notes)

    def said(self) -> str | None:
        """A sentence, if the clock was set back."""
        if not self._steps:
            return None
        times = "once" if self._steps == 1 else f"{self._steps} times"
        return f"The clock was set back {times} in flight; here time goes on."


def _joined(*sentences: str | None) -> str | None:
    return " ".join(one for one in sentences if one is not None) or None


class _Writer:
    """Writes messages and notes in their order, without chunks."""

    def __init__(self, output: BinaryIO) -> None:
        self._output = output
        self._tally = Tally()
        output.write(opening(_LIBRARY, ALL_TOPICS))

    def add(self, part: Part) -> None:
        channels, t_ns, starts, lengths, data = part.messages
        payloads = data.tobytes()
        rows = zip(channels.tolist(), t_ns.tolist(), starts.tolist(), lengths.tolist(), strict=True)
        waiting = list(reversed(part.notes))
        for number, (channel, time_ns, start, length) in enumerate(rows):
            while waiting and waiting[-1][0] <= number:
                self._note(waiting.pop()[1])
            self.message(channel, time_ns, payloads[start : start + length])
        for _, note in reversed(waiting):
            self._note(note)

    def message(self, channel: int, time_ns: int, payload: bytes) -> None:
        self._output.write(message_record(channel, self._tally.add(channel, time_ns), time_ns, payload))

    def finish(self) -> None:
        end = data_end()
        self._output.write(end)
        self._output.write(closing(ALL_TOPICS, self._tally, self._output.tell()))

    def _note(self, note: Note) -> None:
        self._tally.metadata_count += 1
        self._output.write(metadata_record(note.name, notes.written(note.t_ns, note.content)))


def _wrong_clock(reason: str) -> InvalidInputError:
    return InvalidInputError("recording_clock_wrong", f"The clock of this recording is wrong: {reason}.", reason=reason)
