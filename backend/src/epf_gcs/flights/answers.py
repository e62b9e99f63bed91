"""What is asked of one flight: signals, topics, events, overview, track, and what was known at a moment.

Every function gives what the interface sends. Times are seconds since the flight's start.
"""

from __future__ import annotations

from typing import Final

import numpy as np
import pyarrow as pa

from epf_gcs.contract.flights import FlightOverview, FlightTopic, FlightTopics, Signal, Signals, TopicField
from epf_gcs.contract.own_gains import OwnGains
from epf_gcs.flights.derived import find
from epf_gcs.flights.flight_data import FlightData, PeriodCache
from epf_gcs.flights.flown_path import moved_rows, track_rows
from epf_gcs.flights.signals import Array, gaps_of, thin
from epf_gcs.formats.track_points import points_header
from epf_gcs.recordings import notes
from epf_gcs.recordings.notes import Content
from epf_gcs.units import M_PER_FT
from epf_gcs.vehicle.noted import gains_of, identity_of, own_gains_event
from epf_gcs.vehicle.own_gains import own_gains_after

_NS: Final = 1e-9
# Altitudes for the ground of the time bar, the one that fits best first, with the factor to feet.
_ALTITUDES: Final = (
    ("simulator", "altitude_msl_ft", 1.0),
    ("gps", "altitude_m", 1 / M_PER_FT),
    ("analog", "altitude_m", 1 / M_PER_FT),
)
_POINT: Final = np.dtype([("t_ms", "<u4"), ("latitude_e7", "<i4"), ("longitude_e7", "<i4"), ("altitude_mm", "<i4")])
_MOST_POINTS: Final = 720_000


def duration_s(flight: FlightData) -> float:
    """From the first message to the last."""
    return max(0.0, (flight.end_ns - flight.start_ns) * _NS)


def signals(
    flight: FlightData, periods: PeriodCache, names: list[str], from_s: float | None, to_s: float | None, points: int
) -> Signals:
    """The stretch and its signals, each thinned to about `points` steps. Raises NotFoundError, InvalidInputError.

    A signal that this flight does not have is empty; one that the definition does not have is not found.
    """
    whole_s = duration_s(flight)
    first_s = min(max(0.0, from_s or 0.0), whole_s)
    last_s = whole_s if to_s is None else min(max(first_s, to_s), whole_s)
    found = []
    for name in names:
        signal = find(flight, periods, name)
        thinned = thin(signal.t_s, signal.values, first_s, last_s, points, signal.period_s)
        found.append(
            Signal(
                name=name,
                unit=signal.unit,
                at_s=np.round(thinned.at_s, 6).tolist(),
                min=thinned.low.tolist(),
                max=thinned.high.tolist(),
                mean=thinned.mean,
                count=thinned.known,
            )
        )
    return Signals(flight.start_ns * _NS, first_s, last_s, found)


def as_arrow(found: Signals) -> bytes:
    """The same as an Arrow stream: one record batch for each signal, with its name in every row."""
    schema = pa.schema(
        [
            ("name", pa.dictionary(pa.int16(), pa.string())),
            ("at_s", pa.float64()),
            ("min", pa.float64()),
            ("max", pa.float64()),
        ]
    )
    names = [one.name for one in found.signals]
    sink = pa.BufferOutputStream()
    with pa.ipc.new_stream(sink, schema) as writer:
        for place, one in enumerate(found.signals):
            codes = pa.array(np.full(len(one.at_s), place, dtype=np.int16))
            named = pa.DictionaryArray.from_arrays(codes, pa.array(names, pa.string()))
            values = [pa.array(column, pa.float64(), from_pandas=True) for column in (one.at_s, one.min, one.max)]
            writer.write_batch(pa.record_batch([named, *values], schema=schema))
    return bytes(sink.getvalue())


def topics(flight: FlightData) -> FlightTopics:
    """The topics that have samples, with their fields."""
    return FlightTopics(
        [
            FlightTopic(
                name=span.name,
                count=span.samples,
                first_s=(span.first_ns - flight.start_ns) * _NS,
                last_s=(span.last_ns - flight.start_ns) * _NS,
                fields=[
                    TopicField(name, meaning.unit, meaning.kind) for name, meaning in flight.fields(span.name).items()
                ],
            )
            for span in flight.topics()
        ]
    )


def overview(flight: FlightData, periods: PeriodCache, points: int) -> FlightOverview:
    """The altitude in `points` even steps, and the stretches without any data."""
    whole_s = duration_s(flight)
    there = {span.name: span for span in flight.topics()}
    best = next((one for one in _ALTITUDES if one[0] in there and _has_values(flight, one[0], one[1])), None)
    altitude_ft: list[float | None] = [None] * points
    if best is not None:
        topic, field, factor = best
        t_s, values = flight.samples(topic, field)
        altitude_ft = _means(t_s, values * factor, whole_s, points)
    signal = None if best is None else f"{best[0]}.{best[1]}"
    return FlightOverview(whole_s, signal, altitude_ft, silence(flight, periods))


def silence(flight: FlightData, periods: PeriodCache) -> list[list[float]]:
    """The stretches in which no topic has a sample, other than those that come only on request."""
    busy: list[tuple[float, float]] = []
    for span in flight.topics():
        field = next((name for name, meaning in flight.fields(span.name).items() if meaning.kind != "text"), None)
        if field is None:
            continue
        t_s = flight.samples(span.name, field).t_s
        period_s = periods.of(span.name, t_s)
        if period_s is None:
            continue
        begin = float(t_s[0])
        for before, after in gaps_of(t_s, period_s):
            busy.append((begin, before))
            begin = after
        busy.append((begin, float(t_s[-1])))
    return _between(sorted(busy), duration_s(flight))


def track(flight: FlightData, source: str, most_points: int | None) -> bytes:
    """The flown track as the page's globe reads it: header and points of `formats.track_points`."""
    rows = moved_rows(track_rows(flight, source))
    step = max(1, -(-len(rows) // min(most_points or _MOST_POINTS, _MOST_POINTS)))
    points = np.zeros(-(-len(rows) // step), dtype=_POINT)
    t_s, latitude_deg, longitude_deg, altitude_m = rows[::step].T
    points["t_ms"] = np.clip(np.round(t_s * 1e3), 0, 0xFFFFFFFF)
    points["latitude_e7"] = np.round(latitude_deg * 1e7)
    points["longitude_e7"] = np.round(longitude_deg * 1e7)
    points["altitude_mm"] = np.clip(np.round(altitude_m * 1e3), -0x7FFFFFFF, 0x7FFFFFFF)
    total = len(points)
    return points_header(epoch=0, first=0, count=total, total=total, t0_s=flight.start_ns * _NS) + points.tobytes()


def known(flight: FlightData, at_s: float) -> Content:
    """Identity, gains and plans as they were known at a moment: the newest note of each kind before it."""
    until_ns = flight.start_ns + round(at_s * 1e9)
    newest: dict[str, Content] = {}
    own: OwnGains | None = None
    for note in flight.notes():
        if note.t_ns <= until_ns and isinstance(note.content, dict):
            event = own_gains_event(note)
            own = own if event is None else own_gains_after(own, event)
            newest[note.name if note.name != notes.PLAN else f"{notes.PLAN} {note.content.get('plan')}"] = note.content
    parameters = newest.get(notes.PARAMETERS)
    return {
        "at_s": at_s,
        "identity": identity_of(newest.get(notes.IDENTITY)),
        "parameters": None if parameters is None else gains_of(parameters),
        "own": own,
        "missions": {plan: newest.get(f"{notes.PLAN} {plan}") for plan in ("flight", "hil")},
    }


def _has_values(flight: FlightData, topic: str, field: str) -> bool:
    return bool(np.isfinite(flight.samples(topic, field).values).any())


def _means(t_s: Array, values: Array, whole_s: float, points: int) -> list[float | None]:
    known_values = np.isfinite(values)
    places = np.clip((t_s[known_values] / max(whole_s, 1e-9) * points).astype(np.int64), 0, points - 1)
    sums = np.bincount(places, weights=values[known_values], minlength=points)
    counts = np.bincount(places, minlength=points)
    return [
        round(total / count, 1) if count else None for total, count in zip(sums.tolist(), counts.tolist(), strict=True)
    ]


def _between(busy: list[tuple[float, float]], whole_s: float) -> list[list[float]]:
    """The stretches of [0, whole_s] that none of these, in order, covers."""
    found, reached = [], 0.0
    for begin, end in busy:
        if begin > reached + 1.0:
            found.append([reached, begin])
        reached = max(reached, end)
    if busy and whole_s > reached + 1.0:
        found.append([reached, whole_s])
    return found
