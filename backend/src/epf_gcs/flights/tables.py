"""One Parquet file for each topic, written row group by row group in bounded memory."""

from __future__ import annotations

from pathlib import Path
from typing import Final

import pyarrow as pa
import pyarrow.parquet as pq

# Small enough that a stretch of minutes reads little, large enough to pack well: ten minutes of a 50 Hz topic.
_GROUP_ROWS: Final = 32_768
# Rows of text are large: key frames of eighteen hours would wait for their group in memory.
_GROUP_BYTES: Final = 16_000_000
_LEVEL: Final = 1


class Tables:
    """Collects tables by topic in `folder`. Close it in any case."""

    def __init__(self, folder: Path) -> None:
        self._folder = folder
        self._writers: dict[str, pq.ParquetWriter] = {}
        self._waiting: dict[str, list[pa.Table]] = {}

    def add(self, topic: str, table: pa.Table) -> None:
        """Append rows. All tables of a topic have one schema. Raises OSError."""
        waiting = self._waiting.setdefault(topic, [])
        waiting.append(table)
        is_long = sum(one.num_rows for one in waiting) >= _GROUP_ROWS
        if is_long or sum(one.nbytes for one in waiting) >= _GROUP_BYTES:
            self._write(topic)

    def close(self) -> None:
        """Write what waits, and the files' ends. Raises OSError."""
        for topic in self._waiting:
            self._write(topic)
        for writer in self._writers.values():
            writer.close()

    def _write(self, topic: str) -> None:
        waiting, self._waiting[topic] = self._waiting[topic], []
        if not waiting:
            return
        table = pa.concat_tables(waiting)
        writer = self._writers.get(topic)
        if writer is None:
            writer = self._writers[topic] = pq.ParquetWriter(
                self._folder / f"{topic}.parquet",
                table.schema,
                compression="zstd",
                compression_level=_LEVEL,
                use_dictionary=[field.name for field in table.schema if pa.types.is_string(field.type)],
                column_encoding=None,
            )
        writer.write_table(table, row_group_size=_GROUP_ROWS)
