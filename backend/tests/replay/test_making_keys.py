"""The program that makes the key frames of a finished recording before anybody opens it."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path
from typing import Any

import orjson
import pytest

from epf_gcs.replay.keys import EVERY_NS, Keys
from epf_gcs.replay.playhead import Playhead
from epf_gcs.replay.timeline import Timeline
from tests.replay.recordings import STARTS_NS, flight, write
from tests.support.outlet import KeptOutlet


def made(recording: Path, keys: Path) -> tuple[int, list[dict[str, Any]]]:
    """Exit code and all that it said."""
    words = [sys.executable, "-m", "epf_gcs.replay", "--make-keys", "--recording", str(recording), "--keys", str(keys)]
    with subprocess.Popen(words, stdin=subprocess.PIPE, stdout=subprocess.PIPE) as process:
        assert process.stdout is not None
        said = [orjson.loads(line) for line in process.stdout]
    return process.returncode, said


@pytest.fixture
def recording(tmp_path: Path) -> Path:
    return write(tmp_path / "20260101T000000Z.mcap", flight(20.0))


def test_all_key_frames_are_made_and_lead_to_the_moment_that_was_flown(recording: Path, tmp_path: Path) -> None:
    file = tmp_path / "keyframes" / "one.keys"
    code, said = made(recording, file)
    assert (code, said[-1]) == (0, {"done": {"bytes": file.stat().st_size}})
    shares = [one["progress"] for one in said[:-1]]
    assert shares == sorted(shares)
    assert shares[-1] > 0.8
    timeline = Timeline(recording)
    keys = Keys(file, recording.stem, STARTS_NS)
    found = keys.before(timeline.edge_ns)
    assert found is not None
    assert timeline.edge_ns - found[0] <= 2 * EVERY_NS
    kept, played = KeptOutlet(), KeptOutlet()
    Playhead(timeline, kept, *found).advance(timeline.edge_ns)
    Playhead(timeline, played).advance(timeline.edge_ns)
    assert kept.samples
    assert played.samples[-len(kept.samples) :] == kept.samples
    keys.close()


def test_what_was_made_already_is_gone_on_with(recording: Path, tmp_path: Path) -> None:
    file = tmp_path / "one.keys"
    made(recording, file)
    whole = file.read_bytes()
    file.write_bytes(whole[: len(whole) // 2])
    assert made(recording, file)[0] == 0
    assert len(file.read_bytes()) == pytest.approx(len(whole), rel=0.05)


def test_a_recording_that_cannot_be_read_is_told(tmp_path: Path) -> None:
    (tmp_path / "x.mcap").write_bytes(b"no recording at all")
    code, said = made(tmp_path / "x.mcap", tmp_path / "x.keys")
    assert code == 1
    assert said[-1]["fault"]["code"] == "job_failed"
