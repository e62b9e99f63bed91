"""The recorder on a disk that is really full: one of a megabyte, in a mount namespace of the test's own."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import pytest

# Its own user and mount namespace: no permission of the system's is needed, and the disk goes with the program.
_MOUNT = 'mount -t tmpfs -o size=1m none "$0" && exec "$@"'


def _on_a_small_disk(folder: Path, *command: str) -> subprocess.CompletedProcess[str]:
    unshare = ["unshare", "--map-root-user", "--mount", "sh", "-c", _MOUNT, str(folder)]
    return subprocess.run([*unshare, *command], capture_output=True, text=True, check=False)


def test_a_full_disk_loses_only_what_it_says_and_recording_goes_on_when_there_is_room(tmp_path: Path) -> None:
    try:
        if _on_a_small_disk(tmp_path, "true").returncode != 0:
            pytest.skip("this system lets no user mount a disk of their own")
    except FileNotFoundError:
        pytest.skip("this system has no 'unshare'")
    program = (sys.executable, "-m", "tests.flight.recording.on_a_small_disk", str(tmp_path))
    run = _on_a_small_disk(tmp_path, *program)
    assert run.returncode == 0, run.stderr
    found = json.loads(run.stdout.splitlines()[-1])
    assert found["failure"] == "No space left on device"
    assert found["lost"] > 0
    assert found["held"] == found["given"] - found["lost"]
    (noted,) = found["noted"]
    assert noted == {"bytes": found["lost"], "reason": "No space left on device"}
    assert list(tmp_path.iterdir()) == [], "the disk was the test's own"
