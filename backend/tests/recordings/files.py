"""Recordings as the station writes them, and as the mcap library packs them."""

from __future__ import annotations

import random
from collections.abc import Iterator
from io import BytesIO
from typing import Any

from mcap.writer import CompressionType, Writer

from epf_gcs.recordings.mcap_file import Tally, closing, data_end, message_record, metadata_record, opening
from epf_gcs.recordings.notes import MARK, Note, written
from epf_gcs.recordings.reading import Message, Recording
from epf_gcs.recordings.topics import TOPICS

START_NS = 1_769_860_800_000_000_000
EVERY_NS = 1_000_000

Said = tuple[int, int, bytes]


def messages(count: int, seed: int = 1) -> list[Said]:
    """Messages of all four topics. Some payloads look like records themselves."""
    rng = random.Random(seed)
    trap = message_record(1, 7, START_NS, b"inside")
    return [
        (
            rng.choice(list(TOPICS)),
            START_NS + index * EVERY_NS,
            rng.choice((rng.randbytes(rng.randrange(60)), trap, b"", b"\x05" + bytes(40))),
        )
        for index in range(count)
    ]


def mark(t_ns: int, text: str) -> bytes:
    """The record of a mark."""
    return metadata_record(MARK, written(t_ns, {"text": text, "by": None, "id": text}))


def plain(said: list[Said], mark_every: int = 0) -> tuple[bytes, bytes]:
    """Head with messages (and marks before every so many of them), and the end that a finished file has."""
    tally = Tally()
    data = [opening("test 1.0", TOPICS)]
    for index, (channel, t_ns, payload) in enumerate(said):
        if mark_every and index % mark_every == 0:
            data.append(mark(t_ns, str(index)))
            tally.metadata_count += 1
        data.append(message_record(channel, tally.add(channel, t_ns), t_ns, payload))
    body, end = b"".join(data), data_end()
    return body, end + closing(TOPICS, tally, len(body) + len(end))


def packed(said: list[Said], chunk_size: int = 4096, **options: Any) -> bytes:
    """The same messages as the mcap library writes them, in zstd chunks."""
    output = BytesIO()
    writer = Writer(output, chunk_size=chunk_size, **({"compression": CompressionType.ZSTD} | options))
    writer.start()
    numbers = {
        channel: writer.register_channel(topic=topic, message_encoding="application/octet-stream", schema_id=0)
        for channel, topic in reversed(TOPICS.items())
    }
    for index, (channel, t_ns, payload) in enumerate(said):
        writer.add_message(numbers[channel], t_ns, payload, t_ns, index)
    writer.finish()  # type: ignore[no-untyped-call]
    return output.getvalue()


def said_by(recording: Recording) -> list[Said]:
    """The messages of a file that was read at once."""
    read = recording.messages
    return [
        (channel, t_ns, read.data[start : start + length].tobytes())
        for channel, t_ns, start, length in zip(
            read.channel.tolist(), read.t_ns.tolist(), read.start.tolist(), read.length.tolist(), strict=True
        )
    ]


def heard(items: Iterator[Message | Note]) -> list[Said]:
    """The messages of a file that was read one by one."""
    return [(item.channel, item.t_ns, item.data) for item in items if isinstance(item, Message)]
