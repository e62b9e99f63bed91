"""Repair of recordings whose writer was killed: cut off the incomplete last record, note it, and add the summary."""

from __future__ import annotations

import os
import re
import struct
import time
from collections.abc import Callable, Iterable
from dataclasses import dataclass, field, replace
from pathlib import Path
from struct import Struct
from typing import BinaryIO, Final

from mcap.opcode import Opcode

from epf_gcs.disk import open_regular, regular_files
from epf_gcs.flight.memory.flight_log import say
from epf_gcs.recordings.mcap_file import MAGIC, Tally, closing, data_end, metadata_record
from epf_gcs.recordings.next_record import next_record
from epf_gcs.recordings.notes import REPAIRED, written
from epf_gcs.system.priority import go_last

_OURS: Final = re.compile(r"[0-9]{8}T[0-9]{6}Z(-[0-9]+)?\.mcap")
_HEAD: Final = Struct("<BQ")
_MESSAGE: Final = Struct("<HIQQ")
_CHANNEL: Final = Struct("<HHI")
# The records we write between header and summary. A file with any other was not written by us: leave it alone.
_KNOWN: Final = frozenset({Opcode.HEADER, Opcode.CHANNEL, Opcode.MESSAGE, Opcode.METADATA})
# No record of ours is longer: a greater length means damage, not an incomplete record.
_LONGEST: Final = 16 * 1024 * 1024
_FOOTER_BYTES: Final = 9 + 20
# Scanning shares the interpreter with the flight: pause after each burst of records (about 0.1 ms of work).
_BURST: Final = 100
_REST_S: Final = 0.001


class BeyondRepairError(Exception):
    """The file is damaged not only at its end; it was left unchanged."""


@dataclass
class _FileExtent:
    """What a file holds, up to its last whole record."""

    end: int
    topics: dict[int, str] = field(default_factory=dict)
    tally: Tally = field(default_factory=Tally)
    _torn: tuple[int, Tally] | None = None

    def take(self, opcode: int, body: bytes) -> None:
        """A whole record. Raises struct.error and UnicodeDecodeError."""
        self._torn = None
        if opcode == Opcode.MESSAGE:
            channel, _, time_ns, _ = _MESSAGE.unpack_from(body)
            if body.endswith(b"\0"):
                self._torn = self.end, replace(self.tally, counts=dict(self.tally.counts))
            self.tally.add(channel, time_ns)
        elif opcode == Opcode.METADATA:
            self.tally.metadata_count += 1
        elif opcode == Opcode.CHANNEL:
            number, _, length = _CHANNEL.unpack_from(body)
            self.topics[number] = body[_CHANNEL.size : _CHANNEL.size + length].decode()
        self.end += _HEAD.size + len(body)

    def drop_torn(self) -> None:
        """Zeros follow, as a power cut leaves them: a last message that ends in zeros may have lost its end to them.

        A frame has a checksum that tells, a datagram has none.
        """
        if self._torn is not None:
            self.end, self.tally = self._torn


def recordings_in(folder: Path) -> list[Path]:
    """The recordings in this folder, newest first."""
    return sorted((path for path in regular_files(folder) if _OURS.fullmatch(path.name)), reverse=True)


def repair_all(files: Iterable[Path], is_over: Callable[[], bool] = lambda: False) -> None:
    """Repair incomplete recordings in the calling thread, at the lowest priority. Stops early when `is_over()`."""
    go_last()  # where the system refuses, the pauses must suffice
    for path in files:
        if is_over():
            return
        try:
            cut = repair(path, is_over)
        except BeyondRepairError as error:
            say("warning", "recording damaged, left as it is", file=path.name, reason=str(error))
        except OSError as error:
            say("warning", "recording not repaired", file=path.name, reason=error.strerror or str(error))
        else:
            if cut is not None:
                say("info", "recording repaired", file=path.name, bytes_cut=cut)


def repair(path: Path, is_over: Callable[[], bool] = lambda: False) -> int | None:
    """Complete an unfinished recording. Returns the number of bytes cut off, None if nothing was to be done.

    An empty file is removed. Raises BeyondRepairError and OSError, and then leaves the file unchanged.
    """
    with open_regular(path) as file:
        size = os.fstat(file.fileno()).st_size
        if size == 0:
            path.unlink()
            return 0
        if _is_whole(file, size):
            return None
        found = _look_through(file, size, is_over)
        if found is None:
            return None
        file.seek(found.end)
        # Behind the last record only a summary may begin, which is made again: nothing of the flight is lost then.
        is_flight_whole = file.read(1) in (b"", bytes([Opcode.DATA_END]))
        end = data_end()
        if not is_flight_whole:
            end = metadata_record(REPAIRED, written(found.tally.last_ns, {"bytes_cut": size - found.end})) + end
            found.tally.metadata_count += 1
        file.seek(found.end)
        file.truncate()
        file.write(end + closing(found.topics, found.tally, found.end + len(end)))
        file.flush()
        os.fsync(file.fileno())
    return size - found.end


def _is_whole(file: BinaryIO, size: int) -> bool:
    tail = len(MAGIC) + _FOOTER_BYTES
    if size < len(MAGIC) + tail:
        return False
    file.seek(size - tail)
    read = file.read(tail)
    return read.endswith(MAGIC) and _HEAD.unpack_from(read) == (Opcode.FOOTER, 20)


def _look_through(file: BinaryIO, size: int, is_over: Callable[[], bool]) -> _FileExtent | None:
    """Find the last complete record. None if `is_over()` stopped the search."""
    file.seek(0)
    if file.read(len(MAGIC)) != MAGIC:
        raise BeyondRepairError("it does not begin as a recording")
    found = _FileExtent(end=len(MAGIC))
    count = 0
    while (head := file.read(_HEAD.size)) and len(head) == _HEAD.size:
        opcode, length = _HEAD.unpack(head)
        if opcode == Opcode.DATA_END:
            return found  # only the summary is incomplete
        if opcode not in _KNOWN or length > _LONGEST:
            _check_is_blank(head, file)
            found.drop_torn()
            return found
        body = file.read(length)
        if len(body) < length:
            if next_record(file, found.end + 1) is not None:
                raise BeyondRepairError("there is something in it that is no record")
            return found
        try:
            found.take(opcode, body)
        except (struct.error, UnicodeDecodeError) as error:
            raise BeyondRepairError("there is a record in it that makes no sense") from error
        count += 1
        if count % _BURST == 0:
            if is_over():
                return None
            time.sleep(_REST_S)
    return found


def _check_is_blank(head: bytes, file: BinaryIO) -> None:
    """Accept an end of zeros, as a power cut leaves it. Raises BeyondRepairError for other data, which may matter."""
    block = head
    while block:
        if block.count(0) != len(block):
            raise BeyondRepairError("there is something in it that is no record")
        block = file.read(1 << 20)
