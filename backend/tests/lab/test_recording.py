"""The recording of a lab flight is one of the station's: its library, its report and its replay read it."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from epf_gcs.codec.tables import Waypoint
from epf_gcs.flights.index import run as index
from epf_gcs.flights.report.making import make
from epf_gcs.lab.errors import LabError
from epf_gcs.lab.flight import Flight
from epf_gcs.lab.flying import fly_wanted
from epf_gcs.lab.recording import TAG, record
from epf_gcs.lab.refly import refly
from epf_gcs.library.about import read_about
from epf_gcs.recordings import notes
from epf_gcs.recordings.places import Places
from epf_gcs.recordings.reading import read_file
from epf_gcs.recordings.topics import SIMULATOR_RECEIVED
from epf_gcs.xplane.datagram import parse
from epf_gcs.xplane.gather import Gatherer
from tests.flights.flown_flights import quiet
from tests.recordings.files import said_by

ONE_LEG = [Waypoint(27.9380, -15.3830, 1000.0, 55.0)]


@pytest.fixture(scope="module")
def flight() -> Flight:
    return fly_wanted(ONE_LEG, {"wind_kt": 10.0, "seed": 7, "loss_percent": 5.0, "round_trip_ms": 100.0})


def test_the_station_reads_truth_plan_and_moment_from_it(flight: Flight, tmp_path: Path) -> None:
    recorded = record(flight, tmp_path, "one leg")
    path = Places(tmp_path).recording(recorded.id)
    recording = read_file(path)
    assert recording.is_whole
    assert recording.damage is None
    start_ns = int(recording.messages.t_ns[0])
    marks = [note for note in recording.notes if note.name == notes.MARK]
    assert [(note.t_ns - start_ns) / 1e9 for note in marks] == [pytest.approx(flight.moment.at_s, abs=0.001)]

    gatherer, flown = Gatherer("xp10"), []
    for channel, t_ns, data in said_by(recording):
        if channel == SIMULATOR_RECEIVED:
            info = gatherer.take(parse(data) or [], t_ns / 1e9)
            assert info is not None
            flown.append((info.latitude_deg, info.longitude_deg))
    truth = np.column_stack((flight.truth.latitude_deg, flight.truth.longitude_deg))
    np.testing.assert_allclose(np.array(flown), truth, atol=2e-6)

    about = read_about(Places(tmp_path).about(recorded.id))
    assert (about.title, about.tags) == ("one leg", [TAG])
    index([str(path)], quiet)
    report = make(path, Places(tmp_path).made_of(recorded.id))
    assert report.identity.aircraft == "rc"
    assert report.times.duration_s == pytest.approx(flight.time_s, abs=0.1)


def test_laws_that_fly_otherwise_by_now_are_told(flight: Flight, tmp_path: Path) -> None:
    other = replace(flight, gains={"k_roll": 3.0})
    with pytest.raises(LabError, match="another flight when it is flown again"):
        record(other, tmp_path)
    assert not (tmp_path / "recordings").exists()


@pytest.mark.parametrize(
    "given",
    [
        {"faults": ["gyro.drift@3+4=0.002"]},
        {"faults": ["simulator.pause@4+1"]},
        {"loop": "aircraft"},
    ],
    ids=["a fault", "a pause", "the real aircraft's loop"],
)
def test_flights_of_every_kind_are_recorded_and_those_with_a_simulator_flown_again(
    given: dict[str, Any], tmp_path: Path
) -> None:
    plan = [Waypoint(27.9360, -15.3840, 1000.0, 55.0)]
    conditions = {"loop": given.get("loop", "hil"), "seed": 7}
    flown = fly_wanted(plan, conditions, faults=given.get("faults", ()), longest_s=9.0)
    path = Places(tmp_path).recording(record(flown, tmp_path).id)
    assert read_file(path).is_whole
    if conditions["loop"] == "hil":
        found = refly(path)
        assert found.first is None, "\n".join(found.lines())
        assert found.frames > 440
