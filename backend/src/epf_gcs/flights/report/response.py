"""How a loop answered a step of its target: rise time, overshoot, settling, steady error and damping.

Where a second-order model explains the samples (`fitting.py`), the figures are the model's, each with how far it may
be off: neither noise nor a gust is taken for an overshoot. Where the answer is of another kind or cut short, they are
read off the smoothed samples instead, and damping, which is a word of the model, is not told.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Final, Literal, NamedTuple

import numpy as np

from epf_gcs.flights.report.fitting import Fit, Model, answer, fit
from epf_gcs.flights.signals import Array

Method = Literal["model", "measured", "none"]

SETTLED: Final = 0.05
"""The band around the final value, as a share of the change reached, in which the answer counts as settled."""
_LEAST_SAMPLES: Final = 12
# The model explains the samples: share of their variance, and of the step's size what is left (root mean square).
_GOOD_FIT: Final = 0.97
_GOOD_REST: Final = 0.05
# With less of the step reached there is nothing to judge.
_LEAST_REACHED: Final = 0.3
# The last and the one but last eighth of the samples: while they differ by more than the band, it is on its way.
_ENDS: Final = ((0.875, 1.0), (0.75, 0.875))
_NEARLY: Final = 0.25
# A figure that may be off by more, as a share of itself, is not told.
_MOST_DOUBT: Final = 0.25


class Response(NamedTuple):
    """Times in s from the step; `final`, `steady_error` and `peak` in the signal's unit. None: cannot be told.

    `rise_from_s` and `rise_to_s` are when 10 and 90 % of the change were reached. A figure lies within its doubt of the
    true one in 95 of 100 cases; without a model no doubt is known.
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
    damping: float | None = None
    frequency_rad_s: float | None = None
    rise_doubt_s: float | None = None
    overshoot_doubt_percent: float | None = None
    steady_doubt: float | None = None
    damping_doubt: float | None = None


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
    fitted = _model_of(t_s, share)
    method: Method
    if fitted is not None:
        grid_s = np.linspace(0.0, float(t_s[-1]), 4000)
        # Peak and settling lie on the model's own course, also where the next manoeuvre cut them off.
        begin, final, method = fitted.model.begin, fitted.model.final, "model"
        course = answer(grid_s, fitted.model)
    else:
        grid_s, course = _smoothed(t_s, share)
        last, before = (course[(grid_s >= a * grid_s[-1]) & (grid_s <= b * grid_s[-1])] for a, b in _ENDS)
        if abs(float(np.mean(last)) - float(np.mean(before))) > SETTLED:
            return Response("none")
        begin, final, method = 0.0, float(np.mean(np.concatenate((before, last)))), "measured"
    if final - begin < _LEAST_REACHED:
        return Response("none")
    found = _read_off(grid_s, (course - begin) / (final - begin))
    found = found._replace(
        method=method,
        final=start + final * size,
        peak=None if found.peak is None else start + (begin + found.peak * (final - begin)) * size,
        steady_error=(1.0 - final) * size if found.settling_s is not None else None,
    )
    return found if fitted is None else _with_doubt(found, fitted, grid_s, size)


def _with_doubt(found: Response, fitted: Fit, grid_s: Array, size: float) -> Response:
    """With what the model tells, and how far each figure may be off; those that are hardly known are left out."""
    model, uncertain = fitted.model, fitted.uncertain
    rise, damping = uncertain(_figure(grid_s, "rise_s")), uncertain(lambda one: one.damping)
    overshoot = uncertain(_figure(grid_s, "overshoot_percent"))
    steady = uncertain(lambda one: one.final)
    knows_rise = found.rise_s is not None and rise is not None and rise <= _MOST_DOUBT * found.rise_s
    knows_damping = damping is not None and damping <= _MOST_DOUBT * model.damping
    return found._replace(
        rise_s=found.rise_s if knows_rise else None,
        rise_doubt_s=rise if knows_rise else None,
        damping=model.damping if knows_damping else None,
        damping_doubt=damping if knows_damping else None,
        frequency_rad_s=model.frequency_rad_s if knows_damping else None,
        overshoot_doubt_percent=None if found.overshoot_percent is None else overshoot,
        steady_doubt=None if found.steady_error is None or steady is None else steady * abs(size),
    )


def _read_off(t_s: Array, share: Array) -> Response:
    """Figures of a smooth course whose final value is 1."""
    rise_from_s, rise_to_s = _first(t_s, share, 0.1), _first(t_s, share, 0.9)
    top = int(np.argmax(share))
    over = float(share[top]) - 1.0
    outside = np.flatnonzero(np.abs(share - 1.0) > SETTLED)
    settled = None
    if not len(outside):
        settled = 0.0
    elif outside[-1] + 1 < len(t_s) and t_s[-1] - t_s[outside[-1]] > 0.05 * t_s[-1]:
        settled = float(t_s[outside[-1] + 1])
    has_peak = over > 1e-4 and top < len(t_s) - 1
    return Response(
        "none",
        rise_s=None if rise_from_s is None or rise_to_s is None else rise_to_s - rise_from_s,
        rise_from_s=rise_from_s,
        rise_to_s=rise_to_s,
        overshoot_percent=None if rise_to_s is None else 100.0 * over if has_peak else 0.0,
        peak=float(share[top]) if has_peak else None,
        peak_s=float(t_s[top]) if has_peak else None,
        settling_s=settled,
    )


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


def _model_of(t_s: Array, share: Array) -> Fit | None:
    """The model; None where none explains the samples or they end before it shows its final value."""
    found = fit(t_s, share)
    if found is None:
        return None
    model = found.model
    # Where it is still on its way, its final value is a guess.
    reaches = abs(float(answer(t_s[-1:], model)[0]) - model.final) < _NEARLY * abs(model.final)
    is_good = found.left <= (1.0 - _GOOD_FIT) * found.variance and found.left**0.5 <= _GOOD_REST * max(1.0, model.final)
    return found if is_good and reaches and 0.02 < model.damping < 8.0 and model.final > model.begin else None


def _figure(t_s: Array, name: str) -> Callable[[Model], float | None]:
    """One of the figures as a model gives it."""

    def figure(model: Model) -> float | None:
        course = (answer(t_s, model) - model.begin) / (model.final - model.begin)
        found: float | None = getattr(_read_off(t_s, course), name)
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
