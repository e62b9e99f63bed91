"""One set of tiles of a prepared field (`web/fields`): the file has the tables of MBTiles for each of them."""

from __future__ import annotations

import struct
from pathlib import Path
from typing import Final

from epf_gcs.maps import faults
from epf_gcs.maps.layer import Description
from epf_gcs.maps.mbtiles import MbTiles

VECTOR: Final = "vector_"
"""What stands before the names of the tables of roads, rivers and buildings."""

_HEAD_BYTES: Final = 100
_PAGE_SIZE_AT: Final = 16
_PAGE_COUNT_AT: Final = 28
_CUT_OFF: Final = "cut off"


class FieldSet(MbTiles):
    """One opened set. `name_in_file`: empty for the pictures."""

    def __init__(self, path: Path, name: str, name_in_file: str) -> None:
        """Open the file. Raises GatewayError if it cannot be shown; `map_file_empty` if it has no such set."""
        _check_length(path, name)
        self._is_of_roads = name_in_file == "vector"
        super().__init__(path, name, f"{name_in_file}_" if name_in_file else "", is_vector=self._is_of_roads)

    def _describe(self) -> Description:
        # Files without roads have no tables for them.
        named = f"SELECT 1 FROM sqlite_master WHERE type = 'table' AND name = '{VECTOR}tiles'"  # noqa: S608
        if self._is_of_roads and not self._rows(named):
            raise faults.empty(self._name)
        return super()._describe()


def _check_length(path: Path, name: str) -> None:
    """A file that was cut still opens, and its last tiles are missing: compare its length with what its head says."""
    try:
        with path.open("rb") as file:
            head = file.read(_HEAD_BYTES)
        length = path.stat().st_size
    except OSError as error:
        raise faults.damaged(name, error.strerror or str(error)) from error
    if len(head) < _HEAD_BYTES:
        raise faults.damaged(name, _CUT_OFF)
    (page_size,) = struct.unpack_from(">H", head, _PAGE_SIZE_AT)
    (pages,) = struct.unpack_from(">I", head, _PAGE_COUNT_AT)
    if length < pages * (65536 if page_size == 1 else page_size):
        raise faults.damaged(name, _CUT_OFF)
