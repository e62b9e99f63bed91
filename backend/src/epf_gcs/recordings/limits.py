"""How much of a recording is read, and why one is refused: a stranger's file may claim anything."""

from __future__ import annotations

from dataclasses import dataclass

from epf_gcs.errors import GatewayError


class RecordingError(GatewayError):
    """The file cannot be read as a recording at all. Damage inside a recording is told, not raised."""


@dataclass(frozen=True, slots=True)
class Limits:
    """Greatest sizes in bytes, and counts. What a file merely claims (statistics, indexes) is never believed.

    record_bytes: one record that is no chunk. chunk_bytes: one chunk, packed or unpacked. unpacked_bytes: all
    messages of the file with their records. whole_bytes: what `read_file` may hold in memory at once.
    """

    record_bytes: int = 16 << 20
    chunk_bytes: int = 64 << 20
    unpacked_bytes: int = 8 << 30
    whole_bytes: int = 1 << 30
    messages: int = 100_000_000
    notes: int = 100_000


LIMITS = Limits()
