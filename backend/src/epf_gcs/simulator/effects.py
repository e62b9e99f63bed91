"""What each fault does to values and bytes on their way, and what shows that it did."""

from __future__ import annotations

import math
import random
from collections.abc import Callable, Sequence
from typing import Final, Generic, TypeVar

from epf_gcs.contract.simulator_faults import Fault
from epf_gcs.earth import M_PER_DEG
from epf_gcs.simulator.link import Link, LinkQuality
from epf_gcs.simulator.state import Controls
from epf_gcs.units import FT_MIN_PER_FT_S

T = TypeVar("T")

# What differs by less is rounding.
_SHOWS: Final = 1e-9

SENSORS: Final = {
    "gyro": ("gx_rad_s", "gy_rad_s", "gz_rad_s"),
    "attitude": ("pitch_deg", "roll_deg"),
    "pitot": ("speed_kt",),
    "barometer": ("altitude_ft", "vvi_ft_min"),
    "gps": ("latitude_deg", "longitude_deg", "yaw_deg"),
    "receiver": ("receiver",),
}
"""What each sensor measures, by the names of command 50; `receiver` stands for all channels."""

SERVOS: Final = {"elevator": 0, "aileron": 1, "rudder": 2, "engine": 3}
"""Where each is in `Controls`."""


class Effect:
    """One fault at work. `frames`: in how many it showed."""

    def __init__(self, fault: Fault, seed: int) -> None:
        self.fault = fault
        # The text is the seed, so that each fault has random numbers of its own.
        self.dice = random.Random(f"{seed} {fault}")
        self.frames = 0
        self.largest = 0.0

    def evidence(self) -> str | None:
        """What shows that it was there; None: nothing does."""
        if not self.frames:
            return None
        return f"{self.fault}: {self.fault.place} {self.fault.about.says}, shown in {self.frames} frames"

    def show(self, difference: float = math.inf) -> None:
        """Note by how much what arrived differs from what was sent."""
        if not abs(difference) <= _SHOWS:  # what is no number differs, too
            self.frames += 1
            self.largest = max(self.largest, abs(difference))


class SensorEffect(Effect):
    """On the values of one sensor. `fields`: the names of all values that the board is told."""

    def __init__(self, fault: Fault, seed: int, fields: Sequence[str]) -> None:
        super().__init__(fault, seed)
        self._places = [fields.index(name) for name in SENSORS[fault.place] if name in fields]
        self._held: list[float] | None = None
        self._signs = [self.dice.choice((-1.0, 1.0)) for _ in self._places]
        self._bearing = self.dice.uniform(0.0, 2.0 * math.pi)
        self._second = -1

    def change(self, time_s: float, told: list[float]) -> None:
        """Change what the board is told."""
        if not self.fault.is_on(time_s):
            return
        truth = [told[place] for place in self._places]
        for place, value in zip(self._places, self._wrong(time_s, truth), strict=True):
            told[place] = value
        self.show(max((abs(told[p] - true) for p, true in zip(self._places, truth, strict=True)), key=_size))

    def _wrong(self, time_s: float, truth: list[float]) -> list[float]:
        match self.fault.kind:
            case "stuck":
                self._held = self._held or self._stuck(truth)
                return self._held
            case "dropout":
                return [math.nan] * len(truth)
        since_s = time_s - self.fault.start_s
        match self.fault.place:
            case "gps":
                return self._elsewhere(since_s, truth)
            case "barometer":
                altitude_ft, vvi_ft_min = truth
                drifts = self.fault.amount * FT_MIN_PER_FT_S if self.fault.kind == "drift" else 0.0
                return [altitude_ft + self._off(since_s), vvi_ft_min + drifts]
            case "pitot":
                return [truth[0] + self._off(since_s)]
            case _:
                return [value + sign * self._off(since_s) for value, sign in zip(truth, self._signs, strict=True)]

    def _stuck(self, truth: list[float]) -> list[float]:
        # An altitude that stays means no climb.
        return [truth[0], 0.0] if self.fault.place == "barometer" else truth

    def _off(self, since_s: float) -> float:
        match self.fault.kind:
            case "drift":
                return self.fault.amount * since_s
            case "noise":
                return self.dice.gauss(0.0, self.fault.amount)
            case _:
                return self.fault.amount

    def _elsewhere(self, since_s: float, truth: list[float]) -> list[float]:
        latitude_deg, longitude_deg, track_deg = truth
        if self.fault.kind == "noise":
            north_m, east_m = self._off(since_s), self._off(since_s)
        else:
            if self.fault.kind == "jump" and int(since_s) != self._second:
                self._second = int(since_s)
                self._bearing = self.dice.uniform(0.0, 2.0 * math.pi)
            off_m = self._off(since_s)
            north_m, east_m = off_m * math.cos(self._bearing), off_m * math.sin(self._bearing)
        m_per_deg_east = M_PER_DEG * math.cos(math.radians(latitude_deg))
        return [latitude_deg + north_m / M_PER_DEG, longitude_deg + east_m / m_per_deg_east, track_deg]


class ServoEffect(Effect):
    """On one surface or the throttle, between the board's command and the aircraft."""

    def __init__(self, fault: Fault, seed: int, period_s: float) -> None:
        super().__init__(fault, seed)
        self._place = SERVOS[fault.place]
        self._period_s = period_s
        self._at: float | None = None
        self._was_on = False

    def change(self, time_s: float, wanted: Controls) -> Controls:
        """Where the surfaces and the throttle go."""
        values = [wanted.elevator, wanted.aileron, wanted.rudder, wanted.throttle]
        asked = values[self._place]
        if not self.fault.is_on(time_s):
            self._at, self._was_on = asked, False
            return wanted
        self._at = values[self._place] = self._moved(asked, asked if self._at is None else self._at)
        self._was_on = True
        self.show(self._at - asked)
        return Controls(*values)

    def _moved(self, asked: float, at: float) -> float:
        amount = self.fault.amount
        match self.fault.kind:
            case "jammed":
                return at if self._was_on else max(-1.0, min(1.0, at + amount))
            case "slow":
                most = amount * self._period_s
                return at + max(-most, min(most, asked - at))
            case "weak":
                return amount * asked
            case "reversed":
                return -asked
            case _:
                return 0.0


class LineEffect(Effect):
    """On the frames of one flight, in both directions."""

    def __init__(self, fault: Fault, seed: int) -> None:
        super().__init__(fault, seed)
        amount, kind = fault.amount, fault.kind
        self._seed = seed
        self.quality = LinkQuality(
            delay_ms=amount if kind == "delay" else 0.0,
            jitter_ms=amount if kind == "jitter" else 0.0,
            loss=1.0 if kind == "cut" else amount if kind == "loss" else 0.0,
        )

    def direction(self, name: str, damaged: Callable[[T], T]) -> Direction[T]:
        """The way "to" or "from" the board; `damaged` gives what is left of a frame."""
        return Direction(self, f"{self._seed} {self.fault} {name}", damaged)

    def flipped(self, frame: bytes) -> bytes:
        """The frame as it arrives, with a bit flipped if that is the fault."""
        if self.fault.kind != "flipped" or self.dice.random() >= self.fault.amount:
            return frame
        bit = self.dice.randrange(8 * len(frame))
        flipped = bytearray(frame)
        flipped[bit // 8] ^= 1 << bit % 8
        self.show()
        return bytes(flipped)


class Direction(Generic[T]):
    """One direction of a line with a fault."""

    def __init__(self, effect: LineEffect, seed: str, damaged: Callable[[T], T]) -> None:
        self._effect = effect
        self._link: Link[T] = Link(effect.quality, seed)
        self._damaged = damaged

    @property
    def next_due_s(self) -> float | None:
        """When the next frame arrives; None when none is under way."""
        return self._link.next_due_s

    def carry(self, time_s: float, frames: list[T]) -> list[T]:
        """What arrives now; the end of the fault lets go what is still under way."""
        effect, link = self._effect, self._link
        if not effect.fault.is_on(time_s):
            return link.due(math.inf) + frames
        for frame in frames:
            link.send(self._damaged(frame), time_s)
        due = link.due(time_s)
        if effect.fault.kind != "flipped" and due != frames:
            effect.show()
        return due


class GustEffect(Effect):
    """On the air: a gust of 1-cosine over the fault's length, along the steady wind, or from north in calm."""

    def more_kt(self, time_s: float) -> float:
        """By how much it blows more than the steady wind now."""
        if not self.fault.is_on(time_s):
            return 0.0
        share = (time_s - self.fault.start_s) / self.fault.length
        blows_kt = self.fault.amount * 0.5 * (1.0 - math.cos(2.0 * math.pi * share))
        self.show(blows_kt)
        return blows_kt


def _size(value: float) -> float:
    """For the largest: what is no number is larger than any."""
    return math.inf if value != value else value
