"""How a loop answered a step of its target: rise time, overshoot, settling, steady error and damping.

A second-order model (final value, natural frequency, damping ratio, dead time) is fitted to the samples, with large
deviations weighted down, so that neither noise nor a gust is taken for an overshoot. Where the answer is not of second
order (limits, cut short), the figures are read off the smoothed samples instead, and damping only from the overshoot.
"""

from __future__ import annotations

from typing import Final, Literal, NamedTuple

import numpy as np

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
_MOST_FITTED: Final = 900
# How much a dead time as long as the rise must improve the fit, in deviations of the noise.
_DOUBT: Final = 4.0
_ROUNDS: Final = 60
# Below this a peak cannot be told from noise, and the damping ratio not from its overshoot.
_LEAST_PEAK: Final = 0.02


class Response(NamedTuple):
    """Times in s from the step; `final`, `steady_error` and `peak` in the signal's unit. None: cannot be told.

    `rise_from_s` and `rise_to_s` are when 10 and 90 % of the change were reached.
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


class _Model(NamedTuple):
    final: float
    frequency_rad_s: float
    damping: float
    delay_s: float


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
    model = _fit(t_s, share)
    method: Method
    if model is not None:
        grid_s = np.linspace(0.0, float(t_s[-1]), 4000)
        # Peak and settling lie on the model's own course, also where the next manoeuvre cut them off.
        course, final, method = _answer(grid_s, model), model.final, "model"
    else:
        grid_s, course = _smoothed(t_s, share)
        last, before = (course[(grid_s >= a * grid_s[-1]) & (grid_s <= b * grid_s[-1])] for a, b in _ENDS)
        if abs(float(np.mean(last)) - float(np.mean(before))) > SETTLED:
            return Response("none")
        final, method = float(np.mean(np.concatenate((before, last)))), "measured"
    if final < _LEAST_REACHED:
        return Response("none")
    found = _read_off(grid_s, course / final)
    overshoot = found.overshoot_percent
    damping = None if model is None else model.damping
    if model is None and overshoot is not None and overshoot > 100 * _LEAST_PEAK and found.settling_s is not None:
        log = np.log(overshoot / 100.0)
        damping = float(-log / np.sqrt(np.pi**2 + log**2))
    return found._replace(
        method=method,
        final=start + final * size,
        peak=None if found.peak is None else start + found.peak * final * size,
        steady_error=(1.0 - final) * size if found.settling_s is not None else None,
        damping=damping,
        frequency_rad_s=None if model is None else model.frequency_rad_s,
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


def _answer(t_s: Array, model: _Model) -> Array:
    """The unit step answer of the model, times its final value."""
    since_s = np.maximum(t_s - model.delay_s, 0.0)
    damping = model.damping if abs(model.damping - 1.0) > 1e-4 else 1.0 + 1e-4
    root = np.sqrt(complex(damping * damping - 1.0))
    fast, slow = (-model.frequency_rad_s * (damping + root), -model.frequency_rad_s * (damping - root))
    course = 1.0 + (fast * np.exp(slow * since_s) - slow * np.exp(fast * since_s)) / (slow - fast)
    return np.asarray(model.final * course.real, dtype=np.float64)


def _fit(t_s: Array, share: Array) -> _Model | None:
    """The model that fits best; None where none explains the samples or they end before it shows its final value."""
    step = max(1, len(t_s) // _MOST_FITTED)
    t_s, share = t_s[::step], share[::step]
    span_s = float(t_s[-1])
    half = np.flatnonzero(share >= 0.5 * float(np.mean(share[3 * len(share) // 4 :])))
    half_s = max(float(t_s[half[0]]) if len(half) else span_s / 2, span_s / 200)
    longest_s = min(span_s / 3, 5.0)
    doubt = _DOUBT / half_s
    best: tuple[float, Array] | None = None
    for damping in (0.25, 0.7, 1.3):
        begin = np.array([1.0, np.log((1.0 + 0.7 * damping) / half_s), np.log(damping), 0.02 * half_s])
        found = _least_squares(t_s, share, begin, longest_s, doubt)
        if best is None or found[0] < best[0]:
            best = found
    if best is None:
        return None
    model = _of(best[1], longest_s)
    rest = share - _answer(t_s, model)
    variance = float(np.var(share))
    left = float(np.var(rest))
    # Where it is still on its way, its final value is a guess.
    reaches = abs(float(_answer(t_s[-1:], model)[0]) - model.final) < _NEARLY * abs(model.final)
    is_good = left <= (1.0 - _GOOD_FIT) * variance and left**0.5 <= _GOOD_REST * max(1.0, abs(model.final))
    return model if is_good and reaches and 0.02 < model.damping < 8.0 and model.final > 0 else None


def _least_squares(t_s: Array, share: Array, begin: Array, longest_s: float, doubt: float) -> tuple[float, Array]:
    """Levenberg and Marquardt's method with Huber's weights: the cost and the parameters."""
    at, trust = begin.copy(), 1e-2
    rest = share - _answer(t_s, _of(at, longest_s))
    weights = _weights(rest)
    price = _price(rest, doubt)
    cost = float(np.sum(weights * rest**2)) + price * at[3] ** 2
    for _ in range(_ROUNDS):
        slopes = np.empty((len(t_s), len(at)))
        for place in range(len(at)):
            moved = at.copy()
            moved[place] += 1e-5
            slopes[:, place] = (share - _answer(t_s, _of(moved, longest_s)) - rest) / 1e-5
        normal = slopes.T @ (weights[:, None] * slopes)
        towards = slopes.T @ (weights * rest)
        normal[3, 3] += price
        towards[3] += price * at[3]
        change = np.linalg.lstsq(normal + trust * (np.diag(np.diag(normal)) + 1e-9 * np.eye(len(at))), -towards)[0]
        tried = np.clip(at + np.clip(change, -1.0, 1.0), [0.05, -6.0, -4.0, -longest_s], [5.0, 5.0, 2.2, longest_s])
        tried_rest = share - _answer(t_s, _of(tried, longest_s))
        tried_cost = float(np.sum(weights * tried_rest**2)) + price * tried[3] ** 2
        if tried_cost < cost:
            is_over = cost - tried_cost < 1e-9 * cost
            at, rest, trust = tried, tried_rest, max(trust / 5, 1e-9)
            weights = _weights(rest)
            price = _price(rest, doubt)
            cost = float(np.sum(weights * rest**2)) + price * at[3] ** 2
            if is_over:
                break
        else:
            trust *= 6
            if trust > 1e8:
                break
    return float(np.mean(np.minimum(rest**2, 4 * np.median(rest**2) + 1e-12))), at


def _of(at: Array, longest_s: float) -> _Model:
    return _Model(float(at[0]), float(np.exp(at[1])), float(np.exp(at[2])), float(np.clip(at[3], 0.0, longest_s)))


def _price(rest: Array, doubt: float) -> float:
    """What a dead time costs: noise looks like one, so without a reason there is none."""
    return doubt**2 * float(np.median(rest**2)) * len(rest)


def _weights(rest: Array) -> Array:
    """1 for what is near, less for what deviates by more than noise does."""
    scale = 1.345 * 1.4826 * float(np.median(np.abs(rest))) + 1e-9
    return np.asarray(np.minimum(1.0, scale / np.maximum(np.abs(rest), 1e-12)))


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
