"""The bytes of an MCAP file without chunks: whatever reached the disk can be read, up to the last whole record.

The library's own writer builds each record in Python objects under the interpreter's lock, for 10-15 µs
each; the one record that is written thousands of times is packed here in one step instead.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from struct import Struct
from typing import Final

import numpy as np
from mcap.data_stream import RecordBuilder
from mcap.opcode import Opcode
from mcap.records import Channel, DataEnd, Footer, Header, McapRecord, Metadata, Statistics
from numpy.typing import NDArray

MAGIC: Final = b"\x89MCAP0\r\n"
# opcode, record length | channel, sequence, log time, publish time
_MESSAGE: Final = Struct("<BQHIQQ")
_MESSAGE_FIELDS: Final = _MESSAGE.size - 9


def message_record(channel: int, sequence: int, time_ns: int, data: bytes) -> bytes:
    """One message; its publish time is its log time, for the bytes carry no clock of their own."""
    length = _MESSAGE_FIELDS + len(data)
    return _MESSAGE.pack(Opcode.MESSAGE, length, channel, sequence & 0xFFFFFFFF, time_ns, time_ns) + data


def metadata_record(name: str, values: Mapping[str, str]) -> bytes:
    """A note, placed in the file at the time it applies to."""
    return encoded(Metadata(name=name, metadata=dict(values)))


def opening(library: str, topics: Mapping[int, str]) -> bytes:
    """The records before the first message. Messages are raw bytes, so there is no schema."""
    return MAGIC + encoded(Header(profile="", library=library)) + _channels(topics)


@dataclass
class Tally:
    """The counts and times for the summary at the end of a file."""

    counts: dict[int, int] = field(default_factory=dict)
    metadata_count: int = 0
    first_ns: int = 0
    last_ns: int = 0

    def add(self, channel: int, time_ns: int) -> int:
        """Count one message; returns how many there were on its channel before it."""
        if not self.counts:
            self.first_ns = time_ns
        self.last_ns = time_ns
        before = self.counts.get(channel, 0)
        self.counts[channel] = before + 1
        return before

    def add_all(self, channel: int, times_ns: NDArray[np.int64]) -> None:
        """Count the messages of one channel of a chunk; at least one."""
        first_ns, last_ns = int(times_ns.min()), int(times_ns.max())
        self.first_ns = min(self.first_ns, first_ns) if self.counts else first_ns
        self.last_ns = max(self.last_ns, last_ns)
        self.counts[channel] = self.counts.get(channel, 0) + len(times_ns)


def closing(
    topics: Mapping[int, str], tally: Tally, summary_start: int, indexes: bytes = b"", chunk_count: int = 0
) -> bytes:
    """The records after DataEnd; `summary_start` is the offset of the byte after DataEnd.

    A packed file also has `indexes`: the index records of its chunks and notes.
    """
    statistics = Statistics(
        attachment_count=0,
        channel_count=len(topics),
        channel_message_counts=dict(tally.counts),
        chunk_count=chunk_count,
        message_count=sum(tally.counts.values()),
        message_end_time=tally.last_ns,
        message_start_time=tally.first_ns,
        metadata_count=tally.metadata_count,
        schema_count=0,
    )
    footer = Footer(summary_start=summary_start, summary_offset_start=0, summary_crc=0)
    return _channels(topics) + encoded(statistics) + indexes + encoded(footer) + MAGIC


def data_end() -> bytes:
    """The record between messages and summary."""
    return encoded(DataEnd(data_section_crc=0))


def _channels(topics: Mapping[int, str]) -> bytes:
    return b"".join(
        encoded(Channel(id=number, topic=topic, message_encoding="application/octet-stream", metadata={}, schema_id=0))
        for number, topic in topics.items()
    )


def encoded(record: McapRecord) -> bytes:
    """The bytes of a record, by the library."""
    builder = RecordBuilder()
    record.write(builder)
    made: bytes = builder.end()  # type: ignore[no-untyped-call]
    return made
