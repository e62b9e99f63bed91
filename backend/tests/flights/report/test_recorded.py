"""Reports of recordings that went through the index: names and values are those of the wire."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from epf_gcs.codec.encode import encode_telemetry
from epf_gcs.codec.messages_gen import TELEMETRY
from epf_gcs.flights import answers
from epf_gcs.flights.events import find_events
from epf_gcs.flights.export.flown import WHERE
from epf_gcs.flights.fields import fields_of
from epf_gcs.flights.flight_data import PeriodCache, Samples, read_field
from epf_gcs.flights.report.making import make, report
from epf_gcs.flights.summary import summarise
from epf_gcs.recordings.flight_summary import FlightSummary
from epf_gcs.recordings.places import Places
from tests.flights.flown_flights import indexed, recording
from tests.flights.report.made import near
from tests.flights.test_events import MadeFlight


def battery(at_s: float) -> bytes:
    """One that loses 1 V in 100 s."""
    values = dict.fromkeys(fields_of("analog"), 400.0) | {"battery_v": 12.6 - at_s / 100.0}
    return encode_telemetry("analog", *values.values())


def test_the_battery_of_a_real_recording_is_in_its_report(tmp_path: Path) -> None:
    path = indexed(tmp_path, recording(120.0, board=battery))
    found = make(path, Places(tmp_path).made_of(path.stem))
    assert found.battery is not None
    assert found.battery.begin_v == near(12.55, abs=0.01)
    assert found.battery.end_v == near(11.45, abs=0.01)
    assert "battery" not in found.unknown


class FlightWitness(MadeFlight):
    """Has two samples of everything, and keeps what it was asked for."""

    def __init__(self) -> None:
        t_s = np.arange(2.0)
        every = [message.name for message in TELEMETRY.values() if message.topic]
        super().__init__(
            {topic: (t_s, dict.fromkeys(fields_of(topic), t_s)) for topic in (*every, "simulator", "xplane_info")}
        )
        self.asked: set[tuple[str, str]] = set()

    def samples(self, topic: str, field: str) -> Samples:
        self.asked.add((topic, field))
        return super().samples(topic, field)


@pytest.mark.parametrize(
    "ask",
    [
        lambda flight: report("a", flight, FlightSummary(0, 1), [], np.empty(0), np.empty(0)),
        lambda flight: find_events(flight, [], []),
        lambda flight: summarise(flight, []),
        lambda flight: answers.overview(flight, PeriodCache(), 10),
    ],
)
def test_every_signal_that_is_read_is_one_of_the_definition(ask: Callable[[FlightWitness], object]) -> None:
    flight = FlightWitness()
    ask(flight)
    assert len(flight.asked) > 2
    assert all(field in fields_of(topic) for topic, field in flight.asked)


def test_every_signal_of_a_track_is_one_of_the_definition() -> None:
    for where in WHERE.values():
        assert set(where.place) <= set(fields_of(where.topic))
        assert set(where.attitude) <= set(fields_of(where.attitude_topic))


def test_a_signal_that_no_flight_can_have_is_a_fault_of_the_caller() -> None:
    with pytest.raises(KeyError):
        read_field(MadeFlight({}), "analog", "battery_V")
    assert not len(read_field(MadeFlight({}), "analog", "battery_v").t_s)
