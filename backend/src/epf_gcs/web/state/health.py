"""The health of each part, for programs that watch the station. A pure function of the status."""

from __future__ import annotations

from typing import Any, Final, Literal

from epf_gcs.contract.status import BoardStatus, RecordingState, SimulatorStatus, Status
from epf_gcs.web.state.figures import Disk

PartState = Literal["ok", "off", "waiting", "failed"]
"""`off`: not requested. `waiting`: requested and not there yet. `failed`: requested, and lost or broken."""

LEAST_FREE_BYTES: Final = 200_000_000
"""Free disk space that a day's recordings need."""

_HEARTBEAT_S: Final = 3.0
_LINK_STATES: Final[dict[str, PartState]] = {"closed": "off", "opening": "waiting", "open": "ok", "lost": "failed"}


def health(status: Status | None, disk: Disk | None) -> tuple[int, dict[str, Any]]:
    """The HTTP status and the body: 503 where a part failed. `status` None: the flight process does not answer."""
    parts: dict[str, dict[str, Any]] = {"web": _part("ok"), "disk": _disk(disk)}
    if status is None:
        parts["flight"] = _part("failed", "The flight process does not answer.")
    else:
        parts |= {
            "flight": _part("ok"),
            "board": _board(status.board),
            "simulator": _link(status.simulator),
            "recording": _recording(status.recording),
        }
    failed = sorted(name for name, part in parts.items() if part["state"] == "failed")
    body = {
        "status": "failed" if failed else "ok",
        # Of the station itself, whatever is connected to it.
        "processes": "failed" if status is None else "ok",
        "failed": failed,
        "version": None if status is None else status.version,
        "parts": parts,
    }
    return (503 if failed else 200), body


def _part(state: PartState, detail: str | None = None) -> dict[str, Any]:
    return {"state": state, "detail": detail}


def _link(link: BoardStatus | SimulatorStatus) -> dict[str, Any]:
    failure = link.failure
    state: PartState = "failed" if failure is not None else _LINK_STATES.get(link.state, "failed")
    return _part(state, failure.detail if failure is not None else None)


def _board(board: BoardStatus) -> dict[str, Any]:
    part = _link(board)
    age_s = board.heartbeat_age_s
    if part["state"] == "ok" and not board.emulated and age_s is not None and age_s > _HEARTBEAT_S:
        return _part("failed", f"The board's heartbeat is {age_s:.1f} s old.")
    return part


def _recording(recording: RecordingState) -> dict[str, Any]:
    if recording.failure is not None:
        return _part("failed", recording.failure)
    return _part("ok" if recording.active else "off")


def _disk(disk: Disk | None) -> dict[str, Any]:
    if disk is None:
        return _part("failed", "The data folder cannot be looked at.")
    if disk.free_bytes < LEAST_FREE_BYTES:
        return _part("failed", f"{disk.free_bytes // 1_000_000} MB are free: free the disk.")
    return _part("ok")
