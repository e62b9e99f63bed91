"""A recording that the station made of the real board program is flown again to the byte."""

from __future__ import annotations

import sys
from pathlib import Path

import httpx

from board_tests.closed_loop.test_replay import Client
from epf_gcs.lab.recorded_line import SURFACES, read_line
from epf_gcs.lab.refly import refly_line
from tests.support.firmware import make
from tests.support.ports import free_udp_port
from tests.support.programs import Program, board_process, gateway_process
from tests.support.waiting import DEADLINE_S, eventually

_FRAMES = 300


def test_the_stations_recording_of_a_board_is_equal_to_the_byte(tmp_path: Path) -> None:
    make("board")
    receive_port, send_port = free_udp_port(), free_udp_port()
    with (
        board_process(tmp_path / "board"),
        gateway_process(tmp_path / "data") as gateway,
        httpx.Client(timeout=DEADLINE_S) as http,
    ):
        url = gateway.wait_for_words(r"url=(http://\S+)")
        http.base_url = f"{url}/api/v1"
        eventually(lambda: http.put("/hil", json={"path": "assisted"}).is_success, "the flight process is there")
        client = Client(url)
        eventually(lambda: client.kept.client is not None, "the stream says hello")
        http.headers["X-Client"] = client.kept.client or ""
        http.put("/links/board", json={"url": f"pty://{tmp_path / 'board'}"}).raise_for_status()
        eventually(lambda: http.get("/status").json()["board"]["state"] == "open", "the board opens")
        # The stick of a receiver is in no recording.
        http.post("/commands/control_source", json={"value": 1}).raise_for_status()
        for name in ("fms_hil_plan_on", "hil_load_gando", "autotrim_on", "autopilot_on"):
            http.post(f"/commands/{name}", json={}).raise_for_status()
        http.patch("/parameters", json={"k_roll": 2.5}).raise_for_status()
        address = {"receive_port": receive_port, "send_port": send_port, "profile": "xp10"}
        http.put("/links/simulator", json=address).raise_for_status()
        program = [sys.executable, "-m", "epf_gcs.simulator", "--listen", str(send_port)]
        simulator = Program([*program, "--send-to", f"127.0.0.1:{receive_port}"])
        try:
            eventually(lambda: len(client.kept.samples.get("hil_surfaces", ())) > _FRAMES, "some seconds are flown")
        finally:
            simulator.end()
        http.delete("/links/board").raise_for_status()
        http.delete("/links/simulator").raise_for_status()
        path = next((tmp_path / "data" / "recordings").glob("*.mcap"))
        eventually(lambda: client.kept.is_recorded is False, "the recording ends")
        client.stop()
    line = read_line(path)
    assert line.has_steps
    assert sum(one.frame.message.name == SURFACES for one in line.answered) > _FRAMES
    found = refly_line(line)
    assert found.frames > _FRAMES
    assert found.first is None, "\n".join(found.lines())
