"""The health of each part, for programs that watch the station. A pure function of the status."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final, Literal

from epf_gcs.contract.status import BoardStatus, RecordingState, SimulatorStatus, Status
from epf_gcs.web.state.figures import Disk

PartState = Literal["ok", "off", "waiting", "failed"]
"""`off`: not requested. `waiting`: requested and not there yet. `failed`: requested, and lost or broken."""

LEAST_FREE_BYTES: Final = 200_000_000
"""Free disk space that a day's recordings need."""

_HEARTBEAT_S: Final = 3.0
_LINK_STATES: Final[dict[str, PartState]] = {"closed": "off", "opening": "waiting", "open": "ok", "lost": "failed"}


@dataclass(frozen=True, slots=True)
class PartHealth:
    """How a part is; `detail` is a sentence where it failed."""

    state: PartState
    detail: str | None = None


@dataclass(frozen=True, slots=True)
class Health:
    """What programs that watch the station read. `processes`: of the station itself, whatever is connected to it."""

    status: Literal["ok", "failed"]
    processes: Literal["ok", "failed"]
    failed: list[str]
    version: str | None
    parts: dict[str, PartHealth]


def health(status: Status | None, disk: Disk | None) -> tuple[int, Health]:
    """The HTTP status and the body: 503 where a part failed. `status` None: the flight process does not answer."""
    parts = {"web": PartHealth("ok"), "disk": _disk(disk)}
    if status is None:
        parts["flight"] = PartHealth("failed", "The flight process does not answer.")
    else:
        parts |= {
            "flight": PartHealth("ok"),
            "board": _board(status.board),
            "simulator": _link(status.simulator),
            "recording": _recording(status.recording),
        }
    failed = sorted(name for name, part in parts.items() if part.state == "failed")
    body = Health(
        status="failed" if failed else "ok",
        processes="failed" if status is None else "ok",
        failed=failed,
        version=None if status is None else status.version,
        parts=parts,
    )
    return (503 if failed else 200), body


def _link(link: BoardStatus | SimulatorStatus) -> PartHealth:
    failure = link.failure
    state: PartState = "failed" if failure is not None else _LINK_STATES.get(link.state, "failed")
    return PartHealth(state, failure.detail if failure is not None else None)


def _board(board: BoardStatus) -> PartHealth:
    part = _link(board)
    age_s = board.heartbeat_age_s
    if part.state == "ok" and not board.emulated and age_s is not None and age_s > _HEARTBEAT_S:
        return PartHealth("failed", f"The board's heartbeat is {age_s:.1f} s old.")
    return part


def _recording(recording: RecordingState) -> PartHealth:
    if recording.failure is not None:
        return PartHealth("failed", recording.failure)
    return PartHealth("ok" if recording.active else "off")


def _disk(disk: Disk | None) -> PartHealth:
    if disk is None:
        return PartHealth("failed", "The data folder cannot be looked at.")
    if disk.free_bytes < LEAST_FREE_BYTES:
        return PartHealth("failed", f"{disk.free_bytes // 1_000_000} MB are free: free the disk.")
    return PartHealth("ok")
