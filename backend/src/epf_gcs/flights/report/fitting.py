"""Fits a second-order model with dead time and a limit of rate to a step's answer, and says how sure each figure is.

Gusts last for seconds, so neighbouring samples err together: a plain fit takes them for dynamics, and thinks itself
far too sure. After a first, robust fit what is left tells how long the disturbances last and how large they are; the
second fit weighs the samples by that.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Final, NamedTuple

import numpy as np

from epf_gcs.flights.signals import Array

# Samples are joined to at most so many means.
_MOST_FITTED: Final = 240
_ROUNDS: Final = 40
_ENOUGH: Final = 1e-5
# How much a dead time as long as the rise must improve the first fit, in deviations of the noise.
_DOUBT: Final = 4.0
# How far the signal at the step may be from where it was taken to begin, as a share of the step.
_BEGIN_DOUBT: Final = 0.3
# How long gusts last: turbulence is some 50 to 200 m long, and passes at 20 to 50 m/s.
_LASTS_S: Final = (1.0, 2.0, 4.0)
# A limit of rate must explain this much more, in units of the log likelihood, to be believed.
_LIMIT_GAIN: Final = 4.0
# Of the unit answer's: each second, against the natural frequency. Above, it never bites.
_RATES: Final = (0.25,)
_LOWEST: Final = np.array([-1.0, 0.05, -6.0, -4.0, 0.0, -4.0])
_HIGHEST: Final = np.array([1.0, 5.0, 5.0, 2.2, 5.0, 0.0])
_FREE: Final = 0.0
_CONFIDENCE: Final = 1.96


class Model(NamedTuple):
    """The answer runs from `begin` to `final` (shares of the step). `rate` is the most that the unit answer moves in
    1 / `frequency_rad_s`; 1 and above: never limited."""

    begin: float
    final: float
    frequency_rad_s: float
    damping: float
    delay_s: float
    rate: float


class Fit(NamedTuple):
    """The best model, what is left of the samples' means, and `uncertain`: the half width of the interval in which a
    figure of the model lies in 95 of 100 cases."""

    model: Model
    variance: float
    left: float
    uncertain: Callable[[Callable[[Model], float | None]], float | None]


def answer(t_s: Array, model: Model) -> Array:
    """The model's course at these times (s from the step on)."""
    since = np.maximum(t_s - model.delay_s, 0.0) * model.frequency_rad_s
    return model.begin + (model.final - model.begin) * _unit(since, model.damping, model.rate)


def fit(t_s: Array, share: Array) -> Fit | None:
    """The model that fits best; None with too few samples."""
    t_s, share = _means(t_s, share)
    if len(t_s) < 12:
        return None
    span_s = float(t_s[-1])
    half = np.flatnonzero(share >= 0.5 * float(np.mean(share[3 * len(share) // 4 :])))
    half_s = max(float(t_s[half[0]]) if len(half) else span_s / 2, span_s / 200)
    begins = [
        np.array([0.0, 1.0, np.log((1.0 + 0.7 * damping) / half_s), np.log(damping), 0.02 * half_s, _FREE])
        for damping in (0.25, 0.7, 1.3)
    ]
    rough = min((_Search(t_s, share, None, half_s).run(at, limits=False) for at in begins), key=lambda one: one[0])[1]
    whitener = _whitener(t_s, share - answer(t_s, _model(rough)))
    search = _Search(t_s, share, whitener, half_s)
    best = search.run(rough, limits=False)
    for rate in _RATES:
        begin = best[1].copy()
        begin[5] = np.log(rate)
        limited = search.run(begin, limits=True)
        if limited[0] < best[0] - 2.0 * _LIMIT_GAIN and limited[1][5] < -0.05:
            best = limited
    at = best[1]
    model = _model(at)
    rest = share - answer(t_s, model)
    return Fit(model, float(np.var(share)), float(np.var(rest)), search.uncertainty(at))


class _Search:
    """Levenberg and Marquardt's method with Huber's weights; parameters as in `_model`."""

    def __init__(self, t_s: Array, share: Array, whitener: Array | None, half_s: float) -> None:
        self._t_s = t_s
        self._share = share
        self._whitener = whitener
        self._half_s = half_s

    def run(self, begin: Array, *, limits: bool) -> tuple[float, Array]:
        """The cost and the parameters."""
        at, trust = begin.copy(), 1e-2
        free = np.arange(6 if limits else 5)
        rest = self._rest(at)
        cost, weights, prior = self._cost(rest, at)
        for _ in range(_ROUNDS):
            slopes = self._slopes(at, rest, free)
            normal = slopes.T @ (weights[:, None] * slopes) + np.diag(prior[free])
            towards = slopes.T @ (weights * rest) + prior[free] * at[free]
            damped = normal + trust * (np.diag(np.diag(normal)) + 1e-9 * np.eye(len(free)))
            tried = at.copy()
            tried[free] += np.clip(np.linalg.solve(damped, -towards), -1.0, 1.0)
            tried = np.clip(tried, _LOWEST, _HIGHEST)
            tried_rest = self._rest(tried)
            tried_cost, tried_weights, tried_prior = self._cost(tried_rest, tried)
            if tried_cost < cost:
                is_over = cost - tried_cost < _ENOUGH * cost
                at, rest, cost, weights, prior = tried, tried_rest, tried_cost, tried_weights, tried_prior
                trust = max(trust / 5, 1e-9)
                if is_over:
                    break
            else:
                trust *= 6
                if trust > 1e6:
                    break
        return cost, at

    def uncertainty(self, at: Array) -> Callable[[Callable[[Model], float | None]], float | None]:
        """How far figures of the model at these parameters may be off."""
        free = np.arange(6 if at[5] < -0.05 else 5)
        rest = self._rest(at)
        _, weights, prior = self._cost(rest, at)
        slopes = self._slopes(at, rest, free)
        spread = max(1.0, float(np.mean(weights * rest**2)))
        covariance = np.linalg.pinv(slopes.T @ slopes / spread + np.diag(prior[free]))

        def uncertain(figure: Callable[[Model], float | None]) -> float | None:
            here = figure(_model(at))
            if here is None:
                return None
            gradient = np.zeros(len(free))
            for place in free:
                moved = at.copy()
                step = 1e-3 if at[place] + 1e-3 <= _HIGHEST[place] else -1e-3
                moved[place] += step
                there = figure(_model(moved))
                if there is None:
                    return None
                gradient[place] = (there - here) / step
            return float(_CONFIDENCE * np.sqrt(max(0.0, float(gradient @ covariance @ gradient))))

        return uncertain

    def _rest(self, at: Array) -> Array:
        rest = self._share - answer(self._t_s, _model(at))
        return rest if self._whitener is None else self._whitener @ rest

    def _slopes(self, at: Array, rest: Array, free: Any) -> Array:
        slopes = np.empty((len(rest), len(free)))
        for place in free:
            moved = at.copy()
            step = 1e-5 if at[place] + 1e-5 <= _HIGHEST[place] else -1e-5
            moved[place] += step
            slopes[:, place] = (self._rest(moved) - rest) / step
        return slopes

    def _cost(self, rest: Array, at: Array) -> tuple[float, Array, Array]:
        """The cost, the samples' weights and what each parameter costs, squared, that is not at its usual place."""
        prior = np.zeros(6)
        if self._whitener is None:
            prior[0] = 1e6
            prior[4] = (_DOUBT / self._half_s) ** 2 * float(np.median(rest**2)) * len(rest)
            scale = 1.345 * 1.4826 * float(np.median(np.abs(rest))) + 1e-9
        else:
            prior[0] = 1.0 / _BEGIN_DOUBT**2
            prior[4] = 1.0 / self._half_s**2
            scale = 3.0
        weights = np.minimum(1.0, scale / np.maximum(np.abs(rest), 1e-12))
        return float(np.sum(weights * rest**2) + np.sum(prior * at**2)), weights, prior


def _model(at: Array) -> Model:
    return Model(
        float(at[0]), float(at[1]), float(np.exp(at[2])), float(np.exp(at[3])), float(at[4]), float(np.exp(at[5]))
    )


def _unit(since: Array, damping: float, rate: float) -> Array:
    """The unit step answer at times in 1 / natural frequency, nowhere faster than `rate`."""
    course = _swing(since, damping, -1.0, 0.0) + 1.0
    if rate >= 1.0:
        return course
    # From when the limit is reached it moves at it, until the loop itself would go slower.
    fine = np.linspace(0.0, 4.0, 401)
    speed = np.gradient(_swing(fine, damping, -1.0, 0.0), fine)
    fast = np.flatnonzero(speed > rate)
    if not len(fast):
        return course
    begin = float(fine[fast[0]])
    place = float(_swing(np.array([begin]), damping, -1.0, 0.0)[0]) + 1.0
    slows = 1.0 - 2.0 * damping * rate
    if slows <= place:
        return course
    end = begin + (slows - place) / rate
    rest = _swing(np.maximum(since - end, 0.0), damping, slows - 1.0, rate) + 1.0
    return np.where(since < begin, course, np.where(since < end, place + rate * (since - begin), rest))


def _swing(since: Array, damping: float, place: float, speed: float) -> Array:
    """How a second-order system of natural frequency 1 comes to rest at 0 from this place and speed."""
    damping = damping if abs(damping - 1.0) > 1e-4 else 1.0 + 1e-4
    root = np.sqrt(complex(damping * damping - 1.0))
    one, two = -damping + root, -damping - root
    first = (speed - two * place) / (one - two)
    found = first * np.exp(one * since) + (place - first) * np.exp(two * since)
    return np.asarray(found.real, dtype=np.float64)


def _means(t_s: Array, share: Array) -> tuple[Array, Array]:
    """Means of neighbouring samples, at most so many as can be weighed against each other."""
    step = -(-len(t_s) // _MOST_FITTED)
    whole = len(t_s) // step * step
    return t_s[:whole].reshape(-1, step).mean(axis=1), share[:whole].reshape(-1, step).mean(axis=1)


def _whitener(t_s: Array, rest: Array) -> Array:
    """The matrix that makes of such disturbances noise of size 1 without memory: a part of them lasts for a time, the
    rest is the samples' own. The time is the likeliest of some."""
    rest = np.clip(rest, *(np.median(rest) + np.array([-5.0, 5.0]) * (1.4826 * np.median(np.abs(rest)) + 1e-9)))
    apart_s = np.abs(t_s[:, None] - t_s[None, :])
    each_s = float(np.median(np.diff(t_s)))
    whole = float(np.mean(rest**2)) + 1e-12
    next_to = float(np.mean(rest[1:] * rest[:-1]))
    best: tuple[float, Array] | None = None
    for lasts_s in _LASTS_S:
        lasting = min(max(next_to * np.exp(each_s / lasts_s), 0.02 * whole), 0.98 * whole)
        spread = lasting * np.exp(-apart_s / lasts_s) + (whole - lasting) * np.eye(len(rest))
        root = np.linalg.cholesky(spread)
        unlikely = 2.0 * float(np.sum(np.log(np.diag(root)))) + float(np.sum(np.linalg.solve(root, rest) ** 2))
        if best is None or unlikely < best[0]:
            best = (unlikely, root)
    return np.eye(len(rest)) if best is None else np.asarray(np.linalg.inv(best[1]), dtype=np.float64)
