"""A recording that the station made of the real board program is flown again to the byte."""

from __future__ import annotations

from pathlib import Path

from board_tests.closed_loop.kept_flight import kept_station
from epf_gcs.lab.recorded_line import SURFACES, read_line
from epf_gcs.lab.refly import refly_line
from tests.support.waiting import eventually

_FRAMES = 300


def test_the_stations_recording_of_a_board_is_equal_to_the_byte(tmp_path: Path) -> None:
    with kept_station(tmp_path) as station:
        station.open_board()
        # The stick of a receiver is in no recording.
        station.http.post("/commands/control_source", json={"value": 1}).raise_for_status()
        for name in ("fms_hil_plan_on", "hil_load_gando", "autotrim_on", "autopilot_on"):
            station.http.post(f"/commands/{name}", json={}).raise_for_status()
        station.http.patch("/parameters", json={"k_roll": 2.5}).raise_for_status()
        with station.simulated():
            eventually(lambda: len(station.kept.samples.get("hil_surfaces", ())) > _FRAMES, "some seconds are flown")
        path = station.closed()
    line = read_line(path)
    assert line.has_steps
    assert sum(one.frame.message.name == SURFACES for one in line.answered) > _FRAMES
    found = refly_line(line)
    assert found.frames > _FRAMES
    assert found.first is None, "\n".join(found.lines())
