"""What a status says of a board, the live one or a recorded one, from what the board told."""

from __future__ import annotations

from epf_gcs.contract.base import Values
from epf_gcs.contract.status import Features, Firmware, TaskPeriod, TaskPeriods
from epf_gcs.vehicle.wanted import RATE_COMMANDS, IntendedSettings


def features_of(capabilities: Values) -> Features:
    """What the board can do, by its message of capabilities; a legacy board sends none."""
    names = ("acknowledgements", "store", "sources", "missions")
    return Features(**{name: bool(capabilities.get(f"has_{name}")) for name in names})


def firmware_of(capabilities: Values) -> Firmware | None:
    """What an extended board calls itself."""
    if not capabilities:
        return None
    return Firmware(capabilities.get("firmware_name"), capabilities.get("firmware_version"))


def periods_of(wanted: IntendedSettings) -> TaskPeriods:
    """The periods of the three tasks: as commanded, else the board's own."""
    return TaskPeriods(
        *(
            TaskPeriod(round(1000.0 * wanted.period_s(command)), command in wanted.periods_ms)
            for command in RATE_COMMANDS
        )
    )


def percent(bytes_per_s: float, full: float) -> float:
    """The load of a line, in percent of `full` bytes a second."""
    return round(100.0 * bytes_per_s / full, 1) if full else 0.0
