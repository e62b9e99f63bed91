"""Every type of frame and row with its count, rate and last values, in the interface's shape; live and for a replay.

In two steps: `copy_frames` only copies, because live it blocks the event loop and with it the HIL loop; the others
calculate and may run in a thread.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from typing import Any, Final

from epf_gcs.codec.messages_gen import TELEMETRY, XPLANE_ROWS
from epf_gcs.contract.inspector import InspectedFrame, InspectedRow
from epf_gcs.vehicle.arrivals import Arrivals
from epf_gcs.vehicle.frame_statistics import FrameStatistics
from epf_gcs.vehicle.health import ANSWERS
from epf_gcs.vehicle.telemetry import Telemetry
from epf_gcs.xplane.datagram import Eight
from epf_gcs.xplane.mapping import NEEDED_ROWS, TRACK_ROW

# Sent when asked for: the time between two is a person's, and no jitter.
_ANSWERS: Final = ANSWERS | {message.name for message in TELEMETRY.values() if not message.topic}
EXPECTED_ROWS: Final = NEEDED_ROWS | {TRACK_ROW}


@dataclass(frozen=True, slots=True)
class CountedFrame:
    """The counters of one type of frame at the time of the copy."""

    id: int
    name: str
    damaged: int
    stale_after_s: float | None
    arrivals: Arrivals
    units: Mapping[str, str] = field(default_factory=dict)


def copy_frames(statistics: FrameStatistics, telemetry: Telemetry) -> list[CountedFrame]:
    """All types that the definition and the board itself have, heard or not, then those that were heard beside them."""
    known = [
        CountedFrame(
            type_id,
            message.name,
            statistics.damaged[message.name],
            telemetry.stale_after_s(message.name) if message.topic else None,
            statistics.heard[message.name].copy(),
            {value.name: value.unit for value in message.values},
        )
        for type_id, message in (*TELEMETRY.items(), *sorted(statistics.own.items()))
    ]
    unknown = [
        CountedFrame(type_id, f"unknown_0x{type_id:x}", statistics.unknown_damaged[type_id], None, arrivals.copy())
        for type_id, arrivals in sorted(statistics.unknown.items())
    ]
    return known + unknown


def inspect_frames(frames: Iterable[CountedFrame], now_s: float) -> list[InspectedFrame]:
    """`now_s` is the Unix time of the copy."""
    return [
        InspectedFrame(
            id=frame.id,
            name=frame.name,
            damaged=frame.damaged,
            stale_after_s=frame.stale_after_s,
            values=frame.arrivals.values,
            units=frame.units,
            **_measured(frame.arrivals, now_s, has_period=frame.name not in _ANSWERS),
        )
        for frame in frames
    ]


def inspect_rows(heard: Mapping[int, Arrivals], profile: str, now_s: float) -> list[InspectedRow]:
    """All rows of the profile, and those that were heard."""
    definitions = XPLANE_ROWS[profile]
    return [
        InspectedRow(
            row=row,
            name=definitions[row].name if row in definitions else f"row_{row}",
            expected=row in EXPECTED_ROWS,
            values=_finite(heard[row].values) if row in heard else None,
            **_measured(heard[row] if row in heard else Arrivals(), now_s),
        )
        for row in sorted({*definitions, *heard})
    ]


def share_percent(bytes_per_s: float, capacity_bytes_per_s: float | None) -> float | None:
    """What a line carries of what it can; None where that is not known."""
    return round(100.0 * bytes_per_s / capacity_bytes_per_s, 1) if capacity_bytes_per_s else None


def _measured(arrivals: Arrivals, now_s: float, *, has_period: bool = True) -> dict[str, Any]:
    summary = arrivals.summary(now_s)
    jitter_ms = summary.jitter_ms if has_period else None
    return {
        "count": summary.count,
        "rate_hz": round(summary.rate_hz, 2),
        "jitter_ms": None if jitter_ms is None else round(jitter_ms, 3),
        "age_s": None if summary.age_s is None else round(summary.age_s, 3),
    }


def _finite(eight: Eight) -> list[float | None]:
    return [value if abs(value) < float("inf") else None for value in eight]
