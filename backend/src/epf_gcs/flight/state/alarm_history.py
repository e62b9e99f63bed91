"""Alarms that have ended, kept across restarts."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any, Final, get_args

import orjson

from epf_gcs.contract.alarm_ids import AlarmId
from epf_gcs.errors import GatewayError
from epf_gcs.flight.memory.lines_file import LinesFile
from epf_gcs.vehicle.alarms import KEPT, Alarm
from epf_gcs.vehicle.judges import Finding, Level

# An alarm is written when it ends, and once more when it is acknowledged afterwards.
_LINES: Final = 2 * KEPT
_IDS: Final[Mapping[str, AlarmId]] = {name: name for name in get_args(AlarmId)}


class AlarmHistory:
    """`past` holds the alarms of earlier runs, oldest first; `keep` adds those that end from now on."""

    def __init__(self, path: Path, report: Callable[[GatewayError], None]) -> None:
        self._path = path
        self._report = report
        self._file = LinesFile(path, _LINES, report, code="alarms_not_written", what="history of the alarms")
        self.past: list[Alarm] = self._load()

    def keep(self, alarm: Alarm) -> None:
        """Write an alarm that ended, or that was acknowledged after its end. Returns without waiting for the disk."""
        self._file.append(orjson.dumps(alarm.state))

    def close(self) -> None:
        """Wait until all is on the disk."""
        self._file.close()

    def _load(self) -> list[Alarm]:
        try:
            lines = self._file.read()
        except OSError as error:
            self._complain(error.strerror or str(error))
            return []
        found: dict[tuple[str, float], Alarm] = {}
        good: list[bytes] = []
        for line in lines:
            try:
                alarm = _alarm_from(orjson.loads(line))
            except (ValueError, TypeError, KeyError, AttributeError):
                continue
            good.append(line)
            found[alarm.finding.id, alarm.since_s] = alarm
        bad = len(lines) - len(good)
        if bad:
            self._complain(f"{bad} of {len(lines)} lines make no sense")
        self._file.begin_with(good, damaged=bad > 0)
        return list(found.values())[-KEPT:]

    def _complain(self, why: str) -> None:
        self._report(
            GatewayError(
                "alarms_unreadable",
                f"The history of the alarms in {self._path} could not be read whole ({why}): "
                "the gateway starts with what could be read.",
                path=str(self._path),
                reason=why,
            )
        )


def _alarm_from(values: Mapping[str, Any]) -> Alarm:
    """The alarm whose `state` was written. Raises ValueError, TypeError or KeyError for anything else."""
    params = {
        str(name): value for name, value in values["params"].items() if isinstance(value, str | int | float | None)
    }
    level: Level = "critical" if values["level"] == "critical" else "warning"
    return Alarm(
        Finding(_IDS[values["id"]], level, str(values["text"]), params),
        since_s=float(values["since_s"]),
        acknowledged=values["acknowledged"] is True,
        until_s=float(values["until_s"]),
    )
