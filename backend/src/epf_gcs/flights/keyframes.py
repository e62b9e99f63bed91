"""Key frames: at most every 2 s of flight, where to begin reading, and the newest sample of every topic until there."""

from __future__ import annotations

from typing import Any, Final

import numpy as np
import orjson
import pyarrow as pa
import pyarrow.compute as pc

from epf_gcs.recordings.parts import Part
from epf_gcs.recordings.reading import place_of

EVERY_NS: Final = 2_000_000_000
SCHEMA: Final = pa.schema(
    [
        pa.field("t_ns", pa.int64(), nullable=False, metadata={"unit": "ns"}),
        pa.field("place", pa.int64(), nullable=False, metadata={"unit": "byte"}),
        pa.field("newest", pa.string(), nullable=False),
    ]
)


class KeyFrames:
    """Told each part of the recording and the tables made of it; `take` gives the key frames that are due."""

    def __init__(self) -> None:
        self._due_ns: int | None = None
        self._newest: dict[str, Any] = {}

    def take(self, part: Part, tables: dict[str, pa.Table]) -> pa.Table:
        """Key frames in this part. `newest` is JSON: {topic: {"t_ns": ..., "values": {...}}}, as before the place."""
        times, places = self._moments(part)
        samples = {topic: _before(topic, table, times) for topic, table in tables.items() if table.num_rows}
        texts: list[str] = []
        for index in range(len(times)):
            for topic, found in samples.items():
                if found[index] is not None:
                    self._newest[topic] = found[index]
            texts.append(orjson.dumps(self._newest).decode())
        for topic, found in samples.items():
            if found[-1] is not None:
                self._newest[topic] = found[-1]
        return pa.Table.from_arrays(
            [pa.array(times, pa.int64()), pa.array(places, pa.int64()), pa.array(texts, pa.string())], schema=SCHEMA
        )

    def _moments(self, part: Part) -> tuple[list[int], list[int]]:
        """Time of each key frame, and the place of the message that comes next."""
        t_ns = np.maximum.accumulate(part.messages.t_ns) if len(part.messages.t_ns) else part.messages.t_ns
        times: list[int] = []
        places: list[int] = []
        index = 0
        while index < len(t_ns):
            if self._due_ns is not None:
                index = max(index, int(np.searchsorted(t_ns, self._due_ns)))
                if index == len(t_ns):
                    break
            times.append(int(t_ns[index]))
            places.append(place_of(part, index))
            self._due_ns = times[-1] + EVERY_NS
            index += 1
        return times, places


def _before(topic: str, table: pa.Table, times: list[int]) -> list[Any]:
    """The newest sample before each of the times, None where there is none; and the last of all."""
    t_ns = np.maximum.accumulate(table.column("t_ns").to_numpy())
    indexes = [*(np.searchsorted(t_ns, np.array(times, dtype=np.int64)) - 1).tolist(), table.num_rows - 1]
    if topic == "xplane_rows":
        return [None if index < 0 else _rows(table, index) for index in indexes]
    rows = table.take(pa.array([max(0, index) for index in indexes])).to_pylist()
    found: list[Any] = []
    for index, row in zip(indexes, rows, strict=True):
        at_ns = row.pop("t_ns")
        found.append(None if index < 0 else {"t_ns": at_ns, "values": row})
    return found


def _rows(table: pa.Table, index: int) -> dict[str, Any]:
    """A sample of the simulator's rows: all that have the time of this one."""
    at_ns = table.column("t_ns")[index].as_py()
    rows: dict[str, list[float]] = {}
    for row in table.filter(pc.equal(table.column("t_ns"), at_ns)).to_pylist():
        row.pop("t_ns")
        rows[str(row.pop("row"))] = list(row.values())
    return {"t_ns": at_ns, "values": {"rows": rows}}
