"""The rules of a flight's own figures: battery, limits that the operator set, and the pilot's transmitter."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Any, Final

from epf_gcs.contract.alarm_ids import AlarmId
from epf_gcs.contract.answers import BatteryPack
from epf_gcs.contract.base import Values
from epf_gcs.vehicle.judges import LASTS_S, Debounce, Finding, Level, Params

_RECEIVER_LASTS_S: Final = 1.0
# Lithium polymer and lithium ion, with what a charger and a sensor are off by.
_FULL_CELL_V: Final = 4.25


class BatteryJudge:
    """The battery of the board; no alarm while its voltage is not measured or not live.

    Until the operator says how many cells the pack has, the highest voltage that was seen tells it: no cell of lithium
    is charged above `_FULL_CELL_V`. A pack that was never full may be taken for one with fewer cells, so the page asks.
    """

    def __init__(self) -> None:
        self._low = Debounce(LASTS_S)
        self._said_v = 0.0
        self._highest_v = 0.0

    def kept(self) -> list[Any]:
        """Plain values for `restore`."""
        return [self._low.kept(), self._said_v, self._highest_v]

    def restore(self, kept: Sequence[Any]) -> None:
        """Go on from what `kept` gave."""
        low, self._said_v, self._highest_v = kept
        self._low.restore(low)

    def pack(self, limits: Mapping[str, float]) -> BatteryPack | None:
        """What the alarm goes by; None while no voltage was measured."""
        if self._highest_v <= 0.0:
            return None
        told = round(limits["battery_cells"])
        cells = told or math.ceil(self._highest_v / _FULL_CELL_V)
        low_v = limits["battery_low_v"] or cells * limits["battery_cell_low_v"]
        return BatteryPack(round(self._highest_v, 1), cells, not told, round(low_v, 2))

    def look(self, now_s: float, live: Values | None, limits: Mapping[str, float]) -> Finding | None:
        """`live` is the newest sample of analog, None while it is not live."""
        battery_v = None if live is None else live.get("battery_v")
        self._highest_v = max(self._highest_v, battery_v or 0.0)
        pack = self.pack(limits)
        is_low = None if battery_v is None or pack is None else battery_v < pack.low_v
        if battery_v is not None and is_low:
            self._said_v = round(battery_v, 1)
        if not self._low.look(now_s, condition=is_low) or pack is None:
            return None
        params: Params = {"battery_v": self._said_v, "limit_v": round(pack.low_v, 1)}
        why = f", below {pack.low_v:.1f} V"
        if limits["battery_low_v"] == 0.0:
            params["cells"] = pack.cells
            why = f"; {pack.cells} cells need {pack.low_v:.1f} V"
        text = f"The battery is low: {self._said_v:.1f} V{why}. Land, or change it."
        return Finding("battery_low", "critical", text, params)


class LimitJudge:
    """A measured value beyond a limit that the operator set."""

    def __init__(self, alarm: AlarmId, level: Level, text: str, *, is_least: bool = False) -> None:
        """`text` is the sentence, with {value} and {limit}; `is_least`: the value may not be below the limit."""
        self._alarm: AlarmId = alarm
        self._level: Level = level
        self._text = text
        self._is_least = is_least
        self._beyond = Debounce(LASTS_S)
        self._said = 0

    def kept(self) -> list[Any]:
        """Plain values for `restore`."""
        return [self._beyond.kept(), self._said]

    def restore(self, kept: Sequence[Any]) -> None:
        """Go on from what `kept` gave."""
        beyond, self._said = kept
        self._beyond.restore(beyond)

    def look(self, now_s: float, value: float | None, limit: float) -> Finding | None:
        """`value` is None if it is not measured or not live. With a limit of 0 there is no alarm."""
        is_beyond = None
        if limit > 0.0 and value is not None:
            is_beyond = value < limit if self._is_least else value > limit
        if value is not None and is_beyond:
            self._said = round(value)
        if limit == 0.0:
            self._beyond.reset()
        if not self._beyond.look(now_s, condition=is_beyond):
            return None
        params: Params = {"value": self._said, "limit": round(limit)}
        return Finding(self._alarm, self._level, self._text.format(**params), params)


class ReceiverJudge:
    """The receiver of the pilot's transmitter. A board that does not hear it sends its channels as not measured."""

    def __init__(self) -> None:
        self._lost = Debounce(_RECEIVER_LASTS_S)
        self._was_heard = False

    def kept(self) -> list[Any]:
        """Plain values for `restore`."""
        return [self._lost.kept(), self._was_heard]

    def restore(self, kept: Sequence[Any]) -> None:
        """Go on from what `kept` gave."""
        lost, self._was_heard = kept
        self._lost.restore(lost)

    def look(self, now_s: float, live: Values | None) -> Finding | None:
        """`live` is the newest sample of servos_in, None while it is not live."""
        is_heard = None if live is None else all(channel is not None for channel in live.values())
        self._was_heard = self._was_heard or is_heard is True
        # A receiver that was never heard may not be there.
        is_lost = not is_heard if self._was_heard and is_heard is not None else None
        if not self._lost.look(now_s, condition=is_lost):
            return None
        text = "The board does not hear the pilot's transmitter: look at its switch, battery and aerial."
        return Finding("receiver_lost", "critical", text)
