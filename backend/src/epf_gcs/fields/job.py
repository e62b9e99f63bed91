"""One field on its way: what was ordered, how far it is, and where that is kept."""

from __future__ import annotations

import shutil
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Final, Literal

import msgspec

from epf_gcs.contract.flights import Fault
from epf_gcs.contract.maps import FieldSourceName, PreparedField, problem_parts
from epf_gcs.disk import replace_file
from epf_gcs.errors import GatewayError
from epf_gcs.fields.order import Order
from epf_gcs.fields.work import FieldProgress
from epf_gcs.fields.worker import ORDER

STATE: Final = "state.json"

FieldState = Literal["running", "paused", "failed", "done"]


class KeptState(msgspec.Struct):
    """The file: what a restart goes on from."""

    state: FieldState
    progress: FieldProgress
    problem: Fault | None


@dataclass(slots=True)
class FieldJob:
    """`folder`: its own, which goes when it is done or removed. `layer`: the first of its layers once it is done."""

    id: str
    folder: Path
    order: Order
    state: FieldState = "running"
    problem: GatewayError | None = None
    layer: str | None = None
    progress: FieldProgress = field(default_factory=FieldProgress)

    @property
    def file_name(self) -> str:
        """The name of its file in the maps' folder."""
        return f"{self.order.name}.field"

    def is_running(self) -> bool:
        """Whether it is to go on; asked anew after each wait, for others pause it meanwhile."""
        return self.state == "running"

    def is_done(self) -> bool:
        """Whether its file is in the maps' folder."""
        return self.state == "done"

    @property
    def told(self) -> PreparedField:
        """As the interface gives it: its problem, or what it waits for."""
        progress = self.progress
        waits = progress.waits_for if self.problem is None else None
        problem = problem_parts(self.problem) if waits is None else (waits.detail, waits.code, waits.params)
        return PreparedField(
            *problem,
            id=self.id,
            name=self.order.name,
            state=self.state,
            doing=progress.doing,
            percent=progress.percent,
            layer=self.layer,
            sources=[FieldSourceName(part.kind, part.name) for part in self.order.parts],
            tiles=progress.tiles,
            tiles_total=progress.tiles_total,
            tiles_missing=progress.tiles_missing,
            bytes=progress.bytes,
            bytes_total=progress.bytes_total,
            bytes_per_s=progress.bytes_per_s,
            left_s=progress.left_s,
            retries=progress.retries,
            waits_s=progress.waits_s,
        )

    def hear(self, told: FieldProgress) -> None:
        """What its worker said of the progress: counts stay as they are while something is made of them."""
        if told.doing != "fetching":
            told = at_rest(replace(self.progress, doing=told.doing, percent=told.percent))
        self.progress = told

    def write_order(self) -> None:
        """Make its folder. Raises OSError."""
        self.folder.mkdir(parents=True)
        replace_file(self.folder / ORDER, self.order.as_json())

    def write_state(self) -> None:
        """Remember it over a restart. Raises OSError."""
        problem = None if self.problem is None else Fault.of(self.problem)
        kept = KeptState(self.state, replace(self.progress, waits_for=None, waits_s=None), problem)
        replace_file(self.folder / STATE, msgspec.json.encode(kept))

    def drop(self) -> None:
        """Delete its folder with all that arrived. Raises OSError if something is left."""
        if self.folder.exists():
            shutil.rmtree(self.folder)


def at_rest(progress: FieldProgress) -> FieldProgress:
    """The same while nothing is fetched."""
    return replace(progress, waits_s=None, waits_for=None, left_s=None, bytes_per_s=0)


def kept_jobs(folder: Path) -> list[FieldJob]:
    """Those that an earlier run left, to go on with; what is none of ours is left alone. Raises OSError."""
    found: list[FieldJob] = []
    if not folder.is_dir():
        return found
    for one in sorted(folder.iterdir()):
        job = None if one.is_symlink() else _kept(one)
        if job is not None:
            found.append(job)
    return found


def _kept(folder: Path) -> FieldJob | None:
    try:
        order = Order.from_json((folder / ORDER).read_bytes())
    except (OSError, ValueError):
        return None
    job = FieldJob(folder.name, folder, order)
    try:
        kept = msgspec.json.decode((folder / STATE).read_bytes(), type=KeptState)
    except (OSError, ValueError):
        return job  # killed before it was written: it goes on
    job.state, job.progress, said = kept.state, kept.progress, kept.problem
    job.problem = None if said is None else GatewayError(said.code, said.detail, **said.params)
    return job
