"""The station's commands as X-Plane takes them: rows 8, 11 and 25, each value for itself.

Row 8 moves the pilot's stick, row 11 the surfaces past the stick, row 25 the throttle past its lever.
-999 in a value gives that axis back: the surfaces and the throttle to the pilot, the stick to its
neutral place. All other rows, and values that are not finite, are counted and ignored.
"""

import math
from dataclasses import dataclass
from typing import Final

from epf_gcs.codec.messages_gen import NO_VALUE, XPLANE_ROWS
from epf_gcs.simulator.state import NEUTRAL, Controls
from epf_gcs.xplane.datagram import parse

# Axis -> commanded value; None: given back. The axes have the names of the protocol's table.
Command = dict[str, float | None]

_ROWS: Final = {number: XPLANE_ROWS["xp10"][number].values for number in (8, 11, 25)}


@dataclass(slots=True)
class InputCounts:
    """Counts of what arrived and what was ignored."""

    datagrams: int = 0
    bad_datagrams: int = 0
    unknown_rows: int = 0
    bad_values: int = 0


class Inputs:
    """The position of each axis, and whether the station or the pilot commands it.

    `trim` is where the surfaces and the throttle are while the pilot's stick is neutral and the lever
    untouched: the stick moves the surfaces about it, as with an elevator trim.
    """

    def __init__(self, trim: Controls) -> None:
        self._trim = trim
        self._commanded: dict[str, float] = {}
        self.counts = InputCounts()

    def parse(self, datagram: bytes) -> Command | None:
        """Read a datagram; None when it holds no command at all."""
        self.counts.datagrams += 1
        records = parse(datagram)
        if records is None:
            self.counts.bad_datagrams += 1
            return None
        command: Command = {}
        for number, values in records:
            if number not in _ROWS:
                self.counts.unknown_rows += 1
                continue
            for place in _ROWS[number]:
                value = values[place.index]
                if math.isfinite(value):
                    kept = None if value == NO_VALUE else min(place.maximum, max(place.minimum, value))
                    command[place.name] = kept
                else:
                    self.counts.bad_values += 1
        return command or None

    def apply(self, command: Command) -> None:
        """Let the command move its axes."""
        for axis, value in command.items():
            if value is None:
                self._commanded.pop(axis, None)
            else:
                self._commanded[axis] = value

    def stick(self) -> Controls:
        """The pilot's own stick (neutral unless row 8 moved it) and throttle lever."""
        get = self._commanded.get
        return Controls(
            get("stick_elevator", NEUTRAL.elevator),
            get("stick_aileron", NEUTRAL.aileron),
            get("stick_rudder", NEUTRAL.rudder),
            self._trim.throttle,
        )

    def controls(self) -> Controls:
        """What moves the aircraft: each axis commanded from outside, else by the pilot."""
        stick, trim, get = self.stick(), self._trim, self._commanded.get
        return Controls(
            get("surface_elevator", _clip(trim.elevator + stick.elevator)),
            get("surface_aileron", _clip(trim.aileron + stick.aileron)),
            get("surface_rudder", _clip(trim.rudder + stick.rudder)),
            get("throttle_command", trim.throttle),
        )


def _clip(value: float) -> float:
    return min(1.0, max(-1.0, value))
