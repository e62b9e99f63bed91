"""How a loop answered a step of its target: rise time, overshoot, settling and steady error, read off the samples.

All of it is measured against the step that was asked for, on the smoothed samples, and nothing is told of a time that
was not flown. Beside that stands what a second-order model says (`fitting.py`), where it explains the samples and gives
the same figures as they do: its damping, and how far each figure may be off, for neither noise nor a gust is a part of
the model.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Final, Literal, NamedTuple

import numpy as np

from epf_gcs.contract.report import ReportModel
from epf_gcs.flights.report.fitting import Fit, Model, answer, fit
from epf_gcs.flights.signals import Array

Method = Literal["samples", "none"]

SETTLED: Final = 0.05
"""The band around the target, as a share of the step, in which the answer counts as settled."""
_LEAST_SAMPLES: Final = 12
# With less of the step reached there is nothing to judge.
_LEAST_REACHED: Final = 0.3
# At rest the last quarter neither drifts by more than the band nor swings by more than this, as shares of the step.
_QUARTER: Final = 0.75
_MOST_SWING: Final = 0.15
# The mean of this last part of the time is where it ended.
_EIGHTH: Final = 0.875
# The model explains the samples: share of their variance, and of the step's size what is left (root mean square).
_GOOD_FIT: Final = 0.97
_GOOD_REST: Final = 0.05
# So much of the model's change may still be ahead where the samples end, or its final value is a guess.
_NEARLY: Final = 0.05
# The model's figures are those of the samples: within this share of the rise time, and of the step.
_SAME_RISE: Final = 0.15
_SAME_OVERSHOOT: Final = 5.0
# A figure that may be off by more, as a share of itself, is not told.
_MOST_DOUBT: Final = 0.25


class Response(NamedTuple):
    """Times in s from the step; `final`, `steady_error` and `peak` in the signal's unit. None: cannot be told.

    `rise_from_s` and `rise_to_s` are when 10 and 90 % of the step were reached. `is_cut`: it ended before it came to
    rest, so that neither the settling nor a steady error is known.
    """

    method: Method
    rise_s: float | None = None
    rise_from_s: float | None = None
    rise_to_s: float | None = None
    overshoot_percent: float | None = None
    peak: float | None = None
    peak_s: float | None = None
    settling_s: float | None = None
    final: float | None = None
    steady_error: float | None = None
    is_cut: bool = False
    model: ReportModel | None = None


def respond(t_s: Array, values: Array, start: float, target: float) -> Response:
    """The figures of one answer.

    `t_s` (n,) in order, from the step on, `values` (n,) of the signal; `start` is the signal at the step.
    """
    known = np.isfinite(values)
    t_s, values = t_s[known], values[known]
    size = target - start
    if len(t_s) < _LEAST_SAMPLES or size == 0.0:
        return Response("none")
    share = (values - start) / size
    grid_s, course = _smoothed(t_s, share)
    if float(np.max(course)) < _LEAST_REACHED:
        return Response("none")
    found = _read_off(grid_s, course)
    final = float(np.mean(course[grid_s >= _EIGHTH * grid_s[-1]]))
    found = found._replace(
        final=start + final * size,
        peak=None if found.peak is None else start + found.peak * size,
        steady_error=None if found.is_cut else (1.0 - final) * size,
    )
    return found._replace(model=_model(found, t_s, share, grid_s, abs(size)))


def _read_off(t_s: Array, share: Array) -> Response:
    """Figures of a smooth course of shares of the step."""
    rise_from_s, rise_to_s = _first(t_s, share, 0.1), _first(t_s, share, 0.9)
    top = int(np.argmax(share))
    over = float(share[top]) - 1.0
    is_cut = not _is_at_rest(t_s, share)
    outside = np.flatnonzero(np.abs(share - 1.0) > SETTLED)
    settled = float(t_s[min(outside[-1] + 1, len(t_s) - 1)]) if len(outside) else 0.0
    is_settled = not is_cut and (not len(outside) or t_s[-1] - t_s[outside[-1]] > SETTLED * t_s[-1])
    return Response(
        "samples",
        rise_s=None if rise_from_s is None or rise_to_s is None else rise_to_s - rise_from_s,
        rise_from_s=rise_from_s,
        rise_to_s=rise_to_s,
        overshoot_percent=100.0 * max(0.0, over) if over > 0.0 or not is_cut else None,
        peak=float(share[top]) if over > 0.0 else None,
        peak_s=float(t_s[top]) if over > 0.0 else None,
        settling_s=settled if is_settled else None,
        is_cut=is_cut,
    )


def _is_at_rest(t_s: Array, share: Array) -> bool:
    """Whether the course neither drifts nor swings any more at its end."""
    last = t_s >= _QUARTER * t_s[-1]
    slope, begin = np.polyfit(t_s[last], share[last], 1)
    swing = float(np.ptp(share[last] - (slope * t_s[last] + begin)))
    return bool(abs(slope) * (1.0 - _QUARTER) * t_s[-1] <= SETTLED and swing <= _MOST_SWING)


def _first(t_s: Array, share: Array, level: float) -> float | None:
    """When the course first reaches a level, between samples."""
    above = np.flatnonzero(share >= level)
    if not len(above):
        return None
    place = int(above[0])
    if place == 0:
        return float(t_s[0])
    low, high = float(share[place - 1]), float(share[place])
    return float(t_s[place - 1] + (t_s[place] - t_s[place - 1]) * (level - low) / (high - low))


def _model(measured: Response, t_s: Array, share: Array, grid_s: Array, size: float) -> ReportModel | None:
    """What the model says, on the time that was flown; None where it does not say what the samples do."""
    fitted = _fitting(t_s, share)
    if fitted is None:
        return None
    model, uncertain = fitted.model, fitted.uncertain
    found = _read_off(grid_s, answer(grid_s, model))
    rise_doubt, over_doubt = uncertain(_figure(grid_s, "rise_s")), uncertain(_figure(grid_s, "overshoot_percent"))
    rise, over = _off(found.rise_s, measured.rise_s), _off(found.overshoot_percent, measured.overshoot_percent)
    if rise is None or rise > max(_SAME_RISE * (measured.rise_s or 0.0), rise_doubt or 0.0):
        return None
    if over is not None and over > max(_SAME_OVERSHOOT, over_doubt or 0.0):
        return None
    damping_doubt = uncertain(lambda one: one.damping)
    knows_rise = found.rise_s is not None and rise_doubt is not None and rise_doubt <= _MOST_DOUBT * found.rise_s
    knows_damping = damping_doubt is not None and damping_doubt <= _MOST_DOUBT * model.damping
    return ReportModel(
        rise_s=found.rise_s if knows_rise else None,
        rise_doubt_s=rise_doubt if knows_rise else None,
        overshoot_percent=found.overshoot_percent,
        overshoot_doubt_percent=None if found.overshoot_percent is None else over_doubt,
        damping=model.damping if knows_damping else None,
        damping_doubt=damping_doubt if knows_damping else None,
        frequency_rad_s=model.frequency_rad_s if knows_damping else None,
        off=fitted.left**0.5 * size,
    )


def _off(one: float | None, other: float | None) -> float | None:
    return None if one is None or other is None else abs(one - other)


def _fitting(t_s: Array, share: Array) -> Fit | None:
    """The model; None where none explains the samples or they end before it shows its final value."""
    found = fit(t_s, share)
    if found is None:
        return None
    model = found.model
    reaches = abs(float(answer(t_s[-1:], model)[0]) - model.final) < _NEARLY * abs(model.final - model.begin)
    is_good = found.left <= (1.0 - _GOOD_FIT) * found.variance and found.left**0.5 <= _GOOD_REST * max(1.0, model.final)
    return found if is_good and reaches and 0.02 < model.damping < 8.0 and model.final > model.begin else None


def _figure(t_s: Array, name: str) -> Callable[[Model], float | None]:
    """One of the figures as a model gives it."""

    def figure(model: Model) -> float | None:
        found: float | None = getattr(_read_off(t_s, answer(t_s, model)), name)
        return found

    return figure


def _smoothed(t_s: Array, share: Array) -> tuple[Array, Array]:
    """Evenly spaced, each point from a parabola through its neighbours, which keeps the height of a peak."""
    count = min(2000, len(t_s))
    grid_s = np.linspace(float(t_s[0]), float(t_s[-1]), count)
    even = np.interp(grid_s, t_s, share)
    rise = np.flatnonzero(even >= 0.8)
    half = int(np.clip((int(rise[0]) if len(rise) else count // 4) // 6, 1, max(1, count // 10)))
    place = np.arange(-half, half + 1)
    kernel = np.linalg.pinv(np.stack([np.ones_like(place), place, place**2], axis=1))[0]
    padded = np.concatenate((np.full(half, even[0]), even, np.full(half, even[-1])))
    return grid_s, np.convolve(padded, kernel[::-1], mode="valid")
