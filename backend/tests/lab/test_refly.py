"""A recording is flown again by the laws: equal to the byte, or the first frame that differs is named."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from epf_gcs.codec.encode import encode_command
from epf_gcs.codec.tables import Waypoint
from epf_gcs.lab.errors import LabError
from epf_gcs.lab.flying import fly_wanted
from epf_gcs.lab.recorded_line import RecordedLine, Told, read_line
from epf_gcs.lab.recording import record
from epf_gcs.lab.refly import TOLERANCE, refly, refly_line
from epf_gcs.recordings.places import Places

DATA = Path(__file__).parent / "data"
# One leg in the lab in 10 kt of wind; and the board's program in real time, through the gateway, on a busy computer.
SHIPPED = {"one-leg": 491, "board": 303}


def change_at(line: RecordedLine, frame: int, command: bytes) -> RecordedLine:
    """The same, but the board is told one more command before this command 50."""
    infos = [index for index, told in enumerate(line.told) if told.name == "xplane_info"]
    place = infos[frame]
    told = [*line.told[:place], Told(line.told[place].t_s, "set_k_roll", command), *line.told[place:]]
    return replace(line, told=told)


@pytest.fixture(scope="module")
def shipped() -> RecordedLine:
    return read_line(DATA / "board.mcap")


@pytest.mark.parametrize("name", SHIPPED)
def test_the_shipped_recordings_are_equal_to_the_byte(name: str) -> None:
    found = refly(DATA / f"{name}.mcap")
    assert found.is_exact
    assert found.frames == SHIPPED[name]
    assert found.first is None, "\n".join(found.lines())
    assert found.until_s is None


@pytest.mark.parametrize("frame", [60, 200])
def test_a_change_is_named_at_its_frame_with_its_signal_and_its_growth(shipped: RecordedLine, frame: int) -> None:
    found = refly_line(change_at(shipped, frame, encode_command("set_k_roll", 3.0)))
    assert found.first is not None
    assert abs(found.first.frame - frame) <= 1
    assert found.first.signal == "aileron"
    sizes = [size for _, size in found.growth()]
    assert sizes == sorted(sizes)
    assert f"first difference   frame {found.first.frame}, after " in "\n".join(found.lines())


def test_without_the_times_of_the_steps_equal_is_within_the_tolerance(shipped: RecordedLine) -> None:
    deployed = replace(shipped, answered=[replace(one, step=None) for one in shipped.answered])
    found = refly_line(deployed)
    assert not found.is_exact
    assert found.first is None, "\n".join(found.lines())
    assert f"within {TOLERANCE:g}" in next(found.lines())
    changed = refly_line(change_at(deployed, 60, encode_command("set_k_roll", 9.0)))
    assert changed.first is not None
    assert changed.first.size > TOLERANCE


def test_damage_in_the_recording_ends_the_comparison_and_says_so(shipped: RecordedLine) -> None:
    half = replace(shipped, answered=shipped.answered[: len(shipped.answered) // 2], damaged_at_s=7.5)
    found = refly_line(half)
    assert found.first is None
    assert list(found.lines())[-1] == "  compared until 7.5 s: a frame of the board is damaged in the recording"


def test_what_is_no_flight_with_a_simulator_is_refused_in_a_sentence(tmp_path: Path) -> None:
    path = tmp_path / "20260131T120000Z.mcap"
    path.write_bytes(b"no recording")
    with pytest.raises(LabError, match="cannot be read as a recording"):
        refly(path)


def test_a_flight_at_another_rate_in_turbulence_over_a_bad_link_is_equal_to_the_byte(tmp_path: Path) -> None:
    conditions = {"rate_hz": 30, "turbulence": "moderate", "loss_percent": 10.0, "jitter_ms": 30.0, "seed": 7}
    flight = fly_wanted([Waypoint(27.9360, -15.3840, 1000.0, 55.0)], conditions)
    found = refly(Places(tmp_path).recording(record(flight, tmp_path).id))
    assert found.frames > 300
    assert found.first is None, "\n".join(found.lines())


def test_a_flight_by_the_line_law_and_its_gains_is_equal_to_the_byte(tmp_path: Path) -> None:
    flight = fly_wanted([Waypoint(27.9360, -15.3840, 1000.0, 55.0)], {"law": "line"}, {"line_k_bank": 1.0})
    found = refly(Places(tmp_path).recording(record(flight, tmp_path).id))
    assert found.frames > 300
    assert found.first is None, "\n".join(found.lines())
