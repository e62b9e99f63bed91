"""Parquet: the flight's part of the Hive-partitioned dataset in an archive, or one table as it is."""

from __future__ import annotations

import shutil
import zipfile
from pathlib import Path
from typing import Final

import pyarrow.parquet as pq

from epf_gcs.flights.export.asked import ExportRequest, Progress
from epf_gcs.flights.export.number_names import names_of
from epf_gcs.flights.export.stretch import Stretch
from epf_gcs.recordings.export_names import is_single

_PIECE_BYTES: Final = 1 << 20
_GROUP_ROWS: Final = 32_768


def write(asked: ExportRequest, target: Path, aside: Path, progress: Progress) -> None:
    """Raises GatewayError, OSError."""
    stretch = Stretch(asked, progress)
    stretch.expect(stretch.topics)
    if is_single(asked.format, asked.topics):
        _table(stretch, stretch.topics[0], target)
        return
    partition = Path(*stretch.folder.parts[-3:])
    # Stored, for the tables are packed already.
    with zipfile.ZipFile(target, "w", zipfile.ZIP_STORED) as archive:
        for number, topic in enumerate(stretch.topics):
            path = stretch.path(topic)
            if not _is_as_it_is(stretch, topic):
                path = aside / f"{topic}.parquet"
                _table(stretch, topic, path)
            name = f"{partition.as_posix()}/{topic}.parquet"
            with path.open("rb") as source, archive.open(name, "w", force_zip64=True) as entry:
                shutil.copyfileobj(source, entry, _PIECE_BYTES)
            if path.parent == aside:
                path.unlink()
            progress.at((number + 1) / len(stretch.topics))


def _table(stretch: Stretch, topic: str, target: Path) -> None:
    """One table: as it is, or the rows of the stretch with the names of numbers."""
    if _is_as_it_is(stretch, topic):
        shutil.copyfile(stretch.path(topic), target)
        return
    with pq.ParquetWriter(target, stretch.schema(topic), compression="zstd") as writer:
        for batch in stretch.batches(topic):
            writer.write_batch(batch, row_group_size=_GROUP_ROWS)


def _is_as_it_is(stretch: Stretch, topic: str) -> bool:
    return stretch.is_whole and not names_of(topic)
