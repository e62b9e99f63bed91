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
    log = Log("mcap", iter(()))
    log.pieces = _pieces(path, log.said)
    return log


def _pieces(path: Path, said: list[str]) -> Iterator[Piece]:
    rows = Rows()
    unread: Counter[str] = Counter()
    with path.open("rb") as file:
        try:
            for topic, t_ns, values in _rows(file, unread):
                table = rows.add(topic, t_ns, values)
                if table is not None:
                    yield Piece(table, min(1.0, file.tell() / max(1, path.stat().st_size)))
        except (McapError, ValueError, EOFError, LookupError, OverflowError, MemoryError, struct.error) as error:
            said.append(f"This file is damaged, and what follows is left out: {reason_of(error)}.")
    if unread and not rows.has_any:
        raise RecordingError(
            "recording_foreign", f"This file is another program's, and nothing in it is JSON but {', '.join(unread)}."
        )
    for table in rows.rest():
        yield Piece(table, 1.0)
    said += [
        f"{count} messages in the encoding '{one}' are left out: only JSON is read." for one, count in unread.items()
    ]


def _rows(file: BinaryIO, unread: Counter[str]) -> Iterator[tuple[str, int, dict[str, float]]]:
    """Topic, time and numbers of each message in JSON; of the others, how many there are of each encoding."""
    for _, channel, message in make_reader(file).iter_messages():
        encoding = channel.message_encoding[:_LONGEST_ENCODING] or "none"
        values = _numbers(message.data) if encoding == _JSON else None
        if values is None or message.log_time > _LATEST_NS:
            unread[encoding] += 1
        else:
            yield channel.topic, message.log_time, values


def _numbers(data: bytes) -> dict[str, float] | None:
    try:
        content: Any = orjson.loads(data)
    except orjson.JSONDecodeError:
        return None
    return flattened(content)
