"""A folder that version 1.0.0 itself made, in a short flight of its demonstration, is taken over whole and given back.

`data-1.0.0.tar.xz` holds what that version's code wrote: a gain was changed, a threshold and the online maps were
chosen, and the board was killed once, which made an alarm.
"""

from __future__ import annotations

import subprocess
import sys
import tarfile
from pathlib import Path
from typing import Any

import httpx
import orjson
import pytest

from epf_gcs.backup.archive import FILTER
from epf_gcs.data_folder.version import FILE, FORMAT
from tests.support.programs import Program, gateway_process
from tests.support.waiting import DEADLINE_S, eventually

MADE = Path(__file__).parent / "data-1.0.0.tar.xz"
FLIGHT = "20261123T030733Z"
# Its recording, as that version wrote it: neither packed nor with notes.
SECONDS = (10, 20)


@pytest.fixture
def old(tmp_path: Path) -> Path:
    folder = tmp_path / "data"
    with tarfile.open(MADE) as archive:
        archive.extractall(folder, **FILTER)  # noqa: S202 (our own file)
    # The board and the simulator of that day would be opened at the start.
    state = orjson.loads((folder / "state.json").read_bytes())
    (folder / "state.json").write_bytes(orjson.dumps({**state, "board_url": None, "simulator": None}))
    return folder


def asked(program: Program) -> httpx.Client:
    url = program.wait_for_words(r"url=(http://\S+)")
    return httpx.Client(base_url=f"{url}/api/v1", timeout=DEADLINE_S)


def test_all_of_it_is_there_after_the_upgrade_and_what_was_changed_goes_back(old: Path) -> None:
    before = (old / "state.json").read_bytes()
    recorded = (old / "recordings" / f"{FLIGHT}.mcap").read_bytes()
    assert "online" in orjson.loads(before)
    with gateway_process(old) as program, asked(program) as client:
        assert f"was brought from format 1 to {FORMAT}" in program.said
        journal = client.get("/parameters/journal").raise_for_status().json()["entries"]
        assert [change["name"] for change in journal[0]["changes"]] == ["k_pitch"]
        thresholds = client.get("/alarms/thresholds").raise_for_status().json()["thresholds"]
        assert {one["name"]: one["value"] for one in thresholds}["battery_low_v"] == 11.4
        past = client.get("/alarms").json()["past"]
        assert "heartbeat_lost" in [alarm["id"] for alarm in past]
        assert client.get("/map/online").raise_for_status().json()["limit_bytes"] == 100_000_000

        def flight() -> dict[str, Any]:
            (found,) = client.get("/flights").raise_for_status().json()["flights"]
            return dict(found)

        eventually(lambda: flight()["state"] == "indexed", "its recording is indexed")
        assert flight()["id"] == FLIGHT
        assert SECONDS[0] < flight()["duration_s"] < SECONDS[1]
        assert flight()["frames"] > 1000
        program.end()
    assert orjson.loads((old / FILE).read_bytes())["format"] == FORMAT
    assert (old / "recordings" / f"{FLIGHT}.mcap").stat().st_size < len(recorded), "packed in its place"

    back = subprocess.run(
        [sys.executable, "-m", "epf_gcs.launcher.gateway", "downgrade", "--data-dir", str(old)],
        capture_output=True,
        text=True,
        check=True,
    )
    assert "epf-gcs 1.0.0 or older" in back.stdout
    assert (old / "state.json").read_bytes() == before
    assert (old / "recordings" / f"{FLIGHT}.mcap").exists()


def test_a_newer_folder_is_refused_by_every_program_that_would_write_to_it(old: Path) -> None:
    (old / FILE).write_text('{"format": 99, "epf_gcs": "9.0.0"}')
    content = {path: path.read_bytes() for path in old.rglob("*") if path.is_file()}
    for module in ("epf_gcs.launcher.gateway", "epf_gcs.flight", "epf_gcs.web", "epf_gcs.web.invite"):
        command = [sys.executable, "-m", module, "--data-dir", str(old)]
        answer = subprocess.run(command, capture_output=True, text=True, check=False, timeout=DEADLINE_S)
        assert answer.returncode != 0, module
        assert "was written by epf-gcs 9.0.0 (format 99)" in answer.stderr, module
        assert "Traceback" not in answer.stderr, module
    assert {
        path: path.read_bytes()
        for path in old.rglob("*")
        if path.is_file() and path.name not in (".lock", ".web.lock", ".station.lock")
    } == content
