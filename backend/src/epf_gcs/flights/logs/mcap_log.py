"""MCAP files of other programs: messages in JSON."""

from __future__ import annotations

import struct
from collections import Counter
from collections.abc import Iterator
from pathlib import Path
from typing import Any, BinaryIO, Final

import orjson
from mcap.exceptions import McapError
from mcap.reader import make_reader

from epf_gcs.flights.logs.log import Log, Piece, Rows, flattened, reason_of
from epf_gcs.recordings.limits import RecordingError

_JSON: Final = "json"
_LATEST_NS: Final = (1 << 63) - 1
_LONGEST_ENCODING: Final = 32


def read(path: Path) -> Log:
    """Damage ends the reading with what came before it."""
    said: list[str] = []
    return Log("mcap", _pieces(path, said), said=said)


def _pieces(path: Path, said: list[str]) -> Iterator[Piece]:
    rows, messages = Rows(), _Messages()
    with path.open("rb") as file:
        try:
            for topic, t_ns, values in messages.in_json(file):
                table = rows.add(topic, t_ns, values)
                if table is not None:
                    yield Piece(table, min(1.0, file.tell() / max(1, path.stat().st_size)))
        except (McapError, ValueError, EOFError, LookupError, OverflowError, MemoryError, struct.error) as error:
            said.append(f"This file is damaged, and what follows is left out: {reason_of(error)}.")
    others = messages.others
    if others and not rows.has_any:
        raise RecordingError(
            "recording_foreign", f"This file is another program's, and nothing in it is JSON but {', '.join(others)}."
        )
    for table in rows.rest():
        yield Piece(table, 1.0)
    for encoding, count in others.items():
        said.append(f"{count} messages in the encoding '{encoding}' are left out: only JSON is read.")
    if messages.broken:
        said.append(f"Messages that are no JSON, or have no possible time, are left out: {messages.broken}.")


class _Messages:
    """The messages of a file, and how many cannot be read: those of `others`, by their encoding, and `broken` JSON."""

    def __init__(self) -> None:
        self.others: Counter[str] = Counter()
        self.broken = 0

    def in_json(self, file: BinaryIO) -> Iterator[tuple[str, int, dict[str, float]]]:
        """Topic, time (Unix ns) and numbers of each."""
        for _, channel, message in make_reader(file).iter_messages():
            if channel.message_encoding != _JSON:
                self.others[channel.message_encoding[:_LONGEST_ENCODING] or "none"] += 1
                continue
            values = _numbers(message.data)
            if values is None or message.log_time > _LATEST_NS:
                self.broken += 1
            else:
                yield channel.topic, message.log_time, values


def _numbers(data: bytes) -> dict[str, float] | None:
    try:
        content: Any = orjson.loads(data)
    except orjson.JSONDecodeError:
        return None
    return flattened(content)
