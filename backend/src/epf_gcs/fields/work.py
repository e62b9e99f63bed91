"""What the station and the worker of a field say to each other: a line of work, then lines of progress."""

from __future__ import annotations

from dataclasses import dataclass

import msgspec

from epf_gcs.contract.flights import Fault
from epf_gcs.contract.maps import FieldProof, FieldStep
from epf_gcs.workers.lines import WorkerLine


class Prepare(msgspec.Struct, tag_field="do", tag="prepare"):
    """Fetch and make the field in this folder; `servers` of the local network may be asked."""

    folder: str
    servers: list[str]


class Prove(msgspec.Struct, tag_field="do", tag="prove"):
    """Compare every tile of a file with its manifest."""

    path: str
    name: str


Work = Prepare | Prove


@dataclass(frozen=True, slots=True)
class FieldProgress:
    """How far it is. `percent` of what is made; `waits_s`: the source is asked again then, and `waits_for` says why."""

    doing: FieldStep = "waiting"
    percent: int | None = None
    tiles: int = 0
    tiles_total: int = 0
    tiles_missing: int = 0
    bytes: int = 0
    bytes_total: int = 0
    bytes_per_s: int = 0
    left_s: int | None = None
    retries: int = 0
    waits_s: float | None = None
    waits_for: Fault | None = None


class FieldLine(WorkerLine):
    """A line of the worker; `proof` comes at the end of a proof, `is_done` at the end of a preparation."""

    progress: FieldProgress | None = None
    proof: FieldProof | None = None
    is_done: bool = False
