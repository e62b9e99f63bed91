"""What the operator asked the board for, so that it can be requested again after board or gateway restarted."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from types import MappingProxyType
from typing import Final

from epf_gcs.codec.messages_gen import COMMANDS
from epf_gcs.codec.values import Json

_ON: Final = "_on"
_OFF: Final = "_off"
# Streams, with the heartbeat's flag for each; the two plans have no flag.
STREAM_FLAGS: Final[Mapping[str, str | None]] = MappingProxyType(
    {
        "ahrs": "ahrs",
        "inertial": "inertial",
        "analog": "analog",
        "statistics": "statistics",
        "gps": "gps",
        "servos_in": "servos",
        "fly_by_wire": "fly_by_wire",
        "fms_plan": None,
        "fms_hil_plan": None,
    }
)
RATE_COMMANDS: Final = ("set_parameter_task_rate", "set_fms_task_rate", "set_servos_task_rate")
SOURCE_COMMAND: Final = "control_source"


@dataclass(frozen=True, slots=True)
class IntendedSettings:
    """Streams that should be on, periods in ms that were set, and the control source, None where never chosen."""

    streams: frozenset[str] = frozenset()
    periods_ms: Mapping[str, int] = field(default_factory=dict)
    source: int | None = None

    def after(self, command: str, arguments: Sequence[float]) -> IntendedSettings:
        """What is wanted once this command was given."""
        if command == "start":
            return replace(self, streams=frozenset(STREAM_FLAGS))
        if command == "stop":
            return replace(self, streams=frozenset())
        if command in RATE_COMMANDS:
            return replace(self, periods_ms={**self.periods_ms, command: int(arguments[0])})
        if command == SOURCE_COMMAND:
            return replace(self, source=int(arguments[0]))
        for ending, streams in ((_ON, self.streams.union), (_OFF, self.streams.difference)):
            stream = command.removesuffix(ending)
            if stream != command and stream in STREAM_FLAGS:
                return replace(self, streams=streams({stream}))
        return self

    def period_s(self, rate_command: str) -> float:
        """Period of a task as commanded, or the board's own."""
        default = COMMANDS[rate_command].values[0].default
        return self.periods_ms.get(rate_command, default or 0) / 1000.0

    def missing(self, heartbeat: Mapping[str, Json]) -> list[tuple[str, tuple[float, ...]]]:
        """Commands that bring a board with this heartbeat to what is wanted.

        Streams, rates and control source only: the autopilot is never switched on again without the operator.
        """
        commands: list[tuple[str, tuple[float, ...]]] = [
            (name, (period_ms,)) for name, period_ms in self.periods_ms.items()
        ]
        if self.source is not None and heartbeat.get("source_joystick") is not bool(self.source):
            commands.append((SOURCE_COMMAND, (self.source,)))
        commands += [
            (stream + _ON, ())
            for stream, flag in STREAM_FLAGS.items()
            if stream in self.streams and (flag is None or heartbeat.get(flag) is not True)
        ]
        return commands
