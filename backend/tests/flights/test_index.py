"""What the library is told of a recording that the station repaired when it started."""

from __future__ import annotations

from pathlib import Path

from epf_gcs.flight.recording.repair import repair
from epf_gcs.flights.index import run as index
from epf_gcs.recordings.flight_summary import FlightSummary, read_summary
from epf_gcs.recordings.places import Places, stamp_of
from tests.flights.flown_flights import FLIGHT, quiet, recording


def summary_of(data_dir: Path, content: bytes) -> FlightSummary:
    """What is found in this recording after the repair at the start."""
    places = Places(data_dir)
    path = places.recording(FLIGHT)
    path.parent.mkdir(parents=True)
    path.write_bytes(content)
    repair(path)
    index([str(path)], quiet)
    found = read_summary(places.made()[FLIGHT], stamp_of(path))
    assert found is not None
    return found


def test_a_recording_whose_end_was_cut_off_says_so(tmp_path: Path) -> None:
    whole = recording(2.0)
    torn = whole[: len(whole) * 3 // 4]
    damage = summary_of(tmp_path / "torn", torn).damage
    assert damage is not None
    assert "bytes were incomplete and were cut off" in damage
    assert summary_of(tmp_path / "whole", whole).damage is None
