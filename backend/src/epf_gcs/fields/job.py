"""One field on its way: what was ordered, how far it is, and where that is kept."""

from __future__ import annotations

import shutil
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Final, Literal

import orjson

from epf_gcs.disk import replace_file
from epf_gcs.errors import GatewayError
from epf_gcs.fields.order import Order
from epf_gcs.fields.worker import ORDER

STATE: Final = "state.json"

FieldState = Literal["running", "paused", "failed", "done"]

_NO_PROGRESS: Final[dict[str, Any]] = {
    "doing": "waiting",
    "percent": None,
    "tiles": 0,
    "tiles_total": 0,
    "tiles_missing": 0,
    "bytes": 0,
    "bytes_total": 0,
    "bytes_per_s": 0,
    "left_s": None,
    "retries": 0,
    "waits_s": None,
    "waits_for": None,
}


@dataclass(slots=True)
class FieldJob:
    """`folder`: its own, which goes when it is done or removed. `layer`: the first of its layers once it is done."""

    id: str
    folder: Path
    order: Order
    state: FieldState = "running"
    problem: GatewayError | None = None
    layer: str | None = None
    progress: dict[str, Any] = field(default_factory=lambda: dict(_NO_PROGRESS))

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

    def as_dict(self) -> dict[str, Any]:
        """Plain values."""
        progress = {**self.progress}
        waits = progress.pop("waits_for") or {}
        problem = self.problem
        if problem is None and waits:
            told = {"problem": waits["detail"], "problem_code": waits["code"], "problem_params": waits["params"]}
        else:
            told = {
                "problem": None if problem is None else problem.detail,
                "problem_code": None if problem is None else problem.code,
                "problem_params": {} if problem is None else problem.params,
            }
        return {
            "id": self.id,
            "name": self.order.name,
            "state": self.state,
            "layer": self.layer,
            "sources": [{"kind": part.kind, "name": part.name} for part in self.order.parts],
            **progress,
            **told,
        }

    def hear(self, told: dict[str, Any]) -> None:
        """What its worker said of the progress: counts stay as they are while something is made of them."""
        if told["doing"] != "fetching":
            told = {"waits_s": None, "waits_for": None, "left_s": None, "bytes_per_s": 0, **told}
        self.progress.update(told)

    def write_order(self) -> None:
        """Make its folder. Raises OSError."""
        self.folder.mkdir(parents=True)
        replace_file(self.folder / ORDER, orjson.dumps(self.order.as_dict()))

    def write_state(self) -> None:
        """Remember it over a restart. Raises OSError."""
        problem = self.problem
        kept = {
            "state": self.state,
            "progress": {**self.progress, "waits_for": None, "waits_s": None},
            "problem": None if problem is None else problem.as_dict(),
        }
        replace_file(self.folder / STATE, orjson.dumps(kept))

    def drop(self) -> None:
        """Delete its folder with all that arrived. Raises OSError if something is left."""
        if self.folder.exists():
            shutil.rmtree(self.folder)


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
        order = Order.from_dict(orjson.loads((folder / ORDER).read_bytes()))
    except (OSError, ValueError, KeyError, TypeError):
        return None
    job = FieldJob(folder.name, folder, order)
    try:
        kept = orjson.loads((folder / STATE).read_bytes())
        job.state = kept["state"]
        job.progress = {**_NO_PROGRESS, **kept["progress"]}
        said = kept["problem"]
        job.problem = None if said is None else GatewayError(said["code"], said["detail"], **said["params"])
    except (OSError, ValueError, KeyError, TypeError):
        # Killed before it was written: it goes on.
        job.state = "running"
    return job
